/* plan_fill.c - the colour scale, and areas painted from the lowest to the highest
 * level. */
#include "charts/room/plan_fill.h"

#include <math.h>
#include <stdio.h>

#include "charts/room/contour_lines.h"

/* Colours (RGB) at equal steps of the logarithm from `lowest` to `highest`,
 * interpolated linearly between them. */
enum { STEPS = 7 };
static const double colours[STEPS][3] = {
    {0.50, 0.55, 0.83}, {0.46, 0.69, 0.88}, {0.50, 0.82, 0.83}, {0.62, 0.89, 0.66},
    {0.80, 0.94, 0.52}, {0.97, 0.95, 0.50}, {1.00, 0.98, 0.78}};
static const double lowest = 2e-3, highest = 0.15;
static const double darkest_grey = 0.55;

/* Sets the colour of a daylight factor. Few greys can be distinguished, so a grey
 * depends only on the index of the area, not on the daylight factor. count: number of
 * areas. */
static void set_colour(cairo_t *cr, enum pp_plan_fill fill, double factor, int area,
                       int count)
{
    if (fill == PP_FILL_GREY) {
        double grey = count > 1 ? (double)area / (count - 1) : 1.0;
        pp_style_grey(cr, darkest_grey + grey * (1.0 - darkest_grey));
        return;
    }
    double at = log(fmax(factor, 1e-9) / lowest) / log(highest / lowest);
    at = fmin(fmax(at, 0.0), 1.0);
    int step = (int)fmin(floor(at * (STEPS - 1)), STEPS - 2);
    double share = at * (STEPS - 1) - step, rgb[3];
    for (int k = 0; k < 3; k++)
        rgb[k] = colours[step][k] + share * (colours[step + 1][k] - colours[step][k]);
    cairo_set_source_rgb(cr, rgb[0], rgb[1], rgb[2]);
}

enum { LEVELS_MOST = 64 };

/* Lists the levels of the contours, each once, ascending; returns their number. */
static int levels_of(double levels[LEVELS_MOST],
                     const struct pp_daylight_plan *daylight)
{
    const struct pp_curve_list *curves = &daylight->contours;
    int count = 0;
    for (int i = 0; i < curves->count && count < LEVELS_MOST; i++)
        if (count == 0 || curves->list[i].level != levels[count - 1])
            levels[count++] = curves->list[i].level;
    return count;
}

/* Daylight factor that represents the area between two levels: their geometric mean.
 * The lowest and highest area end at the lowest and highest value on the plane. */
static double level_of_area(const struct pp_daylight_plan *daylight,
                            const double *levels, int count, int area)
{
    double low = area > 0 ? levels[area - 1] : daylight->lowest;
    double high = area < count ? levels[area] : daylight->highest;
    return sqrt(fmax(low, 1e-6) * fmax(high, 1e-6));
}

void pp_plan_fill_draw(cairo_t *cr, const struct pp_room_plan *plan,
                       const struct pp_daylight_plan *daylight, enum pp_plan_fill fill)
{
    double levels[LEVELS_MOST];
    int count = levels_of(levels, daylight);
    if (fill == PP_FILL_NONE)
        return;
    set_colour(cr, fill, level_of_area(daylight, levels, count, count), count,
               count + 1);
    cairo_paint(cr);
    for (int k = count - 1; k >= 0; k--) {
        set_colour(cr, fill, level_of_area(daylight, levels, count, k), k, count + 1);
        for (int i = 0; i < daylight->below.count; i++)
            if (daylight->below.list[i].level == levels[k])
                pp_contour_lines_path(cr, plan, &daylight->below.list[i]);
        cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
        cairo_fill(cr);
    }
}

double pp_plan_fill_bar_mm(const struct pp_style *style)
{
    return 3.5 * style->scale + 1.6 * style->text[PP_TEXT_SMALL];
}

void pp_plan_fill_bar(cairo_t *cr, const struct pp_style *style,
                      const struct pp_daylight_plan *daylight, enum pp_plan_fill fill,
                      double x, double y, double width)
{
    double levels[LEVELS_MOST];
    int count = levels_of(levels, daylight);
    double wide = fmin(width / (count + 1), 12.0 * style->scale);
    double high = 3.5 * style->scale;
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5};
    for (int i = 0; i <= count; i++) {
        set_colour(cr, fill, level_of_area(daylight, levels, count, i), i, count + 1);
        cairo_rectangle(cr, x + i * wide, y, wide, high);
        cairo_fill_preserve(cr);
        pp_style_line(cr, style->hair, PP_INK);
        cairo_stroke(cr);
        if (i == count)
            break;
        char words[32];
        pp_style_level(words, sizeof words, levels[i]);
        pp_lettering_draw(cr, style, &set, x + (i + 1) * wide, y + high + 0.3, words);
    }
    set.across = 0.0;
    pp_lettering_draw(cr, style, &set, x + (count + 1) * wide + 1.0 * style->scale,
                      y + 0.5 * (high - style->text[PP_TEXT_SMALL]), "%");
}
