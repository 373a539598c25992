/* average_df.c - the average daylight factor by a single formula: its two forms, and
 * the two practices for glass below the working plane.
 *
 * `average-df` is the average over the working plane [CL84]; `average-df-lynes`, the
 * older form from which it was developed, is the average over all surfaces of the room
 * [LYNES79]. theta is the angle of visible sky in section (reflected/sky_angle.h). In
 * the newer form, glass below the working plane is weighted by the floor's reflectance
 * rho_f, since light through such glass reaches the plane only after reflection by the
 * floor. The other practice, `average-df-above`, omits glass below the plane [BS8206].
 * A rooflight with a well is weighted by the well's efficiency (reflected/well.h).
 * `average-df-well` is the newer form for a room off an atrium or a light well, with an
 * angle theta that stands for the light on the window (reflected/well_window.h).
 *
 * The two forms are averages over different surfaces and should not be compared: before
 * dirt and without glass below the working plane, the older form is (1 + R)/2 times the
 * newer. Both are for the CIE overcast sky; the newer form is for glass of any slope,
 * the older one for vertical glass. The results of several openings are added, with the
 * same A and R. Both include the opening's glass and, through W, the frame;
 * `average-df` also includes dirt. Neither form is meant for obstructions that one
 * section angle does not describe; reflected/obstruction.h describes the conversion of
 * blocks to such an angle.
 */
#include <stddef.h>

#include "methods/reflected/interior.h"
#include "methods/reflected/sky_angle.h"
#include "methods/reflected/well.h"
#include "methods/reflected/well_window.h"
#include "methods/method.h"
#include "methods/refusals.h"

static const struct pp_formula_quantity of_W[] = {
    {"a_u", PP_UNIT_SQUARE_METRE, "area of the opening above the working plane"},
    {"a_l", PP_UNIT_SQUARE_METRE, "area of the opening below the working plane"},
    {"rho_f", PP_UNIT_NUMBER, "reflectance of the floor"},
    {"B", PP_UNIT_NUMBER, "frame factor"},
    {0},
};

static const struct pp_formula glass_that_counts = {
    .symbol = "W",
    .sum = "(a_u + rho_f a_l) B",
    .unit = PP_UNIT_SQUARE_METRE,
    .what = "net glass area, with the glass below the working plane weighted by rho_f",
    .quantities = of_W,
};

static const struct pp_formula glass_above = {
    .symbol = "W",
    .sum = "a_u B",
    .unit = PP_UNIT_SQUARE_METRE,
    .source = "BS8206",
    .what = "net glass area above the working plane",
    .quantities = of_W,
};

static const struct pp_formula_quantity of_W_of_well[] = {
    {"a", PP_UNIT_SQUARE_METRE, "area of the opening"},
    {"B", PP_UNIT_NUMBER, "frame factor"},
    PP_WELL_QUANTITIES,
    {0},
};

static const struct pp_formula glass_behind_well = {
    .symbol = "W",
    .sum = "a B N",
    .unit = PP_UNIT_SQUARE_METRE,
    .what = "net glass area times the efficiency of the well",
    .quantities = of_W_of_well,
};

#define QUANTITIES                                                                     \
    {"T", PP_UNIT_NUMBER, "diffuse transmittance of the glass (1 if unglazed)"},       \
        {"W", PP_UNIT_SQUARE_METRE,                                                    \
         "net glass area: opening area times frame factor"},                           \
        {"theta_h", PP_UNIT_ANGLE, "upper limit of the visible sky in section"},       \
        {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},                          \
        {"theta", PP_UNIT_ANGLE, "angle of visible sky"}, PP_INTERIOR_QUANTITIES

static const struct pp_formula_quantity of_average[] = {
    QUANTITIES, {"M", PP_UNIT_NUMBER, "maintenance factor (dirt)"}, {0}};
static const struct pp_formula_quantity of_lynes[] = {QUANTITIES, {0}};

static const struct pp_formula average = {
    .symbol = "df",
    .sum = "T W theta M / (A (1 - R^2))",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "CL84",
    .what = "average daylight factor over the working plane",
    .quantities = of_average,
};

static const struct pp_formula average_of_surfaces = {
    .symbol = "df",
    .sum = "T W theta / (2 A (1 - R))",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "LYNES79",
    .what = "average daylight factor over all surfaces",
    .quantities = of_lynes,
};

static const struct pp_formula *const formulae[] = {&pp_allowance_glass_W,
                                                    &glass_that_counts,
                                                    &glass_behind_well,
                                                    PP_SKY_ANGLE_FORMULAE,
                                                    PP_SKY_ANGLE_SLOPING_FORMULAE,
                                                    &average,
                                                    NULL};
static const struct pp_formula *const formulae_of_above[] = {
    &pp_allowance_glass_W,
    &glass_above,
    &glass_behind_well,
    PP_SKY_ANGLE_FORMULAE,
    PP_SKY_ANGLE_SLOPING_FORMULAE,
    &average,
    NULL};
static const struct pp_formula *const formulae_of_lynes[] = {
    &pp_allowance_glass_W, PP_SKY_ANGLE_FORMULAE, &average_of_surfaces, NULL};

static const struct pp_formula *const formulae_of_well[] = {&pp_allowance_glass_W,
                                                            &glass_that_counts,
                                                            &pp_sky_angle_head,
                                                            &pp_well_window_light,
                                                            &pp_well_window_theta,
                                                            &average,
                                                            NULL};

/* Treatment of glass below the working plane. */
enum low_glass { COUNTS_BY_FLOOR, LEFT_OUT, COUNTS_IN_FULL };

/* Puts W on the worksheet for an opening that is partly below the working plane. */
static void put_low_glass(struct pp_worksheet *sheet, const struct pp_world *world,
                          const struct pp_opening *opening, double low_m2,
                          enum low_glass practice)
{
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, opening->inner.area_m2 - low_m2,
                     "a_u", "area of the opening above the working plane");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, low_m2, "a_l",
                     "area of the opening below the working plane");
    pp_worksheet_put(
        sheet, PP_UNIT_NUMBER, pp_interior_role(world, PP_FLOOR).reflectance, "rho_f",
        practice == LEFT_OUT
            ? "reflectance of the floor; the formula ignores glass below the plane"
            : "reflectance of the floor, used as the weight of the glass below the "
              "plane");
    pp_allowance_put(sheet, PP_ALLOWS_FRAME, opening, "B", "frame factor");
    pp_worksheet_work(sheet, practice == LEFT_OUT ? &glass_above : &glass_that_counts,
                      "effective net glass area");
}

/* Puts W on the worksheet for glass above a well. */
static void put_well(struct pp_worksheet *sheet, const struct pp_world *world,
                     const struct pp_outside_light *light,
                     const struct pp_opening *opening)
{
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, opening->inner.area_m2, "a",
                     "area of the opening");
    pp_allowance_put(sheet, PP_ALLOWS_FRAME, opening, "B", "frame factor");
    pp_well_put(sheet, world, light, opening);
    pp_worksheet_work(sheet, &glass_behind_well,
                      "effective net glass area at the foot of the well");
}

/* Puts W on the worksheet for glass without a well. */
static void put_glass(struct pp_worksheet *sheet, const struct pp_world *world,
                      const struct pp_opening *opening, enum low_glass practice)
{
    double low_m2 = pp_interior_area_below(&opening->inner, world->working_plane_m);
    if (practice != COUNTS_IN_FULL && low_m2 > 0.0)
        put_low_glass(sheet, world, opening, low_m2, practice);
    else
        pp_allowance_net_glass(sheet, &pp_allowance_glass_W, opening);
}

static enum pp_status put_terms(struct pp_worksheet *sheet,
                                const struct pp_world *world,
                                const struct pp_outside_light *light,
                                const struct pp_opening *opening,
                                enum low_glass practice, struct pp_error *err)
{
    struct pp_interior all = pp_interior_all(world);
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "T",
                     "diffuse transmittance of the glass");
    if (pp_well_is(opening))
        put_well(sheet, world, light, opening);
    else
        put_glass(sheet, world, opening, practice);
    enum pp_status status = pp_sky_angle(sheet, world, light, opening, err);
    if (status == PP_OK)
        pp_interior_put(sheet, &all);
    return status;
}

static enum pp_status work_newer_form(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      enum low_glass practice, struct pp_part *part,
                                      struct pp_error *err)
{
    enum pp_status status =
        put_terms(&part->sheet, world, light, opening, practice, err);
    if (status != PP_OK)
        return status;
    pp_allowance_put(&part->sheet, PP_ALLOWS_DIRT, opening, "M", "maintenance factor");
    part->value = pp_worksheet_work(&part->sheet, &average, "average daylight factor");
    return PP_OK;
}

static enum pp_status evaluate_average_df(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver,
                                          const void *tools, struct pp_part *part,
                                          struct pp_error *err)
{
    (void)receiver, (void)tools;
    return work_newer_form(world, light, opening, COUNTS_BY_FLOOR, part, err);
}

static enum pp_status evaluate_above(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     const void *tools, struct pp_part *part,
                                     struct pp_error *err)
{
    (void)receiver, (void)tools;
    return work_newer_form(world, light, opening, LEFT_OUT, part, err);
}

static enum pp_status evaluate_of_well(const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_worksheet *sheet = &part->sheet;
    struct pp_interior all = pp_interior_all(world);
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "T",
                     "diffuse transmittance of the glass");
    put_glass(sheet, world, opening, COUNTS_BY_FLOOR);
    enum pp_status status = pp_well_window_angle(sheet, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_interior_put(sheet, &all);
    pp_allowance_put(sheet, PP_ALLOWS_DIRT, opening, "M", "maintenance factor");
    part->value = pp_worksheet_work(sheet, &average, "average daylight factor");
    return PP_OK;
}

static enum pp_status evaluate_lynes(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     const void *tools, struct pp_part *part,
                                     struct pp_error *err)
{
    (void)receiver, (void)tools;
    enum pp_status status =
        put_terms(&part->sheet, world, light, opening, COUNTS_IN_FULL, err);
    if (status == PP_OK)
        part->value = pp_worksheet_work(&part->sheet, &average_of_surfaces,
                                        "average daylight factor over all surfaces");
    return status;
}

static const char *refuses_room_off_well(const struct pp_world *world,
                                         const struct pp_outside_light *light,
                                         const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_formula_room(world, light, receiver);
    return why ? why : pp_well_window_refuses_room(world);
}

const struct pp_method pp_method_average_df = {
    .name = "average-df",
    .any_pane = true,
    .summary = "average daylight factor over the working plane by a single formula",
    .source = "CL84",
    .formulae = formulae,
    .gives = PP_GIVES_WHOLE,
    .takes_blinds = true,
    .own_ground = 0.1, /* under an open sky, theta/2 per cent is 45 %: 39.6 % from the
                        * sky, the rest from the ground */
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = pp_refusals_formula_room,
    .evaluate = evaluate_average_df,
};

const struct pp_method pp_method_average_df_above = {
    .name = "average-df-above",
    .any_pane = true,
    .summary = "average daylight factor by a single formula that ignores glass below "
               "the working plane",
    .source = "BS8206",
    .formulae = formulae_of_above,
    .gives = PP_GIVES_WHOLE,
    .takes_blinds = true,
    .own_ground = 0.1,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = pp_refusals_formula_room,
    .evaluate = evaluate_above,
};

const struct pp_method pp_method_average_df_well = {
    .name = "average-df-well",
    .any_pane = true,
    .summary = "average daylight factor of a room off an atrium or light well",
    .source = "CL84",
    .formulae = formulae_of_well,
    .gives = PP_GIVES_WHOLE,
    .takes_blinds = true,
    .of_well = true,
    .by_name = true,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = refuses_room_off_well,
    .refuses = pp_well_window_refuses,
    .evaluate = evaluate_of_well,
};

const struct pp_method pp_method_average_df_lynes = {
    .name = "average-df-lynes",
    .any_pane = true,
    .summary = "average daylight factor over all interior surfaces (older form)",
    .source = "LYNES79",
    .formulae = formulae_of_lynes,
    .gives = PP_GIVES_WHOLE,
    .takes_blinds = true,
    .own_ground = 0.1,
    .speaks_for = PP_FOR_ROOM,
    .of_all_surfaces = true,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME,
    .refuses_room = pp_refusals_formula_room,
    .refuses = pp_refusals_sloping_opening,
    .evaluate = evaluate_lynes,
};
