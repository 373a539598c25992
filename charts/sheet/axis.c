/* axis.c - chooses ticks at 1, 2 or 5 times a power of ten, and draws axes with
 * them. */
#include "charts/sheet/axis.h"

#include <math.h>
#include <stdio.h>

/* Smallest round interval (1, 2 or 5 times a power of ten) that is at least `least`. */
static double round_step(double least)
{
    double power = pow(10.0, floor(log10(least)));
    static const double steps[] = {1.0, 2.0, 5.0};
    for (int i = 0; i < 3; i++)
        if (steps[i] * power >= least * (1.0 - 1e-9))
            return steps[i] * power;
    return 10.0 * power;
}

struct pp_axis pp_axis_linear(double low, double high, double from, double to,
                              double apart_mm, bool round)
{
    struct pp_axis axis = {.from = from, .to = to};
    double least = (high - low) * fmax(apart_mm / fabs(to - from), 0.02);
    double step = round_step(least);
    double first = ceil(low / step - 1e-9), last = floor(high / step + 1e-9);
    if (round) {
        first = floor(low / step + 1e-9);
        last = ceil(high / step - 1e-9);
    }
    axis.low = round ? first * step : low;
    axis.high = round ? last * step : high;
    for (double i = first; i <= last && axis.tick_count < PP_TICKS_MOST; i += 1.0)
        axis.ticks[axis.tick_count++] = i * step;
    axis.decimals = (int)fmax(0.0, -floor(log10(step) + 1e-9));
    return axis;
}

struct pp_axis pp_axis_log(double low, double high, double from, double to,
                           double apart_mm)
{
    struct pp_axis axis = {.from = from, .to = to, .logarithmic = true, .decimals = -1};
    static const double steps[] = {1.0, 2.0, 5.0};

    /* Ticks at 1, 2 and 5 times each power of ten if there is space for them, else at
     * powers of ten only. */
    double decades = log10(high / low);
    bool fine = fabs(to - from) / fmax(decades, 0.3) * 0.30 >= apart_mm;
    int first = (int)floor(log10(low) + 1e-9) - 1, last = (int)ceil(log10(high)) + 1;
    double before = 0.0;
    for (int power = first; power <= last; power++)
        for (int i = 0; i < (fine ? 3 : 1); i++) {
            double tick = steps[i] * pow(10.0, power);
            if (tick <= low * (1.0 + 1e-9)) {
                before = tick;
                continue;
            }
            if (axis.tick_count == 0)
                axis.ticks[axis.tick_count++] = before;
            if (axis.ticks[axis.tick_count - 1] < high * (1.0 - 1e-9)
                && axis.tick_count < PP_TICKS_MOST)
                axis.ticks[axis.tick_count++] = tick;
        }
    axis.low = axis.ticks[0];
    axis.high = axis.ticks[axis.tick_count - 1];
    return axis;
}

double pp_axis_at(const struct pp_axis *axis, double value)
{
    double share;
    if (axis->logarithmic)
        share =
            value > 0.0 ? log(value / axis->low) / log(axis->high / axis->low) : 0.0;
    else
        share = (value - axis->low) / (axis->high - axis->low);
    return axis->from + share * (axis->to - axis->from);
}

void pp_axis_label(const struct pp_axis *axis, int tick, char *text, size_t room)
{
    double value = axis->ticks[tick];
    if (axis->decimals < 0)
        snprintf(text, room, "%.10g", value);
    else
        snprintf(text, room, "%.*f", axis->decimals, fabs(value) < 1e-12 ? 0.0 : value);
}

static double tick_length(const struct pp_style *style)
{
    return 1.2 * style->scale;
}

double pp_axis_draw_across(cairo_t *cr, const struct pp_style *style,
                           const struct pp_axis *axis, double y)
{
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5};
    double length = tick_length(style), reach = length;
    pp_style_line(cr, style->thin, PP_INK);
    cairo_move_to(cr, axis->from, y);
    cairo_line_to(cr, axis->to, y);
    for (int i = 0; i < axis->tick_count; i++) {
        double x = pp_axis_at(axis, axis->ticks[i]);
        cairo_move_to(cr, x, y);
        cairo_line_to(cr, x, y + length);
    }
    cairo_stroke(cr);

    double free_from = -INFINITY;
    for (int i = 0; i < axis->tick_count; i++) {
        char label[32];
        pp_axis_label(axis, i, label, sizeof label);
        double x = pp_axis_at(axis, axis->ticks[i]);
        double below = y + 1.3 * length;
        struct pp_box box = pp_lettering_measure(cr, style, &set, x, below, label);
        if (box.x < free_from)
            continue;
        pp_lettering_draw(cr, style, &set, x, below, label);
        free_from = box.x + box.width + 1.0 * style->scale;
        reach = fmax(reach, box.y + box.height - y);
    }
    return reach;
}

double pp_axis_reach(cairo_t *cr, const struct pp_style *style,
                     const struct pp_axis *axis)
{
    struct pp_lettering set = {.size = PP_TEXT_SMALL};
    double widest = 0.0;
    for (int i = 0; i < axis->tick_count; i++) {
        char label[32];
        pp_axis_label(axis, i, label, sizeof label);
        widest = fmax(widest, pp_lettering_measure(cr, style, &set, 0, 0, label).width);
    }
    return widest + 1.7 * tick_length(style);
}

double pp_axis_draw_up(cairo_t *cr, const struct pp_style *style,
                       const struct pp_axis *axis, double x)
{
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 1.0, .down = 0.5};
    double length = tick_length(style);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_move_to(cr, x, axis->from);
    cairo_line_to(cr, x, axis->to);
    for (int i = 0; i < axis->tick_count; i++) {
        double y = pp_axis_at(axis, axis->ticks[i]);
        cairo_move_to(cr, x, y);
        cairo_line_to(cr, x - length, y);
    }
    cairo_stroke(cr);

    double free_to = INFINITY;
    for (int i = 0; i < axis->tick_count; i++) {
        char label[32];
        pp_axis_label(axis, i, label, sizeof label);
        double y = pp_axis_at(axis, axis->ticks[i]), left = x - 1.7 * length;
        struct pp_box box = pp_lettering_measure(cr, style, &set, left, y, label);
        if (box.y + box.height > free_to)
            continue;
        pp_lettering_draw(cr, style, &set, left, y, label);
        free_to = box.y;
    }
    return pp_axis_reach(cr, style, axis);
}

void pp_axis_grid_across(cairo_t *cr, const struct pp_style *style,
                         const struct pp_axis *up, double left, double right)
{
    pp_style_line(cr, style->hair, PP_GREY_GRID);
    for (int i = 0; i < up->tick_count; i++) {
        double y = pp_axis_at(up, up->ticks[i]);
        cairo_move_to(cr, left, y);
        cairo_line_to(cr, right, y);
    }
    cairo_stroke(cr);
}

void pp_axis_grid_up(cairo_t *cr, const struct pp_style *style,
                     const struct pp_axis *across, double top, double bottom)
{
    pp_style_line(cr, style->hair, PP_GREY_GRID);
    for (int i = 0; i < across->tick_count; i++) {
        double x = pp_axis_at(across, across->ticks[i]);
        cairo_move_to(cr, x, top);
        cairo_line_to(cr, x, bottom);
    }
    cairo_stroke(cr);
}
