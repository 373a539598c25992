/* legend.h - explains lines, markers and fills by a column of samples with text. */
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
    PP_KEY_COLOUR,  /* a field in a colour */
    PP_KEY_HATCH,   /* a hatched field: spacing of the lines curve.dashes[0], mm on
                     * A4 */
};

struct pp_key {
    enum pp_legend_kind kind;
    struct pp_curve_style curve; /* style of lines and markers */
    double grey;                 /* grey level of a tint, or of the line: 0 black, 1
                                  * white */
    double colour[3];            /* red, green, blue, 0 to 1 */
    char words[96];
};

/* Draws the keys one below the other, from the upper left corner x, y, at most `width`
 * wide; words longer than two lines are cut and end in "...". Returns the box of the
 * legend. */
struct pp_box pp_legend_draw(cairo_t *cr, const struct pp_style *style,
                             const struct pp_key *keys, int count, double x, double y,
                             double width);

/* Box of the legend that pp_legend_draw would draw. */
struct pp_box pp_legend_measure(cairo_t *cr, const struct pp_style *style,
                                const struct pp_key *keys, int count, double x,
                                double y, double width);

/* Draws a marker at x, y with an error bar from y_low to y_high, as also in a key. */
void pp_legend_bar(cairo_t *cr, const struct pp_style *style, enum pp_marker marker,
                   double x, double y, double y_low, double y_high);

#endif
