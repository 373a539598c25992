/* hidden_outline.h - hidden cones as areas of the sky, to be drawn. */
#ifndef PP_METHODS_EXACT_HIDDEN_OUTLINE_H
#define PP_METHODS_EXACT_HIDDEN_OUTLINE_H

#include "methods/exact/hidden_cones.h"
#include "model/results/sheets/sky_mask.h"

/* Adds a piece for each run of bearings in which a cone hides some of the sky above the
 * horizon, sampled each quarter of a degree, its ends to a thousandth. north_rad as pp_world
 * has it. The caller clears the mask, after a failure too. */
enum pp_status pp_hidden_outline_add(struct pp_sky_mask *mask,
                                     const struct pp_hidden_cones *cones,
                                     double north_rad, struct pp_error *err);

#endif
