/* fitted_light.h - the light on the outside of an opening, source by source, for the
 * formulae that were fitted to simulated rooms.
 *
 *   V     from the sky alone: the vertical sky component
 *   C_b   from obstructions outside, by the convention of `exact` (exterior.h)
 *   C_g   from the visible ground, with the ground reflectance of the room file
 *
 *   E_b, E_g   effective values of C_b and C_g. The convention of `exact` gives an
 *              obstruction the luminance of the sky behind it, times its reflectance.
 *              In fact obstructions and ground are shaded, as the opening is: their
 *              light is reduced by a power of V / 39.6 %, where 39.6 % is V under an
 *              open sky. The ground faces more of the sky than the opening does, so
 *              its exponent is half as large
 *
 *     E_b = C_b (V / 39.6)^b,   E_g = C_g (V / 39.6)^(b/2),   V / 39.6 at least 0.003
 *
 * with b fitted [ATLAS].
 *
 * All five quantities are divided by Eh. They are valid at the centre of the opening's
 * outside, without glass, under the CIE overcast sky. They do not depend on the
 * receiver and are calculated once for a world.
 */
#ifndef PP_METHODS_FITTED_FITTED_LIGHT_H
#define PP_METHODS_FITTED_FITTED_LIGHT_H

#include "methods/reflected/interior.h"
#include "model/light/outside_light.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

struct pp_fitted_light {
    double V, C_b, C_g;             /* fractions */
    struct pp_interior all;         /* of the room */
    struct pp_interior_parts parts; /* below and above the middle of the opening */
};

/* Rows of a method's list of formulae. */
extern const struct pp_formula pp_fitted_light_E_b, pp_fitted_light_E_g;
#define PP_FITTED_LIGHT_FORMULAE &pp_fitted_light_E_b, &pp_fitted_light_E_g

/* Rows of a formula's list of quantities. */
#define PP_FITTED_LIGHT_QUANTITIES                                                     \
    {"V", PP_UNIT_DAYLIGHT_FACTOR,                                                     \
     "illuminance on the outside of the opening from the sky"},                        \
        {"C_b", PP_UNIT_DAYLIGHT_FACTOR,                                               \
         "illuminance on the opening from obstructions if they are unshaded"},         \
        {"C_g", PP_UNIT_DAYLIGHT_FACTOR,                                               \
         "illuminance on the opening from the visible ground if it is unshaded"},      \
        {"E_b", PP_UNIT_DAYLIGHT_FACTOR,                                               \
         "illuminance on the opening from obstructions"},                              \
    {                                                                                  \
        "E_g", PP_UNIT_DAYLIGHT_FACTOR,                                                \
            "illuminance on the opening from the visible ground"                       \
    }

/* A method's `prepare`: *tools is a struct pp_fitted_light for each opening of the
 * world, in order. The caller frees *tools with free(). */
enum pp_status pp_fitted_light_prepare(void **tools, const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       struct pp_error *err);

/* Records all these quantities on the worksheet for one opening. tools: from
 * pp_fitted_light_prepare. */
void pp_fitted_light_put(struct pp_worksheet *sheet, const void *tools,
                         const struct pp_world *world,
                         const struct pp_opening *opening);

/* A method's `refuses`: for openings that are not vertical, diffusing panes, and rooms
 * with a mean reflectance of 1. */
const char *pp_fitted_light_refuses(const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    const struct pp_receiver *receiver);

#endif
