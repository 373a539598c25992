/* radiosity.h - a coarse radiosity solution of the room, read between its patches.
 *
 * Some thousand patches, whose irradiance comes by the openings and, along a few random
 * rays, by other patches (gathering radiosity), with bilinear interpolation between
 * their centres. It serves as the control variate G of path.h, so that none of its
 * error ends in a result. It depends on the room, the light and the seed alone. radiosity_solve.h
 * makes it.
 */
#ifndef PP_SIMULATE_TRACER_RADIOSITY_H
#define PP_SIMULATE_TRACER_RADIOSITY_H

#include "simulate/scene/light_scene.h"
#include "simulate/transport/niche_light.h"

/* The patches of one side of a part, in a grid; a patch's value stands at its
 * centre. */
struct pp_radiosity_grid {
    int first;           /* of its values; -1: no patches on this side */
    int columns, rows;   /* along the part's a and b */
    double a0, b0;       /* of the first centre, along a and b */
    double per_a, per_b; /* patches a metre */
};

struct pp_radiosity {
    struct pp_radiosity_grid (*grids)[2]; /* by part and side */
    double *values;                       /* exitance over Eh */
    int count;
    const struct pp_light_scene *scene; /* not owned */
    struct pp_niche_light niches;       /* of the sides of niches, by these values */
};

void pp_radiosity_destroy(struct pp_radiosity *radiosity); /* NULL is allowed */

/* The exitance where a ray has met something, over Eh; 0 where there are no patches. */
double pp_radiosity_at(const struct pp_radiosity *radiosity,
                       const struct pp_light_scene *scene,
                       const struct pp_light_hit *hit);

/* The same as a niche's light: `radiosity` is that solution. */
double pp_radiosity_of_side(void *radiosity, const struct pp_light_hit *side,
                            double worth);

/* The number of the patch nearest to the hit; -1 where there are none. */
int pp_radiosity_nearest(const struct pp_radiosity *radiosity,
                         const struct pp_light_scene *scene,
                         const struct pp_light_hit *hit);

#endif
