/* chart_run.h - draws a chart of one kind for the rooms on a command line, and writes
 * the files. */
#ifndef PP_CLI_CHART_CHART_RUN_H
#define PP_CLI_CHART_CHART_RUN_H

#include "api/chart_kind.h"
#include "cli/exit_status.h"
#include "cli/room_options.h"

/* Sheet options as typed. */
struct pp_chart_words {
    const char *format; /* format as typed; NULL: by the extension of the file */
    enum pp_paper paper;
    enum pp_orientation orientation;
    double dpi; /* resolution of PNG; 0: default of the canvas */
    bool list, logarithmic, linear;
    const char *before;   /* file with the former state of the rooms, or "existing";
                           * NULL: none */
    bool before_is_state; /* the former state is the existing state in the same file */
    struct pp_project project; /* facts of the project, which replace those in the room
                                * file */
    struct pp_chart_choice choice;
};

/* Reads the room files, draws the chart and reports errors. The chart is blank if there
 * are no files. */
enum pp_exit pp_chart_run(const struct pp_chart_kind *kind,
                          const struct pp_room_options *room_options,
                          const struct pp_chart_words *options, char **files,
                          int file_count);

#endif
