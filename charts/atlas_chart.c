/* atlas_chart.c - see atlas_chart.h. */
#include "charts/atlas_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/sheet/axis.h"
#include "charts/sheet/legend.h"
#include "charts/sheet/hatch.h"
#include "charts/sheet/page.h"

struct atlas_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_atlas_map *map;
    struct pp_box field;
    struct pp_axis up; /* vertical axis of ratios, in maps by one feature */
};

/* ---- edges of classes ---- */

/* Position of the lower edge of class k along the scale, 0 to 1. All classes are drawn
 * equally wide. */
static double edge_at(const struct pp_atlas_scale *scale, int k)
{
    return (double)k / scale->count;
}

static double across_at(const struct atlas_plot *plot, double share)
{
    return plot->field.x + share * plot->field.width;
}

static double up_at(const struct atlas_plot *plot, double share)
{
    return plot->field.y + (1.0 - share) * plot->field.height;
}

static void edge_words(char *words, size_t room, const struct pp_atlas_scale *scale,
                       int k)
{
    if (isfinite(scale->edges[k]))
        snprintf(words, room, "%g", scale->edges[k]);
    else
        snprintf(words, room, "more");
}

/* Draws ticks, numbers and name of the scale below the field. */
static void draw_across_scale(struct atlas_plot *plot)
{
    const struct pp_style *style = &plot->style;
    const struct pp_atlas_scale *scale = &plot->map->across;
    double bottom = plot->field.y + plot->field.height, tick = 1.2 * style->scale;
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = 0.5};
    char words[32];
    struct pp_box box = {0};
    for (int k = 0; k <= scale->count; k++) {
        double x = across_at(plot, edge_at(scale, k));
        pp_style_line(plot->cr, style->thin, PP_INK);
        cairo_move_to(plot->cr, x, bottom);
        cairo_line_to(plot->cr, x, bottom + tick);
        cairo_stroke(plot->cr);
        edge_words(words, sizeof words, scale, k);
        box = pp_lettering_draw(plot->cr, style, &text, x,
                                bottom + tick + 0.4 * style->scale, words);
    }
    text = (struct pp_lettering){.size = PP_TEXT_BODY, .across = 1.0};
    pp_lettering_draw(plot->cr, style, &text, plot->field.x + plot->field.width,
                      box.y + box.height + 0.8 * style->scale, scale->words);
}

static void draw_up_scale(struct atlas_plot *plot)
{
    const struct pp_style *style = &plot->style;
    const struct pp_atlas_scale *scale = &plot->map->up;
    double tick = 1.2 * style->scale;
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = 1.0, .down = 0.5};
    char words[32];
    for (int k = 0; k <= scale->count; k++) {
        double y = up_at(plot, edge_at(scale, k));
        pp_style_line(plot->cr, style->thin, PP_INK);
        cairo_move_to(plot->cr, plot->field.x - tick, y);
        cairo_line_to(plot->cr, plot->field.x, y);
        cairo_stroke(plot->cr);
        edge_words(words, sizeof words, scale, k);
        pp_lettering_draw(plot->cr, style, &text,
                          plot->field.x - tick - 0.6 * style->scale, y, words);
    }
}

/* Draws the title of the vertical axis, at the left above the field. */
static void draw_up_title(struct atlas_plot *plot, const char *words)
{
    struct pp_lettering text = {.size = PP_TEXT_BODY, .down = 1.0};
    pp_lettering_draw(plot->cr, &plot->style, &text,
                      plot->field.x - 8.0 * plot->style.scale,
                      plot->field.y - 4.5 * plot->style.scale, words);
}

static void draw_frame(struct atlas_plot *plot)
{
    pp_style_line(plot->cr, plot->style.thin, PP_INK);
    cairo_rectangle(plot->cr, plot->field.x, plot->field.y, plot->field.width,
                    plot->field.height);
    cairo_stroke(plot->cr);
}

/* ---- a map by one feature ---- */

/* Limits of the scales of ratios; values beyond them are drawn at the edge. */
static const double least_ratio = 0.01, most_ratio = 100.0;

/* Returns an axis that covers all quantiles within the limits above. */
static struct pp_axis ratio_axis(const struct atlas_plot *plot)
{
    double low = 0.8, high = 1.25;
    for (int k = 0; k < plot->map->across.count; k++) {
        const struct pp_atlas_quantiles *both[] = {&plot->map->real[k],
                                                   &plot->map->own[k]};
        for (int i = 0; i < 2; i++)
            if (isfinite(both[i]->median)) {
                low = fmin(low, both[i]->low);
                high = fmax(high, both[i]->high);
            }
    }
    return pp_axis_log(fmax(low, least_ratio), fmin(high, most_ratio),
                       plot->field.y + plot->field.height, plot->field.y,
                       6.0 * plot->style.scale);
}

static double ratio_at(const struct atlas_plot *plot, double ratio)
{
    return pp_axis_at(&plot->up, fmin(fmax(ratio, plot->up.low), plot->up.high));
}

static void draw_bar(struct atlas_plot *plot, const struct pp_atlas_quantiles *cell,
                     enum pp_marker marker, double x)
{
    if (isfinite(cell->median))
        pp_legend_bar(plot->cr, &plot->style, marker, x, ratio_at(plot, cell->median),
                      ratio_at(plot, cell->low), ratio_at(plot, cell->high));
}

static void draw_classes(struct atlas_plot *plot)
{
    const struct pp_style *style = &plot->style;
    struct pp_lettering text = {
        .size = PP_TEXT_SMALL, .across = 0.5, .down = 1.0, .grey = PP_GREY_TEXT};
    int count = plot->map->across.count;
    double width = plot->field.width / count;
    char words[32];
    for (int k = 0; k < count; k++) {
        double x = plot->field.x + k * width;
        bool own = isfinite(plot->map->own[k].median);
        draw_bar(plot, &plot->map->real[k], PP_DISC, x + (own ? 0.36 : 0.5) * width);
        draw_bar(plot, &plot->map->own[k], PP_CIRCLE, x + 0.64 * width);
        snprintf(words, sizeof words, "%d", plot->map->real[k].rooms);
        pp_lettering_draw(plot->cr, style, &text, x + 0.5 * width,
                          plot->field.y - 0.6 * style->scale, words);
    }
}

static bool has_own(const struct pp_atlas_map *map)
{
    for (int i = 0; i < PP_ATLAS_CELLS; i++)
        if (isfinite(map->own[i].median))
            return true;
    return false;
}

/* Draws the keys above the field, at its right. */
static void draw_keys(struct atlas_plot *plot)
{
    const struct pp_style *style = &plot->style;
    struct pp_key keys[2] = {
        {.kind = PP_KEY_SAMPLED,
         .curve.marker = PP_DISC,
         .words = "in the actual room: errors of assumption and formula"},
        {.kind = PP_KEY_SAMPLED,
         .curve.marker = PP_CIRCLE,
         .words = "in the room that the method assumes: error of the formula"}};
    int count = has_own(plot->map) ? 2 : 1;
    double width = 0.7 * plot->field.width;
    struct pp_box size =
        pp_legend_measure(plot->cr, style, keys, count, 0.0, 0.0, width);
    pp_legend_draw(plot->cr, style, keys, count,
                   plot->field.x + plot->field.width - size.width,
                   plot->field.y - size.height - 4.0 * style->scale, width);
}

static void draw_by_one(struct atlas_plot *plot)
{
    const struct pp_style *style = &plot->style;
    plot->up = ratio_axis(plot);
    double left = plot->field.x, right = plot->field.x + plot->field.width;
    pp_axis_grid_across(plot->cr, style, &plot->up, left, right);
    pp_axis_draw_up(plot->cr, style, &plot->up, left);
    pp_style_line(plot->cr, style->medium, PP_INK);
    cairo_move_to(plot->cr, left, ratio_at(plot, 1.0));
    cairo_line_to(plot->cr, right, ratio_at(plot, 1.0));
    cairo_stroke(plot->cr);
    draw_classes(plot);
    draw_frame(plot);
    draw_keys(plot);
    draw_up_title(plot, "Method divided by simulation");
}

/* ---- a map by two features ---- */

/* Appearance of a cell whose ratio is below up_to: grey level, or spacing of the
 * hatching lines (mm on A4). From 0.83 to 1.2 the hand calculation is considered right,
 * and the cell stays white. */
static const struct {
    double up_to, grey, hatch_mm;
    const char *words;
} looks[] = {
    {0.5, 1.0, 0.7, "under 0.5"},     {0.67, 1.0, 1.2, "0.5 to 0.67"},
    {0.83, 1.0, 2.4, "0.67 to 0.83"}, {1.2, 1.0, 0.0, "0.83 to 1.2"},
    {1.5, 0.86, 0.0, "1.2 to 1.5"},   {2.0, 0.72, 0.0, "1.5 to 2"},
    {3.0, 0.56, 0.0, "2 to 3"},       {INFINITY, 0.38, 0.0, "over 3"},
};
enum { LOOKS = sizeof looks / sizeof looks[0] };

static int look_of(double ratio)
{
    int k = 0;
    while (k + 1 < LOOKS && ratio >= looks[k].up_to)
        k++;
    return k;
}

static void draw_look(struct atlas_plot *plot, struct pp_box box, int look)
{
    pp_style_grey(plot->cr, looks[look].grey);
    cairo_rectangle(plot->cr, box.x, box.y, box.width, box.height);
    cairo_fill(plot->cr);
    if (looks[look].hatch_mm > 0.0) {
        cairo_rectangle(plot->cr, box.x, box.y, box.width, box.height);
        pp_hatch_path(plot->cr, box, looks[look].hatch_mm * plot->style.scale,
                      plot->style.thin, PP_GREY_LINE);
    }
    pp_style_line(plot->cr, plot->style.hair, PP_GREY_LINE);
    cairo_rectangle(plot->cr, box.x, box.y, box.width, box.height);
    cairo_stroke(plot->cr);
}

static void draw_cell(struct atlas_plot *plot, struct pp_box box,
                      const struct pp_atlas_quantiles *cell)
{
    double middle = box.x + 0.5 * box.width, line = box.y + 0.55 * box.height;
    struct pp_lettering text = {
        .size = PP_TEXT_BODY, .bold = true, .across = 0.5, .down = 1.0};
    struct pp_lettering small = {.size = PP_TEXT_SMALL, .across = 0.5};
    char words[32];
    if (cell->rooms == 0)
        return;
    if (isfinite(cell->median)) {
        draw_look(plot, box, look_of(cell->median));
        snprintf(words, sizeof words, "%.2f", cell->median);
        pp_lettering_draw_on_white(plot->cr, &plot->style, &text, middle, line, words);
    }
    snprintf(words, sizeof words, "%d", cell->rooms);
    pp_lettering_draw_on_white(plot->cr, &plot->style, &small, middle, line, words);
}

static void draw_cells(struct atlas_plot *plot)
{
    const struct pp_atlas_map *map = plot->map;
    double width = plot->field.width / map->across.count;
    double height = plot->field.height / map->up.count;
    for (int u = 0; u < map->up.count; u++)
        for (int a = 0; a < map->across.count; a++)
            draw_cell(plot,
                      (struct pp_box){plot->field.x + a * width,
                                      up_at(plot, edge_at(&map->up, u + 1)), width,
                                      height},
                      &map->real[u * PP_ATLAS_CLASSES + a]);
}

/* Draws a sample of each appearance in a row above the field, with the limits below. */
static void draw_looks(struct atlas_plot *plot)
{
    const struct pp_style *style = &plot->style;
    double width = plot->field.width / LOOKS, height = 3.5 * style->scale;
    double y = plot->field.y - 18.0 * style->scale;
    struct pp_lettering text = {.size = PP_TEXT_SMALL, .across = 0.5};
    for (int k = 0; k < LOOKS; k++) {
        struct pp_box box = {plot->field.x + k * width, y, width, height};
        draw_look(plot, box, k);
        pp_lettering_draw(plot->cr, style, &text, box.x + 0.5 * width,
                          y + height + 0.4 * style->scale, looks[k].words);
    }
}

static void draw_by_two(struct atlas_plot *plot)
{
    draw_cells(plot);
    draw_frame(plot);
    draw_looks(plot);
    draw_up_scale(plot);
    draw_up_title(plot, plot->map->up.words);
}

/* ---- the sheet ---- */

/* True if any value is beyond the scale of a map by one feature. */
static bool is_beyond(const struct pp_atlas_map *map)
{
    for (int k = 0; k < map->across.count; k++)
        if (fmin(map->real[k].low, map->own[k].low) < least_ratio
            || fmax(map->real[k].high, map->own[k].high) > most_ratio)
            return true;
    return false;
}

static void say_notes(char *foot, size_t room, const struct pp_atlas_map *map)
{
    pp_page_say(foot, room,
                "%s of %d rooms of the atlas; a ratio of 1 means agreement "
                "with the simulation.",
                map->averages ? "Averages" : "At the points", map->rooms);
    pp_page_say(
        foot, room,
        map->up.count > 1
            ? "Each cell shows the median, with the number of rooms below it. No "
              "median is shown for fewer than %d rooms."
            : "Bars show medians; whiskers show the range from the 5 %% to the 95 %% "
              "quantile. The number of rooms is above each bar. Nothing is drawn for "
              "fewer than %d rooms.",
        PP_ATLAS_ENOUGH);
    if (map->up.count == 1 && is_beyond(map))
        pp_page_say(foot, room, "Values outside %g to %g are drawn at the edge.",
                    least_ratio, most_ratio);
    if (!map->averages)
        pp_page_say(foot, room,
                    "Points of one room in the same class count as one point.");
    if (map->blind)
        pp_page_say(foot, room,
                    "%d values are ignored, because the simulated value is 0 or "
                    "uncertain by more than 10 %%.",
                    map->blind);
}

enum pp_status pp_atlas_chart_draw(struct pp_canvas *canvas,
                                   const struct pp_atlas_map *map, struct pp_error *err)
{
    (void)err;
    struct atlas_plot plot = {
        .cr = pp_canvas_cairo(canvas), .style = pp_page_style(canvas), .map = map};
    char title[96], foot[1024] = "";
    snprintf(title, sizeof title, "Error of %.80s", map->column);
    say_notes(foot, sizeof foot, map);
    const struct pp_page page = {
        title, "Ratio of the method's value to the simulated value", foot};
    struct pp_box body = pp_page_draw(canvas, &plot.style, &page);
    bool by_two = map->up.count > 1;
    double unit = plot.style.scale, left = 12.0 * unit, right = 5.0 * unit;
    double above = (by_two ? 20.0 : 17.0) * unit, below = 12.0 * unit;
    plot.field =
        (struct pp_box){body.x + left, body.y + above, body.width - left - right,
                        body.height - above - below};
    if (by_two)
        draw_by_two(&plot);
    else
        draw_by_one(&plot);
    draw_across_scale(&plot);
    return PP_OK;
}
