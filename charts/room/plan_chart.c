/* plan_chart.c - draws the plan with its contours, their figures and the no-sky line,
 * and below it a scale bar, the legend and the north arrow. */
#include "charts/room/plan_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/room/contour_lines.h"
#include "charts/room/plan_figures.h"
#include "charts/room/plan_fill.h"
#include "charts/room/plan_strip.h"
#include "charts/room/plan_table.h"
#include "charts/sheet/legend.h"
#include "charts/sheet/page.h"
#include "charts/room/room_plan.h"
#include "model/room/section.h"

struct plan_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_plan_chart *chart;
    struct pp_room_plan plan;
    struct pp_labels *labels;
    struct pp_key keys[8];
    const char *quantity; /* what is shown, such as "daylight factor" */
    int key_count;
    bool in_table; /* true if values are listed in a table because they would be too
                    * close together on the plan */
};

/* Curve style of style.c used for the no-sky line. */
enum { NO_SKY_LINE = 2 };

/* Label owner of the no-sky line. Places of a contour have the index of the contour as
 * owner. */
enum { NO_SKY_OWNER = PP_LABEL_MARKS - 1 };

bool pp_plan_chart_landscape(const struct pp_world *world)
{
    struct pp_style style = pp_style_for(210.0);
    struct pp_room_plan plan = {0};
    pp_room_plan_fit(&plan, world, &style, 200.0, 200.0);
    return plan.extent.high[0] - plan.extent.low[0]
           > 1.1 * (plan.extent.high[1] - plan.extent.low[1]);
}

/* ---- the plane ---- */

/* True if all glass is diffusing. Then no sky is visible, and no view of the sky is
 * drawn. */
static bool is_all_diffusing(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (!world->openings[i].glass.diffusing)
            return false;
    return world->opening_count > 0;
}

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
    cairo_stroke(drawing->cr);
}

/* Tints the area where a simulated value is within one standard error of a level. */
static void draw_bands(struct plan_drawing *drawing)
{
    const struct pp_curve_list *bands = &drawing->chart->plan->bands;
    cairo_set_source_rgba(drawing->cr, 0.0, 0.0, 0.0, 0.16);
    cairo_set_fill_rule(drawing->cr, CAIRO_FILL_RULE_EVEN_ODD);
    const struct pp_curve_list *lines = &drawing->chart->plan->contours;
    for (int k = 0; k < lines->count; k++) {
        double level = lines->list[k].level;
        if (k > 0 && lines->list[k - 1].level == level)
            continue;
        for (int i = 0; i < bands->count; i++)
            if (bands->list[i].level == level)
                pp_contour_lines_path(drawing->cr, &drawing->plan, &bands->list[i]);
        cairo_fill(drawing->cr);
    }
}

/* Line weight of a level. The levels of 2 and 5 %, which are used in assessments, are
 * heavier. */
static double weight_of(const struct pp_style *style, double level)
{
    bool heavy = fabs(level - 0.02) < 1e-9 || fabs(level - 0.05) < 1e-9;
    return heavy ? style->medium : style->thin;
}

/* Writes the figure of a level beside a line if none of its lines is long enough for a
 * gap. */
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

/* Registers all lines before the first is labelled, so that values and labels avoid all
 * lines. */
static void note_lines(struct plan_drawing *drawing)
{
    const struct pp_curve_list *curves = &drawing->chart->plan->contours,
                               *no_sky = &drawing->chart->plan->no_sky;
    for (int i = 0; i < curves->count; i++) {
        pp_contour_lines_path(drawing->cr, &drawing->plan, &curves->list[i]);
        pp_labels_note_path(drawing->labels, drawing->cr, i);
        cairo_new_path(drawing->cr);
    }
    for (int i = 0; i < no_sky->count; i++)
        pp_contour_lines_path(drawing->cr, &drawing->plan, &no_sky->list[i]);
    pp_labels_note_path(drawing->labels, drawing->cr, NO_SKY_OWNER);
    cairo_new_path(drawing->cr);
}

static void draw_contours(struct plan_drawing *drawing)
{
    const struct pp_curve_list *curves = &drawing->chart->plan->contours;
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
                 "No contours: the %s is approximately %s everywhere.",
                 drawing->quantity, percent);
    } else {
        snprintf(words, sizeof words, "No contours: there is no daylight.");
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
                      pp_plan_frame_x(&drawing->plan, middle[0]),
                      pp_plan_frame_y(&drawing->plan, middle[1]), words);
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

/* True if the values are simulated, so that they are not described as "by" a method. */
static bool is_traced(const struct pp_daylight_plan *plan)
{
    return strcmp(plan->name, "traced") == 0;
}

static void gather_keys(struct plan_drawing *drawing)
{
    const struct pp_daylight_plan *plan = drawing->chart->plan;
    const struct pp_world *world = drawing->chart->world;
    const struct pp_style *style = &drawing->style;
    char words[96];
    if (plan->contours.count) {
        snprintf(words, sizeof words, "%s%s%s (%%)", drawing->quantity,
                 is_traced(plan) ? ", " : " by ",
                 is_traced(plan) ? "simulated" : plan->name);
        add_key(drawing, PP_KEY_LINE, 0, style->thin / style->medium, PP_INK, words);
    }
    if (plan->bands.count)
        add_key(drawing, PP_KEY_TINT, 0, 1.0, 0.84,
                "within one standard error of the contour");
    bool tinted = drawing->chart->fill == PP_FILL_NONE;
    snprintf(words, sizeof words, "no view of the sky: %.0f\u00a0%% of the plane",
             100.0 * (1.0 - plan->sky_share));
    if (plan->no_sky.count)
        add_key(drawing, PP_KEY_LINE, NO_SKY_LINE, 1.0, PP_INK, "no-sky line");
    if (plan->dark.count && tinted && !is_all_diffusing(world))
        add_key(drawing, PP_KEY_TINT, 0, 1.0, PP_GREY_FILL, words);
    if (pp_room_plan_has_overhead(world)) {
        add_key(drawing, PP_KEY_LINE, 1, style->thin / style->medium, PP_GREY_LINE,
                "glass above the plane");
        drawing->keys[drawing->key_count - 1].curve.dashes[0] = 1.4;
        drawing->keys[drawing->key_count - 1].curve.dashes[1] = 0.8;
    }
    if (pp_room_plan_has_inside(world))
        add_key(drawing, PP_KEY_LINE, 0, style->thick / style->medium, PP_INK,
                "furniture and partitions");
    if (drawing->chart->report && drawing->chart->report->receiver_count) {
        add_key(drawing, PP_KEY_MARKER, 0, 1.0, PP_INK,
                drawing->chart->figures ? "calculation points, with values"
                                        : "calculation points");
        drawing->keys[drawing->key_count - 1].curve.marker = PP_POINT_MARK;
    }
}

/* Writes a fraction in per cent, or "under 0.01 %". */
static void say_percent(char *text, size_t room, double fraction)
{
    if (fraction < 1e-4)
        snprintf(text, room, "under 0.01\u00a0%%");
    else
        pp_style_percent(text, room, fraction);
}

static void say_plan_foot(const struct plan_drawing *drawing, char *foot, size_t room)
{
    const struct pp_plan_chart *chart = drawing->chart;
    const struct pp_daylight_plan *plan = chart->plan;
    for (int i = 0; i < chart->note_count; i++)
        if (chart->notes[i][0])
            pp_page_say(foot, room, "%s", chart->notes[i]);
    if (plan->highest > 0.0) {
        char low[32], high[32];
        say_percent(low, sizeof low, plan->lowest);
        say_percent(high, sizeof high, plan->highest);
        pp_page_say(foot, room,
                    "The highest %s is %s at x\u00a0%.2f, y\u00a0%.2f\u00a0m; the "
                    "lowest is %s at x\u00a0%.2f, y\u00a0%.2f\u00a0m.",
                    drawing->quantity, high, plan->highest_xy[0], plan->highest_xy[1],
                    low, plan->lowest_xy[0], plan->lowest_xy[1]);
    }
    for (int i = 0; i < chart->world->skyline_count; i++) {
        const struct pp_skyline *skyline = &chart->world->skylines[i];
        const char *wall = chart->world->surfaces[skyline->face].name;
        pp_page_say(foot, room, "Skyline of %.3g\u00b0 in front of wall %s.",
                    skyline->angle_rad / PP_RAD, wall ? wall : "of the window");
    }
    if (is_all_diffusing(chart->world))
        pp_page_say(foot, room,
                    "All glass is diffusing, so the view of the sky is not assessed.");
    else if (plan->dark.count)
        pp_page_say(foot, room, "%.0f\u00a0%% of the plane has no view of the sky.",
                    100.0 * (1.0 - plan->sky_share));
    pp_page_assumptions(foot, room, chart->world, chart->light);
    if (chart->report && !chart->report->finished)
        pp_page_say(foot, room,
                    "The run was interrupted: simulated values are preliminary.");
}

static void place_plan(struct plan_drawing *drawing, struct pp_box room)
{
    struct pp_room_plan *plan = &drawing->plan;
    plan->named = true;
    pp_room_plan_fit(plan, drawing->chart->world, &drawing->style, room.width,
                     room.height);
    pp_room_plan_place(plan, &drawing->style, room, false);
    double width = (plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m;
    double height = (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m;
    drawing->labels->field = (struct pp_box){plan->x, plan->y - height, width, height};
}

/* Maximum fraction of the field's width or height for a table of values. */
static const double table_most = 0.5;

/* Places the plan in the field. If values beside the points would be too close
 * together, they are listed in a table beside or below the plan, whichever leaves the
 * larger plan. If the table is too large, table and values are omitted. The last key,
 * for the points, refers to the table. */
static void lay_plan(struct plan_drawing *drawing, struct pp_box field)
{
    const struct pp_plan_chart *chart = drawing->chart;
    const struct pp_style *style = &drawing->style;
    place_plan(drawing, field);
    drawing->in_table = !pp_plan_figures_fit(drawing->cr, style, &drawing->plan, chart);
    if (!drawing->in_table)
        return;
    double gap = 4.0 * style->scale, best = INFINITY;
    struct pp_box table = pp_plan_table_draw(drawing->cr, style, chart, field, false);
    struct pp_box rest[2] = {field, field}, chosen = field;
    rest[0].width -= table.width + gap;
    rest[1].height -= table.height + gap;
    for (int below = 0; below < 2; below++) {
        if (rest[below].width < table_most * field.width
            || rest[below].height < table_most * field.height
            || table.width > field.width || table.height > field.height)
            continue;
        place_plan(drawing, rest[below]);
        if (drawing->plan.scale >= best)
            continue;
        best = drawing->plan.scale;
        chosen = rest[below];
    }
    place_plan(drawing, chosen);
    struct pp_key *points = &drawing->keys[drawing->key_count - 1];
    snprintf(points->words, sizeof points->words, "calculation points%s",
             isfinite(best) ? "; values in the table"
                            : ", too many to print their values on this sheet");
    if (!isfinite(best))
        return;
    table.x = field.x;
    table.y = field.y + field.height - table.height;
    if (chosen.width < field.width) {
        table.x = field.x + field.width - table.width;
        table.y = field.y;
    }
    pp_plan_table_draw(drawing->cr, style, chart, table, true);
}

/* Paints white the fittings that pass through the plane, since there is no daylight
 * factor inside them. */
static void blank_fittings(const struct plan_drawing *drawing)
{
    const struct pp_world *world = drawing->chart->world;
    cairo_set_source_rgb(drawing->cr, 1.0, 1.0, 1.0);
    for (int i = 0; i < world->fitting_count; i++) {
        const struct pp_fitting *fitting = &world->fittings[i];
        if (!pp_section_meets(world, fitting))
            continue;
        for (int k = 0; k < fitting->corner_count; k++)
            cairo_line_to(drawing->cr,
                          pp_plan_frame_x(&drawing->plan, fitting->xy[k][0]),
                          pp_plan_frame_y(&drawing->plan, fitting->xy[k][1]));
        cairo_close_path(drawing->cr);
        cairo_fill(drawing->cr);
    }
}

/* Draws everything on the plane. Areas are clipped to the plane; lines are not. */
static void draw_plane(struct plan_drawing *drawing)
{
    const struct pp_plan_chart *chart = drawing->chart;
    cairo_save(drawing->cr);
    pp_room_plan_path(drawing->cr, &drawing->plan);
    cairo_clip(drawing->cr);
    if (chart->fill == PP_FILL_NONE && !is_all_diffusing(chart->world))
        draw_dark(drawing);
    pp_plan_fill_draw(drawing->cr, &drawing->plan, chart->plan, chart->fill);
    draw_bands(drawing);
    blank_fittings(drawing);
    cairo_restore(drawing->cr);
    draw_no_sky_line(drawing);
    draw_contours(drawing);
}

/* Draws the summary of the plane at the top of the box. If `drawn` is false, only
 * measures. Returns the height. */
static double draw_summary(struct plan_drawing *drawing, struct pp_box box, bool drawn)
{
    char text[1024] = "";
    struct pp_lettering set = {.size = PP_TEXT_BODY, .width = box.width, .lines = 6};
    pp_plan_figures_say(text, sizeof text, drawing->chart);
    if (!text[0])
        return 0.0;
    return (drawn ? pp_lettering_draw : pp_lettering_measure)(
               drawing->cr, &drawing->style, &set, box.x, box.y, text)
               .height
           + 3.0 * drawing->style.scale;
}

/* Finds places for the values; the caller frees the list. NULL: values are not written
 * beside the points. */
static struct pp_plan_figure *place_figures(struct plan_drawing *drawing)
{
    const struct pp_plan_chart *chart = drawing->chart;
    if (!chart->report || !chart->figures || drawing->in_table)
        return NULL;
    struct pp_plan_figure *list =
        calloc((size_t)chart->report->receiver_count + 1, sizeof *list);
    if (list)
        pp_plan_figures_place(list, drawing->cr, &drawing->style, &drawing->plan, chart,
                              drawing->labels);
    else
        pp_canvas_lacks_memory(drawing->cr);
    return list;
}

static void draw_plan_sheet(struct plan_drawing *drawing, struct pp_canvas *canvas)
{
    const struct pp_plan_chart *chart = drawing->chart;
    const struct pp_world *world = chart->world;
    const struct pp_style *style = &drawing->style;
    char sky[96], plane[32], subtitle[400], foot[4096] = "";
    drawing->quantity = chart->plan->direct ? "direct component" : "daylight factor";
    pp_page_sky(sky, sizeof sky, world, chart->light);
    pp_style_metres(plane, sizeof plane, world->working_plane_m);
    snprintf(subtitle, sizeof subtitle,
             "%s%s%s, on the working plane %s above the floor, %s",
             chart->plan->direct ? "Direct component (from sky and obstructions, "
                                   "without internal reflection)"
                                 : "Daylight factor",
             is_traced(chart->plan) ? ", " : " by ",
             is_traced(chart->plan) ? "simulated" : chart->plan->name, plane, sky);
    say_plan_foot(drawing, foot, sizeof foot);
    struct pp_page page = {world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);

    gather_keys(drawing);
    bool filled = chart->fill != PP_FILL_NONE && chart->plan->contours.count;
    double strip = pp_plan_strip_height(style, drawing->key_count),
           gap = 5.0 * style->scale;
    double bar = filled ? pp_plan_fill_bar_mm(style) + 3.0 * style->scale : 0.0;
    double summary = draw_summary(drawing, body, false);
    lay_plan(drawing, (struct pp_box){body.x, body.y, body.width,
                                      body.height - strip - bar - summary - gap});
    pp_plan_names_note(drawing->labels, drawing->cr, style, &drawing->plan);
    note_lines(drawing);
    struct pp_plan_figure *figures = place_figures(drawing);
    draw_plane(drawing);
    if (chart->report)
        pp_plan_figures_draw(drawing->cr, style, &drawing->plan, chart, figures);
    free(figures);
    if (chart->plan->contours.count == 0)
        say_flat(drawing);
    pp_room_plan_draw(drawing->cr, style, &drawing->plan);
    pp_plan_names_draw(drawing->cr, style, &drawing->plan, chart->mark);
    struct pp_box below = {body.x, body.y + body.height - strip - bar - summary,
                           body.width, strip};
    draw_summary(drawing, below, true);
    below.y += summary;
    if (filled)
        pp_plan_fill_bar(drawing->cr, style, chart->plan, chart->fill, below.x, below.y,
                         below.width - 6.0 * style->scale);
    below.y += bar;
    pp_plan_strip_draw(drawing->cr, style, below, drawing->plan.scale,
                       chart->world->north_rad, drawing->keys, drawing->key_count);
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
    draw_plan_sheet(&drawing, canvas);
    free(drawing.labels);
    return PP_OK;
}
