/* availability_chart.c - see availability_chart.h. */
#include "charts/availability_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/sheet/axis.h"
#include "charts/sheet/labels.h"
#include "charts/sheet/legend.h"
#include "charts/sheet/page.h"

struct availability_plot {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_availability_sheet *sheet;
    const struct pp_availability_row *rows; /* rows of the place and method drawn */
    int row_count;                          /* 0: no illuminances inside are drawn */
    char place[64];                         /* "on average", "at 1.50, 2.00 m" */
    struct pp_axis across, up;
    struct pp_box field;
    struct pp_labels *labels;
    char foot[4096];
};

/* ---- choice of rows ---- */

/* Chooses the rows to be drawn: the rows of the first method with a value, at the point
 * if there is only one, else for the average. */
static void choose_rows(struct availability_plot *plot)
{
    const struct pp_availability_sheet *sheet = plot->sheet;
    const struct pp_report *report = sheet->report;
    if (!report)
        return;
    bool point = report->receiver_count == 1;
    int place = point ? 0 : PP_PLACE_AVERAGE;
    for (int i = 0; i < sheet->row_count && !plot->rows; i++)
        if (sheet->rows[i].place == place && isfinite(sheet->rows[i].df.value))
            plot->rows = &sheet->rows[i];
    if (plot->rows)
        plot->row_count = sheet->illuminance_count;
    snprintf(plot->place, sizeof plot->place, "on average");
    if (point)
        snprintf(plot->place, sizeof plot->place, "at %.2f, %.2f m",
                 report->receivers[0].position.x, report->receivers[0].position.y);
}

/* Upper end of the illuminance scale (lx), exceeded in at most 1 of 200 hours of any
 * period. If the scale included the brightest hour, the curves would be compressed. */
static double top_lx(const struct pp_availability_sheet *sheet)
{
    double top = 1000.0;
    for (int i = 0; i < sheet->period_count; i++) {
        const struct pp_availability_period *period = &sheet->periods[i];
        int k = 0;
        while (k + 1 < period->count && period->share[k] < 0.005)
            k++;
        top = fmax(top, period->lx[k]);
    }
    return top;
}

/* ---- words ---- */

/* Rounds to three significant figures, or to 1 lx below 100 lx; a curve cannot be read
 * more precisely. */
static double three_figures(double lx)
{
    double unit = pow(10.0, fmax(0.0, floor(log10(lx)) - 2.0));
    return round(lx / unit) * unit;
}

static void say_rows(struct availability_plot *plot)
{
    const struct pp_availability_sheet *sheet = plot->sheet;
    char percent[32];
    if (sheet->report && plot->row_count == 0)
        pp_page_say(
            plot->foot, sizeof plot->foot, "No daylight factor is available %s%s%s.",
            plot->place, sheet->row_count && sheet->rows[0].df.why ? ": " : "",
            sheet->row_count && sheet->rows[0].df.why ? sheet->rows[0].df.why : "");
    for (int i = 0; i < plot->row_count; i++) {
        const struct pp_availability_row *row = &plot->rows[i];
        pp_style_percent(percent, sizeof percent, row->df.value);
        if (!isfinite(row->needs_lx)) {
            pp_page_say(plot->foot, sizeof plot->foot,
                        "The daylight factor is 0, so %g lx is never reached %s.",
                        row->lx, plot->place);
            continue;
        }
        pp_page_say(
            plot->foot, sizeof plot->foot,
            "%g lx %s (daylight factor %s, %s) requires an external illuminance of "
            "%.0f lx, which is reached in:",
            row->lx, plot->place, percent, row->method, three_figures(row->needs_lx));
        for (int k = 0; k < sheet->period_count; k++)
            pp_page_say(plot->foot, sizeof plot->foot, "%.0f %% of %s%s",
                        100.0 * row->share[k], sheet->periods[k].words,
                        k + 1 < sheet->period_count ? "," : ".\n");
    }
}

static void say_notes(struct availability_plot *plot)
{
    const struct pp_availability_sheet *sheet = plot->sheet;
    say_rows(plot);
    pp_page_say(plot->foot, sizeof plot->foot,
                "External illuminance: %s. Working hours: %s.", sheet->light,
                sheet->calendar);
    if (isfinite(sheet->median_lx))
        pp_page_say(plot->foot, sizeof plot->foot,
                    "Median diffuse illuminance of the brightest 4380 hours of the "
                    "year: %.0f lx.",
                    sheet->median_lx);
    for (int i = 0; i < sheet->period_count; i++)
        if (sheet->periods[i].missing_h > 0.0)
            pp_page_say(plot->foot, sizeof plot->foot,
                        "%.0f hours in the period %s have no data and are ignored.",
                        sheet->periods[i].missing_h, sheet->periods[i].words);
    pp_page_say(plot->foot, sizeof plot->foot, "Sunlight is not included.");
    if (sheet->report && !sheet->report->finished)
        pp_page_say(plot->foot, sizeof plot->foot,
                    "The run was interrupted: simulated values are preliminary.");
}

/* ---- curves ---- */

/* Position on paper (y, mm) of a fraction of the hours. */
static double up_at(const struct availability_plot *plot, double share)
{
    return pp_axis_at(&plot->up, 100.0 * share);
}

/* Draws a curve as steps, from 0 lx to the brightest hour or the end of the scale.
 * Steps too small to be visible are omitted. */
static void draw_curve(struct availability_plot *plot, int index)
{
    const struct pp_availability_period *period = &plot->sheet->periods[index];
    const struct pp_curve_style look = pp_style_curve(index);
    double step = 0.08, x = plot->across.from, y = up_at(plot, period->light);
    cairo_move_to(plot->cr, x, y);
    for (int i = period->count - 1; i >= 0; i--) {
        if (period->lx[i] <= 0.0)
            continue;
        bool past = period->lx[i] > plot->across.high;
        double next_x =
            pp_axis_at(&plot->across, fmin(period->lx[i], plot->across.high));
        double next_y = up_at(plot, i > 0 ? period->share[i - 1] : 0.0);
        if (!past && i > 0 && next_x - x < step && next_y - y < step)
            continue;
        cairo_line_to(plot->cr, next_x, y);
        if (past)
            break;
        cairo_line_to(plot->cr, next_x, next_y);
        x = next_x;
        y = next_y;
    }
    pp_style_pen(plot->cr, &plot->style, &look);
    pp_labels_note_path(plot->labels, plot->cr, index);
    cairo_stroke(plot->cr);
}

static struct pp_key key_of(const struct availability_plot *plot, int index)
{
    const struct pp_availability_period *period = &plot->sheet->periods[index];
    struct pp_key key = {
        .kind = PP_KEY_LINE, .curve = pp_style_curve(index), .grey = PP_INK};
    snprintf(key.words, sizeof key.words, "%s (%.0f h)", period->words, period->hours);
    return key;
}

static void clear_box(struct availability_plot *plot, struct pp_box box)
{
    pp_style_grey(plot->cr, 1.0);
    cairo_rectangle(plot->cr, box.x, box.y, box.width, box.height);
    cairo_fill(plot->cr);
}

/* Writes names next to their curves if there is space for all names. Otherwise draws a
 * legend in the upper right corner, where the descending curves leave space. */
static void name_curves(struct availability_plot *plot)
{
    struct pp_key keys[PP_PERIODS_MOST];
    struct pp_box boxes[PP_PERIODS_MOST];
    double anchors[PP_PERIODS_MOST][2];
    int count = plot->sheet->period_count;
    bool all = true;
    for (int i = 0; i < count; i++) {
        keys[i] = key_of(plot, i);
        struct pp_box size = pp_legend_measure(plot->cr, &plot->style, &keys[i], 1, 0,
                                               0, plot->field.width);
        all = all
              && pp_labels_find(plot->labels, &plot->style, size.width, size.height, i,
                                &boxes[i], anchors[i]);
        if (all)
            pp_labels_note_box(plot->labels, boxes[i]);
    }
    for (int i = 0; i < count && all; i++) {
        clear_box(plot, boxes[i]);
        pp_labels_lead(plot->cr, &plot->style, boxes[i], anchors[i]);
        pp_legend_draw(plot->cr, &plot->style, &keys[i], 1, boxes[i].x, boxes[i].y,
                       plot->field.width);
    }
    if (all)
        return;
    double pad = 2.0 * plot->style.scale;
    struct pp_box size = pp_legend_measure(plot->cr, &plot->style, keys, count, 0, 0,
                                           0.6 * plot->field.width);
    size.x = plot->field.x + plot->field.width - size.width - pad;
    size.y = plot->field.y + pad;
    clear_box(plot, size);
    pp_legend_draw(plot->cr, &plot->style, keys, count, size.x, size.y,
                   0.6 * plot->field.width);
}

/* ---- target illuminances ---- */

/* Draws a vertical line at the illuminance outside that gives a target illuminance
 * inside, its name above the field, and a dot on each curve. *free_from: smallest x for
 * the next name; updated. */
static void draw_mark(struct availability_plot *plot,
                      const struct pp_availability_row *row, double *free_from)
{
    char words[32];
    double bottom = plot->field.y + plot->field.height;
    if (!(row->needs_lx <= plot->across.high))
        return;
    double x = pp_axis_at(&plot->across, row->needs_lx);
    pp_style_line(plot->cr, plot->style.thin, PP_INK);
    cairo_move_to(plot->cr, x, bottom);
    cairo_line_to(plot->cr, x, plot->field.y);
    pp_labels_note_path(plot->labels, plot->cr, -1);
    cairo_stroke(plot->cr);
    for (int i = 0; i < plot->sheet->period_count; i++) {
        double y = up_at(plot, row->share[i]);
        pp_style_marker(plot->cr, &plot->style, PP_DISC, x, y);
        pp_labels_note(plot->labels, -1, x - 1.0, y, x + 1.0, y);
    }

    struct pp_lettering text = {
        .size = PP_TEXT_SMALL, .bold = true, .across = 0.5, .down = 1.0};
    double y = plot->field.y - 0.8 * plot->style.scale;
    snprintf(words, sizeof words, "%g lx inside", row->lx);
    struct pp_box box =
        pp_lettering_measure(plot->cr, &plot->style, &text, x, y, words);
    if (box.x < *free_from) {
        snprintf(words, sizeof words, "%g", row->lx);
        box = pp_lettering_measure(plot->cr, &plot->style, &text, x, y, words);
    }
    if (box.x < *free_from)
        return;
    pp_lettering_draw(plot->cr, &plot->style, &text, x, y, words);
    *free_from = box.x + box.width + 1.5 * plot->style.scale;
}

static int compare_needs(const void *a, const void *b)
{
    double p = (*(const struct pp_availability_row *const *)a)->needs_lx;
    double q = (*(const struct pp_availability_row *const *)b)->needs_lx;
    return (p > q) - (p < q);
}

static void draw_availability_marks(struct availability_plot *plot)
{
    const struct pp_availability_row *ordered[PP_ILLUMINANCES_MOST];
    double free_from = -INFINITY;
    for (int i = 0; i < plot->row_count; i++)
        ordered[i] = &plot->rows[i];
    qsort(ordered, (size_t)plot->row_count, sizeof *ordered, compare_needs);
    for (int i = 0; i < plot->row_count; i++)
        draw_mark(plot, ordered[i], &free_from);
}

/* ---- scales ---- */

/* Draws the scale of the illuminance inside, from y down, and its title below. */
static void draw_inside_scale(struct availability_plot *plot, double y)
{
    const struct pp_style *style = &plot->style;
    double df = plot->rows->df.value;
    char percent[32], title[160];
    struct pp_axis inside =
        pp_axis_linear(0.0, df * plot->across.high, plot->across.from, plot->across.to,
                       15.0 * style->scale, false);
    double reach = pp_axis_draw_across(plot->cr, style, &inside, y);
    pp_style_percent(percent, sizeof percent, df);
    snprintf(title, sizeof title, "Internal illuminance %s, daylight factor %s (lx)",
             plot->place, percent);
    struct pp_lettering text = {.size = PP_TEXT_BODY, .across = 1.0};
    pp_lettering_draw(plot->cr, style, &text, plot->field.x + plot->field.width,
                      y + reach + 0.2 * style->scale, title);
}

static bool has_inside_scale(const struct availability_plot *plot)
{
    return plot->row_count > 0 && plot->rows->df.value > 0.0;
}

static void draw_plot(struct availability_plot *plot)
{
    cairo_t *cr = plot->cr;
    const struct pp_style *style = &plot->style;
    double bottom = plot->field.y + plot->field.height;
    pp_axis_grid_across(cr, style, &plot->up, plot->across.from, plot->across.to);
    pp_axis_grid_up(cr, style, &plot->across, plot->field.y, bottom);
    pp_axis_draw_up(cr, style, &plot->up, plot->field.x);
    double reach = pp_axis_draw_across(cr, style, &plot->across, bottom);

    struct pp_lettering title = {.size = PP_TEXT_BODY, .down = 1.0};
    pp_lettering_draw(cr, style, &title,
                      plot->field.x - pp_axis_reach(cr, style, &plot->up),
                      plot->field.y - 4.2 * style->scale, "Working hours (%)");
    title.down = 0.0;
    title.across = 1.0;
    struct pp_box box =
        pp_lettering_draw(cr, style, &title, plot->field.x + plot->field.width,
                          bottom + reach + 0.2 * style->scale,
                          "External diffuse horizontal illuminance (lx)");
    if (has_inside_scale(plot))
        draw_inside_scale(plot, box.y + box.height + 2.5 * style->scale);

    plot->labels->field = plot->field;
    for (int i = 0; i < plot->sheet->period_count; i++)
        draw_curve(plot, i);
    draw_availability_marks(plot);
    name_curves(plot);
}

static void draw_availability_sheet(struct availability_plot *plot,
                                    struct pp_canvas *canvas)
{
    const struct pp_availability_sheet *sheet = plot->sheet;
    const struct pp_style *style = &plot->style;
    const char *name = sheet->report ? sheet->report->world->name : NULL;
    say_notes(plot);
    const struct pp_page page = {name ? name : "Daylight availability",
                                 "Share of working hours in which the external diffuse "
                                 "illuminance is at least this value",
                                 plot->foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);

    /* On any sheet, the field is at most 1.05 times as high as wide. */
    double left = 10.0 * style->scale, right = 5.0 * style->scale;
    double above = 9.5 * style->scale;
    double below = (has_inside_scale(plot) ? 24.0 : 11.0) * style->scale;
    plot->field =
        (struct pp_box){body.x + left, body.y + above, body.width - left - right,
                        body.height - above - below};
    plot->field.height = fmin(plot->field.height, 1.05 * plot->field.width);
    plot->across =
        pp_axis_linear(0.0, top_lx(sheet), plot->field.x,
                       plot->field.x + plot->field.width, 15.0 * style->scale, true);
    plot->up = pp_axis_linear(0.0, 100.0, plot->field.y + plot->field.height,
                              plot->field.y, 7.0 * style->scale, true);
    draw_plot(plot);
}

enum pp_status pp_availability_chart_draw(struct pp_canvas *canvas,
                                          const struct pp_availability_sheet *sheet,
                                          struct pp_error *err)
{
    struct availability_plot plot = {.cr = pp_canvas_cairo(canvas),
                                     .style = pp_page_style(canvas),
                                     .sheet = sheet,
                                     .labels = calloc(1, sizeof *plot.labels)};
    if (!plot.labels)
        return pp_fail_memory(err);
    choose_rows(&plot);
    draw_availability_sheet(&plot, canvas);
    free(plot.labels);
    return PP_OK;
}
