/* outdoors.h - the light that a ray outdoors meets if it hits no facet: sky, ground,
 * and skylines without a distance.
 *
 * Light is expressed as pi times luminance over Eh, the unit of exitances. By
 * convention, a skyline without a distance has the exitance rho (Ev + rho_ground / 2),
 * where Ev is the illuminance of the skyline from the open sky. Unshaded ground has an
 * exitance equal to its reflectance. The exitance of ground in the shadow of
 * obstructions is unknown (outside_cells.h). Beyond PP_OUTDOORS_FARTHEST times the
 * extent of all obstructions the ground counts as unshaded, since less than 1/1000 of
 * its sky is hidden.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_OUTDOORS_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_OUTDOORS_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

enum { PP_OUTDOORS_FARTHEST = 20 };

struct pp_outdoors {
    const struct pp_world *world; /* not owned */
    struct pp_outside_light light;
    double ground_m;   /* z at which rays meet the ground */
    double farthest_m; /* greatest distance at which shadows on the ground count */
    struct pp_outdoor_skyline {
        struct pp_vec3 away; /* horizontal direction from the wall towards the
                              * skyline */
        double slope;        /* tangent of the skyline's angle */
        double exitance;
    } * skylines;
    int skyline_count;
};

enum pp_outdoors_end {
    PP_OUTDOORS_NOTHING, /* a facet is nearer */
    PP_OUTDOORS_SKY,
    PP_OUTDOORS_FIXED, /* a skyline, or ground without shadows */
    PP_OUTDOORS_GROUND,
};

/* reach_m: extent of the obstructions outdoors, from the room. */
enum pp_status pp_outdoors_init(struct pp_outdoors *outdoors,
                                const struct pp_world *world,
                                const struct pp_outside_light *light, double reach_m,
                                struct pp_error *err);
void pp_outdoors_clear(struct pp_outdoors *outdoors);

/* End of the ray from `from` towards `to` (unit), if the nearest facet is at `facet_m`
 * (INFINITY: none). *light: set for the sky and for fixed light; *distance: set for the
 * ground. */
enum pp_outdoors_end pp_outdoors_meet(const struct pp_outdoors *outdoors,
                                      struct pp_vec3 from, struct pp_vec3 to,
                                      double facet_m, double *light, double *distance);

#endif
