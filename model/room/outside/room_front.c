/* room_front.c - see room_front.h. */
#include "model/room/outside/room_front.h"

#include <stdlib.h>

#include "model/geometry/tolerance.h"
#include "model/room/section.h"

/* Grid of the clipper, as for a facade's own sheet (facades.c). */
static const double grid_m = 0x1p-30;

void pp_room_front_clear(struct pp_room_front *front)
{
    pp_region_clear(&front->sheet);
}

/* Projects vertices onto the sheet's axes. The caller frees the result; NULL if memory
 * runs out. */
static double (*project_to_front(const struct pp_room_front *front,
                                 const struct pp_vec3 *vertices, int count))[2]
{
    double(*xy)[2] = malloc((size_t)count * sizeof *xy);
    if (xy)
        pp_polygon_flatten(vertices, count, front->origin, front->along, front->up, xy);
    return xy;
}

/* ---- a facade's sheet ---- */

bool pp_room_front_is_of_sheet(const struct pp_world *world, int surface)
{
    const struct pp_surface *it = &world->surfaces[surface];
    if (it->role != PP_FACADE)
        return false;
    struct pp_vec3 out =
        pp_vec_unit(pp_polygon_area_vector(world->facades[it->owner].corners, 4));
    return pp_vec_dot(it->outline.normal, out) > 0.5;
}

static bool is_of_facade(const struct pp_world *world, int surface, int facade)
{
    return pp_room_front_is_of_sheet(world, surface)
           && world->surfaces[surface].owner == facade;
}

/* Joins the triangles of the sheet into one region. */
static enum pp_status join_sheet(struct pp_room_front *front,
                                 const struct pp_world *world, int facade,
                                 const struct pp_placement *place,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_region *parts = calloc((size_t)world->surface_count + 1, sizeof *parts);
    int count = 0;
    enum pp_status status = parts ? PP_OK : pp_fail_memory(err);
    for (int i = 0; i < world->surface_count && status == PP_OK; i++) {
        if (!is_of_facade(world, i, facade))
            continue;
        struct pp_vec3 corners[3];
        double xy[3][2];
        for (int k = 0; k < 3; k++)
            corners[k] =
                pp_placement_to_building(place, world->surfaces[i].outline.vertices[k]);
        pp_polygon_flatten(corners, 3, front->origin, front->along, front->up, xy);
        status = pp_clipper_of_ring(clipper, &parts[count++], (const double(*)[2])xy, 3,
                                    err);
    }
    if (status == PP_OK)
        status = pp_clipper_union(clipper, &front->sheet, parts, count, err);
    for (int i = 0; i < count; i++)
        pp_region_clear(&parts[i]);
    free(parts);
    return status;
}

enum pp_status pp_room_front_of(struct pp_room_front *front,
                                const struct pp_world *world, int facade,
                                const struct pp_placement *place,
                                struct pp_clipper *clipper, struct pp_error *err)
{
    const struct pp_facade *it = &world->facades[facade];
    struct pp_vec3 corners[4];
    double xy[4][2];
    for (int k = 0; k < 4; k++)
        corners[k] = pp_placement_to_building(place, it->corners[k]);
    *front = (struct pp_room_front){.origin = corners[0],
                                    .extent = pp_bounds2_empty(),
                                    .reflectance = it->reflectance,
                                    .line = it->line};
    front->out = pp_vec_unit(pp_polygon_area_vector(corners, 4));
    pp_polygon_plane_axes(front->out, &front->along, &front->up);
    pp_polygon_flatten(corners, 4, front->origin, front->along, front->up, xy);
    for (int k = 0; k < 4; k++)
        pp_bounds2_add(&front->extent, xy[k][0], xy[k][1]);
    for (int i = 0; i < world->surface_count; i++)
        if (is_of_facade(world, i, facade))
            front->finish = world->surfaces[i].finish;
    pp_clipper_set_grid(clipper, grid_m);
    enum pp_status status = join_sheet(front, world, facade, place, clipper, err);
    pp_clipper_set_grid(clipper, 0.0);
    return status;
}

enum pp_status pp_room_front_copy(struct pp_room_front *copy,
                                  const struct pp_room_front *front,
                                  struct pp_error *err)
{
    *copy = *front;
    copy->sheet = (struct pp_region){0};
    return pp_region_copy(&copy->sheet, &front->sheet, err);
}

enum pp_status pp_room_front_cut(struct pp_region_pieces *pieces,
                                 const struct pp_room_front *front,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    enum pp_status status =
        pp_region_pieces_cut(pieces, &front->sheet, front->origin, front->along,
                             front->up, PP_ROOM_FRONT_PIECE_M2, clipper, err);
    for (int i = 0; i < pieces->count; i++) {
        struct pp_vec3 *corners = pieces->list[i].corners;
        int count = pieces->list[i].count;
        for (int k = 0; k < count / 2; k++) {
            struct pp_vec3 swap = corners[k];
            corners[k] = corners[count - 1 - k];
            corners[count - 1 - k] = swap;
        }
    }
    return status;
}

struct pp_surface_part pp_room_front_part(const struct pp_room_front *front)
{
    return (struct pp_surface_part){.reflectance = front->reflectance,
                                    .finish = front->finish,
                                    .what = "facade",
                                    .is_front = true,
                                    .is_of_site = true,
                                    .line = front->line};
}

/* ---- trimming ---- */

static bool meets(const struct pp_bounds2 *a, const struct pp_bounds2 *b)
{
    for (int k = 0; k < 2; k++)
        if (a->low[k] > b->high[k] - PP_ROUNDING_M
            || b->low[k] > a->high[k] - PP_ROUNDING_M)
            return false;
    return true;
}

static enum pp_status less(struct pp_room_front *front, const struct pp_region *minus,
                           struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_region left = {0};
    pp_clipper_set_grid(clipper, grid_m);
    enum pp_status status =
        pp_clipper_difference(clipper, &left, &front->sheet, minus, err);
    pp_clipper_set_grid(clipper, 0.0);
    if (status != PP_OK)
        return status;
    pp_region_clear(&front->sheet);
    front->sheet = left;
    return PP_OK;
}

/* True if the sheet is in front of the wall: both face the same way, and the wall is in
 * the sheet's plane or less than PP_ROOM_FRONT_BEHIND_M behind it. */
static bool is_before(const struct pp_room_front *front, const struct pp_polygon *wall)
{
    double behind = pp_vec_dot(front->out, front->origin)
                    - pp_vec_dot(front->out, pp_polygon_middle(wall));
    return pp_vec_length(pp_vec_cross(front->out, wall->normal)) < PP_LEVEL_RAD
           && pp_vec_dot(front->out, wall->normal) < 0.0 && behind > -PP_ROUNDING_M
           && behind < PP_ROOM_FRONT_BEHIND_M;
}

static enum pp_status leave_wall(struct pp_room_front *front,
                                 const struct pp_polygon *wall,
                                 struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    struct pp_region taken = {0};
    double(*xy)[2] = project_to_front(front, wall->vertices, wall->count);
    if (!xy)
        return pp_fail_memory(err);
    for (int i = 0; i < wall->count; i++)
        pp_bounds2_add(&bounds, xy[i][0], xy[i][1]);
    enum pp_status status = PP_OK;
    if (meets(&bounds, &front->extent))
        status = pp_clipper_by_crossings(clipper, &taken, (const double(*)[2])xy,
                                         wall->count, err);
    if (status == PP_OK && taken.count > 0)
        status = less(front, &taken, clipper, err);
    pp_region_clear(&taken);
    free(xy);
    return status;
}

/* Copies the body in the sheet's axes; z is the distance in front of the sheet's plane.
 * *goes_through: the body crosses the plane. The caller clears *turned, whatever the
 * status. */
static enum pp_status turn_body(struct pp_world *turned, bool *goes_through,
                                const struct pp_room_front *front,
                                const struct pp_world *body, struct pp_error *err)
{
    double low = INFINITY, high = -INFINITY;
    *turned = (struct pp_world){0};
    turned->surfaces = calloc((size_t)body->face_count + 1, sizeof *turned->surfaces);
    if (!turned->surfaces)
        return pp_fail_memory(err);
    for (int i = 0; i < body->face_count; i++) {
        struct pp_polygon *outline = &turned->surfaces[i].outline;
        const struct pp_polygon *face = &body->surfaces[i].outline;
        if (pp_polygon_of(outline, face->vertices, face->count, err) != PP_OK)
            return PP_SYSTEM;
        turned->face_count++;
        for (int k = 0; k < face->count; k++) {
            struct pp_vec3 from = pp_vec_sub(face->vertices[k], front->origin);
            outline->vertices[k] =
                pp_vec(pp_vec_dot(from, front->along), pp_vec_dot(from, front->up),
                       pp_vec_dot(from, front->out));
            low = fmin(low, outline->vertices[k].z);
            high = fmax(high, outline->vertices[k].z);
        }
        pp_polygon_measure(outline);
    }
    *goes_through = low < -PP_SAME_M && high > PP_SAME_M;
    return PP_OK;
}

/* Removes the section of a room that crosses the sheet's plane. The section is
 * calculated just behind the plane. */
static enum pp_status leave_section(struct pp_room_front *front,
                                    const struct pp_world *body,
                                    struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_world turned;
    struct pp_region section = {0};
    bool goes_through = false;
    enum pp_status status = turn_body(&turned, &goes_through, front, body, err);
    if (status == PP_OK && goes_through)
        status = pp_section_at(&section, &turned, -PP_SAME_M, err);
    if (status == PP_OK && section.count > 0)
        status = less(front, &section, clipper, err);
    pp_region_clear(&section);
    for (int i = 0; i < turned.face_count; i++)
        pp_polygon_clear(&turned.surfaces[i].outline);
    free(turned.surfaces);
    return status;
}

enum pp_status pp_room_front_give_way(struct pp_room_front *front,
                                      const struct pp_world *body,
                                      struct pp_clipper *clipper, struct pp_error *err)
{
    enum pp_status status = leave_section(front, body, clipper, err);
    for (int i = 0; i < body->face_count && status == PP_OK; i++)
        if (is_before(front, &body->surfaces[i].outline))
            status = leave_wall(front, &body->surfaces[i].outline, clipper, err);
    return status;
}

/* Extent of the other front in the axes of the first; both lie in one plane with
 * parallel axes. */
static struct pp_bounds2 extent_in(const struct pp_room_front *front,
                                   const struct pp_room_front *other)
{
    struct pp_vec3 from = pp_vec_sub(other->origin, front->origin);
    double x = pp_vec_dot(from, front->along), y = pp_vec_dot(from, front->up);
    struct pp_bounds2 extent = other->extent;
    for (int i = 0; i < 2; i++) {
        double *ends = i == 0 ? extent.low : extent.high;
        ends[0] += x;
        ends[1] += y;
    }
    return extent;
}

bool pp_room_front_overlaps(const struct pp_room_front *a,
                            const struct pp_room_front *b)
{
    struct pp_bounds2 extent = extent_in(a, b);
    return pp_vec_length(pp_vec_cross(a->out, b->out)) < PP_LEVEL_RAD
           && pp_vec_dot(a->out, b->out) > 0.0
           && fabs(pp_vec_dot(a->out, pp_vec_sub(b->origin, a->origin))) < PP_SAME_M
           && meets(&a->extent, &extent);
}

enum pp_status pp_room_front_take_out(struct pp_room_front *front,
                                      const struct pp_room_front *other,
                                      struct pp_clipper *clipper, struct pp_error *err)
{
    struct pp_bounds2 extent = extent_in(front, other);
    const double *low = extent.low, *high = extent.high;
    const double ring[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    struct pp_region taken = {0};
    enum pp_status status = pp_clipper_of_ring(clipper, &taken, ring, 4, err);
    if (status == PP_OK)
        status = less(front, &taken, clipper, err);
    pp_region_clear(&taken);
    return status;
}
