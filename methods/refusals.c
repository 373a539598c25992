/* refusals.c - tests sky, receiver and opening, and writes the sentences of a
 * refusal. */
#include "methods/refusals.h"

#include <stddef.h>

/* Directions within this angle of horizontal or vertical count as horizontal or
 * vertical: a figure changes by less than its third digit, and corners written with
 * three decimals are accepted. */
static const double angle_tolerance_rad = 1e-3;

const char *pp_refusals_unless_up(const struct pp_receiver *receiver)
{
    if (receiver
        && (hypot(receiver->normal.x, receiver->normal.y) > angle_tolerance_rad
            || receiver->normal.z < 0.0))
        return "valid only for points that face up";
    return NULL;
}

const char *pp_refusals_unless_overcast_and_up(const struct pp_outside_light *light,
                                               const struct pp_receiver *receiver)
{
    if (light->sky.kind != PP_SKY_OVERCAST)
        return "valid only for the CIE overcast sky";
    return pp_refusals_unless_up(receiver);
}

const char *pp_refusals_if_luminous(const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i = pp_world_next_but_blocks(world, i))
        if (world->surfaces[i].exitance > 0.0)
            return "not valid if surfaces emit light";
    return NULL;
}

const char *pp_refusals_if_mesh(const struct pp_world *world)
{
    return world->mesh_count > 0 ? "not valid with external meshes, because the method "
                                   "represents obstructions by vertical rectangles"
                                 : NULL;
}

/* Largest product of the numbers of triangles, openings and points (plus one). At
 * 9.6e6 (100,000 triangles, one opening, 96 points) the exact method takes 1.7 s and
 * Waldram's diagram 2.6 s. */
static const double mesh_views_most = 1.8e7;

const char *pp_refusals_if_fine_mesh(const struct pp_world *world)
{
    double triangles = world->surface_count - pp_world_before_meshes(world);
    double views = (double)world->opening_count * (world->receiver_count + 1.0);
    return triangles * views > mesh_views_most
               ? "the external meshes have too many triangles; this method would take "
                 "too long"
               : NULL;
}

const char *pp_refusals_luminous_room(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_receiver *receiver)
{
    (void)light, (void)receiver;
    return pp_refusals_if_luminous(world);
}

const char *pp_refusals_formula_room(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_unless_overcast_and_up(light, receiver);
    return why ? why : pp_refusals_if_luminous(world);
}

const char *pp_refusals_unless_vertical(const struct pp_opening *opening)
{
    if (fabs(opening->slope_rad - PP_PI / 2.0) > angle_tolerance_rad)
        return "is not vertical, but the method covers only vertical windows";
    return NULL;
}

const char *pp_refusals_sloping_opening(const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        const struct pp_opening *opening,
                                        const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    return pp_refusals_unless_vertical(opening);
}
