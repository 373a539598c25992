/* entering_light.h - the light that enters through an opening, and its division between
 * the upper and the lower part of the room, for `split-flux` and `sphere`.
 *
 *   C     illuminance of the glass from above the horizon, over Eh
 *   C_g   the same from the ground: rho_g (1 - cos beta)/2, rho_g/2 for vertical glass
 *   beta  slope of the glass, 0 horizontal
 *
 * C of a vertical opening under the overcast sky is that of the BRE table
 * (obstruction.h). For other slopes and skies C is C_hv (1 - alpha/90), as printed in
 * [GEEBELEN], where 0.39 is replaced by the illuminance C_hv of glass of that slope
 * from the open sky, over Eh:
 *
 *     overcast   C_hv = 3/14 (1 + cos beta)
 *                     + 4/(7 pi) (sin beta + (pi - beta) cos beta)
 *     uniform    C_hv = (1 + cos beta)/2
 *
 * Through clear glass, light from above the horizon falls on the lower part of the room
 * and light from the ground on the upper one. A diffusing pane sends the share u of all
 * its light up and the rest down: u = (1 - cos beta)/2, one half for vertical panes.
 */
#ifndef PP_METHODS_REFLECTED_ENTERING_LIGHT_H
#define PP_METHODS_REFLECTED_ENTERING_LIGHT_H

#include <stdbool.h>

#include "model/results/steps.h"
#include "model/room/world.h"

struct pp_entering_light {
    double tau;       /* diffuse transmittance: 0.85 G, 1 for no glass */
    double Ag;        /* net glass area, m2 */
    double alpha_rad; /* of the obstruction */
    double C_hv;      /* NAN where C is from the table */
    double C, C_g;
    double u;
    bool diffusing;
    double up,
        down; /* illuminance of the glass, over Eh, by the light that falls on the
                      * upper and on the lower part first; times tau Ag: a flux */
    double rho_g, beta_rad;
};

enum pp_status pp_entering_light(struct pp_entering_light *light,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening,
                                 struct pp_error *err);

/* Records all terms; u for a diffusing pane only. steps may be NULL. */
void pp_entering_light_steps(struct pp_steps *steps,
                             const struct pp_entering_light *light,
                             const struct pp_opening *opening);

#endif
