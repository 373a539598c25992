/* section_sight.c - see section_sight.h. */
#include "charts/room/section_sight.h"

#include <math.h>

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

struct pp_section_sight pp_section_sight_of(const struct pp_section_cut *section,
                                            const struct pp_world *world, bool near)
{
    struct pp_section_sight sight = {.s = near ? 0.0 : section->length_m};
    int face = near ? section->near_face : section->far_face;
    double out = near ? -1.0 : 1.0;
    if (face < 0 || !middle_of_openings(section, world, face, &sight.z))
        return sight;
    for (int i = 0; i < section->count; i++) {
        const struct pp_cut *cut = &section->list[i];
        bool stands_opposite =
            cut->kind == PP_CUT_OUTSIDE && world->surfaces[cut->of].role != PP_FACADE;
        for (int k = 0; k < 2 && stands_opposite; k++) {
            double away = out * (cut->s[k] - sight.s), up = cut->z[k] - sight.z;
            if (away > 1e-3 && atan2(up, away) > sight.angle_rad) {
                sight.angle_rad = atan2(up, away);
                sight.distance_m = away;
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
        sight.skyline = true;
    }
    return sight;
}
