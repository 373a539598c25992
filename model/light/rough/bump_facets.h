/* bump_facets.h - reflection of a matt surface with bumps [SHHD17].
 *
 * A bump tilts the normal. If a surface reflected like a plane one with the tilted
 * normal, it would reflect light that it does not receive, and exchanging the two
 * directions would change the result. Here the surface consists of facets of two
 * directions instead: tilted facets p, and steps t that close the surface like the
 * steps of a saw. With the normal n of the surface and the slope s, which is the
 * gradient of the height and lies in the surface,
 *
 *     p = (n - s)/|n - s|    area 1/cos A      tan A = |s|
 *     t = s/|s|              area tan A        per area of the surface
 *
 * Towards any direction o above the surface, the facets cover together the projected
 * area o.n of the surface; each has a share of it in proportion to its area times
 * max(0, its normal . o). The rest of a facet is hidden by facets of the other kind. The
 * light that a facet reflects in such directions falls on the other kind, which reflects
 * it again. Both kinds are matt, and each is evenly lit.
 *
 * The reflection conserves energy (a surface with a reflectance of 1 reflects all light)
 * and is reciprocal.
 */
#ifndef PP_MODEL_LIGHT_ROUGH_BUMP_FACETS_H
#define PP_MODEL_LIGHT_ROUGH_BUMP_FACETS_H

#include "model/geometry/vec.h"

enum { PP_BUMP_TILTED, PP_BUMP_STEP, PP_BUMP_KINDS };

struct pp_bump_facets {
    struct pp_vec3 surface; /* normal of the surface */
    struct pp_vec3 normal[PP_BUMP_KINDS];
    double area[PP_BUMP_KINDS]; /* per area of the surface */
    /* Fraction of a kind's light that leaves the surface; the rest falls on the other
     * kind. */
    double leaving[PP_BUMP_KINDS];
};

/* Facets of a surface with the unit normal and a slope that is not 0. */
struct pp_bump_facets pp_bump_facets_of(struct pp_vec3 normal, struct pp_vec3 slope);

/* Shares of the facets in the surface's projected area, towards the unit direction o;
 * their sum is 1. All 0 if o is not above the surface. */
void pp_bump_facets_shares(const struct pp_bump_facets *facets, struct pp_vec3 o,
                           double shares[PP_BUMP_KINDS]);

/* Light that the facets reflect (per area of the surface), if they receive the fractions
 * `shares` of an irradiance of 1 and have this reflectance (0 to 1). Light that a facet
 * receives from the other kind is included. */
void pp_bump_facets_light(const struct pp_bump_facets *facets, double reflectance,
                          const double shares[PP_BUMP_KINDS],
                          double light[PP_BUMP_KINDS]);

/* BRDF (1/sr) towards o, for the light of pp_bump_facets_light. */
double pp_bump_facets_brdf(const struct pp_bump_facets *facets,
                           const double light[PP_BUMP_KINDS], struct pp_vec3 o);

/* Fraction of the irradiance that leaves the surface, for the light of
 * pp_bump_facets_light. */
double pp_bump_facets_albedo(const struct pp_bump_facets *facets,
                             const double light[PP_BUMP_KINDS]);

/* Reflectance for diffuse light of facets with this reflectance; slope: any length. */
double pp_bump_facets_reflectance(double slope, double reflectance);

#endif
