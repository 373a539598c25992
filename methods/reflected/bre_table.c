/* bre_table.c - `bre-table`: minimum internally reflected component in the room, from
 * the published table (irc_minimum.h).
 *
 * The printed minimum T is for an obstruction of 20 degrees, a ceiling of 0.7 and a
 * floor of 40 m2; the factors k_F and k_c [BRE310] convert it to another floor and
 * ceiling, k_o to another obstruction. k_o is not from the source, which contains only
 * the angle of 20 degrees; k_o is the ratio of two results of the formula of `bre`
 * (bre_terms.h).
 *
 * The table is entered with the glass of all openings; each opening contributes in
 * proportion to its glass area, with its own k_o. The table contains clear single glass
 * and, since it uses net glass area, the frame; no dirt, no deterioration of
 * decorations.
 *
 * The method is for vertical openings, the CIE overcast sky and rooms within the
 * printed ranges. The table was published for windows in one wall, from a sill of 0.9 m
 * to the ceiling, in rooms at most twice as long as wide. The minimum is a lower bound
 * for each point, not an average.
 */
#include <stddef.h>

#include "methods/reflected/bre_terms.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/irc_minimum.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_glass[] = {
    {"W_all", PP_UNIT_SQUARE_METRE, "net glass area of all openings"},
    {"F", PP_UNIT_SQUARE_METRE, "floor area"},
    {0},
};

static const struct pp_formula glass_over_floor = {
    .symbol = "p",
    .sum = "100 W_all / F",
    .unit = PP_UNIT_NUMBER,
    .source = "BRE310",
    .what = "ratio of glass area to floor area, per cent",
    .quantities = of_glass,
    .fixed = true,
};

static const struct pp_formula_quantity of_obstruction[] = {PP_BRE_TERMS_OPENING, {0}};

/* 31 (per cent) is C for the table's obstruction of 20 degrees. */
static const struct pp_formula factor_for_obstruction = {
    .symbol = "k_o",
    .sum = "(C R_fw + " PP_BRE_TERMS_GROUND ") / (31 R_fw + " PP_BRE_TERMS_GROUND ")",
    .unit = PP_UNIT_NUMBER,
    .what = "factor for the obstruction (the table assumes 20 degrees)",
    .quantities = of_obstruction,
};

static const struct pp_formula_quantity of_minimum[] = {
    {"T", PP_UNIT_DAYLIGHT_FACTOR, "minimum for p, R_f and R_w, from the table"},
    {"k_F", PP_UNIT_NUMBER, "factor for the floor area, from the table"},
    {"k_c", PP_UNIT_NUMBER, "factor for the ceiling, from the table"},
    {"k_o", PP_UNIT_NUMBER, "factor for the obstruction"},
    {"W_all", PP_UNIT_SQUARE_METRE, "net glass area of all openings"},
    {"F", PP_UNIT_SQUARE_METRE, "floor area"},
    {"R_f", PP_UNIT_NUMBER, "reflectance of the floor"},
    {"R_w", PP_UNIT_NUMBER, "mean reflectance of the walls"},
    {"R_c", PP_UNIT_NUMBER, "reflectance of the ceiling"},
    PP_BRE_TERMS_OPENING,
    {0},
};

static const struct pp_formula minimum = {
    .symbol = "irc",
    .sum = "T k_F k_c k_o W / W_all",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "BRE310",
    .what = "this opening's share of the minimum internally reflected component, by "
            "its glass area",
    .quantities = of_minimum,
};

static const struct pp_formula *const formulae[] = {
    &glass_over_floor, &pp_allowance_glass_W, &factor_for_obstruction, &minimum, NULL};

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

static const char *bre_table_refuses_room(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_formula_room(world, light, receiver);
    if (why)
        return why;
    struct pp_irc_minimum_entry entry = entry_of(world);
    return pp_irc_minimum_lacks(&entry);
}

static void put_reading(struct pp_worksheet *sheet,
                        const struct pp_irc_minimum_entry *entry)
{
    struct pp_irc_minimum read = pp_irc_minimum_read(entry);
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, entry->glass_m2, "W_all",
                     "net glass area of all openings");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, entry->floor_m2, "F", "floor area");
    pp_worksheet_work(sheet, &glass_over_floor,
                      "ratio of glass area to floor area, per cent");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, entry->floor, "R_f",
                     "reflectance of the floor");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, entry->walls, "R_w",
                     "mean reflectance of the walls");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, entry->ceiling, "R_c",
                     "reflectance of the ceiling");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, read.printed, "T",
                     "minimum for p, R_f and R_w, from the table");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, read.floor_factor, "k_F",
                     "factor for the floor area, from the table");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, read.ceiling_factor, "k_c",
                     "factor for the ceiling, from the table");
}

static enum pp_status evaluate_bre_table(const struct pp_world *world,
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
    struct pp_irc_minimum_entry entry = entry_of(world);
    if (terms.W <= 0.0 || (terms.R_fw <= 0.0 && terms.R_cw <= 0.0))
        return PP_OK; /* no glass, or only black surfaces receive light first */
    struct pp_worksheet *sheet = &part->sheet;
    put_reading(sheet, &entry);
    pp_allowance_net_glass(sheet, &pp_allowance_glass_W, opening);
    pp_bre_terms_put_reflected(sheet, &terms, opening);
    pp_worksheet_work(sheet, &factor_for_obstruction,
                      "factor for the obstruction (the table assumes 20 degrees)");
    part->value =
        pp_worksheet_work(sheet, &minimum, "minimum internally reflected component");
    return PP_OK;
}

const struct pp_method pp_method_bre_table = {
    .name = "bre-table",
    .summary = "minimum internally reflected component, from the published table",
    .source = "BRE310",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .own_ground = PP_BRE_GROUND_REFLECTANCE,
    .speaks_for = PP_FOR_MINIMUM,
    .allowances = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = bre_table_refuses_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate_bre_table,
};
