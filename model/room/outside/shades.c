/* shades.c - see shades.h. */
#include "model/room/outside/shades.h"

#include <math.h>

#include "model/geometry/tolerance.h"
#include "model/room/build/free_surfaces.h"

static const char *const words[] = {[PP_OVERHANG] = "overhang",
                                    [PP_FIN] = "fin",
                                    [PP_BALCONY] = "balcony",
                                    [PP_SHELF] = "shelf"};

const char *pp_shades_word(const struct pp_opening_part *part, int line)
{
    for (int i = 0; i < part->shade_count; i++)
        if (part->shades[i].line == line)
            return words[part->shades[i].kind];
    return NULL;
}

/* Axes of a window as seen from outside: right from its left jamb, outwards from the
 * outer face of the wall, up from its sill. */
struct window_axes {
    struct pp_vec3 corner, right, out;
    double width_m, height_m;
    double wall_m;  /* thickness of the wall, outer face to inner face */
    double floor_m; /* height of the room's floor relative to the sill */
};

static struct window_axes axes_of(const struct pp_world *world,
                                  const struct pp_opening *opening)
{
    struct window_axes axes = {.right = pp_vec_scale(opening->along, -1.0),
                               .out = pp_vec_scale(opening->inner.normal, -1.0),
                               .width_m = opening->width_m,
                               .height_m = opening->height_m};
    axes.wall_m = opening->facade >= 0 ? world->facades[opening->facade].depth_m
                                       : opening->reveal_m;
    /* Lower left corner as seen from outside. */
    axes.corner = opening->inner.vertices[0];
    for (int i = 1; i < opening->inner.count; i++) {
        struct pp_vec3 from = pp_vec_sub(opening->inner.vertices[i], axes.corner);
        if (pp_vec_dot(from, axes.right) - 1e-9 < 0.0 && from.z - 1e-9 < 0.0)
            axes.corner = opening->inner.vertices[i];
    }
    axes.floor_m = -axes.corner.z;
    axes.corner = pp_vec_along(axes.corner, axes.wall_m, axes.out);
    return axes;
}

static struct pp_vec3 at(const struct window_axes *axes, double right, double out,
                         double up)
{
    struct pp_vec3 p = pp_vec_along(axes->corner, right, axes->right);
    p = pp_vec_along(p, out, axes->out);
    p.z += up;
    return p;
}

static enum pp_status add_shade_surface(struct pp_resolver *r,
                                        const struct pp_shade_part *shade,
                                        const struct pp_vec3 corners[4],
                                        struct pp_error *err)
{
    struct pp_vec3 list[4] = {corners[0], corners[1], corners[2], corners[3]};
    int lines[4] = {shade->line, shade->line, shade->line, shade->line};
    const struct pp_surface_part part = {
        .vertices = {.list = list, .lines = lines, .count = 4},
        .reflectance = shade->reflectance,
        .finish = shade->finish,
        .line = shade->line};
    return pp_build_free_surfaces_add(r, &part, words[shade->kind], err);
}

/* Adds a horizontal rectangle, `up` above the sill. */
static enum pp_status add_level(struct pp_resolver *r,
                                const struct pp_shade_part *shade,
                                const struct window_axes *axes, double up, double from,
                                double to, struct pp_error *err)
{
    double left = -shade->left_m, right = axes->width_m + shade->right_m;
    return add_shade_surface(
        r, shade,
        (struct pp_vec3[]){at(axes, left, from, up), at(axes, right, from, up),
                           at(axes, right, to, up), at(axes, left, to, up)},
        err);
}

/* Adds a vertical rectangle over a line whose ends are given as (right, out). */
static enum pp_status add_upright(struct pp_resolver *r,
                                  const struct pp_shade_part *shade,
                                  const struct window_axes *axes, const double from[2],
                                  const double to[2], double low, double high,
                                  struct pp_error *err)
{
    return add_shade_surface(r, shade,
                             (struct pp_vec3[]){at(axes, from[0], from[1], low),
                                                at(axes, to[0], to[1], low),
                                                at(axes, to[0], to[1], high),
                                                at(axes, from[0], from[1], high)},
                             err);
}

static enum pp_status add_fins(struct pp_resolver *r, const struct pp_shade_part *shade,
                               const struct window_axes *axes, struct pp_error *err)
{
    const double places[] = {-shade->left_m, axes->width_m + shade->right_m};
    const bool there[] = {shade->is_left, shade->is_right};
    enum pp_status status = PP_OK;
    for (int i = 0; i < 2 && status == PP_OK; i++)
        if (there[i])
            status = add_upright(r, shade, axes, (double[]){places[i], 0.0},
                                 (double[]){places[i], shade->depth_m}, -shade->below_m,
                                 axes->height_m + shade->above_m, err);
    return status;
}

static enum pp_status add_balcony(struct pp_resolver *r,
                                  const struct pp_shade_part *shade,
                                  const struct window_axes *axes, struct pp_error *err)
{
    double floor = axes->floor_m + shade->height_m, depth = shade->depth_m;
    double rail = floor + shade->parapet_m;
    double left = -shade->left_m, right = axes->width_m + shade->right_m;
    const double corners[4][2] = {
        {left, 0.0}, {left, depth}, {right, depth}, {right, 0.0}};
    enum pp_status status = add_level(r, shade, axes, floor, 0.0, depth, err);
    for (int i = 0; i < 3 && status == PP_OK && shade->parapet_m > 0.0; i++)
        status =
            add_upright(r, shade, axes, corners[i], corners[i + 1], floor, rail, err);
    return status;
}

static enum pp_status add_shelf(struct pp_resolver *r,
                                const struct pp_shade_part *shade,
                                const struct window_axes *axes, struct pp_error *err)
{
    if (shade->height_m >= axes->height_m) {
        pp_mistakes_add(r->mistakes, shade->line,
                        "shelf: is %g m above the sill of a window %g m high; "
                        "expected below the head",
                        shade->height_m, axes->height_m);
        return PP_OK;
    }
    enum pp_status status = PP_OK;
    if (shade->depth_m >= PP_SAME_M)
        status = add_level(r, shade, axes, shade->height_m, 0.0, shade->depth_m, err);
    if (status == PP_OK && shade->inside_m >= PP_SAME_M)
        status = add_level(r, shade, axes, shade->height_m, -axes->wall_m,
                           -axes->wall_m - shade->inside_m, err);
    return status;
}

static enum pp_status add_shade(struct pp_resolver *r,
                                const struct pp_shade_part *shade,
                                const struct window_axes *axes, struct pp_error *err)
{
    switch (shade->kind) {
    case PP_OVERHANG:
        return add_level(r, shade, axes, axes->height_m + shade->above_m, 0.0,
                         shade->depth_m, err);
    case PP_FIN:
        return add_fins(r, shade, axes, err);
    case PP_BALCONY:
        return add_balcony(r, shade, axes, err);
    case PP_SHELF:
        return add_shelf(r, shade, axes, err);
    }
    return PP_OK;
}

enum pp_status pp_build_shades(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && r->watertight; i++) {
        const struct pp_opening *opening = &world->openings[i];
        const struct pp_opening_part *part = &r->room->openings[opening->part];
        if (part->shade_count == 0)
            continue;
        if (fabs(opening->inner.normal.z) > PP_SAME_M) {
            pp_mistakes_add(
                r->mistakes, part->shades[0].line,
                "%s: the wall of the window is not vertical; expected a vertical wall",
                words[part->shades[0].kind]);
            continue;
        }
        struct window_axes axes = axes_of(world, opening);
        const int before = world->surface_count;
        for (int k = 0; k < part->shade_count && status == PP_OK; k++)
            status = add_shade(r, &part->shades[k], &axes, err);
        for (int k = before; k < world->surface_count; k++) {
            world->surfaces[k].is_shade = true;
            world->surfaces[k].owner = i;
        }
    }
    return status;
}
