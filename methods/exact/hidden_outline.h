/* hidden_outline.h - hidden cones as areas of the sky, to be drawn. */
#ifndef PP_METHODS_EXACT_HIDDEN_OUTLINE_H
#define PP_METHODS_EXACT_HIDDEN_OUTLINE_H

#include "methods/exact/hidden_cones.h"
#include "model/results/sheets/sky_mask.h"

/* Adds pieces for the part of the sky above the horizon that the cones together hide.
 * The sky is sampled every 0.25 degrees of bearing; the ends of cones are found to
 * 0.001 degrees. Overlapping cones share pieces. north_rad: as in pp_world. The caller
 * clears the mask, even after a failure. */
enum pp_status pp_hidden_outline_add(struct pp_sky_mask *mask,
                                     const struct pp_hidden_cones *cones,
                                     double north_rad, struct pp_error *err);

#endif
