/* bre.c - `bre`: average internally reflected component, BRE inter-reflection formula
 * (bre_terms.h).
 *
 *     IRC = 0.85 W / (A (1 - R)) (C R_fw + 5 R_cw)   per cent   [HLP54], [BRE310]
 *
 * For vertical openings under the CIE overcast sky. The formula contains clear single
 * glass and, through W, the frame; no dirt, no deterioration of decorations.
 */
#include "methods/reflected/bre_terms.h"
#include "methods/method.h"
#include "methods/refusals.h"

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_bre_terms terms;
    enum pp_status status = pp_bre_terms(&terms, world, opening, err);
    if (status != PP_OK)
        return status;
    part->value = pp_bre_terms_average(&terms);
    pp_bre_terms_steps(part->steps, &terms, opening, "irc");
    return PP_OK;
}

const struct pp_method pp_method_bre = {
    .name = "bre",
    .summary = "average internally reflected component, BRE inter-reflection formula",
    .source = "BRE310",
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate,
};
