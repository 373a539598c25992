/* picture_sheet.h - data of a sheet with a picture (charts/picture_chart.h). */
#ifndef PP_MODEL_RESULTS_SHEETS_PICTURE_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_PICTURE_SHEET_H

#include "model/geometry/curve.h"
#include "model/pictures/false_colour.h"
#include "model/pictures/raster.h"

/* A word and its position in the picture, in pixels. */
struct pp_picture_word {
    double x, y;
    char words[16];
};

struct pp_picture_sheet {
    const char *title;  /* not owned; NULL: none */
    char subtitle[512]; /* quantity, view and sky */
    char foot[512];     /* notes */

    struct pp_raster raster;

    double pixels_per_m; /* scale of a parallel view; 0: no uniform scale */
    bool upright;        /* true unless the view is straight up or down */
    double north_rad;    /* for a view straight up or down: direction of north in the
                          * picture, anticlockwise from its top */

    bool scaled; /* false colours with a scale */
    struct pp_false_colour_scale scale;
    bool off_scale[2]; /* true if pixels are below, above the scale */
    const char *unit;  /* unit of the scale; not owned */
    int level_count;   /* number of levels with lines */
    double levels[PP_FALSE_COLOUR_LEVELS_MOST];
    struct pp_curve_list lines; /* in pixels; levels in `unit` */

    struct pp_curve_list grid; /* overlay in pixels: directions, outlines */
    struct pp_picture_word *words;
    int word_count;

    double (*marks)[2]; /* positions of cache records, in pixels */
    int mark_count;
};

void pp_picture_sheet_clear(struct pp_picture_sheet *sheet);

#endif
