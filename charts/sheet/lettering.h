/* lettering.h - words on a chart, placed by a point at one of their sides.
 *
 * Text is UTF-8; invalid bytes are shown as U+FFFD. Sizes do not depend on the format
 * drawn to: glyphs are laid out unhinted, at fractions of a millimetre.
 */
#ifndef PP_CHARTS_SHEET_LETTERING_H
#define PP_CHARTS_SHEET_LETTERING_H

#include <stdbool.h>
#include <stddef.h>

#include <cairo.h>

#include "charts/sheet/style.h"

struct pp_box {
    double x, y, width, height; /* x, y: the upper left corner */
};

bool pp_lettering_boxes_overlap(struct pp_box a, struct pp_box b);

/* Layout of a text. */
struct pp_lettering {
    enum pp_text_size size;
    bool bold, italic;
    bool markup; /* words have pango's markup: <i>, <b>, <sub>, <sup> */
    double grey;
    double across, down; /* point of the text's box that is placed at x, y: 0 left or
                          * top, 0.5 middle, 1 right or bottom */
    double turn_rad;     /* about x, y, clockwise on paper */
    double width;        /* lines are broken at this width; 0: a single line */
    int lines;           /* if width is set: most lines, then ...; 0: any number */
};

/* The box that pp_lettering_draw would fill (not turned). */
struct pp_box pp_lettering_measure(cairo_t *cr, const struct pp_style *style,
                                   const struct pp_lettering *text, double x, double y,
                                   const char *words);

/* Draws the text, and returns the box of pp_lettering_measure. */
struct pp_box pp_lettering_draw(cairo_t *cr, const struct pp_style *style,
                                const struct pp_lettering *text, double x, double y,
                                const char *words);

/* Draws like pp_lettering_draw, on a white ground a little larger than the text. */
struct pp_box pp_lettering_draw_on_white(cairo_t *cr, const struct pp_style *style,
                                         const struct pp_lettering *text, double x,
                                         double y, const char *words);

/* Writes the family name of the font that is used, as UTF-8; "" if the machine has no
 * font. Returns the number of characters of `words` that no font has. */
int pp_lettering_font(const char *words, char *family, size_t room);

#endif
