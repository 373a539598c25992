/* control_variate.h - a coarse radiosity solution of the room, interpolated between
 * patches.
 *
 * About 1,200 patches gather light from the openings and, along a few random rays, from
 * other patches; values between their centres are interpolated bilinearly. The solution
 * is the control variate G of path.h, so errors of the solution do not bias a result.
 * Room, light and seed alone determine it (control_variate_solve.h).
 */
#ifndef PP_SIMULATE_FAST_CONTROL_VARIATE_H
#define PP_SIMULATE_FAST_CONTROL_VARIATE_H

#include "simulate/scene/light_scene.h"
#include "simulate/transport/niche_light.h"

/* The grid of patches on one side of a part; a patch's value applies at its centre. */
struct pp_control_variate_grid {
    int first;           /* index of the first value; -1: no patches on this side */
    int columns, rows;   /* along the part's a and b */
    double a0, b0;       /* position of the first centre, along a and b */
    double per_a, per_b; /* patches per metre */
};

struct pp_control_variate {
    struct pp_control_variate_grid (*grids)[2]; /* by part and side */
    double *values;                             /* exitance over Eh */
    int count;
    const struct pp_light_scene *scene; /* not owned */
    struct pp_niche_light niches;       /* light of the sides of niches, from these
                                         * values */
};

void pp_control_variate_destroy(
    struct pp_control_variate *variate); /* NULL is allowed */

/* Exitance, over Eh, of the surface at a ray's hit point; 0 if the surface has no
 * patches. */
double pp_control_variate_at(const struct pp_control_variate *variate,
                             const struct pp_light_scene *scene,
                             const struct pp_light_hit *hit);

/* Callback for the light of a niche; returns the exitance from pp_control_variate_at.
 * `variate` is a struct pp_control_variate. */
double pp_control_variate_of_side(void *variate, const struct pp_light_hit *side,
                                  double worth);

/* Index of the patch nearest to the hit; -1 if there is none. */
int pp_control_variate_nearest(const struct pp_control_variate *variate,
                               const struct pp_light_scene *scene,
                               const struct pp_light_hit *hit);

#endif
