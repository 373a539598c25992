/* rough_surface.h - a physically rough surface in three channels, with tables by the
 * angle of incidence.
 *
 * The reflectance is that of he_torrance.h, times a factor c of each direction, and a
 * uniform diffuse part a / pi:
 *
 *     spike' = c(i)^2 spike     dd'(i, r) = c(i) c(r) dd(i, r)
 *
 * The published model (c = 1) reflects up to 2 % more than it receives at grazing
 * incidence, because the effective roughness of the lobe depends on both directions and
 * that of the spike on one. Here c is the largest factor, at most 1, for which
 *
 *     spike' + int dd' cos  <=  1        with F = 1 for every angle
 *     a + spike' + int dd' cos  <=  1    with the surface's own F
 *
 * so the surface never reflects more than it receives, remains reciprocal, and is as
 * published wherever the model keeps the bound. The bound is 0.998, not 1, since the
 * tables have errors of up to 0.0015. Light that one facet reflects to another
 * is lost, as published: `lost` is its share for diffuse illumination.
 */
#ifndef PP_MODEL_LIGHT_ROUGH_ROUGH_SURFACE_H
#define PP_MODEL_LIGHT_ROUGH_ROUGH_SURFACE_H

#include "model/base/error.h"
#include "model/geometry/vec.h"
#include "model/light/rgb.h"

/* Lengths in micrometres; index: red, green, blue. */
struct pp_rough_optics {
    double n[3], k[3], wavelength[3];
    double roughness, correlation; /* s0 and T */
    struct pp_rgb diffuse;         /* a: uniform diffuse reflectance */
};

/* Angles of the tables: the square root of the cosine is 0, 1/32, ... 1. */
enum { PP_ROUGH_ANGLES = 33, PP_ROUGH_RADII = 96 };

struct pp_rough_surface {
    struct pp_rough_optics optics;
    int channels;                    /* 1: all channels are equal; else 3 */
    double keep[3][PP_ROUGH_ANGLES]; /* c */
    double lobe[3][PP_ROUGH_ANGLES]; /* int dd' cos */
    double reflectance[3]; /* of spike and lobe together, for diffuse illumination */
    double lost; /* share of diffuse light that the published model loses among
                            * facets of F = 1, in the green channel */
    double most; /* the largest albedo of the published model, with F = 1 */

    /* Distribution of the lobe's light by |i_xy + r_xy| over its largest value 1 +
     * |i_xy|: cumulative shares at these radii. */
    double radius[PP_ROUGH_RADII + 1];
    double share[PP_ROUGH_ANGLES][PP_ROUGH_RADII + 1];
};

/* Fills the tables; this takes some 0.1 s. Lengths must be greater than 0, roughness 0
 * or more, n greater than 0, k 0 or more, a from 0 to 1. Fails only if memory runs
 * out. */
enum pp_status pp_rough_surface_init(struct pp_rough_surface *surface,
                                     const struct pp_rough_optics *optics,
                                     struct pp_error *err);

/* True if both have the same optics. */
bool pp_rough_surface_same(const struct pp_rough_surface *a,
                           const struct pp_rough_surface *b);

/* spike' at the cosine of incidence, and int dd' cos. */
struct pp_rgb pp_rough_surface_spike(const struct pp_rough_surface *surface,
                                     double cosine);
struct pp_rgb pp_rough_surface_lobe(const struct pp_rough_surface *surface,
                                    double cosine);

/* dd' between two unit directions over the surface (z: its normal), 1/sr. */
struct pp_rgb pp_rough_surface_value(const struct pp_rough_surface *surface,
                                     struct pp_vec3 i, struct pp_vec3 r);

/* Reflectance for diffuse illumination, with the uniform diffuse part. */
struct pp_rgb pp_rough_surface_reflectance(const struct pp_rough_surface *surface);

/* Cell of the tables by angle: the lower index, and the weight of the next. */
int pp_rough_surface_cell(double cosine, double *next);

/* Largest angle between i_xy and the sum i_xy + r_xy for which a direction r exists.
 * radius: length of the sum; sine: length of i_xy. */
double pp_rough_surface_reach(double sine, double radius);

#endif
