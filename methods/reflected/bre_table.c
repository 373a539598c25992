/* bre_table.c - `bre-table`: minimum internally reflected component in the room, from
 * the published table (irc_minimum.h).
 *
 *     IRC = T k_F k_c k_o                                                   [BRE310]
 *
 *   T    the printed minimum, by net glass area over floor area and by the mean
 *        reflectances of floor and walls; for an obstruction of 20 degrees, a ceiling
 *        of 0.7 and a floor of 40 m2
 *   k_F  factor for the room's floor area
 *   k_c  factor for the room's ceiling reflectance
 *   k_o  factor for the opening's obstruction,
 *
 *            k_o = (C R_fw + 5 R_cw) / (31 R_fw + 5 R_cw),
 *
 *        the ratio by the formula of `bre` (bre_terms.h), where 31 is C of 20 degrees.
 *        Not of the source, which has no other angle.
 *
 * The table is entered with the glass of all openings; each opening has its share by
 * area, with its own k_o. The table contains clear single glass and, as it goes by net
 * glass area, the frame; no dirt, no deterioration of decorations.
 *
 * For vertical openings, the CIE overcast sky and rooms within the printed ranges.
 * Published for windows in one wall, from a sill of 0.9 m to the ceiling, in rooms at
 * most twice as long as wide. For each point the minimum is a lower bound; it is no
 * average.
 */
#include <stddef.h>

#include "methods/reflected/bre_terms.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/irc_minimum.h"
#include "methods/method.h"
#include "methods/reflected/obstruction.h"
#include "methods/refusals.h"

static const double printed_obstruction_rad = 20.0 * PP_RAD;

static struct pp_irc_minimum_entry entry_of(const struct pp_world *world)
{
    struct pp_interior floor = pp_interior_role(world, PP_FLOOR);
    struct pp_irc_minimum_entry entry = {
        .floor_m2 = floor.area_m2,
        .floor = floor.reflectance,
        .walls = pp_interior_role(world, PP_WALL).reflectance,
        .ceiling = pp_interior_role(world, PP_CEILING).reflectance};
    for (int i = 0; i < world->opening_count; i++)
        entry.glass_m2 += pp_allowance_net_glass_m2(&world->openings[i]);
    return entry;
}

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_formula_room(world, receiver);
    if (why)
        return why;
    struct pp_irc_minimum_entry entry = entry_of(world);
    return pp_irc_minimum_lacks(&entry);
}

static void add_reading_steps(struct pp_steps *steps,
                              const struct pp_irc_minimum_entry *entry,
                              const struct pp_irc_minimum *read)
{
    pp_steps_add_named(steps, PP_UNIT_SQUARE_METRE, entry->glass_m2, "W_all",
                       "net area of glass of all openings");
    pp_steps_add_named(steps, PP_UNIT_SQUARE_METRE, entry->floor_m2, "F",
                       "area of the floor");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER,
                        100.0 * entry->glass_m2 / entry->floor_m2, "p", "100 W_all / F",
                        "glass over floor, per cent");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, entry->floor, "R_f",
                       "reflectance of the floor");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, entry->walls, "R_w",
                       "mean reflectance of the walls");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, entry->ceiling, "R_c",
                       "reflectance of the ceiling");
    pp_steps_add_named(steps, PP_UNIT_SHARE, read->printed, "T",
                       "minimum by p, R_f and R_w, from the table");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, read->floor_factor, "k_F",
                       "factor for the size of the floor, from the table");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, read->ceiling_factor, "k_c",
                       "factor for the ceiling, from the table");
}

static void add_opening_steps(struct pp_steps *steps, const struct pp_opening *opening,
                              const struct pp_bre_terms *terms, double k_o,
                              double value)
{
    pp_allowance_net_glass_step(steps, opening, "W");
    pp_bre_terms_reflected_steps(steps, terms, opening);
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, k_o, "k_o",
                        "(C R_fw + 5 R_cw) / (31 R_fw + 5 R_cw)",
                        "factor for the obstruction; the table has 20 degrees");
    pp_steps_add_worked(steps, PP_UNIT_SHARE, value, "irc", "T k_F k_c k_o W / W_all",
                        "opening on line %d: minimum internally reflected component",
                        opening->line);
}

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
    struct pp_irc_minimum_entry entry = entry_of(world);
    struct pp_irc_minimum read = pp_irc_minimum_read(&entry);
    double as_printed =
        pp_bre_terms_reflected(&terms, pp_obstruction_factor(printed_obstruction_rad));
    if (terms.W <= 0.0 || as_printed <= 0.0)
        return PP_OK; /* no glass, or only black surfaces are lit first */
    double k_o = pp_bre_terms_reflected(&terms, terms.C) / as_printed;
    part->value = read.printed * read.floor_factor * read.ceiling_factor * k_o * terms.W
                  / entry.glass_m2;
    add_reading_steps(part->steps, &entry, &read);
    add_opening_steps(part->steps, opening, &terms, k_o, part->value);
    return PP_OK;
}

const struct pp_method pp_method_bre_table = {
    .name = "bre-table",
    .summary = "minimum internally reflected component, off the published table",
    .source = "BRE310",
    .gives = PP_GIVES_INTERNAL,
    .speaks_for = PP_FOR_MINIMUM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = refuses_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate,
};
