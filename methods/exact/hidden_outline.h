/* hidden_outline.h - hidden cones as areas of the sky, to be drawn. */
#ifndef PP_METHODS_EXACT_HIDDEN_OUTLINE_H
#define PP_METHODS_EXACT_HIDDEN_OUTLINE_H

#include "methods/exact/hidden_cones.h"
#include "model/results/sheets/sky_mask.h"

/* Adds pieces for the part of the sky above the horizon that the cones together hide.
 * It is sampled at steps of a quarter of a degree of bearing, and at the ends of cones
 * to a thousandth of a degree. Overlapping cones share pieces. north_rad: as in
 * pp_world. The caller clears the mask, after a failure too. */
enum pp_status pp_hidden_outline_add(struct pp_sky_mask *mask,
                                     const struct pp_hidden_cones *cones,
                                     double north_rad, struct pp_error *err);

#endif
