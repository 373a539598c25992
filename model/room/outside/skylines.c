/* skylines.c - see skylines.h. */
#include "model/room/outside/skylines.h"

#include <stdlib.h>

#include "model/geometry/tolerance.h"

static void take_heights(const struct pp_polygon *polygon, double *low, double *high)
{
    for (int k = 0; k < polygon->count; k++) {
        *low = fmin(*low, polygon->vertices[k].z);
        *high = fmax(*high, polygon->vertices[k].z);
    }
}

/* The middle between the lowest sill and the highest head of the wall's openings, or of
 * the wall itself where it has none. */
static double middle_of_openings(const struct pp_world *world, int face)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            take_heights(&world->openings[i].inner, &low, &high);
    if (low > high)
        take_heights(&world->surfaces[face].outline, &low, &high);
    return 0.5 * (low + high);
}

/* How far the room and its openings' depths reach outside the wall's plane (m), 0 if
 * they do not. */
static double reach_outside(const struct pp_world *world, int face, struct pp_vec3 out)
{
    struct pp_vec3 wall = world->surfaces[face].outline.vertices[0];
    double reach = 0.0;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        for (int k = 0; k < outline->count && world->surfaces[i].inside; k++)
            reach =
                fmax(reach, pp_vec_dot(out, pp_vec_sub(outline->vertices[k], wall)));
    }
    return reach;
}

/* Notes what is wrong with the skyline; true if nothing is. */
static bool is_good(struct pp_resolver *r, const struct pp_skyline_part *part, int face)
{
    const struct pp_world *world = r->world;
    for (int i = 0; i < world->skyline_count; i++)
        if (world->skylines[i].face == face) {
            pp_mistakes_add(
                r->mistakes, part->line,
                "skyline: a second one for its wall, after that of line %d; "
                "expected one at most",
                world->skylines[i].line);
            return false;
        }
    if (!(part->angle_rad >= 0.0 && part->angle_rad < PP_PI / 2.0)) {
        pp_mistakes_add(r->mistakes, part->line,
                        "skyline: its angle is %g degrees; expected 0 to less than 90",
                        part->angle_rad / PP_RAD);
        return false;
    }
    struct pp_vec3 n = world->surfaces[face].outline.normal;
    double level = hypot(n.x, n.y);
    if (level < PP_LEVEL_RAD) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "skyline: its wall lies flat; expected one that faces sideways");
        return false;
    }
    struct pp_vec3 out = pp_vec(-n.x / level, -n.y / level, 0.0);
    double reach = reach_outside(world, face, out);
    if (part->distance_m < reach + PP_SAME_M) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "skyline: its distance is %g m, but the room or its openings reach "
            "%.4g m beyond that wall; expected more",
            part->distance_m, reach);
        return false;
    }
    return true;
}

enum pp_status pp_build_skylines(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_room *room = r->room;
    struct pp_world *world = r->world;
    world->skylines =
        calloc(room->skyline_count ? room->skyline_count : 1, sizeof *world->skylines);
    if (!world->skylines)
        return pp_fail_memory(err);
    for (int i = 0; i < room->skyline_count; i++) {
        const struct pp_skyline_part *part = &room->skylines[i];
        int face = pp_resolve_wall(r, part->wall, "skyline", part->line);
        if (face < 0 || isnan(part->angle_rad) || isnan(part->distance_m)
            || !is_good(r, part, face))
            continue;
        double middle_z_m = middle_of_openings(world, face);
        double head_z_m = INFINITY;
        if (isfinite(part->distance_m))
            head_z_m = middle_z_m + part->distance_m * tan(part->angle_rad);
        world->skylines[world->skyline_count++] =
            (struct pp_skyline){.face = face,
                                .angle_rad = part->angle_rad,
                                .middle_z_m = middle_z_m,
                                .distance_m = part->distance_m,
                                .head_z_m = head_z_m,
                                .reflectance = part->reflectance,
                                .line = part->line};
    }
    return PP_OK;
}
