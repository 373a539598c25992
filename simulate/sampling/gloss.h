/* gloss.h - the BRDF of a Gaussian gloss that loses no energy.
 *
 * With i and o the unit directions to where light comes from and goes to, on the side
 * of the normal n, and h = i + o (not unit length), Ward's gloss [WARD92] in its
 * bounded form [GMD10] is
 *
 *     f = 1/(pi a_x a_y) exp(-((h.x / a_x)^2 + (h.y / a_y)^2) / (h.n)^2)
 *         (h.h) / (h.n)^4
 *
 * Its half vectors are drawn as Gaussian slopes; a direction then has the weight 2 cos
 * o / (cos i + cos o). Light that a facet reflects down into the surface is lost. The
 * loss is a_x a_y at normal incidence, up to a fifth near grazing incidence however
 * smooth the surface is, and two thirds at a roughness of 1. On a real surface, other
 * facets reflect this light again. The lobe is therefore scaled for both directions,
 *
 *     f'(i, o) = s(i) s(o) f(i, o)        s(i) int f(i, o) s(o) cos o do = 1
 *
 * for every i. No energy is lost; the lobe is reciprocal and keeps its shape. Such an s
 * exists and is unique [SK67]; it lies between 0.88 and 1.18 at roughnesses up to 0.4.
 *
 * The scale s is tabulated over the cosine of the direction and, if there are two
 * roughnesses, over its azimuth. It is read by linear interpolation. The albedo equals
 * the declared one to 0.3 % (to 1 % if one roughness is hundreds of times the other).
 */
#ifndef PP_SIMULATE_SAMPLING_GLOSS_H
#define PP_SIMULATE_SAMPLING_GLOSS_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/geometry/vec.h"

/* True if a gloss of these roughnesses is a mirror. If only one roughness is below
 * SMOOTH = 0.001, it counts as SMOOTH. */
bool pp_gloss_is_mirror(double along, double across);

enum { PP_GLOSS_COSINES = 33, PP_GLOSS_AZIMUTHS = 9 };

struct pp_gloss {
    double along, across; /* roughnesses */
    int azimuths;         /* 1: isotropic */
    double scale[PP_GLOSS_AZIMUTHS][PP_GLOSS_COSINES];
};

/* Calculates s. This takes a few milliseconds, or a few tens if the roughnesses differ.
 * The roughnesses must not be those of a mirror. */
enum pp_status pp_gloss_init(struct pp_gloss *gloss, double along, double across,
                             struct pp_error *err);

/* True if pp_gloss_init would give the same result for these roughnesses. */
bool pp_gloss_is_of(const struct pp_gloss *gloss, double along, double across);

/* s of a unit direction in the surface's frame: x along the first roughness, z (0 to 1)
 * off the surface. All functions below use the same frame. */
double pp_gloss_scale(const struct pp_gloss *gloss, struct pp_vec3 direction);

/* f' between two unit directions, for a gloss of reflectance 1; 1/sr. */
double pp_gloss_value(const struct pp_gloss *gloss, struct pp_vec3 i, struct pp_vec3 o);

/* Samples a direction o for i by two numbers in (0, 1): i mirrored in a facet of random
 * slope. Returns f' cos o divided by the density, at most 4/3 s(i) s(o); 0 if o points
 * into the surface. */
double pp_gloss_sample(const struct pp_gloss *gloss, struct pp_vec3 i, double u,
                       double v, struct pp_vec3 *o);

/* The density with which pp_gloss_sample gives direction o, per steradian. */
double pp_gloss_pdf(const struct pp_gloss *gloss, struct pp_vec3 i, struct pp_vec3 o);

#endif
