/* room_plan.c - chooses the scale of a plan and draws walls, windows, rooflights and
 * free-standing surfaces.
 */
#include "charts/room/room_plan.h"

#include <math.h>
#include <stdio.h>

#include "charts/room/device_drawing.h"
#include "charts/room/plan_names.h"
#include "charts/room/plan_outside.h"

/* A window whose sill is higher than this above the working plane (m) is above the eyes
 * of seated users. It is dashed, like everything above the cut. */
#define HIGH_SILL_M 1.0

double pp_room_plan_border(const struct pp_room_plan *plan,
                           const struct pp_style *style, enum pp_plan_side side)
{
    double walls = pp_plan_frame_walls_mm(plan, style, side);
    return plan->named ? walls + pp_plan_names_mm(style, side) : walls;
}

void pp_room_plan_place(struct pp_room_plan *plan, const struct pp_style *style,
                        struct pp_box box, bool top)
{
    double width = (plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m;
    double height = (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m;
    double left = pp_room_plan_border(plan, style, PP_PLAN_LEFT),
           above = pp_room_plan_border(plan, style, PP_PLAN_ABOVE);
    double right = pp_room_plan_border(plan, style, PP_PLAN_RIGHT),
           below = pp_room_plan_border(plan, style, PP_PLAN_BELOW);
    double spare = top ? 0.0 : box.height - height - above - below;
    plan->x = box.x + 0.5 * (box.width - width - left - right) + left;
    plan->y = box.y + 0.5 * spare + above + height;
}

double pp_room_plan_usual_scale(double least)
{
    static const struct {
        double step, from; /* step is used if the power of ten is `from` or more */
    } steps[] = {{1.0, 1}, {1.25, 100}, {2.0, 1}, {2.5, 10},
                 {5.0, 1}, {7.5, 10},   {10.0, 1}};
    double power = pow(10.0, floor(log10(fmax(least, 1.0))));
    for (int i = 0; i < 7; i++)
        if (power >= steps[i].from && steps[i].step * power >= least * (1.0 - 1e-9))
            return steps[i].step * power;
    return 10.0 * power;
}

void pp_room_plan_fit(struct pp_room_plan *plan, const struct pp_world *world,
                      const struct pp_style *style, double width_mm, double height_mm)
{
    plan->world = world;
    plan->extent = pp_bounds2_empty();
    for (int r = 0; r < world->plane.count; r++)
        for (int i = 0; i < world->plane.rings[r].count; i++)
            pp_bounds2_add(&plan->extent, world->plane.rings[r].xy[i][0],
                           world->plane.rings[r].xy[i][1]);
    if (world->plane.count == 0)
        plan->extent = (struct pp_bounds2){{0.0, 0.0}, {1.0, 1.0}};

    /* Walls and reveals need more space at larger scales. The search starts with the
     * largest scale permitted and goes to smaller scales until room and borders fit. */
    plan->scale = fmax(plan->least_scale, 1.0);
    for (int i = 0; i < 100; i++) {
        plan->scale = pp_room_plan_usual_scale(plan->scale * (i ? 1.001 : 1.0));
        plan->mm_per_m = 1000.0 / plan->scale;
        double border[4];
        for (int side = 0; side < 4; side++)
            border[side] = pp_room_plan_border(plan, style, (enum pp_plan_side)side);
        if ((plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m
                    + border[PP_PLAN_LEFT] + border[PP_PLAN_RIGHT]
                <= width_mm
            && (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m
                       + border[PP_PLAN_ABOVE] + border[PP_PLAN_BELOW]
                   <= height_mm)
            return;
    }
}

void pp_room_plan_path(cairo_t *cr, const struct pp_room_plan *plan)
{
    const struct pp_region *plane = &plan->world->plane;
    for (int r = 0; r < plane->count; r++) {
        cairo_new_sub_path(cr);
        for (int i = 0; i < plane->rings[r].count; i++)
            cairo_line_to(cr, pp_plan_frame_x(plan, plane->rings[r].xy[i][0]),
                          pp_plan_frame_y(plan, plane->rings[r].xy[i][1]));
        cairo_close_path(cr);
    }
}

/* Draws the walls. The stroke is clipped to the outside of the room, so that the inner
 * edge of the stroke is the inside face. */
static void draw_walls(cairo_t *cr, const struct pp_style *style,
                       const struct pp_room_plan *plan)
{
    double weight = pp_plan_frame_wall_mm(style);
    cairo_save(cr);
    cairo_rectangle(
        cr, plan->x - 2.0 * weight,
        pp_plan_frame_y(plan, plan->extent.high[1]) - 2.0 * weight,
        (plan->extent.high[0] - plan->extent.low[0]) * plan->mm_per_m + 4.0 * weight,
        (plan->extent.high[1] - plan->extent.low[1]) * plan->mm_per_m + 4.0 * weight);
    pp_room_plan_path(cr, plan);
    cairo_set_fill_rule(cr, CAIRO_FILL_RULE_EVEN_ODD);
    cairo_clip(cr);
    pp_style_line(cr, 2.0 * weight, PP_INK);
    pp_room_plan_path(cr, plan);
    cairo_stroke(cr);
    cairo_restore(cr);
}

/* Traces a piece of a wall from its inner face outwards. */
static void trace_in_wall(cairo_t *cr, double ends[2][2], const double out[2],
                          double depth)
{
    cairo_new_path(cr);
    cairo_move_to(cr, ends[0][0], ends[0][1]);
    cairo_line_to(cr, ends[1][0], ends[1][1]);
    cairo_line_to(cr, ends[1][0] + depth * out[0], ends[1][1] + depth * out[1]);
    cairo_line_to(cr, ends[0][0] + depth * out[0], ends[0][1] + depth * out[1]);
    cairo_close_path(cr);
}

static void trace_jambs(cairo_t *cr, double ends[2][2], const double out[2],
                        double depth)
{
    for (int i = 0; i < 2; i++) {
        cairo_move_to(cr, ends[i][0], ends[i][1]);
        cairo_line_to(cr, ends[i][0] + depth * out[0], ends[i][1] + depth * out[1]);
    }
}

/* Draws a window. The outline of the wall is interrupted, and its faces continue as
 * thin lines. The glass is a line in its true position: in the middle of the wall or at
 * the outer end of the reveal. The opening extends to the facade. */
static void draw_window(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan,
                        const struct pp_opening *opening)
{
    double ends[2][2], out[2], weight = pp_plan_frame_wall_mm(style);
    pp_plan_frame_ends(plan, &opening->inner, ends, out);
    double lowest = INFINITY;
    for (int i = 0; i < opening->inner.count; i++)
        lowest = fmin(lowest, opening->inner.vertices[i].z);
    bool high = lowest > plan->world->working_plane_m + HIGH_SILL_M;
    double reveal = opening->reveal_m * plan->mm_per_m;
    double depth = fmax(weight, reveal + opening->recess_m * plan->mm_per_m);

    if (!high) {
        pp_style_grey(cr, 1.0);
        trace_in_wall(cr, ends, out, depth);
        cairo_fill(cr);
    }
    double lines[] = {0.0, reveal > 0.0 ? reveal : 0.5 * depth, depth};
    double dash = 1.0 * style->scale;
    pp_style_line(cr, style->thin, high ? 1.0 : PP_INK);
    if (high)
        cairo_set_dash(cr, &dash, 1, 0.0);
    for (int i = high ? 1 : 0; i < (high ? 2 : 3); i++) {
        double off = lines[i];
        cairo_move_to(cr, ends[0][0] + off * out[0], ends[0][1] + off * out[1]);
        cairo_line_to(cr, ends[1][0] + off * out[0], ends[1][1] + off * out[1]);
    }
    if (!high)
        trace_jambs(cr, ends, out, depth);
    cairo_stroke(cr);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            ends[i][k] += lines[1] * out[k];
    pp_device_drawing_cut(cr, style, opening, ends[0], ends[1],
                          (double[]){-out[0], -out[1]}, opening->device.vertical);
}

/* Draws a door. The line of the wall is interrupted up to the facade, and the closed
 * leaf is at the inner face. */
static void draw_door(cairo_t *cr, const struct pp_style *style,
                      const struct pp_room_plan *plan, const struct pp_surface *door)
{
    double ends[2][2], out[2], leaf = pp_plan_frame_wall_mm(style), depth = leaf;
    pp_plan_frame_ends(plan, &door->outline, ends, out);
    for (int i = 0; i < plan->world->facade_count; i++)
        if (plan->world->facades[i].face == door->owner)
            depth = fmax(depth, plan->world->facades[i].depth_m * plan->mm_per_m);
    pp_style_grey(cr, 1.0);
    trace_in_wall(cr, ends, out, depth);
    cairo_fill(cr);
    pp_style_line(cr, style->thin, PP_INK);
    trace_jambs(cr, ends, out, depth);
    cairo_stroke(cr);
    trace_in_wall(cr, ends, out, leaf);
    pp_style_grey(cr, PP_GREY_FILL);
    cairo_fill_preserve(cr);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_stroke(cr);
}

/* Draws rooflights and sloping glass, which are above the cut, with dashed lines.
 * Vertical glass inside the plan, such as a clerestory, is a single dashed line. */
static void draw_overhead(cairo_t *cr, const struct pp_style *style,
                          const struct pp_room_plan *plan,
                          const struct pp_opening *opening)
{
    double dashes[] = {1.4 * style->scale, 0.8 * style->scale}, ends[2][2], out[2];
    pp_style_line(cr, style->thin, PP_GREY_LINE);
    cairo_set_dash(cr, dashes, 2, 0.0);
    if (opening->slope_rad >= 89.5 * PP_RAD) {
        pp_plan_frame_ends(plan, &opening->inner, ends, out);
        cairo_set_line_width(cr, style->medium);
        cairo_move_to(cr, ends[0][0], ends[0][1]);
        cairo_line_to(cr, ends[1][0], ends[1][1]);
        cairo_stroke(cr);
        return;
    }
    cairo_new_sub_path(cr);
    for (int i = 0; i < opening->inner.count; i++)
        cairo_line_to(cr, pp_plan_frame_x(plan, opening->inner.vertices[i].x),
                      pp_plan_frame_y(plan, opening->inner.vertices[i].y));
    cairo_close_path(cr);
    cairo_stroke(cr);
}

/* Draws the line in which the working plane cuts a free-standing surface in the
 * room. */
static void draw_inside(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan,
                        const struct pp_polygon *outline)
{
    double height = plan->world->working_plane_m;
    int count = 0;
    pp_style_line(cr, style->thick, PP_INK);
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 a = outline->vertices[i];
        struct pp_vec3 b = outline->vertices[(i + 1) % outline->count];
        if ((a.z > height) == (b.z > height))
            continue;
        struct pp_vec3 p =
            pp_vec_along(a, (height - a.z) / (b.z - a.z), pp_vec_sub(b, a));
        if (count++ % 2 == 0)
            cairo_move_to(cr, pp_plan_frame_x(plan, p.x), pp_plan_frame_y(plan, p.y));
        else
            cairo_line_to(cr, pp_plan_frame_x(plan, p.x), pp_plan_frame_y(plan, p.y));
    }
    cairo_stroke(cr);
}

static bool stands_inside(const struct pp_surface *surface)
{
    return surface->inside && surface->role == PP_FREE_SURFACE;
}

static bool is_cut(const struct pp_polygon *outline, double height_m)
{
    for (int i = 1; i < outline->count; i++)
        if ((outline->vertices[i].z > height_m) != (outline->vertices[0].z > height_m))
            return true;
    return false;
}

bool pp_room_plan_has_overhead(const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++)
        if (!pp_plan_frame_is_in_wall(world, &world->openings[i]))
            return true;
    return false;
}

bool pp_room_plan_has_inside(const struct pp_world *world)
{
    for (int i = world->face_count; i < world->surface_count; i++)
        if (stands_inside(&world->surfaces[i])
            && is_cut(&world->surfaces[i].outline, world->working_plane_m))
            return true;
    return false;
}

void pp_room_plan_draw(cairo_t *cr, const struct pp_style *style,
                       const struct pp_room_plan *plan)
{
    const struct pp_world *world = plan->world;
    pp_plan_outside_draw(cr, style, plan);
    draw_walls(cr, style, plan);
    for (int i = world->face_count; i < world->surface_count; i++)
        if (stands_inside(&world->surfaces[i]))
            draw_inside(cr, style, plan, &world->surfaces[i].outline);
    for (int i = world->face_count; i < world->surface_count; i++)
        if (world->surfaces[i].is_door)
            draw_door(cr, style, plan, &world->surfaces[i]);
    for (int i = 0; i < world->opening_count; i++)
        (pp_plan_frame_is_in_wall(world, &world->openings[i])
             ? draw_window
             : draw_overhead)(cr, style, plan, &world->openings[i]);
}

struct pp_box pp_room_plan_scale_bar(cairo_t *cr, const struct pp_style *style,
                                     double mm_per_m, double x, double y)
{
    /* Largest of 1, 2 or 5 times a power of ten (m) that is not longer than 60 mm on
     * A4. */
    double most = 60.0 * style->scale / mm_per_m;
    double power = pow(10.0, floor(log10(most)));
    double metres = most >= 5.0 * power   ? 5.0 * power
                    : most >= 2.0 * power ? 2.0 * power
                                          : power;
    int parts = metres < 1.5 * power || metres > 4.0 * power ? 5 : 4;
    double part = metres * mm_per_m / parts, height = 1.0 * style->scale;

    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5};
    double top = y + 1.3 * style->text[PP_TEXT_SMALL], right = x;
    pp_style_line(cr, style->thin, PP_INK);
    for (int i = 0; i < parts; i++) {
        cairo_rectangle(cr, x + i * part, top, part, height);
        if (i % 2 == 0)
            cairo_fill_preserve(cr);
        cairo_stroke(cr);
    }
    for (int end = 0; end < 2; end++) {
        char words[32] = "0";
        if (end)
            pp_style_metres(words, sizeof words, metres);
        struct pp_box box =
            pp_lettering_draw(cr, style, &set, x + end * parts * part, y, words);
        right = fmax(right, box.x + box.width);
    }
    return (struct pp_box){x, y, right - x, top + height - y};
}

void pp_room_plan_north_arrow(cairo_t *cr, const struct pp_style *style,
                              double north_rad, double x, double y, double radius)
{
    cairo_save(cr);
    cairo_translate(cr, x, y);
    cairo_rotate(cr, -north_rad);
    pp_style_line(cr, style->thin, PP_INK);
    cairo_arc(cr, 0, 0, radius, 0, 2.0 * PP_PI);
    cairo_stroke(cr);
    cairo_move_to(cr, 0, -radius);
    cairo_line_to(cr, 0.45 * radius, 0.75 * radius);
    cairo_line_to(cr, 0, 0.4 * radius);
    cairo_close_path(cr);
    cairo_fill(cr);
    cairo_move_to(cr, 0, -radius);
    cairo_line_to(cr, -0.45 * radius, 0.75 * radius);
    cairo_line_to(cr, 0, 0.4 * radius);
    cairo_close_path(cr);
    cairo_stroke(cr);
    cairo_restore(cr);
    struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .bold = true, .across = 0.5, .down = 0.5};
    double away = radius + 0.7 * style->text[PP_TEXT_SMALL];
    pp_lettering_draw(cr, style, &set, x - away * sin(north_rad),
                      y - away * cos(north_rad), "N");
}
