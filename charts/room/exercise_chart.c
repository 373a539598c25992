/* exercise_chart.c - lays out section and plan side by side, the elevations below, and
 * ruled lines for the answers at the bottom. */
#include "charts/room/exercise_chart.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/room/block_plan.h"
#include "charts/room/plan_names.h"

#include "charts/room/room_elevation.h"
#include "charts/room/room_plan.h"
#include "charts/section/room_section.h"
#include "charts/room/room_words.h"
#include "charts/sheet/page.h"

enum { ELEVATIONS_MOST = 4, ANSWER_LINES = 4 /* the first for name and date */ };

struct exercise_drawing {
    cairo_t *cr;
    struct pp_style style;
    const struct pp_exercise *exercise;
    struct pp_section_cut cut;
    struct pp_report report; /* report for the single point */
    struct pp_room_elevation elevations[ELEVATIONS_MOST];
    int elevation_count;
    double scale; /* denominator of the scale of section and plan; also of elevations,
                   * unless they have the scale of a diagram */
};

/* Finds the walls whose openings face the point, in order of their first openings. */
static void find_elevations(struct exercise_drawing *drawing)
{
    const struct pp_world *world = drawing->exercise->world;
    struct pp_vec3 eye = drawing->exercise->receiver.position;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double before = pp_vec_dot(pp_vec_sub(eye, opening->inner.vertices[0]),
                                   opening->inner.normal);
        bool known = !(before > 1e-6) || drawing->elevation_count == ELEVATIONS_MOST;
        for (int k = 0; k < drawing->elevation_count; k++)
            known = known || drawing->elevations[k].first->face == opening->face;
        if (!known)
            pp_room_elevation_init(&drawing->elevations[drawing->elevation_count++],
                                   world, opening, eye);
    }
}

static double caption_mm(const struct pp_style *style)
{
    return 1.8 * style->text[PP_TEXT_SMALL];
}

/* Height of the scale bar below the plan, and of the dimensions below an elevation
 * (mm). */
static double bar_mm(const struct pp_style *style)
{
    return 6.5 * style->scale;
}

/* Writes a caption below a drawing, centred on x. */
static void write_caption(const struct exercise_drawing *drawing, double x, double y,
                          double width, const char *words)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                     .grey = PP_GREY_TEXT,
                                     .across = 0.5,
                                     .width = width,
                                     .lines = 2};
    struct pp_box box =
        pp_lettering_measure(drawing->cr, &drawing->style, &set, 0.0, 0.0, words);
    const struct pp_lettering line = {
        .size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT, .width = width, .lines = 2};
    pp_lettering_draw(drawing->cr, &drawing->style, &line, x - 0.5 * box.width,
                      y + 0.8 * drawing->style.scale, words);
}

/* Width beside the section to be reserved for obstructions (mm). */
static double outside_mm(const struct exercise_drawing *drawing, bool near)
{
    struct pp_room_section section = {.world = drawing->exercise->world,
                                      .cut = &drawing->cut};
    bool obstructed = pp_room_section_has_outside(&section, near);
    return (obstructed ? 22.0 : 12.0) * drawing->style.scale;
}

static struct pp_room_section fitted_section(const struct exercise_drawing *drawing,
                                             struct pp_box box)
{
    struct pp_room_section section = {.world = drawing->exercise->world,
                                      .cut = &drawing->cut,
                                      .report = &drawing->report,
                                      .least_scale = drawing->scale,
                                      .named = true,
                                      .no_angles = true};
    double left = outside_mm(drawing, true), right = outside_mm(drawing, false);
    pp_room_section_fit(&section, &drawing->style, box.width - left - right,
                        box.height - 3.0 * drawing->style.scale);
    section.x = box.x + left;
    section.y = box.y + 3.0 * drawing->style.scale;
    section.left_mm = left - 1.0;
    section.right_mm =
        box.width - left - drawing->cut.length_m * section.mm_per_m - 1.0;
    section.head_mm = 3.0 * drawing->style.scale;
    return section;
}

static struct pp_room_plan fitted_plan(const struct exercise_drawing *drawing,
                                       struct pp_box box)
{
    struct pp_room_plan plan = {.least_scale = drawing->scale, .named = true};
    pp_room_plan_fit(&plan, drawing->exercise->world, &drawing->style, box.width,
                     box.height - bar_mm(&drawing->style));
    pp_room_plan_place(&plan, &drawing->style, box, true);
    return plan;
}

/* Denominator of the largest usual scale at which all elevations fit side by side. */
static double elevations_scale(const struct exercise_drawing *drawing,
                               struct pp_box box)
{
    double width = 0.0, height = 0.0, gaps = 14.0 * drawing->style.scale;
    for (int i = 0; i < drawing->elevation_count; i++) {
        const struct pp_bounds2 *extent = &drawing->elevations[i].extent;
        width += extent->high[0] - extent->low[0];
        height = fmax(height, extent->high[1] - extent->low[1]);
    }
    double most = fmin(
        (box.width - gaps * drawing->elevation_count) / width,
        (box.height - caption_mm(&drawing->style) - bar_mm(&drawing->style)) / height);
    return pp_room_plan_usual_scale(1000.0 / most);
}

/* Chooses a common scale for section and plan; also for elevations, unless a diagram
 * determines their scale. */
static void choose_scale(struct exercise_drawing *drawing, struct pp_box section,
                         struct pp_box plan, struct pp_box elevations)
{
    drawing->scale = 0.0;
    double first = 1000.0 / fitted_section(drawing, section).mm_per_m;
    double second = fitted_plan(drawing, plan).scale;
    drawing->scale = fmax(first, second);
    if (!(drawing->exercise->viewing_mm > 0.0))
        drawing->scale = fmax(drawing->scale, elevations_scale(drawing, elevations));
}

static void draw_section(const struct exercise_drawing *drawing, struct pp_box box)
{
    struct pp_room_section section = fitted_section(drawing, box);
    pp_room_section_draw(drawing->cr, &drawing->style, &section);
}

static void draw_exercise_plan(const struct exercise_drawing *drawing,
                               struct pp_box box)
{
    const struct pp_style *style = &drawing->style;
    struct pp_vec3 point = drawing->exercise->receiver.position;
    struct pp_room_plan plan = fitted_plan(drawing, box);
    char words[64];
    pp_room_plan_draw(drawing->cr, style, &plan);
    const struct pp_plan_mark mark = {
        {drawing->cut.origin[0], drawing->cut.origin[1]},
        {drawing->cut.origin[0] + drawing->cut.length_m * drawing->cut.along[0],
         drawing->cut.origin[1] + drawing->cut.length_m * drawing->cut.along[1]}};
    pp_plan_names_draw(drawing->cr, style, &plan, &mark);
    pp_block_plan_axes(drawing->cr, style, &plan);
    double x = pp_plan_frame_x(&plan, point.x), y = pp_plan_frame_y(&plan, point.y);
    pp_style_marker(drawing->cr, style, PP_DISC, x, y);
    const struct pp_lettering at = {.size = PP_TEXT_SMALL, .down = 0.5};
    snprintf(words, sizeof words, "P (%.4g, %.4g)", point.x, point.y);
    pp_lettering_draw(drawing->cr, style, &at, x + 1.5 * style->scale, y, words);
    snprintf(words, sizeof words, "Plan 1:%g", plan.scale);
    double below = plan.y + pp_room_plan_border(&plan, style, PP_PLAN_BELOW);
    double bar =
        fmin(plan.x + 20.0 * style->scale, box.x + box.width - 62.0 * style->scale);
    bar = fmax(bar, box.x + 20.0 * style->scale);
    write_caption(drawing, bar - 12.0 * style->scale, below, box.width, words);
    pp_room_plan_scale_bar(drawing->cr, style, plan.mm_per_m, bar,
                           below + 0.4 * style->scale);
}

static int compare_edges(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}

static void dimension(const struct exercise_drawing *drawing, double x0, double y0,
                      double x1, double y1, double mm_per_m)
{
    double length = hypot(x1 - x0, y1 - y0);
    if (length > 0.1)
        pp_plan_names_dimension(drawing->cr, &drawing->style, x0, y0, x1, y1,
                                length / mm_per_m, false);
}

/* Draws dimensions of the wall: below, to the jambs of the openings; at the left, to
 * the lowest sill and the highest head. Also labels the openings. */
static void draw_elevation_dimensions(const struct exercise_drawing *drawing,
                                      const struct pp_room_elevation *elevation)
{
    enum { EDGES_MOST = 24 };
    const struct pp_world *world = elevation->world;
    const struct pp_polygon *wall = &world->surfaces[elevation->first->face].outline;
    double across[EDGES_MOST], up[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    int count = 0;
    across[0] = INFINITY;
    across[1] = -INFINITY;
    for (int i = 0; i < wall->count; i++) {
        double x, y;
        pp_room_elevation_place(elevation, wall->vertices[i], &x, &y);
        across[0] = fmin(across[0], x);
        across[1] = fmax(across[1], x);
        up[0] = fmin(up[0], -y);
        up[3] = fmax(up[3], -y);
    }
    count = 2;
    for (int i = 0; i < world->opening_count && count + 2 <= EDGES_MOST; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        double low = INFINITY, high = -INFINITY, top = INFINITY;
        if (world->openings[i].face != elevation->first->face)
            continue;
        for (int k = 0; k < outline->count; k++) {
            double x, y;
            pp_room_elevation_place(elevation, outline->vertices[k], &x, &y);
            low = fmin(low, x);
            high = fmax(high, x);
            top = fmin(top, y);
            up[1] = fmin(up[1], -y);
            up[2] = fmax(up[2], -y);
        }
        across[count++] = low;
        across[count++] = high;
        const struct pp_lettering name = {
            .size = PP_TEXT_SMALL, .bold = true, .across = 0.5};
        pp_lettering_draw(drawing->cr, &drawing->style, &name, 0.5 * (low + high),
                          top + 0.6 * drawing->style.scale, world->openings[i].label);
    }
    qsort(across, (size_t)count, sizeof *across, compare_edges);
    double y = -up[0] + 0.42 * bar_mm(&drawing->style),
           x = across[0] - 0.6 * bar_mm(&drawing->style);
    for (int i = 0; i + 1 < count; i++)
        dimension(drawing, across[i], y, across[i + 1], y, elevation->mm_per_m);
    for (int i = 0; i < 3; i++)
        dimension(drawing, x, -up[i], x, -up[i + 1], elevation->mm_per_m);
}

static void draw_elevations(struct exercise_drawing *drawing, struct pp_box box)
{
    const struct pp_exercise *exercise = drawing->exercise;
    double part = box.width / drawing->elevation_count;
    for (int i = 0; i < drawing->elevation_count; i++) {
        struct pp_room_elevation *elevation = &drawing->elevations[i];
        const struct pp_bounds2 *extent = &elevation->extent;
        const char *wall = exercise->world->surfaces[elevation->first->face].name;
        char words[160];
        elevation->mm_per_m = exercise->viewing_mm > 0.0
                                  ? exercise->viewing_mm / elevation->distance_m
                                  : 1000.0 / drawing->scale;
        double width = (extent->high[0] - extent->low[0]) * elevation->mm_per_m;
        elevation->x = box.x + i * part + 0.5 * (part - width)
                       - extent->low[0] * elevation->mm_per_m;
        elevation->y = box.y + extent->high[1] * elevation->mm_per_m;
        pp_room_elevation_draw(drawing->cr, &drawing->style, elevation);
        draw_elevation_dimensions(drawing, elevation);
        snprintf(words, sizeof words, "%s%.60s from inside, %.2f\u00a0m away, ",
                 wall ? "Wall " : "Face", wall ? wall : "", elevation->distance_m);
        size_t length = strlen(words);
        snprintf(words + length, sizeof words - length,
                 exercise->viewing_mm > 0.0 ? "1\u00a0m is %.2f\u00a0mm" : "1:%g",
                 exercise->viewing_mm > 0.0 ? elevation->mm_per_m : drawing->scale);
        write_caption(drawing, box.x + (i + 0.5) * part,
                      elevation->y - extent->low[1] * elevation->mm_per_m
                          + bar_mm(&drawing->style),
                      part, words);
    }
}

/* Draws the labels of the answers, each with a line to write on. */
static void draw_answers(const struct exercise_drawing *drawing, struct pp_box box)
{
    const struct pp_style *style = &drawing->style;
    const char *unit = drawing->exercise->unit;
    double step = box.height / ANSWER_LINES;
    char words[ANSWER_LINES][96];
    snprintf(words[0], sizeof words[0], "Name, date");
    snprintf(words[1], sizeof words[1], "Sky component: %s",
             unit ? unit : "readings \u00d7 corrections");
    snprintf(words[2], sizeof words[2], "Externally reflected component");
    snprintf(words[3], sizeof words[3], "Total with glass, frame and dirt");
    for (int i = 0; i < ANSWER_LINES; i++) {
        const struct pp_lettering set = {.size = PP_TEXT_BODY, .down = 1.0};
        double y = box.y + (i + 1) * step - 1.0;
        pp_lettering_draw(drawing->cr, style, &set, box.x, y, words[i]);
        cairo_move_to(drawing->cr, box.x + 0.4 * box.width, y);
        cairo_line_to(drawing->cr, box.x + box.width, y);
        pp_style_line(drawing->cr, style->thin, PP_GREY_LINE);
        cairo_stroke(drawing->cr);
    }
}

/* Height of the elevations (mm), which at the scale of a diagram is the same on every
 * sheet size. Without a viewing distance it is two fifths of `most`; best_layout then
 * chooses another height. */
static double elevations_height(const struct exercise_drawing *drawing, double most)
{
    double tallest = 0.0, viewing = drawing->exercise->viewing_mm;
    for (int i = 0; i < drawing->elevation_count; i++) {
        const struct pp_room_elevation *e = &drawing->elevations[i];
        tallest = fmax(tallest, (e->extent.high[1] - e->extent.low[1]) * viewing
                                    / fmax(e->distance_m, 1e-3));
    }
    return viewing > 0.0
               ? tallest + 1.6 * caption_mm(&drawing->style) + bar_mm(&drawing->style)
               : 0.4 * most;
}

/* Areas of the drawings on the sheet. */
struct exercise_layout {
    struct pp_box section, plan, elevations;
    struct pp_box blocks; /* width 0: no block plan */
};

/* Lays out the sheet above the answers. below: height of the elevations (mm). */
static struct exercise_layout lay_out(const struct exercise_drawing *drawing,
                                      struct pp_box body, double below)
{
    double gap = 4.0 * drawing->style.scale, above = body.height - below - 2.0 * gap;
    bool blocks = drawing->exercise->world->block_count > 0;
    bool at_diagram = drawing->exercise->viewing_mm > 0.0;
    struct pp_box elevations = {body.x, body.y + above + gap, body.width, below};
    struct exercise_layout layout = {.elevations = elevations};
    /* The caption of the section is 90 mm wide; on a narrow sheet the plan is placed
     * below the section. */
    if (0.6 * body.width < (90.0 + 14.0) * drawing->style.scale) {
        layout.section = (struct pp_box){body.x, body.y, body.width, 0.4 * above - gap};
        layout.plan =
            (struct pp_box){body.x, body.y + 0.4 * above, body.width, 0.6 * above};
        if (blocks) {
            layout.blocks = layout.plan;
            layout.plan.width = layout.blocks.width = 0.5 * (body.width - gap);
            layout.blocks.x += 0.5 * (body.width + gap);
        }
        return layout;
    }
    layout.section = (struct pp_box){body.x, body.y, 0.6 * body.width - gap, above};
    layout.plan =
        (struct pp_box){body.x + 0.6 * body.width, body.y, 0.4 * body.width, above};
    if (blocks && at_diagram) {
        layout.blocks = layout.section;
        layout.section.height *= 0.5;
        layout.blocks.height *= 0.5;
        layout.blocks.y += layout.section.height;
    } else if (blocks) {
        layout.elevations.width = layout.section.width;
        layout.blocks =
            (struct pp_box){layout.plan.x, elevations.y, layout.plan.width, below};
    }
    return layout;
}

/* Lays out the sheet at the largest scale. The elevations have the height that a
 * diagram requires, or else the height that suits all drawings. */
static struct exercise_layout best_layout(struct exercise_drawing *drawing,
                                          struct pp_box body)
{
    static const double shares[] = {0.45, 0.4, 0.35, 0.3, 0.25};
    double diagram = elevations_height(drawing, body.height), best = INFINITY;
    struct exercise_layout chosen = lay_out(drawing, body, 0.4 * body.height);
    for (int i = 0; i < (drawing->exercise->viewing_mm > 0.0 ? 1 : 5); i++) {
        const struct exercise_layout layout = lay_out(
            drawing, body,
            drawing->exercise->viewing_mm > 0.0 ? diagram : shares[i] * body.height);
        choose_scale(drawing, layout.section, layout.plan, layout.elevations);
        if (drawing->scale < best) {
            best = drawing->scale;
            chosen = layout;
        }
    }
    drawing->scale = best;
    return chosen;
}

static enum pp_status draw_body(struct exercise_drawing *drawing, struct pp_box body,
                                struct pp_error *err)
{
    const struct pp_exercise *exercise = drawing->exercise;
    double answers = ANSWER_LINES * 2.4 * drawing->style.text[PP_TEXT_BODY];
    double width = 0.0;
    for (int i = 0; i < drawing->elevation_count; i++) {
        const struct pp_room_elevation *e = &drawing->elevations[i];
        width = fmax(width, (e->extent.high[0] - e->extent.low[0])
                                * exercise->viewing_mm / e->distance_m);
    }
    struct pp_box drawings = body;
    drawings.height -= answers;
    if (exercise->viewing_mm > 0.0
        && (drawings.height - elevations_height(drawing, drawings.height)
                < 33.0 * drawing->style.scale
            || width * drawing->elevation_count > body.width))
        return pp_fail(err, PP_BAD_INPUT,
                       "the elevations do not fit on the sheet at the diagram's scale; "
                       "expected a larger --paper or a shorter --viewing-distance");
    const struct exercise_layout layout = best_layout(drawing, drawings);
    draw_section(drawing, layout.section);
    draw_exercise_plan(drawing, layout.plan);
    if (layout.blocks.width > 0.0)
        pp_block_plan_draw(drawing->cr, &drawing->style, exercise->world,
                           layout.blocks);
    draw_elevations(drawing, layout.elevations);
    draw_answers(drawing, (struct pp_box){body.x, body.y + body.height - answers,
                                          body.width, answers});
    return PP_OK;
}

enum pp_status pp_exercise_chart_draw(struct pp_canvas *canvas,
                                      const struct pp_exercise *exercise,
                                      struct pp_error *err)
{
    struct exercise_drawing drawing = {.cr = pp_canvas_cairo(canvas),
                                       .style = pp_page_style(canvas),
                                       .exercise = exercise};
    struct pp_receiver receiver = exercise->receiver;
    drawing.report = (struct pp_report){
        .world = exercise->world, .receivers = &receiver, .receiver_count = 1};
    find_elevations(&drawing);
    if (drawing.elevation_count == 0)
        return pp_fail(err, PP_BAD_INPUT, "the point faces no opening");
    enum pp_status status =
        pp_section_cut_init(&drawing.cut, exercise->world, &receiver, 1, err);
    if (status != PP_OK)
        return status;
    char subtitle[256], sky[96], foot[2048] = "";
    pp_page_sky(sky, sizeof sky, exercise->world, exercise->light);
    snprintf(
        subtitle, sizeof subtitle,
        "Exercise: daylight at x\u00a0%.2f, y\u00a0%.2f, z\u00a0%.2f\u00a0m, by %s, %s",
        receiver.position.x, receiver.position.y, receiver.position.z, exercise->tool,
        sky);
    pp_page_assumptions(foot, sizeof foot, exercise->world, exercise->light);
    pp_room_words_outside(foot, sizeof foot, exercise->world);
    pp_page_say(foot, sizeof foot,
                "On the elevations, the cross is opposite the point, and the dashed "
                "line is at its height.");
    const struct pp_page page = {exercise->world->name, subtitle, foot};
    struct pp_box body = pp_page_draw(canvas, &drawing.style, &page);
    status = draw_body(&drawing, body, err);
    pp_section_cut_clear(&drawing.cut);
    return status;
}
