/* position.c - see position.h.
 *
 * A vertical line upwards from a point in the room crosses one more ceiling than
 * floors. Crossings are decided in plan, with half-open edges. Since neighbouring faces
 * share the ends of an edge exactly, a line through the edge crosses exactly one of the
 * two faces, and never a vertical face.
 */
#include "model/room/position.h"

#include <stdlib.h>

#include "model/geometry/polygon.h"
#include "model/geometry/tolerance.h"

/* True if the vertical line through the point crosses the face, in plan. */
static bool is_over_or_under(const struct pp_polygon *face, struct pp_vec3 point)
{
    bool inside = false;
    for (int i = 0; i < face->count; i++) {
        struct pp_vec3 p = face->vertices[i], q = face->vertices[(i + 1) % face->count];
        if ((p.y > point.y) == (q.y > point.y))
            continue;
        struct pp_vec3 low = p.y < q.y ? p : q, high = p.y < q.y ? q : p;
        if ((high.x - low.x) * (point.y - low.y) - (point.x - low.x) * (high.y - low.y)
            > 0.0)
            inside = !inside;
    }
    return inside;
}

/* Height of the face's plane at the point's x and y, limited to the face's own
 * heights. */
static double height_at(const struct pp_polygon *face, struct pp_vec3 point)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < face->count; i++) {
        low = fmin(low, face->vertices[i].z);
        high = fmax(high, face->vertices[i].z);
    }
    struct pp_vec3 n = face->normal, middle = pp_polygon_middle(face);
    double z =
        middle.z - (n.x * (point.x - middle.x) + n.y * (point.y - middle.y)) / n.z;
    return fmin(fmax(z, low), high);
}

bool pp_position_in_room(const struct pp_world *world, struct pp_vec3 point)
{
    int ceilings = 0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        if (face->normal.z == 0.0 || !is_over_or_under(face, point)
            || !(height_at(face, point) > point.z))
            continue;
        ceilings += face->normal.z < 0.0 ? 1 : -1;
    }
    return ceilings > 0;
}

struct pp_bounds3 pp_position_bounds(const struct pp_world *world)
{
    struct pp_bounds3 bounds = pp_bounds3_empty();
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            pp_bounds3_add(&bounds, world->surfaces[i].outline.vertices[k]);
    return bounds;
}

bool pp_position_is_near(const struct pp_bounds3 *room, const struct pp_vec3 *corners,
                         int count)
{
    const double hair = 2.0 * PP_SAME_M;
    struct pp_bounds3 own = pp_bounds3_empty();
    for (int k = 0; k < count; k++)
        pp_bounds3_add(&own, corners[k]);
    return own.low.x < room->high.x + hair && own.high.x > room->low.x - hair
           && own.low.y < room->high.y + hair && own.high.y > room->low.y - hair
           && own.low.z < room->high.z + hair && own.high.z > room->low.z - hair;
}

bool pp_position_in_surface(const struct pp_world *world, struct pp_vec3 point)
{
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        if (fabs(pp_polygon_height(outline, point)) < PP_TOUCH_M
            && pp_polygon_side(outline, point, PP_TOUCH_M) != PP_OUTSIDE)
            return true;
    }
    return false;
}

/* True if the point is between the two outlines of an opening, or in its plane. */
static bool is_in_opening(const struct pp_opening *opening, struct pp_vec3 point)
{
    double height = pp_polygon_height(&opening->inner, point);
    return height < PP_TOUCH_M && height > -opening->reveal_m - PP_TOUCH_M
           && pp_polygon_side(&opening->inner, point, PP_TOUCH_M) != PP_OUTSIDE;
}

static bool is_in_block(const struct pp_block *block, struct pp_vec3 point)
{
    struct pp_vec3 from = pp_vec_sub(point, block->corner);
    double c = cos(block->rotate_rad), s = sin(block->rotate_rad);
    double x = c * from.x + s * from.y, y = c * from.y - s * from.x;
    return x > -PP_TOUCH_M && x < block->width_m + PP_TOUCH_M && y > -PP_TOUCH_M
           && y < block->depth_m + PP_TOUCH_M && from.z > -PP_TOUCH_M
           && from.z < block->height_m + PP_TOUCH_M;
}

static bool is_in_fitting(const struct pp_fitting *fitting, struct pp_vec3 point)
{
    return point.z > fitting->low_m - PP_TOUCH_M
           && point.z < fitting->high_m + PP_TOUCH_M
           && pp_polygon_ring_side(fitting->xy, fitting->corner_count, point.x, point.y,
                                   PP_TOUCH_M)
                  != PP_OUTSIDE;
}

bool pp_position_in_fitting(const struct pp_world *world, struct pp_vec3 point)
{
    for (int i = 0; i < world->fitting_count; i++)
        if (is_in_fitting(&world->fittings[i], point))
            return true;
    return false;
}

/* Message for a receiver on a surface of that role. */
static const char *fault_on_surface(enum pp_role role)
{
    switch (role) {
    case PP_FLOOR:
        return "lies on the floor but does not face straight up (nx, ny, nz)";
    case PP_WALL:
        return "lies on a wall but does not face straight into the room (nx, ny, nz)";
    case PP_CEILING:
        return "lies on the ceiling but does not face straight down (nx, ny, nz)";
    case PP_REVEAL:
        return "lies in an opening";
    case PP_BLOCK:
        return "lies inside a block";
    case PP_FACADE:
        return "lies in a facade";
    case PP_SKYLINE:
        return "lies behind a skyline";
    case PP_COVER:
        return "lies on a door or a dado";
    case PP_FREE_SURFACE:
    case PP_ROLE_COUNT:
        break;
    }
    return "lies on a surface";
}

/* True if a receiver on that surface receives the light that falls on the surface from
 * the room. */
static bool lies_on(const struct pp_surface *surface, struct pp_vec3 normal)
{
    bool envelope = surface->role == PP_FLOOR || surface->role == PP_WALL
                    || surface->role == PP_CEILING;
    return envelope
           && pp_vec_length(pp_vec_cross(surface->outline.normal, normal))
                  < PP_LEVEL_RAD
           && pp_vec_dot(surface->outline.normal, normal) > 0.0;
}

enum pp_status pp_position_find_surfaces(struct pp_position_surfaces *surfaces,
                                         const struct pp_world *world,
                                         const struct pp_bounds3 *box,
                                         struct pp_error *err)
{
    surfaces->count = 0;
    surfaces->list =
        malloc(((size_t)world->surface_count + 1) * sizeof *surfaces->list);
    if (!surfaces->list)
        return pp_fail_memory(err);
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        if (pp_position_is_near(box, outline->vertices, outline->count))
            surfaces->list[surfaces->count++] = i;
    }
    return PP_OK;
}

/* Fault of a receiver (see position.h). among: surfaces to test; NULL: all surfaces. */
static const char *find_fault(const struct pp_world *world,
                              const struct pp_position_surfaces *among,
                              struct pp_vec3 position, struct pp_vec3 normal)
{
    bool on_face = false;
    for (int i = 0; i < world->opening_count; i++)
        if (is_in_opening(&world->openings[i], position))
            return fault_on_surface(PP_REVEAL);
    for (int i = 0; i < world->block_count; i++)
        if (is_in_block(&world->blocks[i], position))
            return fault_on_surface(PP_BLOCK);
    if (pp_position_in_fitting(world, position))
        return "lies inside furniture, a column or a partition";
    const int count = among ? among->count : world->surface_count;
    for (int i = 0; i < count; i++) {
        const struct pp_surface *surface = &world->surfaces[among ? among->list[i] : i];
        /* The tolerance is larger at a door or dado, to include a point on the wall
         * behind it. */
        double near_m = surface->role == PP_COVER ? 2.0 * PP_TOUCH_M : PP_TOUCH_M;
        if (!(fabs(pp_polygon_height(&surface->outline, position)) < near_m
              && pp_polygon_distance(&surface->outline, position) < near_m))
            continue;
        if (!lies_on(surface, normal))
            return fault_on_surface(surface->role);
        on_face = true;
    }
    if (!on_face && !pp_position_in_room(world, position))
        return "lies outside the room";
    return NULL;
}

const char *pp_position_receiver_fault(const struct pp_world *world,
                                       struct pp_vec3 position, struct pp_vec3 normal)
{
    return find_fault(world, NULL, position, normal);
}

const char *pp_position_fault_among(const struct pp_world *world,
                                    const struct pp_position_surfaces *surfaces,
                                    struct pp_vec3 position, struct pp_vec3 normal)
{
    return find_fault(world, surfaces, position, normal);
}

enum pp_status pp_position_place_receiver(struct pp_receiver *receiver,
                                          const struct pp_world *world,
                                          struct pp_vec3 place, struct pp_error *err)
{
    if (isnan(place.z))
        place.z = world->working_plane_m;
    *receiver =
        (struct pp_receiver){.position = place, .normal = pp_vec(0.0, 0.0, 1.0)};
    const char *fault = pp_position_receiver_fault(world, place, receiver->normal);
    if (!fault)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "the point %g,%g,%g %s; expected a point in the free space of the "
                   "room",
                   place.x, place.y, place.z, fault);
}

struct pp_world_view pp_position_view(const struct pp_world *world, struct pp_vec3 eye,
                                      double bearing_rad)
{
    return (struct pp_world_view){
        .eye = eye,
        .bearing_rad = bearing_rad,
        .direction = pp_vec_at_bearing(bearing_rad - world->north_rad, 0.0)};
}
