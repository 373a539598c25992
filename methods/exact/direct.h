/* direct.h - sky and externally reflected component of a view, patch by patch.
 *
 * With tau the transmittance of the glass at the angle of incidence (1 without glass),
 * luminances divided by Eh, and integrals over solid angle, a patch contributes
 *
 *     to the sky component, where it shows
 *       sky               integral L tau (n.u)
 *     to the externally reflected component, where it shows
 *       an obstruction    f integral L tau (n.u), the integral being the equivalent sky
 *                         component; below the horizon with the luminance at the
 *                         horizon; f = rho for the overcast sky, else rho / 2
 *       an exitance M     M / pi integral tau (n.u)
 *       ground            rho_ground / pi integral tau (n.u)
 *
 * The integrals are evaluated in closed form if sky and glass allow it, otherwise by
 * the opening's tables if there are any, otherwise by quadrature.
 */
#ifndef PP_METHODS_EXACT_DIRECT_H
#define PP_METHODS_EXACT_DIRECT_H

#include "methods/fast/pane_light.h"
#include "methods/exact/solid_angle.h"
#include "methods/exact/quadrature.h"
#include "methods/view/visible.h"
#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/steps.h"
#include "model/room/world.h"

struct pp_direct {
    double sky, external; /* components divided by Eh */
    /* Set by the caller: */
    bool rough; /* true: faster, with errors up to 1e-6 of the open sky by tables, about
                 * PP_QUADRATURE_ROUGH by quadrature */
    double unglazed_error; /* error bound without glass; 0: PP_QUADRATURE_UNGLAZED;
                            * from PP_QUADRATURE_PANE on, tables may have errors up to
                            * 1e-6 of the open sky */
    const struct pp_pane_light *tables; /* tables of the opening; not owned; NULL:
                                         * none */
    double error; /* error of both components, estimated by the quadrature; 0 for
                   * closed forms and tables */
    struct pp_steps *steps; /* where steps are recorded; may be NULL */
};

/* Adds the components of a view to *sum. The glass is perpendicular to the view's
 * `toward`. No allocation for closed forms over rings of at most 64 corners. */
enum pp_status pp_direct_add(struct pp_direct *sum, const struct pp_visible *visible,
                             struct pp_vec3 normal, const struct pp_glass *glass,
                             const struct pp_outside_light *light,
                             struct pp_error *err);

/* Adds the components of a receiver's view through an opening to *sum, with `glass`
 * (clear, or none) in place of the opening's own. */
enum pp_status pp_direct_through(struct pp_direct *sum, const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening,
                                 const struct pp_receiver *receiver,
                                 const struct pp_glass *glass, struct pp_error *err);

/* Moments of the part of a patch that is also within the half-spaces `more`, at most
 * three. */
enum pp_status pp_direct_moments(struct pp_moments *moments,
                                 const struct pp_visible *visible,
                                 const struct pp_visible_patch *patch,
                                 struct pp_vec3 normal, const struct pp_vec3 *more,
                                 int more_count, struct pp_error *err);

/* The integral of a luminance times (n.u) over a patch, by quadrature to
 * PP_QUADRATURE_GLAZED. */
enum pp_status pp_direct_quadrature(double *value, const struct pp_visible *visible,
                                    const struct pp_visible_patch *patch,
                                    struct pp_vec3 normal,
                                    const struct pp_integrand *integrand,
                                    struct pp_error *err);

#endif
