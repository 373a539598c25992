/* direct.h - what the patches of a view give a receiver: the conventions of the direct
 * component at work.
 *
 *     sky       integral of L tau(i) (n.u) over what shows the sky
 *     external  luminance factor f times the same over what hides it (its equivalent
 *               sky component), f = rho for the overcast sky, else rho / 2;
 *               hidden below the horizon: f times the luminance at the horizon;
 *               ground that is seen: rho_ground / pi times integral tau (n.u);
 *               exitance M of what hides: M / pi times integral tau (n.u)
 *
 * with tau the transmittance of the glass at its angle of incidence, 1 where there is
 * none. Closed form where sky and glass allow it, else quadrature.
 */
#ifndef PP_METHODS_EXACT_DIRECT_H
#define PP_METHODS_EXACT_DIRECT_H

#include "methods/exact/solid_angle.h"
#include "methods/view/visible.h"
#include "model/base/error.h"
#include "model/results/steps.h"
#include "model/room/world.h"

struct pp_direct {
    double sky, external; /* over Eh */
    bool rough;           /* asked for: fast, to about PP_QUADRATURE_ROUGH */
    double error;         /* of both, the bound that the quadrature claims; 0 for closed
                           * forms */
    struct pp_steps *steps; /* where it is set out on paper; NULL: nowhere */
};

/* Adds to *sum, of which the caller has set `rough`. Glass lies square to the view's
 * `toward`. Nothing is allocated for closed forms over rings of at most 64 corners. */
enum pp_status pp_direct_add(struct pp_direct *sum, const struct pp_visible *visible,
                             struct pp_vec3 normal, const struct pp_glass *glass,
                             const struct pp_world *world, const struct pp_sky *sky,
                             struct pp_error *err);

/* The same for all that a receiver sees through an opening, as though its glass were
 * `glass` (clear, or none). */
enum pp_status pp_direct_through(struct pp_direct *sum, const struct pp_world *world,
                                 const struct pp_opening *opening,
                                 const struct pp_receiver *receiver,
                                 const struct pp_glass *glass, struct pp_error *err);

/* Luminance factor of what hides the sky, from its reflectance. */
double pp_direct_factor(const struct pp_sky *sky, double reflectance);

/* Moments of what lies of a patch within `more` half-spaces, at most three, too. */
enum pp_status pp_direct_moments(struct pp_moments *moments,
                                 const struct pp_visible *visible,
                                 const struct pp_visible_patch *patch,
                                 struct pp_vec3 normal, const struct pp_vec3 *more,
                                 int more_count, struct pp_error *err);

#endif
