/* blind.h - transmittances of a blind for hand methods.
 *
 * For even light from the sky's half and the ground's half of the outside, with
 * straight and scattered light (slat_cell.h). A method that multiplies its figures for
 * a window by one number uses their mean. A vertical window under the CIE overcast sky
 * receives 80 % of its light from the sky and 20 % from ground of reflectance 0.2:
 *
 *     horizontal slats in a vertical window:  0.8 sky + 0.2 ground
 *     vertical slats, and sloping windows:    that of even light from all directions
 */
#ifndef PP_MODEL_LIGHT_SLATS_BLIND_H
#define PP_MODEL_LIGHT_SLATS_BLIND_H

#include "model/light/slats/slat_cell.h"

struct pp_blind {
    struct pp_slats slats;
    double sky, ground, all; /* transmittances */
    double mean;             /* for hand methods */
    int holders;             /* number of openings that share it */
};

/* Makes the blind, with one holder. PP_BAD_INPUT if its slats touch each other. */
enum pp_status pp_blind_create(struct pp_blind **blind, const struct pp_slats *slats,
                               bool horizontal_in_vertical_window,
                               struct pp_error *err);

/* A holder less; the blind is freed after the last. NULL is allowed. */
void pp_blind_release(struct pp_blind *blind);

#endif
