/* blind_scatter.h - the functions of a blind as a pane that scatters
 * (model/light/pane_scatter.h), by equation (1) of blind.h. */
#ifndef PP_MODEL_LIGHT_SLATS_BLIND_SCATTER_H
#define PP_MODEL_LIGHT_SLATS_BLIND_SCATTER_H

#include "model/light/slats/blind.h"

/* Fills in the functions and the tables for sampling; `through` and the means must be
 * set before the call. */
void pp_blind_scatter_init(struct pp_blind *blind);

/* Share of light with this direction of travel, in the axes of the pane, that passes
 * straight between the slats, without the glass. */
double pp_blind_scatter_gaps(const struct pp_blind *blind, struct pp_vec3 in);

/* Range of the sine of the profile angle in a bin of `count` from -90 to 90 degrees. */
double pp_blind_scatter_range(int bin, int count);

/* Mean of f, a function of the cosine of incidence, over all directions with profile
 * angle p, weighted by the light from each direction on the window's plane: (2/pi)
 * integral of f(cos s cos p) cos^2 s ds. */
double pp_blind_scatter_mean(double (*f)(const struct pp_glass *, double),
                             const struct pp_glass *glass, double profile_rad);

#endif
