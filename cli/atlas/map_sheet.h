/* map_sheet.h - a map of an atlas on a sheet of paper. */
#ifndef PP_CLI_ATLAS_MAP_SHEET_H
#define PP_CLI_ATLAS_MAP_SHEET_H

#include "charts/sheet/canvas.h"
#include "cli/exit_status.h"
#include "studies/research/atlas/atlas_mapping.h"

struct pp_map_sheet {
    enum pp_atlas_mapping_kind kind;
    const char *method; /* not owned */
    enum pp_paper paper;
};

/* Draws the map of that atlas to a PDF, SVG or PNG by the ending of `output`. */
enum pp_exit pp_map_sheet_write(const struct pp_map_sheet *sheet, const char *path,
                                const char *output);

#endif
