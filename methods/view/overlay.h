/* overlay.h - pieces in a view's plane laid over each other: what is seen of which. */
#ifndef PP_METHODS_VIEW_OVERLAY_H
#define PP_METHODS_VIEW_OVERLAY_H

#include <stdbool.h>

#include "methods/view/occluders.h"
#include "model/geometry/region.h"

/* The union of the pieces, which are turned counter-clockwise where they are not. */
enum pp_status pp_overlay_union(struct pp_clipper *clipper, struct pp_region *whole,
                                const struct pp_occluders *pieces,
                                struct pp_error *err);

/* Is it no matter which of the two hides the other? */
bool pp_overlay_same_light(const struct pp_occluder *a, const struct pp_occluder *b);

/* What is seen of all pieces that give off the same light as piece `index`, none of
 * them before it, behind all that give off another. distance_m: of the plane from the
 * eye. */
enum pp_status pp_overlay_seen(struct pp_clipper *clipper, struct pp_region *seen,
                               const struct pp_occluders *pieces, int index,
                               double distance_m, struct pp_error *err);

#endif
