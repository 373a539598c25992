/* bre_min.c - `bre-min`: minimum internally reflected component in the room, from the
 * average by `bre`.
 *
 *     IRC_min = IRC_average / k                                             [BRE310]
 *
 *   k  1.8, 1.4, 1.3, 1.2 for walls of a mean reflectance of 0.2, 0.4, 0.6, 0.8
 *
 * k is published for these four; between them it is interpolated linearly, outside them
 * it is that of the nearer end, which gives too high a minimum for walls darker than
 * 0.2 and too low a one for lighter than 0.8: the more evenly light is spread, the
 * nearer the minimum is to the average. The mean is that of all walls without their
 * openings.
 *
 * The minimum is that of the point farthest from the windows, and is published for
 * rooms with windows in one wall, at most twice as long as wide. For each point it is a
 * lower bound; it is no average. Scope and allowances are those of `bre`.
 */
#include "methods/reflected/bre_terms.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/irc_minimum.h"
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
    double walls = pp_interior_role(world, PP_WALL).reflectance;
    double k = pp_irc_minimum_average_ratio(walls);
    part->value = pp_bre_terms_average(&terms) / k;

    pp_bre_terms_steps(part->steps, &terms, opening, "IRC_av");
    pp_steps_add_named(part->steps, PP_UNIT_NUMBER, walls, "R_w",
                       "mean reflectance of the walls");
    pp_steps_add_named(part->steps, PP_UNIT_NUMBER, k, "k",
                       "average over minimum for such walls, from the table");
    pp_steps_add_worked(part->steps, PP_UNIT_SHARE, part->value, "irc", "IRC_av / k",
                        "opening on line %d: minimum internally reflected component",
                        opening->line);
    return PP_OK;
}

const struct pp_method pp_method_bre_min = {
    .name = "bre-min",
    .summary = "minimum internally reflected component, by bre and published ratios",
    .source = "BRE310",
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_MINIMUM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate,
};
