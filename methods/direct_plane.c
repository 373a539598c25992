/* direct_plane.c - evaluates a method at points of the plane, moved off walls and
 * openings. */
#include "methods/direct_plane.h"

#include <math.h>
#include <stdlib.h>

#include "methods/allowance.h"
#include "methods/method.h"
#include "model/geometry/bounds.h"

/* Least distance from a vertical opening at which points are evaluated: a fraction of
 * the plane's diagonal, but at most opening_inset_most_m (m). Contours crowd together
 * close to an opening; the distance is less than the thickness of a wall on the
 * drawing. */
static const double opening_inset = 1.0 / 500.0, opening_inset_most_m = 0.02;

/* Least distance from a wall (m); so small that contours appear to reach the wall. */
static const double wall_inset_m = 0.001;

struct pp_direct_plane {
    const struct pp_world *world;
    struct pp_outside_light light;
    const struct pp_method *method;
    void *tools; /* prepared data of the method */
    double inset_m;
};

/* Moves a point that is nearer than inset_m to the region's edge inwards, to a distance
 * of inset_m. The region's interior is on the left of its rings. */
struct pp_vec3 pp_direct_plane_off_walls(const struct pp_region *region, double z,
                                         double inset_m, double x, double y)
{
    struct pp_vec3 moved = pp_vec(x, y, z);
    for (int r = 0; r < region->count; r++)
        for (int i = 0; i < region->rings[r].count; i++) {
            const double *a = region->rings[r].xy[i];
            const double *b = region->rings[r].xy[(i + 1) % region->rings[r].count];
            double dx = b[0] - a[0], dy = b[1] - a[1], length = hypot(dx, dy);
            double share = ((x - a[0]) * dx + (y - a[1]) * dy) / (length * length);
            share = fmin(fmax(share, 0.0), 1.0);
            double off = hypot(a[0] + share * dx - x, a[1] + share * dy - y);
            if (off >= inset_m)
                continue;
            moved.x -= dy / length * (inset_m - off);
            moved.y += dx / length * (inset_m - off);
        }
    return moved;
}

/* Returns the place, moved away from any vertical opening that is nearer than
 * inset_m. */
static struct pp_vec3 off_openings(const struct pp_world *world, double inset_m,
                                   struct pp_vec3 place)
{
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (fabs(opening->inner.normal.z) > 0.1)
            continue;
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k < opening->inner.count; k++) {
            double along = pp_vec_dot(opening->along, opening->inner.vertices[k]);
            low = fmin(low, along);
            high = fmax(high, along);
        }
        double along = pp_vec_dot(opening->along, place);
        double off = pp_vec_dot(pp_vec_sub(place, opening->inner.vertices[0]),
                                opening->inner.normal);
        if (along > low && along < high && off >= 0.0 && off < inset_m) {
            place.x += (inset_m - off) * opening->inner.normal.x;
            place.y += (inset_m - off) * opening->inner.normal.y;
        }
    }
    return place;
}

/* PP_BAD_INPUT, with the reason, if the method does not cover the room. */
static enum pp_status check_method(const struct pp_method *method,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   struct pp_error *err)
{
    const char *why = pp_method_refuses_room(method, world, light, NULL);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "%s: %s", method->name, why);
    for (int i = 0; i < world->opening_count; i++) {
        why =
            pp_method_refuses_opening(method, world, light, &world->openings[i], NULL);
        if (why)
            return pp_fail(err, PP_BAD_INPUT, "%s: %s %s %s", method->name,
                           pp_world_kind(world, world->openings[i].line),
                           world->openings[i].label, why);
    }
    return PP_OK;
}

/* Largest product of the number of triangles outside and the number of openings.
 * Contours over the plane take 1.0 s with 200 triangles and 3.4 s with 500. */
static const double mesh_triangles_most = 700.0;

static enum pp_status check_meshes(const struct pp_world *world, struct pp_error *err)
{
    int triangles = world->surface_count - pp_world_before_meshes(world);
    if ((double)triangles * world->opening_count <= mesh_triangles_most)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT,
                   "the external meshes have %d triangles, too many for contours on "
                   "the working plane; expected single points, or at most %.0f "
                   "triangles divided by the number of openings",
                   triangles, mesh_triangles_most);
}

enum pp_status pp_direct_plane_create(struct pp_direct_plane **plane,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_method *method,
                                      struct pp_error *err)
{
    const struct pp_bounds2 box = pp_region_bounds(&world->plane);
    double diagonal = hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    *plane = NULL;
    enum pp_status status = check_meshes(world, err);
    if (status == PP_OK)
        status = check_method(method, world, light, err);
    if (status != PP_OK)
        return status;
    struct pp_direct_plane *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    *made = (struct pp_direct_plane){
        .world = world,
        .light = *light,
        .method = method,
        .inset_m = fmin(opening_inset * diagonal, opening_inset_most_m)};
    if (method->prepare_for_plane)
        status = method->prepare_for_plane(&made->tools, world, &made->light, err);
    else if (method->prepare_fast)
        status = method->prepare_fast(&made->tools, world, &made->light, err);
    else if (method->prepare)
        status = method->prepare(&made->tools, world, &made->light, err);
    if (status == PP_OK)
        *plane = made;
    else
        free(made);
    return status;
}

void pp_direct_plane_destroy(struct pp_direct_plane *plane)
{
    if (!plane)
        return;
    if (plane->method->destroy_tools)
        plane->method->destroy_tools(plane->tools);
    free(plane);
}

enum pp_status pp_direct_plane_at(const struct pp_direct_plane *plane, double x,
                                  double y, double *sky, double *external,
                                  struct pp_error *err)
{
    const struct pp_world *world = plane->world;
    const struct pp_method *method = plane->method;
    const struct pp_receiver receiver = {
        .position = off_openings(world, plane->inset_m,
                                 pp_direct_plane_off_walls(&world->plane,
                                                           world->working_plane_m,
                                                           wall_inset_m, x, y)),
        .normal = pp_vec(0.0, 0.0, 1.0)};
    *sky = *external = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_part part = {0};
        enum pp_status status =
            (method->evaluate_roughly ? method->evaluate_roughly : method->evaluate)(
                world, &plane->light, opening, &receiver, plane->tools, &part, err);
        if (status == PP_OK && part.why)
            status =
                pp_fail(err, PP_BAD_INPUT, "%s: %s %s %s", method->name,
                        pp_world_kind(world, opening->line), opening->label, part.why);
        if (status != PP_OK)
            return status;
        double allowance = pp_allowance_of(method, world, opening);
        *sky += part.sky * allowance;
        *external += part.external * allowance;
    }
    return PP_OK;
}
