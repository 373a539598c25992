/* entering_light.h - the light that enters through an opening, and its division between
 * the upper and the lower part of the room, for `split-flux`, `sphere`, `dresler` and
 * `arndt` (which does not use the division).
 *
 * tau is the transmittance of the pane for diffuse light: 0.827 for clear single glass,
 * and the stated value for a diffusing pane. The published 0.85 is used only in `bre`,
 * because the factors of `bre` are based on that value.
 *
 * C and C_g are the illuminances of the glass from above the horizon and from the
 * ground, divided by Eh. For a vertical opening under the overcast sky, C is read from
 * the BRE table (obstruction.h). For other slopes and skies [GEEBELEN] prints C with
 * the factor 0.39; here C_hv, the illuminance of glass of that slope from the open sky
 * over Eh (sky.h), replaces 0.39.
 *
 * For glass with a well (well.h), C and C_g are the light through the foot of the well,
 * reduced by the well's efficiency N. Light that has met the sides of the well leaves
 * the foot as from a diffuse pane. The direct illuminance of the working plane by this
 * light, E_w, is internally reflected light that the formulae of the room omit;
 * pp_entering_light_of_well adds E_w.
 *
 * Through clear glass, light from above the horizon falls on the lower part of the room
 * and light from the ground on the upper one. A diffusing pane sends the fraction u of
 * all its light up and the rest down; u is one half for vertical panes.
 */
#ifndef PP_METHODS_REFLECTED_ENTERING_LIGHT_H
#define PP_METHODS_REFLECTED_ENTERING_LIGHT_H

#include "methods/allowance.h"
#include "model/light/outside_light.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

/* Rows of a formula's list of quantities. */
#define PP_ENTERING_LIGHT_QUANTITIES                                                   \
    {"tau", PP_UNIT_NUMBER, "diffuse transmittance of the glass (1 if unglazed)"},     \
        {"Ag", PP_UNIT_SQUARE_METRE,                                                   \
         "net glass area: opening area times frame factor"},                           \
        {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},                          \
        {"C", PP_UNIT_DAYLIGHT_FACTOR,                                                 \
         "illuminance on the glass from above the horizon"},                           \
        {"rho_g", PP_UNIT_NUMBER, "reflectance of the ground"},                        \
        {"beta", PP_UNIT_ANGLE, "slope of the glass (0: horizontal)"},                 \
    {                                                                                  \
        "C_g", PP_UNIT_DAYLIGHT_FACTOR, "illuminance on the glass from the ground"     \
    }
#define PP_ENTERING_LIGHT_SHARE_UP                                                     \
    {                                                                                  \
        "u", PP_UNIT_NUMBER,                                                           \
            "fraction of the light from the diffusing pane that goes upwards"          \
    }

/* Rows of a method's list of formulae. */
extern const struct pp_formula pp_entering_light_C, pp_entering_light_C_g,
    pp_entering_light_u, pp_entering_light_C_of_well, pp_entering_light_C_g_of_well,
    pp_entering_light_E_w, pp_entering_light_with_well;
#define PP_ENTERING_LIGHT_FORMULAE                                                     \
    &pp_allowance_glass_Ag, &pp_entering_light_C, &pp_entering_light_C_of_well,        \
        &pp_entering_light_C_g, &pp_entering_light_C_g_of_well, &pp_entering_light_u
/* Further rows for a method that adds the light reflected by wells. */
#define PP_ENTERING_LIGHT_WELL_FORMULAE                                                \
    &pp_entering_light_E_w, &pp_entering_light_with_well

/* Records all quantities of these lists; u for a diffusing pane only. */
enum pp_status pp_entering_light(struct pp_worksheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_opening *opening,
                                 struct pp_error *err);

/* Adds E_w, calculated by that formula, to irc, which is on the sheet with the given
 * value. Returns the sum; for an opening without a well, returns irc. */
double pp_entering_light_of_well(struct pp_worksheet *sheet,
                                 const struct pp_formula *E_w,
                                 const struct pp_world *world,
                                 const struct pp_opening *opening, double irc);

#endif
