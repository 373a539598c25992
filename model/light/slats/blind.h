/* blind.h - a blind with its glass, for simulations by direction and for hand methods.
 *
 * Light that passes straight is traced as a ray (slats.h). Scattered light depends only
 * on the profile angles p and q at which it arrives and leaves, because the slats are
 * endless and Lambertian. Let N(p, q) be the fraction of the light behind the outer
 * glass that leaves the blind in the bin of q, and d the bin's range of sin q. Then
 *
 *     btdf(in, out) = tau_outer(in) (2/pi) N(p, q) / d tau_inner(out)            (1)
 *
 * because light that leaves a bin with uniform radiance L has the flux L pi d / 2. N is
 * tabulated at steps of 2.5 degrees of p. It includes the light that blind and glass
 * reflect between them; for this, the glass has the mean reflectance of a bin. For
 * light from the room to the outside, btdf(in, out) = btdf(-out, -in).
 *
 * Hand methods multiply by one number, the mean transmittance of the blind alone. It is
 * calculated from the transmittances for uniform light from the upper half of the
 * outside (sky), from the lower half (ground), and from both. A vertical window under
 * the CIE overcast sky receives 80 % of its light from the sky and 20 % from ground of
 * reflectance 0.2:
 *
 *     horizontal slats in a vertical window:  0.8 sky + 0.2 ground
 *     vertical slats, and sloping windows:    uniform light from both halves
 */
#ifndef PP_MODEL_LIGHT_SLATS_BLIND_H
#define PP_MODEL_LIGHT_SLATS_BLIND_H

#include "model/light/glass.h"
#include "model/light/pane_scatter.h"
#include "model/light/slats/slat_cell.h"
#include "model/light/slats/window_device.h"

enum {
    PP_BLIND_CELLS = 72,              /* of p, from -90 to 90 degrees */
    PP_BLIND_BINS = PP_SLAT_BINS / 2, /* of q, the same */
    PP_BLIND_SUNS = 360,              /* steps of p for the straight light of the sun */
};

struct pp_blind {
    struct pp_pane_scatter scatter; /* data: this blind, which must not move */
    struct pp_window_device device;
    struct pp_glass glass;        /* outer and inner together */
    struct pp_glass outer, inner; /* panes before and behind the slats */

    double through[PP_BLIND_CELLS + 1][PP_BLIND_BINS]; /* N at the ends of the cells */
    /* For sampling: means of tau_outer over each cell and of tau_inner over each bin;
     * cumulative sums of N tau_outer d over cells, up to and including each cell. */
    double outer_mean[PP_BLIND_CELLS], inner_mean[PP_BLIND_BINS];
    double cumulative[PP_BLIND_BINS][PP_BLIND_CELLS];

    double sky, ground, all; /* transmittances of the blind alone */
    double mean;             /* transmittance for hand methods */
    int holders;             /* number of openings that share it */

    /* Of slats that follow the sun (blind_follow.h): */
    struct pp_blind *for_sun; /* the blind for light of the sun, released with this
                               * one; NULL: this one */
    double straight_of_sun[PP_BLIND_SUNS + 1]; /* of such a blind for the sun, by p */
};

/* Makes the blind of a device, with one holder. glass: clear, or none; a blind between
 * panes needs at least two panes. PP_BAD_INPUT if neighbouring slats touch. */
enum pp_status pp_blind_create(struct pp_blind **blind,
                               const struct pp_window_device *device,
                               const struct pp_glass *glass, bool upright,
                               struct pp_error *err);

/* Removes a holder; the blind is freed after the last one. NULL is allowed. */
void pp_blind_release(struct pp_blind *blind);

#endif
