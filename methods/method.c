/* method.c - the list of the hand methods, in the order in which results show them. */
#include "methods/method.h"

#include <stddef.h>
#include <string.h>

/* clang-format off */
const struct pp_method *const pp_methods[] = {
    &pp_method_exact,
    &pp_method_brs_table,
    &pp_method_brs_rooflight,
    &pp_method_waldram,
    &pp_method_waldram_overlay,
    &pp_method_pepper_pot,
    &pp_method_pepper_pot_sky,
    &pp_method_protractor,
    &pp_method_protractor_upright,
    &pp_method_bre,
    &pp_method_bre_min,
    &pp_method_bre_table,
    &pp_method_split_flux,
    &pp_method_sphere,
    &pp_method_arndt,
    &pp_method_dresler,
    &pp_method_k_factor,
    &pp_method_nomogram,
    &pp_method_irc_atlas,
    &pp_method_bre_atlas,
    &pp_method_split_flux_atlas,
    &pp_method_average_df,
    &pp_method_average_df_above,
    &pp_method_average_df_well,
    &pp_method_average_df_lynes,
    &pp_method_average_df_atlas,
    &pp_method_efficiency,
    &pp_method_lumen,
    &pp_method_lumen_one,
    NULL,
};
/* clang-format on */

const struct pp_method *pp_method_at(int index)
{
    return pp_methods[index];
}

const struct pp_method *pp_method_find(const char *name)
{
    for (int i = 0; pp_methods[i]; i++)
        if (strcmp(pp_methods[i]->name, name) == 0)
            return pp_methods[i];
    return NULL;
}

const char *pp_method_refuses_room(const struct pp_method *method,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receiver)
{
    if (world->tree_count > 0)
        return "does not cover trees, whose crowns let part of the light through; a "
               "simulation (--simulate) covers trees";
    if (world->outer_pane_count > 0 && !method->of_well)
        return "does not cover rooms nested within a model that has glass between the "
               "room and the sky; average-df-well and a simulation (--simulate) do";
    return method->refuses_room ? method->refuses_room(world, light, receiver) : NULL;
}

const char *pp_method_refuses_opening(const struct pp_method *method,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver)
{
    if (opening->blind && !method->takes_blinds)
        return "has a blind, but the method covers only windows without blinds; a "
               "simulation (--simulate) covers blinds";
    const char *why =
        method->refuses ? method->refuses(world, light, opening, receiver) : NULL;
    bool scatters =
        opening->measured && opening->measured->kind == PP_MEASURED_SCATTERING;
    if (why || !scatters || method->any_pane)
        return why;
    return "has a measured pane that scatters light by direction, but the method is "
           "for clear or diffusing glass";
}
