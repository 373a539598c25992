#include "charts/section_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/axes.h"
#include "charts/labels.h"
#include "charts/legend.h"
#include "charts/page.h"
#include "charts/room_section.h"
#include "charts/section_cut.h"
#include "charts/smooth.h"

/* One column of the report on the chart. */
struct series {
    const struct pp_column *column;
    enum { CURVE, SAMPLED, LEVEL } kind;
    struct pp_curve_style look;
    struct pp_key key;
};

/* More names than that go to a legend below the section; at most so many a column. */
enum { KEYS_INSIDE = 6, KEYS_MOST = 64 };

struct legend {
    int columns, rows; /* 0: there is none */
    double wide, height;
};

struct plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_report *report;
    struct pp_section_cut cut;
    struct pp_axis across, up;
    struct pp_box field; /* of the curves */
    int *order;          /* receivers by their distance */
    double *distance;    /* of each receiver */
    struct series *series;
    int series_count, curve_count;
    struct pp_labels *labels;
    struct legend legend;
    char foot[4096];
};

/* --- what there is to draw -----------------------------------------------------------
 */

static bool is_sampled(const struct pp_report *report, const struct pp_column *column)
{
    for (int i = 0; i < report->receiver_count; i++)
        if (isfinite(column->points[i].value) && isfinite(column->points[i].std_error))
            return true;
    return false;
}

static int values_in(const struct pp_report *report, const struct pp_column *column,
                     const char **why)
{
    int count = 0;
    *why = 0;
    for (int i = 0; i < report->receiver_count; i++) {
        if (isfinite(column->points[i].value))
            count++;
        else if (!*why)
            *why = column->points[i].why;
    }
    return count;
}

/* A column without all its values is accounted for at the foot. */
static void account(struct plot *plot, const struct pp_column *column, int count,
                    const char *why)
{
    int all = column->points ? plot->report->receiver_count : 1;
    if (count == all)
        return;
    char where[64] = "";
    if (column->points && count > 0)
        snprintf(where, sizeof where, " at %d of %d points", all - count, all);
    pp_page_say(plot->foot, sizeof plot->foot, "%s has no value%s%s%s.", column->name,
                where, why ? ": " : "", why ? why : "");
}

static void name_series(struct series *series)
{
    struct pp_key *key = &series->key;
    const struct pp_column *column = series->column;
    key->curve = series->look;
    key->grey = PP_INK;
    if (series->kind == SAMPLED) {
        key->kind = PP_KEY_SAMPLED;
        snprintf(key->words, sizeof key->words, "%s \u00b1 standard error",
                 column->name);
    } else if (series->kind == LEVEL) {
        char percent[32];
        pp_style_percent(percent, sizeof percent, column->average.value);
        key->kind = PP_KEY_LINE;
        snprintf(key->words, sizeof key->words, "%s, room average %s", column->name,
                 percent);
    } else {
        key->kind = PP_KEY_LINE;
        snprintf(key->words, sizeof key->words, "%s", column->name);
    }
}

/* Columns of daylight factors that have a value. Sampled ones are points with error
 * bars, the others lines; where these are more than four, they get markers too. */
static void choose_series(struct plot *plot)
{
    int lines = 0;
    for (int i = 0; i < plot->report->column_count; i++) {
        const struct pp_column *column = &plot->report->columns[i];
        if (column->component != PP_DF)
            continue;
        struct series *series = &plot->series[plot->series_count];
        *series = (struct series){.column = column, .kind = CURVE};
        const char *why = column->average.why;
        int count = isfinite(column->average.value);
        if (!column->points) {
            series->kind = LEVEL;
        } else {
            count = values_in(plot->report, column, &why);
            if (is_sampled(plot->report, column))
                series->kind = SAMPLED;
        }
        account(plot, column, count, why);
        if (count == 0)
            continue;
        series->look = series->kind == SAMPLED
                           ? (struct pp_curve_style){.marker = PP_CIRCLE}
                           : pp_style_curve(lines++);
        if (series->kind == LEVEL)
            series->look.weight *= 0.6;
        plot->curve_count += series->kind == CURVE;
        name_series(series);
        plot->series_count++;
    }
    for (int i = 0; i < plot->series_count; i++)
        if (plot->series[i].kind == CURVE && plot->curve_count > 4)
            plot->series[i].key.kind = PP_KEY_MARKED_LINE;
}

/* Per cent, with what the error bar adds (a sign) standard errors away. */
static double percent_of(const struct pp_reading *reading, double errors)
{
    double error = isfinite(reading->std_error) ? reading->std_error : 0.0;
    return 100.0 * (reading->value + errors * error);
}

static void range_of(const struct plot *plot, double *low, double *high)
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

/* --- layout --------------------------------------------------------------------------
 */

static int compare_distances(const void *a, const void *b, void *distances)
{
    const double *distance = distances;
    double p = distance[*(const int *)a], q = distance[*(const int *)b];
    if (p != q)
        return p < q ? -1 : 1;
    return *(const int *)a - *(const int *)b;
}

static enum pp_status sort_points(struct plot *plot, struct pp_error *err)
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

/* The axes: curves in `field` less what the labels of the upright axis take. */
static void lay_axes(struct plot *plot, bool logarithmic)
{
    const struct pp_style *style = &plot->style;
    struct pp_box field = plot->field;
    double low, high;
    range_of(plot, &low, &high);
    double bottom = field.y + field.height, apart = 11.0 * style->scale;
    if (!(high > 0.0))
        high = 1.0;
    if (logarithmic && isfinite(low))
        plot->up =
            pp_axis_log(fmax(low, 1e-5 * high), high * 1.02, bottom, field.y, apart);
    else
        plot->up = pp_axis_linear(0.0, high, bottom, field.y, apart, true);
    plot->across = pp_axis_linear(0.0, plot->cut.length_m, field.x,
                                  field.x + field.width, 13.0 * style->scale, false);
}

/* --- curves --------------------------------------------------------------------------
 */

/* Draws points first ... last of the order, which all have values, as one curve, and
 * notes where it runs. Points at one distance are drawn once. */
static void draw_run(struct plot *plot, int index, int first, int last)
{
    const struct series *series = &plot->series[index];
    double(*xy)[2] = malloc((size_t)(last - first + 1) * sizeof *xy);
    int count = 0;
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
        pp_smooth_path(plot->cr, (const double(*)[2])xy, count);
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

static void draw_curve(struct plot *plot, int index)
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

static void draw_samples(struct plot *plot, int index)
{
    const struct series *series = &plot->series[index];
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

static void draw_level(struct plot *plot, int index)
{
    const struct series *series = &plot->series[index];
    double y = pp_axis_at(&plot->up, percent_of(&series->column->average, 0.0));
    pp_style_pen(plot->cr, &plot->style, &series->look);
    cairo_move_to(plot->cr, plot->across.from, y);
    cairo_line_to(plot->cr, plot->across.to, y);
    pp_labels_note_path(plot->labels, plot->cr, index);
    cairo_stroke(plot->cr);
}

/* --- words ---------------------------------------------------------------------------
 */

/* A curve's name has a sample of its line with it, since curves may lie on each other;
 * the others stand next to what they name. */
static struct pp_box draw_name(struct plot *plot, const struct series *series, double x,
                               double y, bool drawn)
{
    const struct pp_text text = {.size = PP_TEXT_BODY};
    double wide = plot->field.width;
    if (series->kind == CURVE)
        return (drawn ? pp_legend_draw : pp_legend_measure)(
            plot->cr, &plot->style, &series->key, 1, x, y, wide);
    return (drawn ? pp_text_draw : pp_text_measure)(plot->cr, &plot->style, &text, x, y,
                                                    series->key.words);
}

/* A legend of some of the names, on white. */
static void draw_keys(struct plot *plot, int first, int count, double x, double y,
                      double width)
{
    struct pp_key keys[KEYS_MOST];
    for (int i = 0; i < count; i++)
        keys[i] = plot->series[first + i].key;
    struct pp_box box =
        pp_legend_measure(plot->cr, &plot->style, keys, count, x, y, width);
    pp_style_grey(plot->cr, 1.0);
    cairo_rectangle(plot->cr, box.x - 1.0, box.y, box.width + 2.0, box.height);
    cairo_fill(plot->cr);
    pp_legend_draw(plot->cr, &plot->style, keys, count, x, y, width);
}

/* The columns that the legend needs at the foot of the body, and their size. */
static void lay_legend(struct plot *plot, double width)
{
    struct legend *legend = &plot->legend;
    legend->columns = 0;
    legend->height = 0.0;
    if (plot->series_count <= KEYS_INSIDE)
        return;
    double gap = 5.0 * plot->style.scale, row = 0.0;
    legend->wide = 0.0;
    for (int i = 0; i < plot->series_count; i++) {
        struct pp_box box = pp_legend_measure(plot->cr, &plot->style,
                                              &plot->series[i].key, 1, 0, 0, width);
        legend->wide = fmax(legend->wide, box.width + gap);
        row = fmax(row, box.height + 0.7 * plot->style.scale);
    }
    legend->columns = (int)fmax(1.0, floor((width + gap) / legend->wide));
    legend->rows = (plot->series_count + legend->columns - 1) / legend->columns;
    legend->rows = legend->rows < KEYS_MOST ? legend->rows : KEYS_MOST;
    legend->height = legend->rows * row;
}

/* In the field's emptiest corner, or beside it. */
static void draw_legend_inside(struct plot *plot, struct pp_box aside)
{
    struct pp_box field = plot->field;
    struct pp_key keys[KEYS_INSIDE];
    for (int i = 0; i < plot->series_count; i++)
        keys[i] = plot->series[i].key;
    struct pp_box size = pp_legend_measure(plot->cr, &plot->style, keys,
                                           plot->series_count, 0, 0, aside.width);
    double pad = 1.5 * plot->style.scale;
    double left = field.x + pad, right = field.x + field.width - size.width - pad;
    double top = field.y + pad, bottom = field.y + field.height - size.height - pad;
    const double corners[][2] = {
        {right, top}, {left, bottom}, {left, top}, {right, bottom}};
    for (int i = 0; i < 4 && aside.x < field.x + field.width; i++) {
        struct pp_box box = {corners[i][0], corners[i][1], size.width, size.height};
        if (pp_labels_is_free(plot->labels, box)) {
            aside.x = box.x;
            aside.y = box.y;
            break;
        }
    }
    draw_keys(plot, 0, plot->series_count, aside.x, aside.y, aside.width);
}

/* Names next to the curves where there is room for all, else a legend. */
static void name_curves(struct plot *plot, struct pp_box aside)
{
    struct pp_labels *labels = plot->labels;
    struct pp_box boxes[KEYS_INSIDE];
    double anchors[KEYS_INSIDE][2];
    int count = plot->series_count, before = labels->count;
    bool all = true;
    for (int i = 0; i < count && all; i++) {
        struct pp_box size = draw_name(plot, &plot->series[i], 0, 0, false);
        all = pp_labels_find(labels, &plot->style, size.width, size.height, i,
                             &boxes[i], anchors[i]);
        if (all)
            pp_labels_note_box(labels, boxes[i]);
    }
    for (int i = 0; i < count && all; i++) {
        pp_style_grey(plot->cr, 1.0);
        cairo_rectangle(plot->cr, boxes[i].x, boxes[i].y, boxes[i].width,
                        boxes[i].height);
        cairo_fill(plot->cr);
        pp_labels_lead(plot->cr, &plot->style, boxes[i], anchors[i]);
        draw_name(plot, &plot->series[i], boxes[i].x, boxes[i].y, true);
    }
    if (all)
        return;
    labels->count = before;
    draw_legend_inside(plot, aside);
}

static void say_nothing_there(struct plot *plot)
{
    struct pp_text text = {.size = PP_TEXT_HEAD,
                           .grey = PP_GREY_TEXT,
                           .across = 0.5,
                           .down = 0.5,
                           .width = 0.9 * plot->field.width};
    pp_text_draw(plot->cr, &plot->style, &text, plot->field.x + 0.5 * plot->field.width,
                 plot->field.y + 0.5 * plot->field.height,
                 "There are no daylight factors to draw.");
}

static void draw_plot(struct plot *plot, struct pp_box aside)
{
    cairo_t *cr = plot->cr;
    const struct pp_style *style = &plot->style;
    double bottom = plot->field.y + plot->field.height;
    pp_axis_grid_across(cr, style, &plot->up, plot->across.from, plot->across.to);
    pp_axis_draw_up(cr, style, &plot->up, plot->field.x);
    double reach = pp_axis_draw_across(cr, style, &plot->across, bottom);

    struct pp_text title = {.size = PP_TEXT_BODY, .down = 1.0};
    pp_text_draw(cr, style, &title, plot->field.x - pp_axis_reach(cr, style, &plot->up),
                 plot->field.y - 1.6 * style->scale, "Daylight factor (%)");
    title.down = 0.0;
    title.across = 1.0;
    pp_text_draw(cr, style, &title, plot->field.x + plot->field.width,
                 bottom + reach + 0.2 * style->scale,
                 plot->cut.near_window ? "Distance from the window wall (m)"
                                       : "Distance from the wall (m)");

    for (int kind = LEVEL; kind >= CURVE; kind--)
        for (int i = 0; i < plot->series_count; i++) {
            if ((int)plot->series[i].kind != kind)
                continue;
            if (kind == LEVEL)
                draw_level(plot, i);
            else if (kind == SAMPLED)
                draw_samples(plot, i);
            else
                draw_curve(plot, i);
        }
    plot->labels->field = plot->field;
    if (plot->series_count == 0)
        say_nothing_there(plot);
    else if (plot->legend.columns == 0)
        name_curves(plot, aside);
}

/* --- the sheet -----------------------------------------------------------------------
 */

bool pp_section_chart_landscape(const struct pp_section_chart *chart)
{
    const struct pp_report *report = chart->report;
    struct pp_section_cut cut;
    if (pp_section_cut_create(&cut, report->world, report->receivers,
                              report->receiver_count, 0)
        != PP_OK)
        return true;
    bool landscape = cut.length_m > 4.5 * report->world->height_m;
    pp_section_cut_clear(&cut);
    return landscape;
}

static void say_notes(struct plot *plot, const struct pp_section_chart *chart)
{
    pp_page_assumptions(plot->foot, sizeof plot->foot, chart->report->world);
    for (int i = 0; i < chart->note_count; i++)
        pp_page_say(plot->foot, sizeof plot->foot, "%s", chart->notes[i]);
    if (!chart->report->finished)
        pp_page_say(plot->foot, sizeof plot->foot,
                    "The run was interrupted: sampled values are what was there so "
                    "far.");
}

static void draw_sheet(struct plot *plot, struct pp_canvas *canvas,
                       const struct pp_section_chart *chart)
{
    const struct pp_world *world = chart->report->world;
    char sky[96], subtitle[256];
    pp_page_sky(sky, sizeof sky, world);
    snprintf(subtitle, sizeof subtitle,
             "Daylight factor against distance from the %s, %s",
             plot->cut.near_window ? "window" : "wall", sky);
    say_notes(plot, chart);
    struct pp_page page = {world->name, subtitle, plot->foot};
    struct pp_box body = pp_page_draw(canvas, &plot->style, &page);

    lay_legend(plot, body.width);
    if (plot->legend.columns)
        body.height -= plot->legend.height + 4.0 * plot->style.scale;

    /* The section takes what its scale needs; the curves stand above it to the same
     * scale across. */
    struct pp_style *style = &plot->style;
    struct pp_room_section section = {
        .world = world, .cut = &plot->cut, .report = chart->report};
    double left = 16.0 * style->scale, right = 3.0 * style->scale;
    if (pp_room_section_has_outside(&section, true))
        left = 24.0 * style->scale;
    if (pp_room_section_has_outside(&section, false))
        right = 24.0 * style->scale;
    double between = 17.0 * style->scale;
    pp_room_section_fit(&section, style, body.width - left - right,
                        0.5 * (body.height - between));
    double width = plot->cut.length_m * section.mm_per_m;
    double title = 5.5 * style->scale;
    double high = body.height - title - between - section.height_mm;
    high = fmin(high, fmax(0.8 * width, 85.0 * style->scale));
    plot->field = (struct pp_box){body.x + left, body.y + title, width, high};

    /* A narrow room leaves a strip beside the curves for a legend; a wide one has it in
     * the curves' upper right corner. */
    double beside = body.x + body.width - (plot->field.x + width) - 5.0 * style->scale;
    struct pp_box aside = {plot->field.x + width + 5.0 * style->scale, plot->field.y,
                           beside, 0};
    if (beside < 34.0 * style->scale) {
        aside.width = fmin(62.0 * style->scale, 0.6 * width);
        aside.x = plot->field.x + width - aside.width;
    }
    lay_axes(plot, chart->logarithmic);
    draw_plot(plot, aside);
    section.x = plot->field.x;
    section.y = plot->field.y + plot->field.height + between;
    section.left_mm = left;
    section.right_mm = right;
    pp_room_section_draw(plot->cr, style, &section);
    double below = section.y + section.height_mm + 4.0 * style->scale;
    for (int i = 0; i < plot->legend.columns; i++) {
        int first = i * plot->legend.rows, rest = plot->series_count - first;
        if (rest > 0)
            draw_keys(plot, first, rest < plot->legend.rows ? rest : plot->legend.rows,
                      body.x + i * plot->legend.wide, below, body.width);
    }
}

enum pp_status pp_section_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_section_chart *chart,
                                     struct pp_error *err)
{
    const struct pp_report *report = chart->report;
    struct plot plot = {.cr = pp_canvas_cairo(canvas),
                        .style = pp_page_style(canvas),
                        .report = report};
    enum pp_status status = pp_section_cut_create(
        &plot.cut, report->world, report->receivers, report->receiver_count, err);
    if (status != PP_OK)
        return status;
    status = sort_points(&plot, err);
    if (status == PP_OK) {
        choose_series(&plot);
        draw_sheet(&plot, canvas, chart);
    }
    pp_section_cut_clear(&plot.cut);
    free(plot.order);
    free(plot.distance);
    free(plot.series);
    free(plot.labels);
    return status;
}
