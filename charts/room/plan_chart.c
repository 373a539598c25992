/* plan_chart.c - draws the plan with its contours, their figures, the no-sky line,
 * and below the plan scale bar, legend and north.
 */
#include "charts/room/plan_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/room/contour_lines.h"
#include "charts/sheet/legend.h"
#include "charts/sheet/page.h"
#include "charts/room/room_plan.h"

struct plan_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_plan_chart *chart;
    struct pp_room_plan plan;
    struct pp_labels *labels;
    struct pp_key keys[4];
    int key_count;
};

/* The curve of style.c whose dash the no-sky line has. */
enum { NO_SKY_LINE = 2 };

bool pp_plan_chart_landscape(const struct pp_world *world)
{
    struct pp_style style = pp_style_for(210.0);
    struct pp_room_plan plan;
    pp_room_plan_fit(&plan, world, &style, 200.0, 200.0);
    return plan.extent.high[0] - plan.extent.low[0]
           > 1.1 * (plan.extent.high[1] - plan.extent.low[1]);
}

/* ---- the plane ---- */

static void draw_dark(struct plan_drawing *drawing)
{
    const struct pp_curve_list *dark = &drawing->chart->plan->dark;
    for (int i = 0; i < dark->count; i++)
        pp_contour_lines_path(drawing->cr, &drawing->plan, &dark->list[i]);
    cairo_set_fill_rule(drawing->cr, CAIRO_FILL_RULE_WINDING);
    pp_style_grey(drawing->cr, PP_GREY_FILL);
    cairo_fill(drawing->cr);
}

static void draw_no_sky_line(struct plan_drawing *drawing)
{
    const struct pp_curve_list *lines = &drawing->chart->plan->no_sky;
    struct pp_curve_style look = pp_style_curve(NO_SKY_LINE);
    pp_style_pen(drawing->cr, &drawing->style, &look);
    for (int i = 0; i < lines->count; i++)
        pp_contour_lines_path(drawing->cr, &drawing->plan, &lines->list[i]);
    pp_labels_note_path(drawing->labels, drawing->cr, -1);
    cairo_stroke(drawing->cr);
}

/* Reference points, except those under figures or the no-sky line. */
static void draw_receivers(struct plan_drawing *drawing)
{
    const struct pp_report *report = drawing->chart->report;
    for (int i = 0; report && i < report->receiver_count; i++) {
        double x = pp_room_plan_x(&drawing->plan, report->receivers[i].position.x);
        double y = pp_room_plan_y(&drawing->plan, report->receivers[i].position.y);
        if (!pp_labels_is_near(drawing->labels, -1, x, y, 1.2 * drawing->style.scale))
            pp_style_marker(drawing->cr, &drawing->style, PP_POINT_MARK, x, y);
    }
}

/* The lines of 2 and 5 %, by which rooms are judged, are heavier. */
static double weight_of(const struct pp_style *style, double level)
{
    bool heavy = fabs(level - 0.02) < 1e-9 || fabs(level - 0.05) < 1e-9;
    return heavy ? style->medium : style->thin;
}

/* The figure of a level of which no line is long enough stands beside one. */
static void label_beside(struct plan_drawing *drawing, int owner, const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    struct pp_box size = pp_lettering_measure(drawing->cr, &drawing->style, &set, 0, 0,
                                              words),
                  box;
    double anchor[2];
    if (!pp_labels_find(drawing->labels, &drawing->style, size.width, size.height,
                        owner, &box, anchor))
        return;
    pp_labels_lead(drawing->cr, &drawing->style, box, anchor);
    pp_lettering_draw(drawing->cr, &drawing->style, &set, box.x, box.y, words);
    pp_labels_note_box(drawing->labels, box);
}

static void draw_contours(struct plan_drawing *drawing)
{
    const struct pp_curve_list *curves = &drawing->chart->plan->contours;

    /* Every line is noted before any is labelled, so that figures keep off all. */
    for (int i = 0; i < curves->count; i++) {
        pp_contour_lines_path(drawing->cr, &drawing->plan, &curves->list[i]);
        pp_labels_note_path(drawing->labels, drawing->cr, i);
        cairo_new_path(drawing->cr);
    }
    for (int first = 0; first < curves->count;) {
        double level = curves->list[first].level;
        char words[32];
        pp_style_level(words, sizeof words, level);
        bool labelled = false;
        int i = first, longest = first;
        for (; i < curves->count && curves->list[i].level == level; i++) {
            labelled |= pp_contour_lines_draw(
                drawing->cr, &drawing->style, &drawing->plan, &curves->list[i],
                weight_of(&drawing->style, level), words, drawing->labels, i);
            if (pp_curve_length(&curves->list[i])
                > pp_curve_length(&curves->list[longest]))
                longest = i;
        }
        if (!labelled)
            label_beside(drawing, longest, words);
        first = i;
    }
}

static void say_flat(struct plan_drawing *drawing)
{
    const struct pp_daylight_plan *plan = drawing->chart->plan;
    char words[160];
    if (plan->highest > 0.0) {
        char percent[32];
        pp_style_percent(percent, sizeof percent, plan->highest);
        snprintf(words, sizeof words,
                 "No contours: the daylight factor is about %s everywhere.", percent);
    } else {
        snprintf(words, sizeof words, "No contours: there is no daylight here.");
    }
    double middle[2];
    for (int k = 0; k < 2; k++)
        middle[k] = 0.5 * (drawing->plan.extent.low[k] + drawing->plan.extent.high[k]);
    struct pp_lettering set = {
        .size = PP_TEXT_BODY,
        .grey = PP_GREY_TEXT,
        .across = 0.5,
        .down = 0.5,
        .width = fmax(0.8 * (drawing->plan.extent.high[0] - drawing->plan.extent.low[0])
                          * drawing->plan.mm_per_m,
                      30.0)};
    pp_lettering_draw(drawing->cr, &drawing->style, &set,
                      pp_room_plan_x(&drawing->plan, middle[0]),
                      pp_room_plan_y(&drawing->plan, middle[1]), words);
}

/* ---- around the plan ---- */

static void add_key(struct plan_drawing *drawing, enum pp_legend_kind kind, int look,
                    double weight, double grey, const char *words)
{
    struct pp_key *key = &drawing->keys[drawing->key_count++];
    *key = (struct pp_key){.kind = kind, .curve = pp_style_curve(look), .grey = grey};
    key->curve.weight = weight;
    snprintf(key->words, sizeof key->words, "%s", words);
}

static void gather_keys(struct plan_drawing *drawing)
{
    const struct pp_daylight_plan *plan = drawing->chart->plan;
    char words[96];
    if (plan->contours.count) {
        snprintf(words, sizeof words, "daylight factor by %s (%%)", plan->name);
        add_key(drawing, PP_KEY_LINE, 0, drawing->style.thin / drawing->style.medium,
                PP_INK, words);
    }
    if (plan->no_sky.count)
        add_key(drawing, PP_KEY_LINE, NO_SKY_LINE, 1.0, PP_INK, "no-sky line");
    if (plan->dark.count) {
        snprintf(words, sizeof words, "no direct sky: %.0f\u00a0%% of the plane",
                 100.0 * (1.0 - plan->sky_share));
        add_key(drawing, PP_KEY_TINT, 0, 1.0, PP_GREY_FILL, words);
    }
    if (drawing->chart->report && drawing->chart->report->receiver_count) {
        add_key(drawing, PP_KEY_MARKER, 0, 1.0, PP_INK, "reference points");
        drawing->keys[drawing->key_count - 1].curve.marker = PP_POINT_MARK;
    }
}

static void say_foot(const struct pp_plan_chart *chart, char *foot, size_t room)
{
    const struct pp_daylight_plan *plan = chart->plan;
    if (plan->highest > 0.0) {
        char low[32], high[32];
        pp_style_percent(low, sizeof low, plan->lowest);
        pp_style_percent(high, sizeof high, plan->highest);
        pp_page_say(
            foot, room,
            "Highest daylight factor %s at x\u00a0%.2f, y\u00a0%.2f\u00a0m; lowest "
            "%s at x\u00a0%.2f, y\u00a0%.2f\u00a0m.",
            high, plan->highest_xy[0], plan->highest_xy[1], low, plan->lowest_xy[0],
            plan->lowest_xy[1]);
    }
    for (int i = 0; i < chart->world->skyline_count; i++) {
        const struct pp_skyline *skyline = &chart->world->skylines[i];
        const char *wall = chart->world->surfaces[skyline->face].name;
        pp_page_say(foot, room, "Skyline of %.3g\u00b0 before wall %s.",
                    skyline->angle_rad / PP_RAD, wall ? wall : "of the window");
    }
    pp_page_assumptions(foot, room, chart->world);
    for (int i = 0; i < chart->note_count; i++)
        pp_page_say(foot, room, "%s", chart->notes[i]);
}

/* Scale bar left, legend in the middle, north right, in a strip at the body's foot. */
static double strip_height(const struct plan_drawing *drawing)
{
    double keys = drawing->key_count * (1.35 * drawing->style.text[PP_TEXT_BODY])
                  + 0.7 * drawing->style.scale * drawing->key_count;
    return fmax(keys, 14.0 * drawing->style.scale);
}

static void draw_strip(struct plan_drawing *drawing, struct pp_box strip)
{
    const struct pp_style *style = &drawing->style;
    struct pp_box bar =
        pp_room_plan_scale_bar(drawing->cr, style, drawing->plan.mm_per_m,
                               strip.x + 1.0 * style->scale, strip.y);
    char words[32];
    snprintf(words, sizeof words, "1:%.0f", drawing->plan.scale);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .bold = true};
    pp_lettering_draw(drawing->cr, style, &set, strip.x,
                      bar.y + bar.height + style->scale, words);
    struct pp_lettering note = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
    pp_lettering_draw(drawing->cr, style, &note, strip.x,
                      bar.y + bar.height + style->scale
                          + 1.35 * style->text[PP_TEXT_BODY],
                      "printed at 100\u00a0%");
    double radius = 3.8 * style->scale;
    double north = strip.x + strip.width - radius - 3.5 * style->scale;
    pp_room_plan_north_arrow(drawing->cr, style, drawing->chart->world->north_rad,
                             north, strip.y + radius + 2.5 * style->scale, radius);
    double left =
        fmax(bar.x + bar.width + 8.0 * style->scale, strip.x + 0.40 * strip.width);
    pp_legend_draw(drawing->cr, style, drawing->keys, drawing->key_count, left, strip.y,
                   north - radius - 4.0 * style->scale - left);
}

static void place_plan(struct plan_drawing *drawing, struct pp_box room)
{
    struct pp_room_plan *plan = &drawing->plan;
    pp_room_plan_fit(plan, drawing->chart->world, &drawing->style, room.width,
                     room.height);
    double width = (plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m;
    double height = (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m;
    plan->x = room.x + 0.5 * (room.width - width);
    plan->y = room.y + 0.5 * (room.height + height);
    drawing->labels->field = (struct pp_box){plan->x, plan->y - height, width, height};
}

static void draw_sheet(struct plan_drawing *drawing, struct pp_canvas *canvas)
{
    const struct pp_plan_chart *chart = drawing->chart;
    const struct pp_world *world = chart->world;
    char sky[96], plane[32], subtitle[256], foot[4096] = "";
    pp_page_sky(sky, sizeof sky, world);
    pp_style_metres(plane, sizeof plane, world->working_plane_m);
    snprintf(subtitle, sizeof subtitle,
             "Daylight factor on the working plane %s above the floor, %s", plane, sky);
    say_foot(chart, foot, sizeof foot);
    struct pp_page page = {world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, &drawing->style, &page);

    gather_keys(drawing);
    double strip = strip_height(drawing), gap = 5.0 * drawing->style.scale;
    place_plan(drawing,
               (struct pp_box){body.x, body.y, body.width, body.height - strip - gap});
    cairo_save(drawing->cr);
    pp_room_plan_path(drawing->cr, &drawing->plan);
    cairo_clip(drawing->cr);
    draw_dark(drawing);
    cairo_restore(drawing->cr);
    draw_no_sky_line(drawing);
    draw_contours(drawing);
    draw_receivers(drawing);
    if (chart->plan->contours.count == 0)
        say_flat(drawing);
    pp_room_plan_draw(drawing->cr, &drawing->style, &drawing->plan);
    draw_strip(drawing, (struct pp_box){body.x, body.y + body.height - strip,
                                        body.width, strip});
}

enum pp_status pp_plan_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_plan_chart *chart,
                                  struct pp_error *err)
{
    struct plan_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                   .style = pp_page_style(canvas),
                                   .chart = chart,
                                   .labels = calloc(1, sizeof *drawing.labels)};
    if (!drawing.labels)
        return pp_fail_memory(err);
    draw_sheet(&drawing, canvas);
    free(drawing.labels);
    return PP_OK;
}
