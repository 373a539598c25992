/* style.c - the sizes, dashes and markers of style.h, and the number formats of
 * charts. */
#include "charts/sheet/style.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "model/geometry/vec.h"

struct pp_style pp_style_for(double short_mm)
{
    double scale = sqrt(short_mm / 210.0);
    return (struct pp_style){
        .scale = scale,
        .text = {2.35 * scale, 2.8 * scale, 3.4 * scale, 5.0 * scale},
        .hair = 0.10 * scale,
        .thin = 0.18 * scale,
        .medium = 0.35 * scale,
        .thick = 0.65 * scale,
        .marker = 1.35 * scale,
        .margin = short_mm < 160.0 ? 10.0 : 14.0 * scale,
    };
}

void pp_style_grey(cairo_t *cr, double grey)
{
    cairo_set_source_rgb(cr, grey, grey, grey);
}

struct pp_curve_style pp_style_curve(int index)
{
    static const struct pp_curve_style lines[] = {
        {0, {0}, 1.0, 0},
        {2, {2.4, 1.1}, 1.0, 0},
        {4, {3.2, 0.8, 0.5, 0.8}, 1.0, 0},
        {2, {0.9, 0.8}, 1.0, 0},
        {6, {3.2, 0.8, 0.5, 0.8, 0.5, 0.8}, 1.0, 0},
        {2, {5.0, 1.3}, 0.7, 0},
        {4, {1.8, 0.8, 1.8, 2.2}, 0.7, 0},
        {2, {0.35, 1.0}, 1.2, 0},
    };
    /* Circle and diamond are reserved for simulated points. */
    static const enum pp_marker markers[] = {
        PP_DISC,         PP_CROSS,  PP_FULL_SQUARE, PP_TRIANGLE,
        PP_FULL_DIAMOND, PP_SQUARE, PP_PLUS,
    };
    /* The numbers of lines (8) and markers (7) have no common factor, so there are 56
     * different pairs. */
    struct pp_curve_style style = lines[index % 8];
    style.marker = markers[index % 7];
    return style;
}

void pp_style_pen(cairo_t *cr, const struct pp_style *style,
                  const struct pp_curve_style *curve)
{
    double dashes[6];
    for (int i = 0; i < curve->dash_count; i++)
        dashes[i] = curve->dashes[i] * style->scale;
    cairo_set_dash(cr, dashes, curve->dash_count, 0.0);
    cairo_set_line_width(cr, curve->weight * style->medium);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
    pp_style_grey(cr, PP_INK);
}

void pp_style_line(cairo_t *cr, double weight_mm, double grey)
{
    cairo_set_dash(cr, 0, 0, 0.0);
    cairo_set_line_width(cr, weight_mm);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
    pp_style_grey(cr, grey);
}

static void polygon_path(cairo_t *cr, double x, double y, double radius, int corners,
                         double first_rad)
{
    cairo_new_path(cr);
    for (int i = 0; i < corners; i++) {
        double angle = first_rad + 2.0 * PP_PI * i / corners;
        cairo_line_to(cr, x + radius * cos(angle), y + radius * sin(angle));
    }
    cairo_close_path(cr);
}

void pp_style_marker(cairo_t *cr, const struct pp_style *style, enum pp_marker marker,
                     double x, double y)
{
    double r = 0.5 * style->marker;
    pp_style_line(cr, 0.6 * style->medium, PP_INK);
    cairo_new_path(cr);
    switch (marker) {
    case PP_DISC:
    case PP_CIRCLE:
        cairo_arc(cr, x, y, r, 0.0, 2.0 * PP_PI);
        break;
    case PP_FULL_SQUARE:
    case PP_SQUARE:
        polygon_path(cr, x, y, 1.25 * r, 4, PP_PI / 4.0);
        break;
    case PP_FULL_TRIANGLE:
    case PP_TRIANGLE:
        polygon_path(cr, x, y, 1.25 * r, 3, -PP_PI / 2.0);
        break;
    case PP_FULL_DIAMOND:
    case PP_DIAMOND:
        polygon_path(cr, x, y, 1.3 * r, 4, 0.0);
        break;
    case PP_PLUS:
    case PP_POINT_MARK:
        if (marker == PP_POINT_MARK) {
            r *= 0.7;
            pp_style_line(cr, style->hair, PP_GREY_LINE);
        }
        cairo_move_to(cr, x - 1.2 * r, y);
        cairo_line_to(cr, x + 1.2 * r, y);
        cairo_move_to(cr, x, y - 1.2 * r);
        cairo_line_to(cr, x, y + 1.2 * r);
        cairo_stroke(cr);
        return;
    case PP_CROSS:
        cairo_move_to(cr, x - r, y - r);
        cairo_line_to(cr, x + r, y + r);
        cairo_move_to(cr, x - r, y + r);
        cairo_line_to(cr, x + r, y - r);
        cairo_stroke(cr);
        return;
    }
    bool full = marker == PP_DISC || marker == PP_FULL_SQUARE
                || marker == PP_FULL_TRIANGLE || marker == PP_FULL_DIAMOND;
    pp_style_grey(cr, full ? PP_INK : 1.0);
    cairo_fill_preserve(cr);
    pp_style_grey(cr, PP_INK);
    cairo_stroke(cr);
}

void pp_style_arrow(cairo_t *cr, const struct pp_style *style, const double from[2],
                    const double to[2], double head_mm, double half_mm)
{
    double length = hypot(to[0] - from[0], to[1] - from[1]);
    double dx = (to[0] - from[0]) / length, dy = (to[1] - from[1]) / length;
    pp_style_line(cr, style->thin, PP_INK);
    cairo_new_path(cr);
    cairo_move_to(cr, from[0], from[1]);
    cairo_line_to(cr, to[0], to[1]);
    cairo_stroke(cr);
    cairo_move_to(cr, to[0], to[1]);
    for (int side = 1; side >= -1; side -= 2)
        cairo_line_to(cr, to[0] - head_mm * dx + side * half_mm * dy,
                      to[1] - head_mm * dy - side * half_mm * dx);
    cairo_close_path(cr);
    pp_style_grey(cr, PP_INK);
    cairo_fill(cr);
}

void pp_style_percent(char *text, size_t room, double fraction)
{
    double percent = 100.0 * fraction;
    double size = fabs(percent);
    int decimals = size >= 9.95 ? 0 : size >= 0.995 ? 1 : 2;
    if (size > 0.0 && size < 0.0995)
        decimals = 1 - (int)floor(log10(size));
    snprintf(text, room, "%.*f\u00a0%%", decimals > 9 ? 9 : decimals, percent);
}

void pp_style_level(char *text, size_t room, double fraction)
{
    snprintf(text, room, "%.4g", 100.0 * fraction);
}

void pp_style_metres(char *text, size_t room, double metres)
{
    char number[64];
    snprintf(number, sizeof number, "%.2f", metres);
    size_t length = strlen(number);
    while (length && number[length - 1] == '0')
        number[--length] = 0;
    if (length && number[length - 1] == '.')
        number[--length] = 0;
    snprintf(text, room, "%s\u00a0m", strcmp(number, "-0") == 0 ? "0" : number);
}
