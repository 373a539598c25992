/* section_sight.c - see section_sight.h. */
#include "charts/section/section_sight.h"

#include <math.h>

#include "model/geometry/tolerance.h"

/* Mid-height of a face's openings: of those cut, or else of all. False: there are
 * none. */
static bool middle_of_openings(const struct pp_section_cut *section,
                               const struct pp_world *world, int face, double *z)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < section->count; i++) {
        const struct pp_cut *cut = &section->list[i];
        if (cut->kind != PP_CUT_OPENING || world->openings[cut->of].face != face)
            continue;
        low = fmin(low, fmin(cut->z[0], cut->z[1]));
        high = fmax(high, fmax(cut->z[0], cut->z[1]));
    }
    if (!(high > low)) {
        for (int i = 0; i < world->opening_count; i++) {
            const struct pp_opening *opening = &world->openings[i];
            if (opening->face != face)
                continue;
            for (int k = 0; k < opening->inner.count; k++) {
                low = fmin(low, opening->inner.vertices[k].z);
                high = fmax(high, opening->inner.vertices[k].z);
            }
        }
    }
    *z = 0.5 * (low + high);
    return high > low;
}

/* True if the surface is the wall round a nested window, on the side of the coarse
 * model. */
static bool is_round_window(const struct pp_surface *surface,
                            const struct pp_world *world)
{
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *glass = &world->openings[i].outer;
        if (world->openings[i].is_nested
            && fabs(pp_vec_dot(surface->outline.normal, glass->normal)) > 1.0 - 1e-6
            && fabs(pp_polygon_height(glass, surface->outline.vertices[0])) < PP_SAME_M)
            return true;
    }
    return false;
}

/* True if the cut is an obstruction outside, other than a facade. */
static bool stands_outside(const struct pp_cut *cut, const struct pp_world *world)
{
    return cut->kind == PP_CUT_OUTSIDE && world->surfaces[cut->of].role != PP_FACADE
           && !is_round_window(&world->surfaces[cut->of], world);
}

/* True if the sky is visible from the middle of the window at that angle. */
static bool sees_sky(const struct pp_section_cut *section, const struct pp_world *world,
                     const struct pp_section_sight *sight, double out, double angle_rad)
{
    double across = out * cos(angle_rad), up = sin(angle_rad);
    for (int i = 0; i < section->count; i++) {
        const struct pp_cut *cut = &section->list[i];
        double s[2], z[2], side[2];
        if (!stands_outside(cut, world))
            continue;
        for (int k = 0; k < 2; k++) {
            s[k] = cut->s[k] - sight->s;
            z[k] = cut->z[k] - sight->z;
            side[k] = across * z[k] - up * s[k];
        }
        if (side[0] * side[1] >= 0.0)
            continue;
        double share = side[0] / (side[0] - side[1]);
        double at_s = s[0] + share * (s[1] - s[0]), at_z = z[0] + share * (z[1] - z[0]);
        if (across * at_s + up * at_z > 1e-3)
            return false;
    }
    return true;
}

/* Number of steps, a quarter of a degree each, in which the section is searched for
 * sky. */
enum { SIGHT_STEPS = 360 };

/* Finds the highest range of angles in which sky is visible. angle_rad stays 0 and
 * overhang_rad stays pi/2 if nothing limits the range. Returns false if no sky is
 * visible. */
static bool find_sky(struct pp_section_sight *sight,
                     const struct pp_section_cut *section, const struct pp_world *world,
                     double out)
{
    int high = SIGHT_STEPS - 1;
    double step = 0.5 * PP_PI / SIGHT_STEPS;
    while (high >= 0 && !sees_sky(section, world, sight, out, (high + 0.5) * step))
        high--;
    int low = high;
    while (low >= 0 && sees_sky(section, world, sight, out, (low + 0.5) * step))
        low--;
    if (high < 0)
        return false;
    if (high < SIGHT_STEPS - 1)
        sight->overhang_rad = (high + 1) * step;
    sight->angle_rad = (low + 1) * step;
    return true;
}

struct pp_section_sight pp_section_sight_of(const struct pp_section_cut *section,
                                            const struct pp_world *world, bool near)
{
    struct pp_section_sight sight = {
        .s = near ? 0.0 : section->length_m, .overhang_rad = 0.5 * PP_PI, .of = -1};
    int face = near ? section->near_face : section->far_face;
    double out = near ? -1.0 : 1.0;
    if (face < 0 || !middle_of_openings(section, world, face, &sight.z))
        return sight;
    /* A coarse model begins at the glass of a nested window. */
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face && world->openings[i].is_nested)
            sight.s =
                (near ? 0.0 : section->length_m) + out * world->openings[i].reveal_m;
    /* The head of the obstruction is the end of a cut that is nearest to the edge of
     * the sky. */
    double edge = find_sky(&sight, section, world, out) ? sight.angle_rad : 0.5 * PP_PI;
    double nearest = sight.overhang_rad < 0.5 * PP_PI ? 0.5 * PP_RAD : 0.5 * PP_PI;
    sight.angle_rad = 0.0;
    for (int i = 0; i < section->count && edge > 0.0; i++) {
        const struct pp_cut *cut = &section->list[i];
        for (int k = 0; k < 2 && stands_outside(cut, world); k++) {
            double away = out * (cut->s[k] - sight.s), up = cut->z[k] - sight.z;
            double angle = atan2(up, away);
            if (away > 1e-3 && angle > 0.0 && fabs(angle - edge) < nearest) {
                nearest = fabs(angle - edge);
                sight.angle_rad = angle;
                sight.distance_m = away;
                sight.of = cut->of;
            }
        }
    }
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        if (skyline->face != face || skyline->angle_rad <= sight.angle_rad)
            continue;
        sight.angle_rad = skyline->angle_rad;
        sight.z = skyline->middle_z_m;
        sight.distance_m = skyline->distance_m;
        sight.of = -1;
        sight.skyline = true;
    }
    return sight;
}
