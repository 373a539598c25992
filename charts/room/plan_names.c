/* plan_names.c - see plan_names.h. */
#include "charts/room/plan_names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/room/section.h"

/* Maximum number of names that are registered, so that later names do not cover
 * them. */
enum { NAMES_MOST = 200 };

struct name_drawing {
    cairo_t *cr;
    const struct pp_style *style;
    const struct pp_room_plan *plan;
    struct pp_box taken[NAMES_MOST];
    int count;
};

/* Height (mm) of the strip of names, and of the strip of dimensions outside it. */
static double strip_mm(const struct pp_style *style)
{
    return 4.6 * style->scale;
}

double pp_plan_names_mm(const struct pp_style *style, enum pp_plan_side side)
{
    bool measured = side == PP_PLAN_LEFT || side == PP_PLAN_BELOW;
    return measured ? 2.0 * strip_mm(style) : strip_mm(style);
}

static void take(struct name_drawing *drawing, struct pp_box box)
{
    if (drawing->count < NAMES_MOST)
        drawing->taken[drawing->count++] = box;
}

static bool is_free(const struct name_drawing *drawing, struct pp_box box)
{
    double gap = 0.6 * drawing->style->scale;
    struct pp_box wide = {box.x - gap, box.y - gap, box.width + 2.0 * gap,
                          box.height + 2.0 * gap};
    for (int i = 0; i < drawing->count; i++)
        if (pp_lettering_boxes_overlap(drawing->taken[i], wide))
            return false;
    return drawing->count < NAMES_MOST;
}

/* ---- along walls ---- */

/* Distance on paper (mm) from the wall's inner face to its outer face or facade. */
static double depth_of(const struct name_drawing *drawing, int face)
{
    const struct pp_world *world = drawing->plan->world;
    double depth = pp_plan_frame_wall_mm(drawing->style);
    for (int i = 0; i < world->facade_count; i++)
        if (world->facades[i].face == face)
            depth = fmax(depth, world->facades[i].depth_m * drawing->plan->mm_per_m
                                    + drawing->style->medium);
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            depth =
                fmax(depth, (world->openings[i].reveal_m + world->openings[i].recess_m)
                                * drawing->plan->mm_per_m);
    return depth;
}

/* Writes a name outside a wall, at the middle of a piece of the wall or at the nearest
 * free place. Names along walls that run up the sheet are turned. */
static void write_along(struct name_drawing *drawing, const struct pp_polygon *piece,
                        int face, struct pp_lettering set, const char *words)
{
    const struct pp_style *style = drawing->style;
    double ends[2][2], out[2];
    pp_plan_frame_ends(drawing->plan, piece, ends, out);
    struct pp_box size =
        pp_lettering_measure(drawing->cr, style, &set, 0.0, 0.0, words);
    bool turned = fabs(out[0]) > fabs(out[1]);
    double wide = turned ? size.height : size.width,
           high = turned ? size.width : size.height;
    double off = depth_of(drawing, face) + 0.8 * style->scale
                 + 0.5 * (fabs(out[0]) * wide + fabs(out[1]) * high);
    double length = hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    double along[2] = {-out[1], out[0]}, step = 0.5 * style->scale;
    set.across = set.down = 0.5;
    set.turn_rad = turned ? -0.5 * PP_PI : 0.0;
    for (int i = 0; i * step <= 0.5 * length + 6.0 * style->scale; i++)
        for (int way = -1; way <= 1; way += 2) {
            double x = 0.5 * (ends[0][0] + ends[1][0]) + off * out[0]
                       + way * i * step * along[0];
            double y = 0.5 * (ends[0][1] + ends[1][1]) + off * out[1]
                       + way * i * step * along[1];
            struct pp_box box = {x - 0.5 * wide, y - 0.5 * high, wide, high};
            if (!is_free(drawing, box))
                continue;
            take(drawing, box);
            pp_style_grey(drawing->cr, 1.0);
            cairo_rectangle(drawing->cr, box.x, box.y, box.width, box.height);
            cairo_fill(drawing->cr);
            pp_lettering_draw(drawing->cr, style, &set, x, y, words);
            return;
        }
}

static void name_windows(struct name_drawing *drawing)
{
    const struct pp_world *world = drawing->plan->world;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .bold = true};
    for (int i = 0; i < world->opening_count; i++)
        if (pp_plan_frame_is_in_wall(world, &world->openings[i]))
            write_along(drawing, &world->openings[i].inner, world->openings[i].face,
                        set, world->openings[i].label);
}

void pp_plan_names_wall(char words[PP_PLAN_NAMES_WALL], const char *name)
{
    bool number = strspn(name, "0123456789") == strlen(name);
    snprintf(words, PP_PLAN_NAMES_WALL, "%s%.30s", number ? "wall " : "", name);
}

static void name_walls(struct name_drawing *drawing)
{
    const struct pp_world *world = drawing->plan->world;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .grey = PP_GREY_TEXT};
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *wall = &world->surfaces[i];
        char words[PP_PLAN_NAMES_WALL];
        if (wall->role != PP_WALL || !wall->name || fabs(wall->outline.normal.z) > 1e-3)
            continue;
        pp_plan_names_wall(words, wall->name);
        write_along(drawing, &wall->outline, i, set, words);
    }
}

/* ---- overhead ---- */

/* Box of the name of an opening above the plane, in the upper left corner of its
 * outline. */
static struct pp_box overhead_box(cairo_t *cr, const struct pp_style *style,
                                  const struct pp_room_plan *plan,
                                  const struct pp_opening *opening)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .bold = true};
    double x = INFINITY, y = INFINITY, gap = 0.6 * style->scale;
    for (int i = 0; i < opening->inner.count; i++) {
        x = fmin(x, pp_plan_frame_x(plan, opening->inner.vertices[i].x));
        y = fmin(y, pp_plan_frame_y(plan, opening->inner.vertices[i].y));
    }
    return pp_lettering_measure(cr, style, &set, x + gap, y + gap, opening->label);
}

/* Registers the area of a fitting that the plane cuts, as nested outlines 2 mm apart,
 * which is less than the height of any label. */
static void note_fitting(struct pp_labels *labels, const struct pp_room_plan *plan,
                         const struct pp_fitting *fitting)
{
    static const double APART_MM = 2.0;
    int corners = fitting->corner_count;
    double centre[2] = {0.0, 0.0}, xy[PP_FITTING_CORNERS][2], reach = 0.0;
    for (int k = 0; k < corners; k++) {
        xy[k][0] = pp_plan_frame_x(plan, fitting->xy[k][0]);
        xy[k][1] = pp_plan_frame_y(plan, fitting->xy[k][1]);
        centre[0] += xy[k][0] / corners;
        centre[1] += xy[k][1] / corners;
    }
    for (int k = 0; k < corners; k++)
        reach = fmax(reach, hypot(xy[k][0] - centre[0], xy[k][1] - centre[1]));
    for (double off = 0.0; off < reach; off += APART_MM) {
        double share = 1.0 - off / reach;
        for (int k = 0; k < corners; k++) {
            const double *a = xy[k], *b = xy[(k + 1) % corners];
            pp_labels_note(labels, PP_LABEL_MARKS,
                           centre[0] + share * (a[0] - centre[0]),
                           centre[1] + share * (a[1] - centre[1]),
                           centre[0] + share * (b[0] - centre[0]),
                           centre[1] + share * (b[1] - centre[1]));
        }
    }
}

void pp_plan_names_note(struct pp_labels *labels, cairo_t *cr,
                        const struct pp_style *style, const struct pp_room_plan *plan)
{
    const struct pp_world *world = plan->world;
    for (int i = 0; i < world->opening_count; i++)
        if (!pp_plan_frame_is_in_wall(world, &world->openings[i]))
            pp_labels_note_box(labels,
                               overhead_box(cr, style, plan, &world->openings[i]));
    for (int i = 0; i < world->fitting_count; i++)
        if (pp_section_meets(world, &world->fittings[i]))
            note_fitting(labels, plan, &world->fittings[i]);
}

static void name_overhead(struct name_drawing *drawing)
{
    const struct pp_world *world = drawing->plan->world;
    const struct pp_lettering set = {.size = PP_TEXT_SMALL, .bold = true};
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (pp_plan_frame_is_in_wall(world, opening))
            continue;
        struct pp_box box =
            overhead_box(drawing->cr, drawing->style, drawing->plan, opening);
        if (!is_free(drawing, box))
            continue;
        take(drawing, box);
        pp_lettering_draw_on_white(drawing->cr, drawing->style, &set, box.x, box.y,
                                   opening->label);
    }
}

/* ---- dimensions ---- */

void pp_plan_names_dimension(cairo_t *cr, const struct pp_style *style, double x0,
                             double y0, double x1, double y1, double metres,
                             bool with_unit)
{
    double tick = 0.9 * style->scale;
    char words[32];
    struct pp_lettering set = {.size = PP_TEXT_SMALL, .across = 0.5, .down = 0.5};
    bool upright = fabs(y1 - y0) > fabs(x1 - x0);
    double x = 0.5 * (x0 + x1), y = 0.5 * (y0 + y1);
    pp_style_line(cr, style->hair, PP_INK);
    cairo_new_path(cr);
    cairo_move_to(cr, x0, y0);
    cairo_line_to(cr, x1, y1);
    for (int end = 0; end < 2; end++) {
        double ex = end ? x1 : x0, ey = end ? y1 : y0;
        cairo_move_to(cr, ex - tick, ey + tick);
        cairo_line_to(cr, ex + tick, ey - tick);
    }
    cairo_stroke(cr);
    pp_style_metres(words, sizeof words, metres);
    if (!with_unit)
        words[strcspn(words, "\u00a0 ")] = '\0';
    struct pp_box box = pp_lettering_measure(cr, style, &set, x, y, words);
    double wide = upright ? box.height : box.width + 1.6 * style->scale;
    double high = upright ? box.width + 1.6 * style->scale : box.height;
    if (box.width + 1.6 * style->scale > hypot(x1 - x0, y1 - y0)) {
        x -= upright ? 0.8 * box.height : 0.0;
        y += upright ? 0.0 : 0.8 * box.height;
    }
    pp_style_grey(cr, 1.0);
    cairo_rectangle(cr, x - 0.5 * wide, y - 0.5 * high, wide, high);
    cairo_fill(cr);
    set.turn_rad = upright ? -0.5 * PP_PI : 0.0;
    pp_lettering_draw(cr, style, &set, x, y, words);
}

static void draw_dimensions(struct name_drawing *drawing)
{
    const struct pp_room_plan *plan = drawing->plan;
    const struct pp_style *style = drawing->style;
    const struct pp_bounds2 *room = &plan->extent;
    double left = plan->x, below = plan->y;
    double right = pp_plan_frame_x(plan, room->high[0]),
           top = pp_plan_frame_y(plan, room->high[1]);
    double y = below + pp_plan_frame_walls_mm(plan, style, PP_PLAN_BELOW)
               + 1.5 * strip_mm(style);
    double x = left - pp_plan_frame_walls_mm(plan, style, PP_PLAN_LEFT)
               - 1.5 * strip_mm(style);
    pp_plan_names_dimension(drawing->cr, style, left, y, right, y,
                            room->high[0] - room->low[0], true);
    pp_plan_names_dimension(drawing->cr, style, x, below, x, top,
                            room->high[1] - room->low[1], true);
}

/* ---- section marks ---- */

/* Thickness on paper (mm) of the wall on whose inner face a point (m) lies. */
static double depth_at(const struct name_drawing *drawing, const double xy[2])
{
    const struct pp_world *world = drawing->plan->world;
    double depth = pp_plan_frame_wall_mm(drawing->style);
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *wall = &world->surfaces[i].outline;
        struct pp_vec3 place = pp_vec(xy[0], xy[1], wall->vertices[0].z);
        struct pp_vec3 to = pp_vec_sub(place, wall->vertices[0]);
        if (world->surfaces[i].role == PP_WALL
            && fabs(pp_vec_dot(to, wall->normal)) < 0.02)
            depth = fmax(depth, depth_of(drawing, i));
    }
    return depth;
}

/* Draws one end of a section mark: a heavy line outwards, an arrow in the direction of
 * view, and the letter A. out: unit vector on paper out of the room, along the section;
 * seen: unit vector in the direction of view. */
static void mark_end(struct name_drawing *drawing, double x, double y, double depth,
                     const double out[2], const double seen[2])
{
    cairo_t *cr = drawing->cr;
    const struct pp_style *style = drawing->style;
    const struct pp_lettering set = {
        .size = PP_TEXT_SMALL, .bold = true, .across = 0.5, .down = 0.5};
    double from = depth + 0.5 * style->scale, to = from + 3.2 * style->scale,
           head = 1.0 * style->scale;
    double tip[2] = {x + to * out[0] + 2.6 * style->scale * seen[0],
                     y + to * out[1] + 2.6 * style->scale * seen[1]};
    double letter[2] = {tip[0] + 1.6 * style->scale * seen[0],
                        tip[1] + 1.6 * style->scale * seen[1]};
    pp_style_line(cr, style->thick, PP_INK);
    cairo_new_path(cr);
    cairo_move_to(cr, x + from * out[0], y + from * out[1]);
    cairo_line_to(cr, x + to * out[0], y + to * out[1]);
    cairo_stroke(cr);
    const double foot[2] = {x + to * out[0], y + to * out[1]};
    pp_style_arrow(cr, style, foot, tip, head, 0.5 * head);
    struct pp_box box = pp_lettering_draw(cr, style, &set, letter[0], letter[1], "A");
    double low[2] = {fmin(box.x, x), fmin(box.y, y)},
           high[2] = {fmax(box.x + box.width, x), fmax(box.y + box.height, y)};
    take(drawing,
         (struct pp_box){low[0], low[1], high[0] - low[0] + 0.4, high[1] - low[1]});
}

static void draw_mark(struct name_drawing *drawing, const struct pp_plan_mark *mark)
{
    const struct pp_room_plan *plan = drawing->plan;
    double x[2] = {pp_plan_frame_x(plan, mark->from[0]),
                   pp_plan_frame_x(plan, mark->to[0])};
    double y[2] = {pp_plan_frame_y(plan, mark->from[1]),
                   pp_plan_frame_y(plan, mark->to[1])};
    double length = hypot(x[1] - x[0], y[1] - y[0]);
    if (!(length > 0.0))
        return;
    double along[2] = {(x[1] - x[0]) / length, (y[1] - y[0]) / length};
    /* On paper y runs down, so the left of `along` is (along_y, -along_x). */
    double seen[2] = {along[1], -along[0]}, back[2] = {-along[0], -along[1]};
    mark_end(drawing, x[0], y[0], depth_at(drawing, mark->from), back, seen);
    mark_end(drawing, x[1], y[1], depth_at(drawing, mark->to), along, seen);
}

void pp_plan_names_draw(cairo_t *cr, const struct pp_style *style,
                        const struct pp_room_plan *plan,
                        const struct pp_plan_mark *mark)
{
    struct name_drawing drawing = {.cr = cr, .style = style, .plan = plan};
    if (mark)
        draw_mark(&drawing, mark);
    name_windows(&drawing);
    name_walls(&drawing);
    name_overhead(&drawing);
    draw_dimensions(&drawing);
}
