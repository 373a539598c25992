/* scatter.h - where light goes from a surface: a material's lobes at one point.
 *
 * With i and o the unit directions to where light comes from and goes to, on the side
 * of the normal n, and h = i + o (not unit length), the gloss is [GMD10]
 *
 *     f = gloss / (pi a_x a_y) exp(-((h.x / a_x)^2 + (h.y / a_y)^2) / (h.n)^2)
 *         (h.h) / (h.n)^4
 *
 * Its half vectors are drawn as Gaussian slopes; a direction then has the weight
 * 2 cos o / (cos i + cos o). What goes through as a gloss is the same with o mirrored
 * in the surface. A roughness below SMOOTH is a mirror.
 */
#ifndef PP_SIMULATE_SCATTER_H
#define PP_SIMULATE_SCATTER_H

#include <stdbool.h>

#include "model/material.h"
#include "model/rgb.h"
#include "model/vec.h"

enum pp_lobe {
    PP_LOBE_DIFFUSE,
    PP_LOBE_THROUGH_DIFFUSE,
    PP_LOBE_GLOSS,
    PP_LOBE_THROUGH_GLOSS,
    PP_LOBE_MIRROR,
    PP_LOBE_STRAIGHT,
    PP_LOBE_COUNT,
};

/* All for light that comes to an eye in direction `eye`; n on the eye's side. */
struct pp_lobes {
    struct pp_rgb share[PP_LOBE_COUNT]; /* how much of it each sends on, all in all (of
                                         * a gloss at most) */
    struct pp_vec3 a, b, n;             /* right-handed; a along the grain */
    struct pp_vec3 eye;
    double roughness[2]; /* along a and b */
};

void pp_lobes_init(struct pp_lobes *lobes, const struct pp_material *material,
                   struct pp_vec3 n, struct pp_vec3 eye);

/* What passes straight through the material without being scattered, at the cosine of
 * the angle of incidence. */
struct pp_rgb pp_straight_through(const struct pp_material *material,
                                  double cos_incidence);

/* f of the glosses between the eye and direction o (unit, any side), 1/sr. */
struct pp_rgb pp_lobes_gloss(const struct pp_lobes *lobes, struct pp_vec3 o);

/* The smaller roughness: how wide the gloss looks, in radians. */
double pp_lobes_width(const struct pp_lobes *lobes);

/* A direction of that lobe by two numbers in (0, 1), and the factor that its share is
 * then worth; false where it would go into the surface. */
bool pp_lobes_sample(const struct pp_lobes *lobes, enum pp_lobe lobe, double u,
                     double v, struct pp_vec3 *o, double *factor);

#endif
