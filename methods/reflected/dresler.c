/* dresler.c - `dresler`: internally reflected component by the interreflection of two
 * cavities, the room above and the room below the middle of the opening.
 *
 * Dresler derived the reflected component from the interreflection of the room's parts
 * [DRE54]. His own formula was not available; this one is derived from that principle,
 * under these conditions: light from above the horizon falls on the lower part first,
 * light from the ground on the upper part; each part is diffuse, has one mean
 * reflectance (openings: 0.1) and is uniformly lit; the two exchange light through the
 * horizontal plane of area S between them. A part of area A_u sends the share S/A_u of
 * its light to the plane and the rest to itself. The reflectance of the upper part,
 * seen through the plane, is therefore
 *
 *     k_u = rho_u S/A_u / (1 - rho_u (1 - S/A_u))
 *
 * and likewise for the lower part. The result is the illuminance on that plane from
 * above, by reflected light. This illuminance equals the result of `split-flux` except
 * in one respect: in `split-flux` all light reflected by one part falls on the other.
 *
 * The method is for vertical openings and any sky. The results of several openings,
 * each with its own plane, are added. The formula contains the opening's glass and,
 * through Ag, the frame; no dirt, no deterioration of decorations.
 */
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/method.h"
#include "methods/refusals.h"

#define PART(A_, rho_, where)                                                          \
    {"S", PP_UNIT_SQUARE_METRE,                                                        \
     "area of a horizontal plane at the height of the opening's centre"},              \
        {A_, PP_UNIT_SQUARE_METRE,                                                     \
         "area of all surfaces " where ", openings included"},                         \
    {                                                                                  \
        rho_, PP_UNIT_NUMBER, "mean reflectance of these surfaces (openings: 0.1)"     \
    }

static const struct pp_formula_quantity of_k_u[] = {
    PART("A_u", "rho_u", "above this plane"), {0}};
static const struct pp_formula_quantity of_k_l[] = {
    PART("A_l", "rho_l", "below this plane"), {0}};

static const struct pp_formula k_u = {
    .symbol = "k_u",
    .sum = "rho_u S / (A_u (1 - rho_u) + rho_u S)",
    .unit = PP_UNIT_NUMBER,
    .what = "effective reflectance of the upper part of the room at this plane",
    .quantities = of_k_u,
};
static const struct pp_formula k_l = {
    .symbol = "k_l",
    .sum = "rho_l S / (A_l (1 - rho_l) + rho_l S)",
    .unit = PP_UNIT_NUMBER,
    .what = "effective reflectance of the lower part of the room at this plane",
    .quantities = of_k_l,
};

#define QUANTITIES                                                                     \
    PP_ENTERING_LIGHT_QUANTITIES,                                                      \
        {"S", PP_UNIT_SQUARE_METRE, "area of the horizontal plane"},                   \
        {"k_u", PP_UNIT_NUMBER, "effective reflectance of the upper part"},            \
    {                                                                                  \
        "k_l", PP_UNIT_NUMBER, "effective reflectance of the lower part"               \
    }

static const struct pp_formula_quantity of_clear[] = {QUANTITIES, {0}};
static const struct pp_formula_quantity of_diffusing[] = {
    QUANTITIES, PP_ENTERING_LIGHT_SHARE_UP, {0}};

static const struct pp_formula clear = {
    .symbol = "irc",
    .sum = "tau Ag k_u / (S (1 - k_u k_l)) (C_g + k_l C)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "internally reflected component, for clear glass",
    .quantities = of_clear,
};
static const struct pp_formula diffusing = {
    .symbol = "irc",
    .sum = "tau Ag k_u / (S (1 - k_u k_l)) (C_g + C) (u + (1 - u) k_l)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .what = "internally reflected component, for a diffusing pane",
    .quantities = of_diffusing,
};

static const struct pp_formula *const formulae[] = {
    PP_ENTERING_LIGHT_FORMULAE, &k_u, &k_l, &clear, &diffusing, NULL};

static void put_parts(struct pp_worksheet *sheet, const struct pp_world *world,
                      const struct pp_opening *opening)
{
    double z = opening->middle_z_m;
    struct pp_interior_parts parts = pp_interior_split_without(world, z, -1);
    pp_worksheet_put(
        sheet, PP_UNIT_SQUARE_METRE, pp_interior_section_m2(world, z), "S",
        "area of the horizontal plane at %.2f m, the height of the opening's centre",
        z);
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, parts.upper.area_m2, "A_u",
                     "area of surfaces above this plane, openings included");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.upper.reflectance, "rho_u",
                     "mean reflectance of these surfaces (openings: 0.1)");
    pp_worksheet_work(sheet, &k_u,
                      "effective reflectance of the upper part at this plane");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, parts.lower.area_m2, "A_l",
                     "area of surfaces below this plane, openings included");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, parts.lower.reflectance, "rho_l",
                     "mean reflectance of these surfaces (openings: 0.1)");
    pp_worksheet_work(sheet, &k_l,
                      "effective reflectance of the lower part at this plane");
}

static enum pp_status evaluate_dresler(const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_worksheet *sheet = &part->sheet;
    enum pp_status status = pp_entering_light(sheet, world, light, opening, err);
    if (status != PP_OK)
        return status;
    put_parts(sheet, world, opening);
    part->value =
        pp_worksheet_work(sheet, opening->glass.diffusing ? &diffusing : &clear,
                          "internally reflected component");
    return PP_OK;
}

const struct pp_method pp_method_dresler = {
    .name = "dresler",
    .summary = "internally reflected component, with the upper and lower parts of the "
               "room as cavities",
    .source = "DRE54",
    .formulae = formulae,
    .gives = PP_GIVES_INTERNAL,
    .takes_blinds = true,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_luminous_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate_dresler,
};
