/* section_chart.c - lays out the sheet of the section chart and draws its curves, error
 * bars and level lines over the section.
 */
#include "charts/section/section_chart.h"

#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "charts/section/room_section.h"
#include "charts/section/section_names.h"
#include "charts/section/section_series.h"

/* If the ratio of the highest to the lowest value is larger, the scale is logarithmic;
 * on a linear scale the low values would lie on the axis. */
#define WIDE_RANGE 30.0

/* Value in per cent, with `errors` standard errors added. */
static double percent_of(const struct pp_reading *reading, double errors)
{
    double error = isfinite(reading->std_error) ? reading->std_error : 0.0;
    return 100.0 * (reading->value + errors * error);
}

static void range_of(const struct pp_section_plot *plot, double *low, double *high)
{
    *low = INFINITY;
    *high = 0.0;
    for (int i = 0; i < plot->series_count; i++) {
        const struct pp_column *column = plot->series[i].column;
        int count = column->points ? plot->report->receiver_count : 1;
        for (int k = 0; k < count; k++) {
            const struct pp_reading *reading =
                column->points ? &column->points[k] : &column->average;
            if (!isfinite(reading->value))
                continue;
            *high = fmax(*high, percent_of(reading, 1.0));
            if (reading->value > 0.0)
                *low = fmin(*low, percent_of(reading, 0.0));
        }
    }
}

/* ---- a smooth curve: the monotone piecewise cubic of Fritsch and Butland [FB84] ----
 *
 * Between two points the curve is the cubic that has the slope m at each end. With the
 * widths h0, h1 and slopes d0, d1 of the chords before and after a point,
 *
 *     m = 1 / (w / d0 + (1 - w) / d1)          d0 d1 > 0, else 0
 *     w = (h0 + 2 h1) / (3 (h0 + h1))
 *
 * At the first and last point m is the slope of the only chord.
 */

/* Slope at point i: the weighted harmonic mean of the slopes of both chords, or 0 at an
 * extremum. At the first and last point, the slope of the only chord. */
static double smooth_slope_at(const double (*xy)[2], int count, int i)
{
    int left = i > 0 ? i - 1 : 0, right = i + 1 < count ? i : count - 2;
    double h0 = xy[left + 1][0] - xy[left][0], h1 = xy[right + 1][0] - xy[right][0];
    double d0 = (xy[left + 1][1] - xy[left][1]) / h0;
    double d1 = (xy[right + 1][1] - xy[right][1]) / h1;
    if (!(d0 * d1 > 0.0))
        return 0.0;
    double w0 = (h0 + 2.0 * h1) / (3.0 * (h0 + h1)), w1 = 1.0 - w0;
    return 1.0 / (w0 / d0 + w1 / d1);
}

/* Adds cubics through the points to the path. The curve is smooth, and monotone
 * wherever the points are. The x of the points must be strictly ascending. count: 1 or
 * more; for 1 the path only moves to the point. */
static void smooth_path(cairo_t *cr, const double (*xy)[2], int count)
{
    cairo_move_to(cr, xy[0][0], xy[0][1]);
    for (int i = 0; i + 1 < count; i++) {
        double third = (xy[i + 1][0] - xy[i][0]) / 3.0;
        double m0 = smooth_slope_at(xy, count, i),
               m1 = smooth_slope_at(xy, count, i + 1);
        cairo_curve_to(cr, xy[i][0] + third, xy[i][1] + third * m0,
                       xy[i + 1][0] - third, xy[i + 1][1] - third * m1, xy[i + 1][0],
                       xy[i + 1][1]);
    }
}

/* ---- layout ---- */

static int compare_distances(const void *a, const void *b, void *distances)
{
    const double *distance = distances;
    double p = distance[*(const int *)a], q = distance[*(const int *)b];
    if (p != q)
        return p < q ? -1 : 1;
    return *(const int *)a - *(const int *)b;
}

static enum pp_status sort_points(struct pp_section_plot *plot, struct pp_error *err)
{
    int count = plot->report->receiver_count;
    plot->order = malloc((size_t)count * sizeof *plot->order);
    plot->distance = malloc((size_t)count * sizeof *plot->distance);
    plot->series =
        malloc((size_t)(plot->report->column_count + 1) * sizeof *plot->series);
    plot->labels = calloc(1, sizeof *plot->labels);
    if (!plot->order || !plot->distance || !plot->series || !plot->labels)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        plot->order[i] = i;
        plot->distance[i] =
            pp_section_cut_s(&plot->cut, plot->report->receivers[i].position);
    }
    qsort_r(plot->order, (size_t)count, sizeof *plot->order, compare_distances,
            plot->distance);
    return PP_OK;
}

/* Sets the axes along the lower and the left side of the field. */
static void lay_axes(struct pp_section_plot *plot, enum pp_section_scale scale)
{
    const struct pp_style *style = &plot->style;
    struct pp_box field = plot->field;
    double low, high;
    range_of(plot, &low, &high);
    double bottom = field.y + field.height, apart = 11.0 * style->scale;
    if (!(high > 0.0))
        high = 1.0;
    bool logarithmic =
        scale == PP_SCALE_LOG || (scale == PP_SCALE_AS_FITS && high > WIDE_RANGE * low);
    if (logarithmic && isfinite(low))
        plot->up =
            pp_axis_log(fmax(low, 1e-5 * high), high * 1.02, bottom, field.y, apart);
    else
        plot->up = pp_axis_linear(0.0, high, bottom, field.y, apart, true);
    plot->across = pp_axis_linear(0.0, plot->cut.length_m, field.x,
                                  field.x + field.width, 13.0 * style->scale, false);
}

/* ---- curves ---- */

/* Draws points first ... last of the order as one curve, which labels avoid. All of
 * them must have values. Points at equal distance are drawn once. */
static void draw_run(struct pp_section_plot *plot, int index, int first, int last)
{
    const struct pp_series *series = &plot->series[index];
    double(*xy)[2] = malloc((size_t)(last - first + 1) * sizeof *xy);
    int count = 0;
    if (!xy)
        pp_canvas_lacks_memory(plot->cr);
    for (int i = first; i <= last && xy; i++) {
        int point = plot->order[i];
        double x = pp_axis_at(&plot->across, plot->distance[point]);
        if (count && x - xy[count - 1][0] < 1e-6)
            continue;
        xy[count][0] = x;
        xy[count++][1] =
            pp_axis_at(&plot->up, percent_of(&series->column->points[point], 0.0));
    }
    if (count) {
        pp_style_pen(plot->cr, &plot->style, &series->look);
        smooth_path(plot->cr, (const double(*)[2])xy, count);
        pp_labels_note_path(plot->labels, plot->cr, index);
        cairo_stroke(plot->cr);
    }
    double next = -INFINITY;
    for (int i = 0; i < count; i++) {
        bool marked = series->key.kind == PP_KEY_MARKED_LINE || count == 1;
        if (!marked || xy[i][0] < next)
            continue;
        pp_style_marker(plot->cr, &plot->style, series->look.marker, xy[i][0],
                        xy[i][1]);
        pp_labels_note(plot->labels, index, xy[i][0], xy[i][1], xy[i][0], xy[i][1]);
        next = xy[i][0] + 5.0 * plot->style.scale;
    }
    free(xy);
}

static void draw_curve(struct pp_section_plot *plot, int index)
{
    const struct pp_reading *points = plot->series[index].column->points;
    int count = plot->report->receiver_count;
    for (int first = 0; first < count;) {
        int last = first;
        while (last < count && isfinite(points[plot->order[last]].value))
            last++;
        if (last > first)
            draw_run(plot, index, first, last - 1);
        first = last + 1;
    }
}

static void draw_samples(struct pp_section_plot *plot, int index)
{
    const struct pp_series *series = &plot->series[index];
    for (int i = 0; i < plot->report->receiver_count; i++) {
        const struct pp_reading *reading = &series->column->points[plot->order[i]];
        if (!isfinite(reading->value))
            continue;
        double x = pp_axis_at(&plot->across, plot->distance[plot->order[i]]);
        double y = pp_axis_at(&plot->up, percent_of(reading, 0.0));
        double low = pp_axis_at(&plot->up, percent_of(reading, -1.0));
        double high = pp_axis_at(&plot->up, percent_of(reading, 1.0));
        low = fmin(low, plot->field.y + plot->field.height);
        pp_legend_bar(plot->cr, &plot->style, series->look.marker, x, y, low, high);
        pp_labels_note(plot->labels, index, x, low, x, high);
        for (int side = -1; side <= 1; side += 2)
            pp_labels_note(plot->labels, index, x + 0.5 * side * plot->style.marker, y,
                           x + 0.5 * side * plot->style.marker, y);
    }
}

static void draw_level(struct pp_section_plot *plot, int index)
{
    const struct pp_series *series = &plot->series[index];
    double y = pp_axis_at(&plot->up, percent_of(&series->column->average, 0.0));
    pp_style_pen(plot->cr, &plot->style, &series->look);
    cairo_move_to(plot->cr, plot->across.from, y);
    cairo_line_to(plot->cr, plot->across.to, y);
    pp_labels_note_path(plot->labels, plot->cr, index);
    cairo_stroke(plot->cr);
}

static void say_nothing_there(struct pp_section_plot *plot)
{
    struct pp_lettering text = {.size = PP_TEXT_HEAD,
                                .grey = PP_GREY_TEXT,
                                .across = 0.5,
                                .down = 0.5,
                                .width = 0.9 * plot->field.width};
    pp_lettering_draw(
        plot->cr, &plot->style, &text, plot->field.x + 0.5 * plot->field.width,
        plot->field.y + 0.5 * plot->field.height, "No method gives a daylight factor.");
}

static void draw_plot(struct pp_section_plot *plot, struct pp_box aside)
{
    cairo_t *cr = plot->cr;
    const struct pp_style *style = &plot->style;
    double bottom = plot->field.y + plot->field.height;
    pp_axis_grid_across(cr, style, &plot->up, plot->across.from, plot->across.to);
    pp_axis_draw_up(cr, style, &plot->up, plot->field.x);
    double reach = pp_axis_draw_across(cr, style, &plot->across, bottom);

    struct pp_lettering title = {.size = PP_TEXT_BODY, .down = 1.0};
    pp_lettering_draw(cr, style, &title,
                      plot->field.x - pp_axis_reach(cr, style, &plot->up),
                      plot->field.y - 1.6 * style->scale, "Daylight factor (%)");
    title.down = 0.0;
    title.across = 1.0;
    pp_lettering_draw(cr, style, &title, plot->field.x + plot->field.width,
                      bottom + reach + 0.2 * style->scale,
                      plot->cut.near_window ? "Distance from the window wall (m)"
                                            : "Distance from the wall (m)");

    for (int kind = PP_LEVEL; kind >= PP_CURVE; kind--)
        for (int i = 0; i < plot->series_count; i++) {
            if ((int)plot->series[i].kind != kind)
                continue;
            if (kind == PP_LEVEL)
                draw_level(plot, i);
            else
                draw_curve(plot, i);
            if (kind == PP_SAMPLED)
                draw_samples(plot, i);
        }
    plot->labels->field = plot->field;
    if (plot->series_count == 0)
        say_nothing_there(plot);
    else if (plot->legend.columns == 0)
        pp_section_names_draw(plot, aside);
}

/* ---- the sheet ---- */

static void say_notes(struct pp_section_plot *plot,
                      const struct pp_section_chart *chart)
{
    pp_page_assumptions(plot->foot, sizeof plot->foot, chart->report->world,
                        &chart->report->light);
    for (int i = 0; i < chart->note_count; i++)
        if (chart->notes[i][0])
            pp_page_say(plot->foot, sizeof plot->foot, "%s", chart->notes[i]);
    if (!chart->report->finished)
        pp_page_say(plot->foot, sizeof plot->foot,
                    "The run was interrupted: simulated values are preliminary.");
}

static void draw_section_sheet(struct pp_section_plot *plot, struct pp_canvas *canvas,
                               const struct pp_section_chart *chart)
{
    const struct pp_world *world = chart->report->world;
    char sky[96], subtitle[256];
    pp_page_sky(sky, sizeof sky, world, &chart->report->light);
    snprintf(subtitle, sizeof subtitle,
             "Daylight factor against distance from the %s, %s",
             plot->cut.near_window ? "window" : "wall", sky);
    say_notes(plot, chart);
    struct pp_page page = {world->name, subtitle, plot->foot};
    struct pp_box body = pp_page_draw(canvas, &plot->style, &page);

    pp_section_names_fit_legend(plot, body.width);
    if (plot->legend.columns)
        body.height -= plot->legend.height + 4.0 * plot->style.scale;

    /* The section has the height that its scale requires. The curves are above the
     * section, at the same horizontal scale. */
    struct pp_style *style = &plot->style;
    struct pp_room_section section = {
        .world = world, .cut = &plot->cut, .report = chart->report, .named = true};
    double left = 16.0 * style->scale, right = 9.0 * style->scale;
    if (pp_room_section_has_outside(&section, true))
        left = 24.0 * style->scale;
    if (pp_room_section_has_outside(&section, false))
        right = 24.0 * style->scale;
    double between = 17.0 * style->scale;
    section.head_mm = 3.0 * style->scale;
    if (pp_room_section_has_outside(&section, true)
        || pp_room_section_has_outside(&section, false)) {
        section.head_mm = 16.0 * style->scale;
        between += 14.0 * style->scale;
    }
    pp_room_section_fit(&section, style, body.width - left - right,
                        0.5 * (body.height - between));
    /* Reserves height for the wells of rooflights, which extend above the room. */
    double wells = pp_section_frame_above_mm(&section) + style->scale - section.head_mm;
    section.head_mm += fmax(wells, 0.0);
    between += fmax(wells, 0.0);
    double width = plot->cut.length_m * section.mm_per_m;
    /* Uses any spare width for obstructions. */
    double spare = fmax(body.width - left - right - width, 0.0);
    if (pp_room_section_has_outside(&section, true))
        left += spare;
    else if (pp_room_section_has_outside(&section, false))
        right += spare;
    double title = 5.5 * style->scale;
    double high = body.height - title - between - section.height_mm;
    high = fmin(high, fmax(1.2 * width, 85.0 * style->scale));
    plot->field = (struct pp_box){body.x + left, body.y + title, width, high};

    /* The legend is beside the curves if a narrow room leaves enough width there;
     * otherwise in the curves' upper right corner. */
    double beside = body.x + body.width - (plot->field.x + width) - 5.0 * style->scale;
    struct pp_box aside = {plot->field.x + width + 5.0 * style->scale, plot->field.y,
                           beside, 0};
    if (beside < 34.0 * style->scale) {
        aside.width = fmin(62.0 * style->scale, 0.6 * width);
        aside.x = plot->field.x + width - aside.width;
    }
    lay_axes(plot, chart->scale);
    draw_plot(plot, aside);
    section.x = plot->field.x;
    section.y = plot->field.y + plot->field.height + between;
    section.left_mm = left;
    section.right_mm = right;
    section.most_x = body.x + body.width;
    pp_room_section_draw(plot->cr, style, &section);
    double below = section.y + section.height_mm + 4.0 * style->scale;
    for (int i = 0; i < plot->legend.columns; i++) {
        int first = i * plot->legend.rows, rest = plot->series_count - first;
        if (rest > 0)
            pp_section_names_draw_keys(
                plot, first, rest < plot->legend.rows ? rest : plot->legend.rows,
                body.x + i * plot->legend.wide, below, body.width);
    }
}

enum pp_status pp_section_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_section_chart *chart,
                                     struct pp_error *err)
{
    const struct pp_report *report = chart->report;
    struct pp_section_plot plot = {.cr = pp_canvas_cairo(canvas),
                                   .style = pp_page_style(canvas),
                                   .report = report};
    enum pp_status status = pp_section_cut_init(
        &plot.cut, report->world, report->receivers, report->receiver_count, err);
    if (status != PP_OK)
        return status;
    status = sort_points(&plot, err);
    if (status == PP_OK) {
        pp_section_series_choose(&plot);
        draw_section_sheet(&plot, canvas, chart);
    }
    pp_section_cut_clear(&plot.cut);
    free(plot.order);
    free(plot.distance);
    free(plot.series);
    free(plot.labels);
    return status;
}
