/* fitted_parts.c - records A_u, rho_u, A_l and rho_l for an opening. */
#include "methods/fitted/fitted_parts.h"

#include "methods/fitted/fitted_light.h"

void pp_fitted_parts_put(struct pp_worksheet *sheet, const void *tools,
                         const struct pp_world *world, const struct pp_opening *opening)
{
    const struct pp_fitted_light *list = tools;
    struct pp_interior_parts parts = list[opening - world->openings].parts;
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, parts.upper.area_m2, "A_u",
                     "area of surfaces above %.2f m, the height of the opening's "
                     "centre",
                     opening->middle_z_m);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.upper.reflectance, "rho_u",
                     "mean reflectance of these surfaces");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, parts.lower.area_m2, "A_l",
                     "area of surfaces below this height");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.lower.reflectance, "rho_l",
                     "mean reflectance of these surfaces");
}

const char *pp_fitted_parts_refuses(const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_opening *opening,
                                    const struct pp_receiver *receiver)
{
    if (!pp_interior_is_split(world, opening->middle_z_m))
        return "has all surfaces of the room either above or below its centre";
    return pp_fitted_light_refuses(world, light, opening, receiver);
}
