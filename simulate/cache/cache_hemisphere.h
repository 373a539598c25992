/* cache_hemisphere.h - the light that comes to a surface, by a hemisphere of rays.
 *
 * The unit square is cut into side x side cells and laid on the hemisphere [SC97], so
 * that every cell counts the same for the irradiance: one ray goes into each, more into
 * those that differ from their neighbours, and into all while the irradiance is not
 * sure enough. Cells touch as they do in the square, which is what the derivatives need
 * (cache_derivatives.h).
 */
#ifndef PP_SIMULATE_CACHE_CACHE_HEMISPHERE_H
#define PP_SIMULATE_CACHE_CACHE_HEMISPHERE_H

#include "simulate/cache/cache_entry.h"

/* What is seen in one cell. Vectors in the frame (a, b, normal) of the record. */
struct pp_cache_hemisphere_cell {
    struct pp_rgb radiance; /* mean of its rays */
    struct pp_vec3 to;      /* unit: of its first ray */
    double distance_m;      /* of what that met; INFINITY: nothing */
    struct pp_vec3 facing;  /* normal of what that met */
    double samples;
    double contrast; /* of its neighbours: what more rays are dealt out by */
    double gradient_per_radiance[2]; /* of its radiance on the gradient, 1/m */
    double hessian_per_radiance[3]; /* and on the second derivatives aa, ab, bb, 1/m2 */
};

struct pp_cache_hemisphere {
    int side;
    const struct pp_vec3 *corners; /* (side + 1)^2 unit directions of the cells'
                                       * corners,    row by row; not owned */
    struct pp_cache_hemisphere_cell *cells; /* side^2, row by row */
    double nearest_m; /* what is nearer changes with the place as if it were so far */
    struct pp_vec3 a, b, normal;
    struct pp_rgb irradiance;
};

/* The corners of all hemispheres of that side; to be freed. NULL: no memory. */
struct pp_vec3 *pp_cache_hemisphere_corners(int side);

/* Fills cells and irradiance; state has all but its index. */
void pp_cache_hemisphere_sample(struct pp_cache_hemisphere *hemisphere,
                                struct pp_radiance_state *state,
                                const struct pp_cache_place *place, int supersamples);

#endif
