/* point_areas.h - means over the plane from points that represent areas of it. */
#ifndef PP_MODEL_RESULTS_SHEETS_POINT_AREAS_H
#define PP_MODEL_RESULTS_SHEETS_POINT_AREAS_H

#include "model/room/world.h"

/* Sum of the areas of the points (m2). NAN: one of them has no area, or receivers is
 * NULL, and all count equally. */
double pp_point_areas_sum(const struct pp_receiver *receivers, int count);

/* True if the points have areas, and these are not equal. */
bool pp_point_areas_differ(const struct pp_receiver *receivers, int count);

/* Weight of a point in means: its area divided by that of the first point, so that
 * equal areas have weights of exactly 1; 1 if a point has no area (sum is NAN). */
double pp_point_areas_weight(const struct pp_receiver *receivers, double sum,
                             int index);

/* Sum of the weights of all points. */
double pp_point_areas_whole(const struct pp_receiver *receivers, int count);

/* Share of a point in the mean over all of them. */
double pp_point_areas_share(const struct pp_receiver *receivers, int count, double sum,
                            int index);

#endif
