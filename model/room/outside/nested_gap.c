/* nested_gap.c - see nested_gap.h. */
#include "model/room/outside/nested_gap.h"

#include <math.h>

#include "model/geometry/tolerance.h"

/* Greatest angle between a facade and a wall in its plane (rad). */
static const double one_plane_rad = 1.0 * PP_RAD;

/* A smaller overlap of a wall and the gap (m2) is rounding. */
static const double overlap_m2 = 1e-6;

/* Copies the face of the room to the axes of the coarse model. */
static enum pp_status copy_face(struct pp_polygon *copy, const struct pp_polygon *face,
                                const struct pp_placement *place, struct pp_error *err)
{
    enum pp_status status = pp_polygon_of(copy, face->vertices, face->count, err);
    if (status != PP_OK)
        return status;
    for (int k = 0; k < copy->count; k++)
        copy->vertices[k] = pp_placement_to_room(place, copy->vertices[k]);
    pp_polygon_measure(copy);
    return PP_OK;
}

/* True if the face has the bearing of the wall, and meets its plane. */
static bool meets_wall(const struct pp_polygon *face, const struct pp_polygon *wall)
{
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < face->count; k++) {
        double height = pp_polygon_height(wall, face->vertices[k]);
        low = fmin(low, height);
        high = fmax(high, height);
    }
    return pp_vec_dot(face->normal, wall->normal) >= cos(one_plane_rad)
           && low < PP_SET_OFF_M && high > -PP_SET_OFF_M;
}

/* A gap, and the room beside it. */
struct gap_beside_room {
    struct pp_region *gap;
    struct pp_resolver *r;
    const struct pp_polygon *wall; /* of the coarse model */
    const struct pp_face_axes *axes;
    struct pp_bounds2 room; /* extent of the room along the axes */
};

/* Subtracts the polygon from the gap. *less_m2: the area that the gap loses. */
static enum pp_status take_polygon(const struct gap_beside_room *g,
                                   const struct pp_polygon *polygon, double *less_m2,
                                   struct pp_error *err)
{
    struct pp_region part;
    double before = pp_region_area(g->gap);
    enum pp_status status =
        pp_face_less_openings(&part, g->r->clipper, g->axes, polygon, NULL, -1, err);
    if (status == PP_OK)
        status = pp_clipper_take_away(g->r->clipper, g->gap, &part, err);
    *less_m2 = before - pp_region_area(g->gap);
    pp_region_clear(&part);
    return status;
}

/* Adds a face to the extent of the room. If it stands in the gap, it gets the
 * reflectance of the facade. */
static enum pp_status add_face(struct gap_beside_room *g, struct pp_surface *face,
                               const struct pp_placement *place, double reflectance,
                               struct pp_error *err)
{
    struct pp_polygon copy;
    double covered_m2 = 0.0;
    enum pp_status status = copy_face(&copy, &face->outline, place, err);
    if (status != PP_OK)
        return status;
    for (int k = 0; k < copy.count; k++) {
        struct pp_vec3 from = pp_vec_sub(copy.vertices[k], g->axes->origin);
        pp_bounds2_add(&g->room, pp_vec_dot(from, g->axes->a),
                       pp_vec_dot(from, g->axes->b));
    }
    if (meets_wall(&copy, g->wall))
        status = take_polygon(g, &copy, &covered_m2, err);
    if (covered_m2 > overlap_m2)
        face->back = reflectance;
    pp_polygon_clear(&copy);
    return status;
}

/* Subtracts the rectangle that the room covers. */
static enum pp_status take_room(const struct gap_beside_room *g, struct pp_error *err)
{
    const double *low = g->room.low, *high = g->room.high;
    struct pp_vec3 corners[4];
    struct pp_polygon rectangle;
    double covered_m2;
    for (int k = 0; k < 4; k++) {
        double x = k == 1 || k == 2 ? high[0] : low[0], y = k >= 2 ? high[1] : low[1];
        corners[k] =
            pp_vec_along(pp_vec_along(g->axes->origin, x, g->axes->a), y, g->axes->b);
    }
    enum pp_status status = pp_polygon_of(&rectangle, corners, 4, err);
    if (status != PP_OK)
        return status;
    status = take_polygon(g, &rectangle, &covered_m2, err);
    pp_polygon_clear(&rectangle);
    return status;
}

enum pp_status pp_nested_gap_find(struct pp_region *gap, struct pp_resolver *r,
                                  const struct pp_world *coarse,
                                  const struct pp_placement *place,
                                  const struct pp_facade *facade,
                                  const struct pp_face_axes *axes, struct pp_error *err)
{
    struct gap_beside_room g = {.gap = gap,
                                .r = r,
                                .wall = &coarse->surfaces[facade->face].outline,
                                .axes = axes,
                                .room = pp_bounds2_empty()};
    enum pp_status status =
        pp_face_less_openings(gap, r->clipper, axes, g.wall, NULL, -1, err);
    for (int i = 0; i < r->world->face_count && status == PP_OK; i++)
        status = add_face(&g, &r->world->surfaces[i], place, facade->reflectance, err);
    return status == PP_OK ? take_room(&g, err) : status;
}
