/* blind_follow.h - slats that follow the sun.
 *
 * For sunlight of the profile angle p the slats take the smallest angle at which none of
 * it passes straight; if no angle does that, the one at which least passes (slats.h).
 * Their angle is thus a function of p alone, and so is the light that they scatter. A year
 * of suns needs one pane for all angles of the slats: the blind for the sun, with straight
 * and scattered light by p. Its light from the sky is that of slats at 0 degrees.
 */
#ifndef PP_MODEL_LIGHT_SLATS_BLIND_FOLLOW_H
#define PP_MODEL_LIGHT_SLATS_BLIND_FOLLOW_H

#include "model/light/slats/blind.h"

/* The angle for sunlight of a profile angle. Curved slats turn as far as they can without
 * touching. */
double pp_blind_follow_tilt(const struct pp_slats *slats, double profile_rad);

/* Makes the blind for the sun, as pp_blind_create does. */
enum pp_status pp_blind_follow_create(struct pp_blind **blind,
                                      const struct pp_window_device *device,
                                      const struct pp_glass *glass, bool upright,
                                      struct pp_error *err);

#endif
