/* picture_sheet.h - the data of a sheet with a picture on it
 * (charts/picture_chart.h). */
#ifndef PP_MODEL_RESULTS_SHEETS_PICTURE_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_PICTURE_SHEET_H

#include "model/geometry/curve.h"
#include "model/pictures/false_colour.h"
#include "model/pictures/raster.h"

/* A word at a place in the picture, in pixels. */
struct pp_picture_word {
    double x, y;
    char words[16];
};

struct pp_picture_sheet {
    const char *title;  /* not owned; NULL: none */
    char subtitle[512]; /* the quantity, the view, the sky */
    char foot[512];     /* notes */

    struct pp_raster raster;

    double pixels_per_m; /* of a parallel view; 0: of no one scale */
    bool upright;        /* not seen from straight above or below; else: */
    double north_rad;    /* north is so far anticlockwise of up */

    bool scaled; /* in false colours: with a scale beside */
    struct pp_false_colour_scale scale;
    bool off_scale[2]; /* true if pixels are below, above the scale */
    const char *unit;  /* of the scale; not owned */
    int level_count;   /* that have lines */
    double levels[PP_FALSE_COLOUR_LEVELS_MOST];
    struct pp_curve_list lines; /* in pixels, levels in the unit */

    struct pp_curve_list grid; /* over it, in pixels: directions, outlines */
    struct pp_picture_word *words;
    int word_count;

    double (*marks)[2]; /* places of records, in pixels */
    int mark_count;
};

void pp_picture_sheet_clear(struct pp_picture_sheet *sheet);

#endif
