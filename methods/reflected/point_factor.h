/* point_factor.h - the share of the light through a point that falls directly on a
 * level region: of diffuse light, and of the sky's. */
#ifndef PP_METHODS_REFLECTED_POINT_FACTOR_H
#define PP_METHODS_REFLECTED_POINT_FACTOR_H

#include "model/geometry/polygon.h"
#include "model/geometry/region.h"
#include "model/geometry/vec.h"
#include "model/light/sky.h"

/* Configuration factor [HSM16]: the share (0 to 1) of light that falls on the region in
 * the level plane at height z. The light leaves a surface at `from`, by the cosine
 * about `normal` (unit). The part of the region behind the surface is not counted. */
double pp_point_factor(struct pp_vec3 from, struct pp_vec3 normal,
                       const struct pp_region *region, double z);

/* Sky light of an unglazed opening at `from`, whose normal points in, that falls
 * directly on the region below, over Eh: from 0 to the light on the opening. The sky
 * has a gradation and no azimuth dependence. */
double pp_point_factor_sky(struct pp_vec3 from, struct pp_vec3 normal,
                           const struct pp_region *region, double z,
                           const struct pp_sky *sky);

/* Share of the sky's light from the point `from`, through a convex polygon below it, the
 * foot, of four edges at most, that falls straight on the region below, 0 to 1. */
double pp_point_factor_through(struct pp_vec3 from, const struct pp_polygon *foot,
                               const struct pp_region *region, double z,
                               const struct pp_sky *sky);

#endif
