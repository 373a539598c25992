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

/* Subtracts the polygon from the region. *less_m2 (may be NULL): the area that the
 * region loses. */
static enum pp_status take_polygon(struct pp_region *region, struct pp_clipper *clipper,
                                   const struct pp_face_axes *axes,
                                   const struct pp_polygon *polygon, double *less_m2,
                                   struct pp_error *err)
{
    struct pp_region part;
    double before = pp_region_area(region);
    enum pp_status status =
        pp_face_less_openings(&part, clipper, axes, polygon, NULL, -1, err);
    if (status == PP_OK)
        status = pp_clipper_take_away(clipper, region, &part, err);
    if (less_m2)
        *less_m2 = before - pp_region_area(region);
    pp_region_clear(&part);
    return status;
}

/* Gives the face the facade's reflectance if it stands in the gap. room: extent of the
 * room along the axes, to which the face is added. */
static enum pp_status add_face(struct pp_bounds2 *room, struct pp_region *gap,
                               struct pp_resolver *r, const struct pp_polygon *wall,
                               const struct pp_placement *place,
                               const struct pp_face_axes *axes,
                               const struct pp_facade *facade, struct pp_surface *face,
                               struct pp_error *err)
{
    struct pp_polygon copy;
    double covered_m2 = 0.0;
    enum pp_status status = copy_face(&copy, &face->outline, place, err);
    if (status != PP_OK)
        return status;
    for (int k = 0; k < copy.count; k++) {
        struct pp_vec3 from = pp_vec_sub(copy.vertices[k], axes->origin);
        pp_bounds2_add(room, pp_vec_dot(from, axes->a), pp_vec_dot(from, axes->b));
    }
    if (meets_wall(&copy, wall))
        status = take_polygon(gap, r->clipper, axes, &copy, &covered_m2, err);
    if (covered_m2 > overlap_m2)
        face->back = facade->reflectance;
    pp_polygon_clear(&copy);
    return status;
}

static enum pp_status take_room(struct pp_region *gap, struct pp_resolver *r,
                                const struct pp_face_axes *axes,
                                const struct pp_bounds2 *room, struct pp_error *err)
{
    struct pp_vec3 corners[4];
    struct pp_polygon rectangle;
    for (int k = 0; k < 4; k++) {
        double x = k == 1 || k == 2 ? room->high[0] : room->low[0],
               y = k >= 2 ? room->high[1] : room->low[1];
        corners[k] = pp_vec_along(pp_vec_along(axes->origin, x, axes->a), y, axes->b);
    }
    enum pp_status status = pp_polygon_of(&rectangle, corners, 4, err);
    if (status != PP_OK)
        return status;
    status = take_polygon(gap, r->clipper, axes, &rectangle, NULL, err);
    pp_polygon_clear(&rectangle);
    return status;
}

enum pp_status pp_nested_gap_find(struct pp_region *gap, struct pp_resolver *r,
                                  const struct pp_world *coarse,
                                  const struct pp_placement *place,
                                  const struct pp_facade *facade,
                                  const struct pp_face_axes *axes, struct pp_error *err)
{
    const struct pp_polygon *wall = &coarse->surfaces[facade->face].outline;
    struct pp_bounds2 room = pp_bounds2_empty();
    enum pp_status status =
        pp_face_less_openings(gap, r->clipper, axes, wall, NULL, -1, err);
    for (int i = 0; i < r->world->face_count && status == PP_OK; i++)
        status = add_face(&room, gap, r, wall, place, axes, facade,
                          &r->world->surfaces[i], err);
    return status == PP_OK ? take_room(gap, r, axes, &room, err) : status;
}
