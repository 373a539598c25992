/* lit_area_chart.c - see lit_area_chart.h. */
#include "charts/room/lit_area_chart.h"

#include <math.h>
#include <stdio.h>

#include "charts/room/contour_lines.h"
#include "charts/room/plan_names.h"
#include "charts/room/plan_strip.h"
#include "charts/room/room_plan.h"
#include "charts/sheet/hatch.h"
#include "charts/sheet/page.h"

/* Curve styles of style.c: solid for the proposed state, dash-dotted for the existing
 * state. */
enum { LINE_NOW = 0, LINE_BEFORE = 2 };

/* Areas smaller than this (m2) are within the tolerance of the lines, and are not
 * reported as loss or gain. */
static const double no_area_m2 = 0.005;

struct lit_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_lit_area_chart *chart;
    struct pp_world legal; /* copy of the world with the reference plane of the area */
    struct pp_room_plan plan;
    struct pp_key keys[6];
    int key_count;
};

static bool is_sky_factor(const struct lit_drawing *drawing)
{
    return drawing->chart->line == PP_LIT_SKY_FACTOR;
}

/* ---- the plane ---- */

static void add_outlines(struct lit_drawing *drawing, const struct pp_curve_list *list)
{
    for (int i = 0; i < list->count; i++)
        pp_contour_lines_path(drawing->cr, &drawing->plan, &list->list[i]);
}

static struct pp_box plane_box(const struct lit_drawing *drawing)
{
    const struct pp_room_plan *plan = &drawing->plan;
    double width = (plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m;
    double height = (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m;
    return (struct pp_box){plan->x, plan->y - height, width, height};
}

/* Clips to the part of the plane outside the outlines of dark areas. */
static void clip_to_lit(struct lit_drawing *drawing, const struct pp_curve_list *dark)
{
    struct pp_box box = plane_box(drawing);
    cairo_rectangle(drawing->cr, box.x - 1.0, box.y - 1.0, box.width + 2.0,
                    box.height + 2.0);
    add_outlines(drawing, dark);
    cairo_set_fill_rule(drawing->cr, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_clip(drawing->cr);
}

/* Hatches the area that is dark in one state and lit in the other. */
static void hatch_between(struct lit_drawing *drawing, const struct pp_lit_area *dark,
                          const struct pp_lit_area *lit, double apart_mm)
{
    cairo_save(drawing->cr);
    clip_to_lit(drawing, &lit->dark);
    add_outlines(drawing, &dark->dark);
    cairo_set_fill_rule(drawing->cr, CAIRO_FILL_RULE_WINDING);
    pp_hatch_path(drawing->cr, plane_box(drawing), apart_mm * drawing->style.scale,
                  drawing->style.hair, PP_GREY_TEXT);
    cairo_restore(drawing->cr);
}

static void stroke_line(struct lit_drawing *drawing, const struct pp_lit_area *area,
                        int look)
{
    struct pp_curve_style curve = pp_style_curve(look);
    curve.weight *= look == LINE_NOW ? 1.3 : 1.0;
    pp_style_pen(drawing->cr, &drawing->style, &curve);
    add_outlines(drawing, &area->line);
    cairo_stroke(drawing->cr);
}

static void draw_plane(struct lit_drawing *drawing)
{
    const struct pp_lit_area_chart *chart = drawing->chart;
    cairo_t *cr = drawing->cr;
    cairo_save(cr);
    pp_room_plan_path(cr, &drawing->plan);
    cairo_clip(cr);
    add_outlines(drawing, &chart->now->dark);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_WINDING);
    pp_style_grey(cr, PP_GREY_FILL);
    cairo_fill(cr);
    if (chart->before) {
        hatch_between(drawing, chart->now, chart->before, 1.1);
        hatch_between(drawing, chart->before, chart->now, 2.6);
    }
    cairo_restore(cr);
    if (chart->before)
        stroke_line(drawing, chart->before, LINE_BEFORE);
    stroke_line(drawing, chart->now, LINE_NOW);
}

/* ---- words and keys ---- */

static struct pp_key *add_key(struct lit_drawing *drawing, enum pp_legend_kind kind,
                              const char *words)
{
    struct pp_key *key = &drawing->keys[drawing->key_count++];
    *key = (struct pp_key){
        .kind = kind, .curve = pp_style_curve(LINE_NOW), .grey = PP_INK};
    snprintf(key->words, sizeof key->words, "%s", words);
    return key;
}

static void gather_keys(struct lit_drawing *drawing)
{
    const struct pp_lit_area_chart *chart = drawing->chart;
    const char *line =
        is_sky_factor(drawing) ? "sky factor of 0.2\u00a0%" : "no-sky line";
    char words[96];
    snprintf(words, sizeof words, "%s%s", line, chart->before ? ", proposed" : "");
    add_key(drawing, PP_KEY_LINE, words)->curve.weight *= 1.3;
    if (chart->before) {
        snprintf(words, sizeof words, "%s, existing", line);
        add_key(drawing, PP_KEY_LINE, words)->curve = pp_style_curve(LINE_BEFORE);
    }
    struct pp_key *dark =
        add_key(drawing, PP_KEY_TINT,
                is_sky_factor(drawing) ? "not adequately lit" : "no view of the sky");
    dark->grey = PP_GREY_FILL;
    if (chart->before && chart->before->lit_m2 > chart->now->lit_m2 + no_area_m2)
        add_key(drawing, PP_KEY_HATCH, "lost")->curve.dashes[0] = 1.1;
    if (chart->before && chart->now->lit_m2 > chart->before->lit_m2 + no_area_m2)
        add_key(drawing, PP_KEY_HATCH, "gained")->curve.dashes[0] = 2.6;
}

/* Writes the lit area of one state, and its fraction of the room's area. */
static void say_area(const struct lit_drawing *drawing, char *text, size_t room,
                     const char *state, const struct pp_lit_area *area)
{
    pp_page_say(text, room, "%s: %.2f\u00a0m² %s, %.1f\u00a0%% of %.2f\u00a0m².", state,
                area->lit_m2,
                is_sky_factor(drawing) ? "adequately lit" : "with a view of the sky",
                100.0 * area->lit_m2 / area->plane_m2, area->plane_m2);
}

static void say_loss(const struct lit_drawing *drawing, char *text, size_t room)
{
    const struct pp_lit_area *now = drawing->chart->now,
                             *before = drawing->chart->before;
    double lost = before->lit_m2 - now->lit_m2;
    if (before->lit_m2 > 0.0)
        pp_page_say(text, room, "%s: %.2f\u00a0m²; ratio of proposed to existing %.3f.",
                    lost < 0.0 ? "Gained" : "Lost", fabs(lost),
                    now->lit_m2 / before->lit_m2);
    if (!is_sky_factor(drawing) || lost < no_area_m2)
        return;
    const struct pp_lit_loss loss =
        pp_lit_area_loss(now->plane_m2, before->lit_m2, now->lit_m2);
    char zones[256] = "";
    for (int i = 0; i < PP_ZONE_COUNT; i++)
        if (loss.zones_m2[i] > 0.0)
            pp_page_say(zones, sizeof zones, "%s%s %.2f\u00a0m²", zones[0] ? "+ " : "",
                        pp_lit_area_zone_name((enum pp_lit_zone)i), loss.zones_m2[i]);
    pp_page_say(text, room, "By zones: %s; equivalent first zone %.2f\u00a0m².", zones,
                loss.equivalent_m2);
}

static void say_all(const struct lit_drawing *drawing, char *text, size_t room)
{
    const struct pp_lit_area_chart *chart = drawing->chart;
    if (!(chart->now->plane_m2 > 0.0)) {
        pp_page_say(text, room, "The working plane has no area.");
        return;
    }
    if (chart->before)
        say_area(drawing, text, room, "Before", chart->before);
    say_area(drawing, text, room, "Now", chart->now);
    if (chart->before)
        say_loss(drawing, text, room);
}

/* ---- the sheet ---- */

static void place_plan(struct lit_drawing *drawing, struct pp_box room)
{
    struct pp_room_plan *plan = &drawing->plan;
    plan->named = true;
    pp_room_plan_fit(plan, &drawing->legal, &drawing->style, room.width, room.height);
    pp_room_plan_place(plan, &drawing->style, room, false);
}

static void draw_lit_area_sheet(struct lit_drawing *drawing, struct pp_canvas *canvas)
{
    const struct pp_lit_area_chart *chart = drawing->chart;
    const struct pp_style *style = &drawing->style;
    char plane[32], subtitle[256], sums[1024] = "";
    pp_style_metres(plane, sizeof plane, chart->now->plane_m);
    snprintf(
        subtitle, sizeof subtitle,
        is_sky_factor(drawing)
            ? "Area with a sky factor over 0.2\u00a0%% (uniform sky, no glass), at %s "
              "above the floor%s"
            : "Area with a view of the sky, on the working plane %s above the floor%s",
        plane, chart->before ? ": existing and proposed" : "");
    const char *foot =
        is_sky_factor(drawing)
            ? "At least half of the room should be adequately lit. Zones are quarters "
              "of the room's area. For the equivalent first zone, areas in the front "
              "zone, first zone, second zone and makeweight are multiplied by 3/2, 1, "
              "1/2 and 1/4."
            : "At least 0.8 of the area that had a view of the sky should keep it "
              "[BR209].";
    struct pp_page page = {chart->world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, style, &page);
    gather_keys(drawing);
    say_all(drawing, sums, sizeof sums);
    struct pp_lettering set = {.size = PP_TEXT_BODY, .width = body.width, .lines = 6};
    double said =
        pp_lettering_measure(drawing->cr, style, &set, body.x, body.y, sums).height;
    double strip = pp_plan_strip_height(style, drawing->key_count);
    double gap = 5.0 * style->scale, below = said + 3.0 * style->scale + strip;
    place_plan(drawing,
               (struct pp_box){body.x, body.y, body.width, body.height - below - gap});
    draw_plane(drawing);
    pp_room_plan_draw(drawing->cr, style, &drawing->plan);
    pp_plan_names_draw(drawing->cr, style, &drawing->plan, NULL);
    double top = body.y + body.height - below;
    pp_lettering_draw(drawing->cr, style, &set, body.x, top, sums);
    pp_plan_strip_draw(
        drawing->cr, style,
        (struct pp_box){body.x, top + said + 3.0 * style->scale, body.width, strip},
        drawing->plan.scale, chart->world->north_rad, drawing->keys,
        drawing->key_count);
}

enum pp_status pp_lit_area_chart_draw(struct pp_canvas *canvas,
                                      const struct pp_lit_area_chart *chart,
                                      struct pp_error *err)
{
    (void)err;
    struct lit_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                  .style = pp_page_style(canvas),
                                  .chart = chart,
                                  .legal = *chart->world};
    drawing.legal.plane = chart->now->plane;
    drawing.legal.working_plane_m = chart->now->plane_m;
    draw_lit_area_sheet(&drawing, canvas);
    return PP_OK;
}
