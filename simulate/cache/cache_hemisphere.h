/* cache_hemisphere.h - the irradiance of a surface, calculated with a hemisphere of
 * rays.
 *
 * Stratified sampling: the unit square is divided into side x side cells and mapped to
 * the hemisphere [SC97] so that every cell has the same weight in the irradiance. Each
 * cell gets one ray. Cells whose neighbours differ from each other get more rays; all
 * cells do if the irradiance is too uncertain. Cells that are neighbours in the square
 * are neighbours on the hemisphere, as the derivatives require (cache_derivatives.h).
 */
#ifndef PP_SIMULATE_CACHE_CACHE_HEMISPHERE_H
#define PP_SIMULATE_CACHE_CACHE_HEMISPHERE_H

#include "model/geometry/frame.h"
#include "simulate/cache/cache_entry.h"
#include "simulate/transport/radiance.h"

/* The radiance of one cell, and the surface that its first ray meets. Vectors are in
 * the record's frame. */
struct pp_cache_hemisphere_cell {
    struct pp_rgb radiance; /* mean over the cell's rays */
    struct pp_vec3 to;      /* unit direction of the first ray */
    double distance_m;      /* distance of the surface met; INFINITY: none */
    struct pp_vec3 facing;  /* normal of that surface */
    uint32_t path;          /* path index of the first ray */
    double samples;
    double contrast; /* among the neighbours; cells with a large one get more rays */
    double gradient_per_radiance[2]; /* d(gradient)/dL, 1/m */
    double hessian_per_radiance[3];  /* d(second derivatives aa, ab, bb)/dL, 1/m2 */
};

struct pp_cache_hemisphere {
    int side;
    const struct pp_vec3 *corners; /* (side + 1)^2 unit directions, row by row; not
                                    * owned */
    struct pp_cache_hemisphere_cell *cells; /* side^2, row by row */
    double nearest_m;      /* least distance of surfaces in the derivatives */
    struct pp_frame frame; /* z: normal of the surface */
    struct pp_rgb irradiance;
};

/* Corners of the cells of a hemisphere with side^2 cells; the caller frees them. NULL:
 * out of memory. */
struct pp_vec3 *pp_cache_hemisphere_corners(int side);

/* Fills the cells and the irradiance. The caller sets all members of `state` except the
 * index. */
void pp_cache_hemisphere_sample(struct pp_cache_hemisphere *hemisphere,
                                struct pp_radiance_state *state,
                                const struct pp_cache_place *place, int supersamples);

#endif
