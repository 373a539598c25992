/* face_less_openings.c - see face_less_openings.h. */
#include "model/room/face_less_openings.h"

#include <stdbool.h>
#include <stdlib.h>

/* A corner returned by the clipper equals a polygon's corner if nearer than this. */
static const double SAME_POINT_M = 1e-7;

static enum pp_status region_of(struct pp_region *region, struct pp_clipper *clipper,
                                const struct pp_face_axes *axes,
                                const struct pp_polygon *polygon, struct pp_error *err)
{
    double(*xy)[2] = malloc(sizeof *xy * (size_t)polygon->count);
    if (!xy)
        return pp_fail_memory(err);
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 v = pp_vec_sub(polygon->vertices[i], axes->origin);
        xy[i][0] = pp_vec_dot(v, axes->a);
        xy[i][1] = pp_vec_dot(v, axes->b);
    }
    enum pp_status status = pp_clipper_by_crossings(
        clipper, region, (const double(*)[2])xy, polygon->count, err);
    free(xy);
    return status;
}

/* Subtracts an opening's outline from the region. */
static enum pp_status cut_opening_from_face(struct pp_region *region,
                                            struct pp_clipper *clipper,
                                            const struct pp_face_axes *axes,
                                            const struct pp_polygon *hole,
                                            struct pp_error *err)
{
    struct pp_region gap = {0, NULL};
    enum pp_status status = region_of(&gap, clipper, axes, hole, err);
    if (status == PP_OK)
        status = pp_clipper_take_away(clipper, region, &gap, err);
    pp_region_clear(&gap);
    return status;
}

struct pp_face_axes pp_face_less_openings_axes(const struct pp_polygon *polygon)
{
    struct pp_face_axes axes = {.origin = polygon->vertices[0]};
    pp_polygon_plane_axes(polygon->normal, &axes.a, &axes.b);
    return axes;
}

enum pp_status pp_face_less_openings(struct pp_region *region,
                                     struct pp_clipper *clipper,
                                     const struct pp_face_axes *axes,
                                     const struct pp_polygon *polygon,
                                     const struct pp_world *world, int face,
                                     struct pp_error *err)
{
    *region = (struct pp_region){0, NULL};
    enum pp_status status = region_of(region, clipper, axes, polygon, err);
    for (int i = 0; status == PP_OK && face >= 0 && i < world->opening_count; i++)
        if (world->openings[i].face == face)
            status = cut_opening_from_face(region, clipper, axes,
                                           &world->openings[i].inner, err);
    return status;
}

static bool snap(struct pp_vec3 *point, const struct pp_polygon *polygon)
{
    for (int i = 0; i < polygon->count; i++)
        if (pp_vec_length(pp_vec_sub(polygon->vertices[i], *point)) < SAME_POINT_M) {
            *point = polygon->vertices[i];
            return true;
        }
    return false;
}

struct pp_vec3 pp_face_less_openings_corner(const struct pp_face_axes *axes,
                                            const double xy[2],
                                            const struct pp_polygon *polygon,
                                            const struct pp_world *world, int face)
{
    struct pp_vec3 point =
        pp_vec_along(pp_vec_along(axes->origin, xy[0], axes->a), xy[1], axes->b);
    bool found = snap(&point, polygon);
    for (int i = 0; face >= 0 && !found && i < world->opening_count; i++)
        found =
            world->openings[i].face == face && snap(&point, &world->openings[i].inner);
    return point;
}
