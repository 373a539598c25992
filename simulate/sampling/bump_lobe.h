/* bump_lobe.h - the lobe of a matt surface with bumps
 * (model/light/rough/bump_facets.h).
 *
 * A direction is sampled in two steps: a kind of facet, in proportion to the light that
 * it reflects in the channel of luminance, then a cosine-weighted direction about its
 * normal. Some of these directions point into the surface; they count as light 0. All
 * directions are unit vectors in the scene.
 */
#ifndef PP_SIMULATE_SAMPLING_BUMP_LOBE_H
#define PP_SIMULATE_SAMPLING_BUMP_LOBE_H

#include <stdbool.h>

#include "model/geometry/vec.h"
#include "model/light/rgb.h"

struct pp_bump_lobe {
    struct pp_vec3 slope;       /* in the surface, not 0 */
    struct pp_rgb facet;        /* reflectance of the facets */
    struct pp_vec3 normal, eye; /* normal on the eye's side; direction of the eye */
};

/* Fraction of the light from the eye's direction that the surface reflects. */
struct pp_rgb pp_bump_lobe_albedo(const struct pp_bump_lobe *lobe);

/* BRDF (1/sr) between the eye and o. */
struct pp_rgb pp_bump_lobe_brdf(const struct pp_bump_lobe *lobe, struct pp_vec3 o);

/* Density (per steradian) with which pp_bump_lobe_sample gives o. */
double pp_bump_lobe_pdf(const struct pp_bump_lobe *lobe, struct pp_vec3 o);

/* Samples a direction from two numbers in (0, 1). *light: BRDF times cosine, divided by
 * the density. False if the direction points into the surface. */
bool pp_bump_lobe_sample(const struct pp_bump_lobe *lobe, double u, double v,
                         struct pp_vec3 *o, struct pp_rgb *light);

#endif
