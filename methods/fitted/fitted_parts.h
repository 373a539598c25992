/* fitted_parts.h - the parts of a room below and above the middle of an opening's
 * height, without openings (interior.h), for the formulae that were fitted to simulated
 * rooms. */
#ifndef PP_METHODS_FITTED_FITTED_PARTS_H
#define PP_METHODS_FITTED_FITTED_PARTS_H

#include "methods/reflected/interior.h"
#include "model/light/outside_light.h"

/* Rows of a formula's list of quantities. */
#define PP_FITTED_PARTS_QUANTITIES                                                     \
    {"A_u", PP_UNIT_SQUARE_METRE,                                                      \
     "area of surfaces above the centre of the opening, excluding openings"},          \
        {"rho_u", PP_UNIT_NUMBER, "mean reflectance of these surfaces"},               \
        {"A_l", PP_UNIT_SQUARE_METRE, "area of surfaces below this height"},           \
    {                                                                                  \
        "rho_l", PP_UNIT_NUMBER, "mean reflectance of these surfaces"                  \
    }

/* Records the four quantities on the worksheet. tools: from pp_fitted_light_prepare. */
void pp_fitted_parts_put(struct pp_worksheet *sheet, const void *tools,
                         const struct pp_world *world,
                         const struct pp_opening *opening);

/* A method's `refuses`: like pp_fitted_light_refuses, and also for openings with no
 * surface of the room above or below their middle. */
const char *pp_fitted_parts_refuses(const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    const struct pp_receiver *receiver);

#endif
