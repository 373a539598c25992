/* lettering.h - text on a chart, placed by a point of its box.
 *
 * Text is UTF-8; invalid bytes are shown as U+FFFD. Sizes are the same in all formats,
 * since glyphs are unhinted and placed at fractions of a millimetre.
 */
#ifndef PP_CHARTS_SHEET_LETTERING_H
#define PP_CHARTS_SHEET_LETTERING_H

#include <stdbool.h>
#include <stddef.h>

#include <cairo.h>

#include "charts/sheet/style.h"

struct pp_box {
    double x, y, width, height; /* x, y: upper left corner; mm */
};

bool pp_lettering_boxes_overlap(struct pp_box a, struct pp_box b);

/* Style and placement of a text. */
struct pp_lettering {
    enum pp_text_size size;
    bool bold, italic;
    bool markup; /* the text has Pango markup: <i>, <b>, <sub>, <sup> */
    double grey;
    double across, down; /* point of the text's box that is placed at x, y: 0 left or
                          * top, 0.5 middle, 1 right or bottom */
    double turn_rad;     /* rotation about x, y, clockwise on paper */
    double width;        /* line width, mm; 0: a single line */
    int lines;           /* maximum number of lines if width is set; longer text ends in
                          * "..."; 0: no limit */
};

/* Box of the text that pp_lettering_draw would draw, without rotation. */
struct pp_box pp_lettering_measure(cairo_t *cr, const struct pp_style *style,
                                   const struct pp_lettering *text, double x, double y,
                                   const char *words);

/* Draws the text. Returns its box without rotation, as pp_lettering_measure does. */
struct pp_box pp_lettering_draw(cairo_t *cr, const struct pp_style *style,
                                const struct pp_lettering *text, double x, double y,
                                const char *words);

/* Draws the text like pp_lettering_draw, on a white background a little larger than the
 * text. */
struct pp_box pp_lettering_draw_on_white(cairo_t *cr, const struct pp_style *style,
                                         const struct pp_lettering *text, double x,
                                         double y, const char *words);

/* Writes the family name (UTF-8) of the font that is used; "" if the machine has no
 * font. Returns the number of characters in `words` that are missing from all fonts. */
int pp_lettering_font(const char *words, char *family, size_t room);

#endif
