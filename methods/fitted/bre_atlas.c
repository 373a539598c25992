/* bre_atlas.c - `bre-atlas`: the BRE formula (reflected/bre_terms.h) with corrections
 * fitted to simulated rooms [ATLAS]: for the actual ground and obstructions, and for
 * position.
 *
 *   L      effective light on the opening (from the sky, the obstructions and the
 *          visible ground), divided by the light that the formula assumes (C, and a
 *          ground of reflectance 0.1)
 *   irc_m  mean over the working plane
 *
 * The printed formula is a mean over all surfaces. The working plane faces the upper
 * part of the room. Light from the ground arrives there directly, light from the sky
 * after one reflection. A power of rho_u represents reflection by the upper part
 * towards the plane. A high window, with more of the room below it, gives more light;
 * so does a room that is shallow compared with its height. In the limit R to 1 (a
 * furnace) the formula is the energy balance 0.85 W (V + C_g)/(A (1 - R)) under an open
 * sky, for any fitted constants. f_d and f_s are defined in fitted_position.h. Scope
 * and allowances are the same as for `bre`, except for diffusing panes.
 */
#include <stdlib.h>

#include "methods/fitted/fitted_constants.h"
#include "methods/fitted/fitted_light.h"
#include "methods/fitted/fitted_opening.h"
#include "methods/fitted/fitted_parts.h"
#include "methods/fitted/fitted_position.h"
#include "methods/method.h"
#include "methods/reflected/bre_terms.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity quantities[] = {
    PP_BRE_TERMS_OPENING,
    PP_INTERIOR_QUANTITIES,
    PP_FITTED_PARTS_QUANTITIES,
    PP_FITTED_LIGHT_QUANTITIES,
    {"d_r", PP_UNIT_METRE,
     "depth of the room, perpendicular to the wall with the opening"},
    {"h_r", PP_UNIT_METRE, "height of the room"},
    PP_FITTED_POSITION_QUANTITIES,
    {"IRC_av", PP_UNIT_DAYLIGHT_FACTOR,
     "average internally reflected component by the published formula"},
    {"L", PP_UNIT_NUMBER,
     "ratio of the entering light to that of the published formula"},
    {"irc_m", PP_UNIT_DAYLIGHT_FACTOR,
     "mean internally reflected component over the working plane"},
    {0},
};

static const struct pp_formula light_ratio = {
    .symbol = "L",
    .sum = "((V + E_b) R_fw + E_g) rho_u^" PP_FITTED_BRE_UPPER
           " / (C R_fw + " PP_BRE_TERMS_GROUND ")",
    .source = "ATLAS",
    .unit = PP_UNIT_NUMBER,
    .what = "ratio of the entering light to that of the published formula",
    .quantities = quantities,
};

static const struct pp_formula mean = {
    .symbol = "irc_m",
    .sum = "IRC_av L ((A_l / A_u)^" PP_FITTED_BRE_PARTS
           " (1 + h_r / d_r)^" PP_FITTED_BRE_SHALLOW ")^(1 - R)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "mean internally reflected component",
    .quantities = quantities,
};

static const struct pp_formula at_point = {
    .symbol = "irc",
    .sum = "irc_m f_d f_s",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "ATLAS",
    .what = "internally reflected component at the point",
    .quantities = quantities,
};

static const struct pp_formula *const formulae[] = {&pp_allowance_glass_W,
                                                    &pp_bre_terms_IRC_av,
                                                    PP_FITTED_LIGHT_FORMULAE,
                                                    &light_ratio,
                                                    PP_FITTED_POSITION_FORMULAE,
                                                    &mean,
                                                    &at_point,
                                                    NULL};

/* As pp_fitted_parts_refuses, and also for rooms in which every surface has a
 * reflectance of 0, except those of the opening's wall: the divisor of L would be 0. */
static const char *bre_atlas_refuses(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver)
{
    struct pp_interior_parts parts =
        pp_interior_split_without(world, opening->middle_z_m, opening->face);
    if (!(parts.lower.reflectance > 0.0 || parts.upper.reflectance > 0.0))
        return "is in a room in which every surface has a reflectance of 0";
    return pp_fitted_parts_refuses(world, light, opening, receiver);
}

/* Data of each opening of the world, in order. */
struct bre_atlas_tools {
    void *light;                 /* struct pp_fitted_light */
    struct pp_bre_terms terms[]; /* all 0 for openings that are not vertical */
};

static void destroy_bre_atlas(void *of_bre_atlas)
{
    struct bre_atlas_tools *tools = of_bre_atlas;
    if (tools)
        free(tools->light);
    free(tools);
}

static enum pp_status prepare_bre_atlas(void **of_bre_atlas,
                                        const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        struct pp_error *err)
{
    size_t count = (size_t)world->opening_count;
    struct bre_atlas_tools *tools =
        calloc(1, sizeof *tools + count * sizeof *tools->terms);
    if (!tools)
        return pp_fail_memory(err);
    enum pp_status status = pp_fitted_light_prepare(&tools->light, world, light, err);
    for (int i = 0; i < world->opening_count && status == PP_OK; i++)
        if (!pp_refusals_unless_vertical(&world->openings[i]))
            status =
                pp_bre_terms(&tools->terms[i], world, light, &world->openings[i], err);
    if (status != PP_OK)
        destroy_bre_atlas(tools);
    else
        *of_bre_atlas = tools;
    return status;
}

static enum pp_status evaluate_bre_atlas(const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         const struct pp_opening *opening,
                                         const struct pp_receiver *receiver,
                                         const void *tools, struct pp_part *part,
                                         struct pp_error *err)
{
    (void)light, (void)err;
    struct pp_worksheet *sheet = &part->sheet;
    const struct bre_atlas_tools *prepared = tools;
    pp_bre_terms_work(sheet, &pp_bre_terms_IRC_av,
                      &prepared->terms[opening - world->openings], opening);
    pp_fitted_light_put(sheet, prepared->light, world, opening);
    pp_fitted_parts_put(sheet, prepared->light, world, opening);
    pp_worksheet_work(sheet, &light_ratio,
                      "ratio of the entering light to that of the published formula");
    pp_fitted_position_put_room(sheet, world, opening);
    if (receiver)
        pp_fitted_opening_put_breadth(sheet, opening);
    part->value =
        pp_fitted_position_work(sheet, &mean, &at_point, world, opening, receiver);
    return PP_OK;
}

const struct pp_method pp_method_bre_atlas = {
    .name = "bre-atlas",
    .summary =
        "internally reflected component by position, by the BRE inter-reflection "
        "formula corrected to match simulated rooms",
    .source = "ATLAS",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_POINT,
    .has_average = true,
    .of_real_room = true,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = bre_atlas_refuses,
    .refuses_alike = true,
    .prepare = prepare_bre_atlas,
    .destroy_tools = destroy_bre_atlas,
    .evaluate = evaluate_bre_atlas,
};
