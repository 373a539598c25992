/* skylines.c - see skylines.h.
 *
 * A skyline at a distance D is a vertical wall, visible from both sides, from the
 * ground to its head. Its length is 200 D. The parts of an endless wall that are
 * missing would be seen within 0.6 degrees of the wall's direction. For a skyline of 70
 * degrees (D = 10 m), their absence increases the vertical sky component of a window
 * opposite by 7e-6 of its value, and that of a window in a perpendicular wall by 8e-5.
 */
#include "model/room/outside/skylines.h"

#include <stdlib.h>

#include "model/geometry/tolerance.h"
#include "model/room/ground.h"

/* Half the length of a skyline's wall divided by its distance. */
static const double half_length = 100.0;

static void take_heights(const struct pp_polygon *polygon, double *low, double *high)
{
    for (int k = 0; k < polygon->count; k++) {
        *low = fmin(*low, polygon->vertices[k].z);
        *high = fmax(*high, polygon->vertices[k].z);
    }
}

/* Mean of the lowest sill and the highest head of the wall's openings; of the wall's
 * foot and top if it has no openings. */
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

/* Horizontal unit vector away from the room. */
static struct pp_vec3 outward_of(const struct pp_world *world, int face)
{
    struct pp_vec3 n = world->surfaces[face].outline.normal;
    return pp_vec_unit(pp_vec(-n.x, -n.y, 0.0));
}

/* Origin of distances: on the wall's centre line, in its plane (which may slope), at
 * mid-height of its openings. */
static struct pp_vec3 middle_of_wall(const struct pp_world *world, int face)
{
    const struct pp_polygon *wall = &world->surfaces[face].outline;
    struct pp_vec3 out = outward_of(world, face), middle = pp_polygon_middle(wall);
    middle.z = middle_of_openings(world, face);
    double aside = pp_vec_dot(wall->normal, pp_vec_sub(wall->vertices[0], middle));
    return pp_vec_along(middle, aside / pp_vec_dot(wall->normal, out), out);
}

/* Distance (m) by which the room and its reveals extend beyond the wall; 0 or more. */
static double reach_outside(const struct pp_world *world, int face)
{
    struct pp_vec3 out = outward_of(world, face), wall = middle_of_wall(world, face);
    double reach = 0.0;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        for (int k = 0; k < outline->count && world->surfaces[i].inside; k++)
            reach =
                fmax(reach, pp_vec_dot(out, pp_vec_sub(outline->vertices[k], wall)));
    }
    return reach;
}

/* Reports mistakes of the skyline; true if there are none. */
static bool is_good(struct pp_resolver *r, const struct pp_skyline_part *part, int face)
{
    const struct pp_world *world = r->world;
    for (int i = 0; i < world->skyline_count; i++)
        if (world->skylines[i].face == face) {
            pp_mistakes_add(r->mistakes, part->line,
                            "skyline: the wall already has a skyline, on line %d; "
                            "expected only one",
                            world->skylines[i].line);
            return false;
        }
    if (!(part->angle_rad >= 0.0 && part->angle_rad < PP_PI / 2.0)) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "skyline: its angle is %g degrees; expected 0 or more and less than 90",
            part->angle_rad / PP_RAD);
        return false;
    }
    struct pp_vec3 n = world->surfaces[face].outline.normal;
    if (hypot(n.x, n.y) < PP_LEVEL_RAD) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "skyline: its wall is horizontal; expected a vertical or sloping wall");
        return false;
    }
    double reach = reach_outside(world, face);
    if (part->distance_m < reach + PP_SAME_M) {
        pp_mistakes_add(r->mistakes, part->line,
                        "skyline: its distance is %g m, but the room or its openings "
                        "extend %.4g m beyond that wall; expected a larger distance",
                        part->distance_m, reach);
        return false;
    }
    return true;
}

/* Adds the wall of the last skyline. */
static enum pp_status add_wall(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_world *world = r->world;
    int index = world->skyline_count - 1;
    const struct pp_skyline *skyline = &world->skylines[index];
    double low = pp_ground_level(world), half = half_length * skyline->distance_m;
    if (isinf(skyline->distance_m) || !(skyline->head_z_m > low + PP_SAME_M))
        return PP_OK;
    struct pp_vec3 out = outward_of(world, skyline->face), corners[4];
    struct pp_vec3 right = pp_vec_cross(out, pp_vec(0.0, 0.0, 1.0));
    struct pp_vec3 middle =
        pp_vec_along(middle_of_wall(world, skyline->face), skyline->distance_m, out);
    for (int k = 0; k < 4; k++) {
        corners[k] = pp_vec_along(middle, k == 1 || k == 2 ? half : -half, right);
        corners[k].z = k < 2 ? low : skyline->head_z_m;
    }
    const struct pp_surface wall = {.role = PP_SKYLINE,
                                    .front = skyline->reflectance,
                                    .back = skyline->reflectance,
                                    .owner = index,
                                    .line = skyline->line};
    return pp_resolve_add_face(r, wall, corners, 4, err);
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
        if (add_wall(r, err) != PP_OK)
            return PP_SYSTEM;
    }
    return PP_OK;
}
