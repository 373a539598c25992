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
 * assessed. Obstructions outside, the size of the windows and their glass do not
 * matter.
 */
#include <math.h>
#include <stdlib.h>

#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "methods/reflected/interior.h"
#include "model/geometry/frame.h"
#include "studies/side_lit_box.h"

static const char title_of_ratio[] = "d/w + d/h";

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

static enum pp_status assess_limiting_depth(const struct pp_inquiry *inquiry,
                                            struct pp_finding_list *findings,
                                            struct pp_error *err)
{
    const struct pp_world *world = inquiry->world;
    const char *why;
    struct pp_side_lit_box box;
    if (!pp_side_lit_box_of(&box, world, &why)) {
        struct pp_finding finding = pp_finding_not_judged(why, title_of_ratio);
        return pp_finding_list_add(findings, &finding, err);
    }
    double d = box.depth_m, w = box.width_m, h = box.head_z - box.floor_z, R_b;
    enum pp_status status =
        rear_reflectance(&R_b, world, box.into, box.front + d / 2.0, err);
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
