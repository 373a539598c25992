/* style.h - appearance of charts: line weights, tints, dashes, markers, text sizes.
 *
 * Charts can be printed in black and white and photocopied. Lines differ by dash and
 * marker, never by tint alone. On A4 no line is thinner than 0.1 mm. Greys that
 * distinguish areas are not lighter than 12 % black. All sizes are millimetres on
 * paper, in proportion to the square root of the sheet's shorter side (except for the
 * margin of A5). An A2 poster and an A5 page are thus each legible at their usual
 * distance.
 */
#ifndef PP_CHARTS_SHEET_STYLE_H
#define PP_CHARTS_SHEET_STYLE_H

#include <stddef.h>

#include <cairo.h>

enum pp_text_size { PP_TEXT_SMALL, PP_TEXT_BODY, PP_TEXT_HEAD, PP_TEXT_TITLE };

struct pp_style {
    double scale;                     /* factor of the sizes below; 1 for A4 */
    double text[4];                   /* type sizes, mm; index: enum pp_text_size */
    double hair, thin, medium, thick; /* line weights, mm */
    double marker;                    /* size of the marker of a point, mm */
    double margin;                    /* margin of the sheet, mm */
};

/* Style for a sheet whose shorter side is short_mm. */
struct pp_style pp_style_for(double short_mm);

/* Grey levels (0 black, 1 white) of ink, secondary text, background lines, grids and
 * fills. */
#define PP_INK 0.0
#define PP_GREY_TEXT 0.30
#define PP_GREY_LINE 0.55
#define PP_GREY_GRID 0.80
#define PP_GREY_FILL 0.88

void pp_style_grey(cairo_t *cr, double grey);

/* Line style of a curve. */
struct pp_curve_style {
    int dash_count;   /* 0: a solid line */
    double dashes[6]; /* lengths of dashes and gaps, mm on A4 */
    double weight;    /* line weight as a multiple of style.medium */
    int marker;       /* enum pp_marker */
};

enum pp_marker {
    PP_DISC,
    PP_CIRCLE,
    PP_FULL_SQUARE,
    PP_SQUARE,
    PP_FULL_TRIANGLE,
    PP_TRIANGLE,
    PP_FULL_DIAMOND,
    PP_DIAMOND,
    PP_PLUS,
    PP_CROSS,
    PP_POINT_MARK, /* a small grey plus, for a position without a value */
};

struct pp_curve_style pp_style_curve(int index);

/* Sets line width and dash of a curve. */
void pp_style_pen(cairo_t *cr, const struct pp_style *style,
                  const struct pp_curve_style *curve);

/* Sets a solid line of that weight and grey level (0 black to 1 white). */
void pp_style_line(cairo_t *cr, double weight_mm, double grey);

/* Draws a marker centred at x, y. Open markers are filled white. */
void pp_style_marker(cairo_t *cr, const struct pp_style *style, enum pp_marker marker,
                     double x, double y);

/* Draws an arrow: a thin line and a filled head. head_mm: length of the head; half_mm:
 * half its width. */
void pp_style_arrow(cairo_t *cr, const struct pp_style *style, const double from[2],
                    const double to[2], double head_mm, double half_mm);

/* Writes a fraction in per cent, to two significant digits, or to whole per cent:
 * "0.0012 %", "0.35 %", "2.1 %", "48 %". The space is non-breaking. */
void pp_style_percent(char *text, size_t room, double fraction);

/* Writes a level in per cent, to four digits and as short as possible: "0.5", "2",
 * "12.5". */
void pp_style_level(char *text, size_t room, double fraction);

/* Writes a length in metres to the centimetre, without trailing zeros: "2.7 m", "14
 * m". */
void pp_style_metres(char *text, size_t room, double metres);

#endif
