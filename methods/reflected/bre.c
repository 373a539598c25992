/* bre.c - `bre`: average internally reflected component, by the BRE inter-reflection
 * formula [HLP54], [BRE310], which is in bre_terms.h.
 *
 * The method is for vertical openings under the CIE overcast sky. The formula contains
 * clear single glass and, through W, the frame; no dirt, no deterioration of
 * decorations.
 */
#include <stddef.h>

#include "methods/reflected/bre_terms.h"
#include "methods/method.h"
#include "methods/refusals.h"

static enum pp_status evaluate_bre(const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_opening *opening,
                                   const struct pp_receiver *receiver,
                                   const void *tools, struct pp_part *part,
                                   struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_bre_terms terms;
    enum pp_status status = pp_bre_terms(&terms, world, light, opening, err);
    if (status != PP_OK)
        return status;
    part->value = pp_bre_terms_work(&part->sheet, &pp_bre_terms_irc, &terms, opening);
    return PP_OK;
}

static const struct pp_formula *const formulae[] = {&pp_allowance_glass_W,
                                                    &pp_bre_terms_irc, NULL};

const struct pp_method pp_method_bre = {
    .name = "bre",
    .summary = "average internally reflected component, by the BRE inter-reflection "
               "formula",
    .source = "BRE310",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .own_ground = PP_BRE_GROUND_REFLECTANCE,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate_bre,
};
