/* device_drawing.c - see device_drawing.h. */
#include "charts/room/device_drawing.h"

#include <math.h>

/* Dimensions on paper (mm, to be multiplied by style.scale). */
static const double gap_mm = 0.9, stroke_mm = 1.2, apart_mm = 1.0, wave_mm = 1.6;

/* Line on paper that represents the device. */
struct device_line {
    double x, y;   /* start of the line */
    double dx, dy; /* unit vector along the line */
    double nx, ny; /* unit vector into the room */
    double length;
};

static void draw_cut_slats(cairo_t *cr, const struct pp_style *style,
                           const struct device_line *line, double tilt)
{
    double half = 0.5 * stroke_mm * style->scale;
    int count = (int)floor(line->length / (apart_mm * style->scale));
    for (int i = 0; i < count; i++) {
        double at = (i + 0.5) * line->length / count;
        double x = line->x + at * line->dx, y = line->y + at * line->dy;
        double a = half * cos(tilt), b = -half * sin(tilt);
        cairo_move_to(cr, x - a * line->nx - b * line->dx,
                      y - a * line->ny - b * line->dy);
        cairo_line_to(cr, x + a * line->nx + b * line->dx,
                      y + a * line->ny + b * line->dy);
    }
}

static void draw_wave(cairo_t *cr, const struct pp_style *style,
                      const struct device_line *line)
{
    double wave = wave_mm * style->scale, out = 0.3 * wave;
    int count = (int)fmax(2.0, round(line->length / wave));
    double step = line->length / count;
    cairo_move_to(cr, line->x, line->y);
    for (int i = 0; i < count; i++) {
        double side = i % 2 ? -out : out, from = i * step, to = (i + 1) * step;
        cairo_curve_to(cr, line->x + (from + 0.35 * step) * line->dx + side * line->nx,
                       line->y + (from + 0.35 * step) * line->dy + side * line->ny,
                       line->x + (from + 0.65 * step) * line->dx + side * line->nx,
                       line->y + (from + 0.65 * step) * line->dy + side * line->ny,
                       line->x + to * line->dx, line->y + to * line->dy);
    }
}

void pp_device_drawing_cut(cairo_t *cr, const struct pp_style *style,
                           const struct pp_opening *opening, const double from[2],
                           const double to[2], const double inwards[2],
                           bool slats_are_cut)
{
    const struct pp_window_device *device = &opening->device;
    double length = hypot(to[0] - from[0], to[1] - from[1]);
    double off = gap_mm * style->scale;
    if (device->kind == PP_DEVICE_NONE || !(length > 0.0))
        return;
    if (device->position != PP_DEVICE_INSIDE)
        off = device->position == PP_DEVICE_OUTSIDE ? -off : 0.0;
    const struct device_line line = {.x = from[0] + off * inwards[0],
                                     .y = from[1] + off * inwards[1],
                                     .dx = (to[0] - from[0]) / length,
                                     .dy = (to[1] - from[1]) / length,
                                     .nx = inwards[0],
                                     .ny = inwards[1],
                                     .length = length};
    double dash = (device->kind == PP_DEVICE_SCREEN ? 0.35 : apart_mm) * style->scale;
    cairo_save(cr);
    cairo_set_dash(cr, NULL, 0, 0.0);
    pp_style_line(cr, style->thin, PP_INK);
    if (device->kind == PP_DEVICE_CURTAIN) {
        draw_wave(cr, style, &line);
    } else if (device->kind == PP_DEVICE_BLIND && slats_are_cut) {
        draw_cut_slats(cr, style, &line, device->slats.tilt_rad);
    } else {
        cairo_set_dash(cr, &dash, 1, 0.0);
        cairo_move_to(cr, line.x, line.y);
        cairo_line_to(cr, line.x + length * line.dx, line.y + length * line.dy);
    }
    cairo_stroke(cr);
    cairo_restore(cr);
}

void pp_device_drawing_front(cairo_t *cr, const struct pp_style *style,
                             const struct pp_opening *opening)
{
    const struct pp_window_device *device = &opening->device;
    bool upright = device->kind == PP_DEVICE_CURTAIN || device->vertical;
    bool both = device->kind == PP_DEVICE_SCREEN;
    double x0, y0, x1, y1, apart = apart_mm * style->scale;
    if (device->kind == PP_DEVICE_NONE)
        return;
    cairo_path_t *outline = cairo_copy_path(cr);
    cairo_path_extents(cr, &x0, &y0, &x1, &y1);
    cairo_save(cr);
    cairo_clip(cr);
    pp_style_line(cr, 0.6 * style->thin, PP_GREY_LINE);
    for (double x = x0 + apart; (upright || both) && x < x1; x += apart) {
        cairo_move_to(cr, x, y0);
        cairo_line_to(cr, x, y1);
    }
    for (double y = y0 + apart; (!upright || both) && y < y1; y += apart) {
        cairo_move_to(cr, x0, y);
        cairo_line_to(cr, x1, y);
    }
    cairo_stroke(cr);
    cairo_restore(cr);
    cairo_append_path(cr, outline);
    cairo_path_destroy(outline);
}
