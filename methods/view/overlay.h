/* overlay.h - the visible part of each of several occluders that overlap in a view. */
#ifndef PP_METHODS_VIEW_OVERLAY_H
#define PP_METHODS_VIEW_OVERLAY_H

#include <stdbool.h>

#include "methods/view/occluders.h"
#include "model/geometry/clipper.h"
#include "model/geometry/region.h"

/* The union of the pieces. Clockwise pieces are turned counter-clockwise. */
enum pp_status pp_overlay_union(struct pp_clipper *clipper, struct pp_region *whole,
                                const struct pp_occluders *pieces,
                                struct pp_error *err);

/* True if both have the same reflectance and exitance, so that their order does not
 * matter. */
bool pp_overlay_same_light(const struct pp_occluder *a, const struct pp_occluder *b);

/* Visible part of all pieces with the same light as piece `index`, which must be the
 * first of them. Pieces with other light hide what is behind them. distance_m: distance
 * of the plane from the eye. */
enum pp_status pp_overlay_seen(struct pp_clipper *clipper, struct pp_region *seen,
                               const struct pp_occluders *pieces, int index,
                               double distance_m, struct pp_error *err);

#endif
