/* legend.h - explains lines, markers and fills in a column of samples and words. */
#ifndef PP_CHARTS_SHEET_LEGEND_H
#define PP_CHARTS_SHEET_LEGEND_H

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"

enum pp_legend_kind {
    PP_KEY_LINE,
    PP_KEY_MARKED_LINE,
    PP_KEY_SAMPLED, /* a marker with an error bar */
    PP_KEY_MARKER,  /* a marker without a line */
    PP_KEY_TINT,    /* a tinted field */
    PP_KEY_COLOUR,  /* a field of a colour */
    PP_KEY_HATCH,   /* a field hatched with lines curve.dashes[0] mm apart on A4 */
};

struct pp_key {
    enum pp_legend_kind kind;
    struct pp_curve_style curve; /* style of lines and markers */
    double grey;                 /* grey level of a tint, or of the line: 0 black to 1
                                  * white */
    double colour[3];            /* red, green, blue, 0 to 1 */
    char words[96];
};

/* Draws the keys one below the other from x, y on, no wider than `width` (words are cut
 * with ... if necessary). Returns the box filled. */
struct pp_box pp_legend_draw(cairo_t *cr, const struct pp_style *style,
                             const struct pp_key *keys, int count, double x, double y,
                             double width);

/* The box that pp_legend_draw would fill. */
struct pp_box pp_legend_measure(cairo_t *cr, const struct pp_style *style,
                                const struct pp_key *keys, int count, double x,
                                double y, double width);

/* Draws a marker with a bar of one standard error up and down; also used as a key. */
void pp_legend_bar(cairo_t *cr, const struct pp_style *style, enum pp_marker marker,
                   double x, double y, double y_low, double y_high);

#endif
