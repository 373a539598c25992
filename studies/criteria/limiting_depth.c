/* limiting_depth.c - limit on the depth of a room lit from one side [BS8206],
 * [BREEAM14]:
 *
 *   d/w + d/h <= 2 / (1 - R_b)
 *
 *   d    depth: from the window wall to the wall opposite (m)
 *   w    width of the room along the window wall (m)
 *   h    height of the highest window head above the floor (m)
 *   R_b  area-weighted mean reflectance of the rear half of the room, farther than d/2
 *        from the window wall: floor, ceiling, walls, and both sides of free-standing
 *        surfaces
 *
 * The rule is for box-shaped rooms with windows in one wall; other rooms are not
 * judged. Obstructions outside, the size of the windows and their glass do not matter.
 */
#include <math.h>
#include <stdlib.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "methods/reflected/interior.h"
#include "model/geometry/frame.h"
#include "model/geometry/tolerance.h"

static const char title_of_ratio[] = "d/w + d/h";

static bool is_level(const struct pp_polygon *polygon)
{
    return fabs(polygon->normal.z) > cos(PP_LEVEL_RAD);
}

/* The window wall of a box-shaped room with windows in one wall; NULL for any other
 * room, with the reason in *why. A box has one level floor, one horizontal ceiling and
 * four more faces, all with four corners and right angles, to 1e-3. */
static const struct pp_surface *window_wall(const struct pp_world *world,
                                            const char **why)
{
    int floors = 0, ceilings = 0, rectangles = 0;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        floors += face->role == PP_FLOOR && is_level(&face->outline);
        ceilings += face->role == PP_CEILING && is_level(&face->outline);
        rectangles += face->outline.count == 4;
        for (int k = 0; k < face->outline.count; k++) {
            const struct pp_vec3 *v = face->outline.vertices;
            int n = face->outline.count;
            struct pp_vec3 a = pp_vec_sub(v[(k + 1) % n], v[k]);
            struct pp_vec3 b = pp_vec_sub(v[(k + 2) % n], v[(k + 1) % n]);
            rectangles -=
                fabs(pp_vec_dot(a, b)) > 1e-3 * pp_vec_length(a) * pp_vec_length(b);
        }
    }
    *why = world->face_count != 6 || floors != 1 || ceilings != 1 || rectangles != 6
               ? "the room is not a box"
           : world->opening_count == 0 ? "the room has no openings"
                                       : NULL;
    for (int i = 0; i < world->opening_count && !*why; i++) {
        if (world->surfaces[world->openings[i].face].role != PP_WALL)
            *why = "the room also has rooflights";
        else if (world->openings[i].face != world->openings[0].face)
            *why = "the room has windows in more than one wall";
    }
    return *why ? NULL : &world->surfaces[world->openings[0].face];
}

/* Adds a polygon's part farther than `from` along `into` to the sums of area and of
 * area times reflectance. */
static enum pp_status add_rear(double sums[2], const struct pp_polygon *polygon,
                               struct pp_vec3 into, double from, double reflectance,
                               struct pp_error *err)
{
    /* The polygon turned so that the depth points down, for pp_interior_area_below. */
    struct pp_vec3 down = pp_vec_scale(into, -1.0), up = {0.0, 0.0, 1.0};
    struct pp_frame frame = {pp_vec_cross(up, down), up, down};
    struct pp_polygon turned = *polygon;
    turned.vertices = malloc((size_t)polygon->count * sizeof *turned.vertices);
    if (!turned.vertices)
        return pp_fail_memory(err);
    for (int i = 0; i < polygon->count; i++)
        turned.vertices[i] = pp_frame_in(&frame, polygon->vertices[i]);
    turned.normal = pp_frame_in(&frame, polygon->normal);
    double area_m2 = pp_interior_area_below(&turned, -from);
    free(turned.vertices);
    sums[0] += area_m2;
    sums[1] += area_m2 * reflectance;
    return PP_OK;
}

/* R_b: mean reflectance of the surfaces farther than `from` along `into`. */
static enum pp_status rear_reflectance(double *mean, const struct pp_world *world,
                                       struct pp_vec3 into, double from,
                                       struct pp_error *err)
{
    double sums[2] = {0.0, 0.0};
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (!surface->inside || surface->role == PP_REVEAL)
            continue;
        double cover[2] = {0.0, 0.0}, *to = surface->role == PP_COVER ? cover : sums;
        double behind =
            surface->role == PP_COVER ? world->surfaces[surface->owner].front : 0.0;
        enum pp_status status =
            add_rear(to, &surface->outline, into, from, surface->front - behind, err);
        sums[1] += cover[1]; /* replaces part of its wall, whose area is already
                              * included */
        if (status == PP_OK && surface->role == PP_FREE_SURFACE)
            status = add_rear(sums, &surface->outline, into, from, surface->back, err);
        if (status != PP_OK)
            return status;
    }
    *mean = sums[1] / sums[0];
    return PP_OK;
}

/* Extent of the room along a direction; *low is its lower end. */
static double room_extent_along(const struct pp_world *world, struct pp_vec3 along,
                                double *low)
{
    double high = -INFINITY;
    *low = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            double at = pp_vec_dot(world->surfaces[i].outline.vertices[k], along);
            *low = fmin(*low, at);
            high = fmax(high, at);
        }
    return high - *low;
}

static enum pp_status assess_limiting_depth(const struct pp_inquiry *inquiry,
                                            struct pp_finding_list *findings,
                                            struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    const char *why;
    const struct pp_surface *wall = window_wall(world, &why);
    if (!wall) {
        struct pp_finding finding = pp_finding_not_judged(why, title_of_ratio);
        return pp_finding_list_add(findings, &finding, err);
    }
    struct pp_vec3 into = wall->outline.normal, up = {0.0, 0.0, 1.0};
    double front, side, floor_z, head_z = -INFINITY;
    double d = room_extent_along(world, into, &front);
    double w = room_extent_along(world, pp_vec_cross(up, into), &side);
    room_extent_along(world, up, &floor_z);
    for (int i = 0; i < world->opening_count; i++)
        for (int k = 0; k < world->openings[i].inner.count; k++)
            head_z = fmax(head_z, world->openings[i].inner.vertices[k].z);
    double h = head_z - floor_z, R_b;
    enum pp_status status = rear_reflectance(&R_b, world, into, front + d / 2.0, err);
    if (status != PP_OK)
        return status;

    double most = 2.0 / (1.0 - R_b);
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_RATIO, d / w + d / h, most, true, title_of_ratio);
    pp_finding_note(&finding,
                    "d %.2f m, w %.2f m, h %.2f m, R_b %.2f; the depth limit is %.2f m",
                    d, w, h, R_b, most / (1.0 / w + 1.0 / h));
    return pp_finding_list_add(findings, &finding, err);
}

const struct pp_criterion pp_criterion_limiting_depth = {
    .name = "limiting-depth",
    .title = "Limiting depth",
    .source = "BS8206, BREEAM14",
    .withdrawn = "BS 8206-2 was withdrawn in 2019; later versions of BREEAM replaced "
                 "the 2014 version",
    .summary = "d/w + d/h is at most 2/(1 - R_b) in rooms lit from one side",
    .bears_on_use = pp_bearing_needs_daylight,
    .evaluate = assess_limiting_depth,
};
