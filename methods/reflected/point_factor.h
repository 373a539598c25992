/* point_factor.h - the share of the light through a point that falls directly on a
 * horizontal region, for diffuse light and for skylight. */
#ifndef PP_METHODS_REFLECTED_POINT_FACTOR_H
#define PP_METHODS_REFLECTED_POINT_FACTOR_H

#include "model/geometry/polygon.h"
#include "model/geometry/region.h"
#include "model/geometry/vec.h"
#include "model/light/sky.h"

/* Configuration factor [HSM16]: the share (0 to 1) of the diffuse light leaving a
 * surface at `from` with the unit normal `normal` that falls on the region in the
 * horizontal plane at height z. The part of the region behind the surface is not
 * counted. */
double pp_point_factor(struct pp_vec3 from, struct pp_vec3 normal,
                       const struct pp_region *region, double z);

/* Skylight through an unglazed opening at `from` (its normal points in) that falls
 * directly on the region below, over Eh: from 0 to the light on the opening. The sky
 * has a gradation and no azimuth dependence. */
double pp_point_factor_sky(struct pp_vec3 from, struct pp_vec3 normal,
                           const struct pp_region *region, double z,
                           const struct pp_sky *sky);

/* Share (0 to 1) of the skylight that passes straight from the point `from` through a
 * convex polygon with at most four edges, the foot of a well, that then falls directly
 * on the region below. */
double pp_point_factor_through(struct pp_vec3 from, const struct pp_polygon *foot,
                               const struct pp_region *region, double z,
                               const struct pp_sky *sky);

#endif
