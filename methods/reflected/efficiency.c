/* efficiency.c - `efficiency`: average daylight factor over the working plane by the
 * efficiency of the windows, after Frühling [FRU28], in the form of [DIN5034].
 *
 * The light that falls on the windows is multiplied by the efficiency, the fraction of
 * it that reaches the working plane, and divided by the plane's area:
 *
 *     DF = sum over the openings, T Ag E_o eta M / S
 *
 * E_o is the light on the glass. For vertical windows the published form depends on the
 * angle of an infinitely long skyline (quoted from memory). This form is the light of
 * the overcast sky above the skyline plus 0.15 of the skylight that the skyline hides:
 *
 *     VSC(alpha) + 0.15 (VSC(0) - VSC(alpha)) = 31.888 - 18.214 sin alpha + 7.730 cos 2 alpha
 *
 * For other slopes the same rule is applied to the calculated light from the sky on the
 * glass. The published tables of eta, and a rule for light from the ground, were not
 * available. Both are derived here, from the position and the slope of the opening, for
 * a room of three uniformly lit zones, the plane, the ceiling and the walls between
 * them.
 *
 *   - The fraction d of the light from the sky falls directly on the plane, the rest
 *     on walls. d is calculated for the open sky at the opening's middle. Light
 *     reflected by the sides of a well is assumed diffuse. Light from the ground goes
 *     up; the fraction g falls on the ceiling.
 *   - The rest reaches the plane by reflections between the three zones
 *     (reflected/room_zones.h).
 *
 * Glass below the working plane, and light lost in reveals and on objects in the room,
 * are neglected.
 */
#include <math.h>
#include <stddef.h>

#include "methods/reflected/entering_light.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/obstruction.h"
#include "methods/reflected/point_factor.h"
#include "methods/reflected/room_zones.h"
#include "methods/reflected/well.h"
#include "methods/method.h"
#include "methods/refusals.h"
#include "model/light/sky.h"

/* ---- entering light ---- */

static const struct pp_formula_quantity of_glass[] = {
    {"a", PP_UNIT_SQUARE_METRE, "area of the opening above the working plane"},
    {"B", PP_UNIT_NUMBER, "frame factor"},
    {0},
};
static const struct pp_formula_quantity of_glass_of_well[] = {
    {"a", PP_UNIT_SQUARE_METRE, "area of the opening above the working plane"},
    {"B", PP_UNIT_NUMBER, "frame factor"},
    PP_WELL_QUANTITIES,
    {0},
};
static const struct pp_formula_quantity of_E_o[] = {
    {"C_hv", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on glass of this slope from the open sky"},
    {"alpha", PP_UNIT_ANGLE, "angle of the obstruction"},
    {0},
};

#define OWN(left, right, of, words, list)                                              \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = of, .what = words, .quantities = list    \
    }

static const struct pp_formula glass =
    OWN("Ag", "a B", PP_UNIT_SQUARE_METRE, "net glass area", of_glass);
static const struct pp_formula glass_of_well =
    OWN("Ag", "a B N", PP_UNIT_SQUARE_METRE,
        "net glass area times the efficiency of the well", of_glass_of_well);
static const struct pp_formula on_window = {
    .symbol = "E_o",
    .sum = "31.88 - 18.22 sin(alpha) + 7.73 cos(2 alpha)",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "DIN5034",
    .what = "illuminance on a vertical window from sky and obstructions",
    .quantities = of_E_o,
};
static const struct pp_formula on_sloping =
    OWN("E_o", "C_hv (1 - 0.85 alpha / 90)", PP_UNIT_DAYLIGHT_FACTOR,
        "illuminance on glass of another slope from sky and obstructions", of_E_o);

/* ---- the efficiencies ---- */

static const struct pp_formula_quantity of_sky[] = {
    {"f", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on the glass from open-sky light that reaches the plane directly"},
    {"C_hv", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on glass of this slope from the open sky"},
    {0},
};
static const struct pp_formula_quantity of_diffuse[] = {
    {"f_d", PP_UNIT_NUMBER, "form factor from the opening to the plane"}, {0}};
static const struct pp_formula_quantity of_light_of_well[] = {
    {"f_s", PP_UNIT_NUMBER,
     "fraction of the direct light through the well that reaches the plane"},
    {"f_d", PP_UNIT_NUMBER, "form factor from the foot of the well to the plane"},
    PP_WELL_QUANTITIES,
    {0},
};
static const struct pp_formula_quantity of_ground[] = {
    {"f_c", PP_UNIT_NUMBER,
     "form factor from the centre of the opening to the ceiling"},
    {"beta", PP_UNIT_ANGLE, "slope of the glass (0: horizontal)"},
    {0},
};
static const struct pp_formula_quantity of_efficiency[] = {
    {"d", PP_UNIT_NUMBER, "fraction of the sky light that falls on the plane"},
    {"g", PP_UNIT_NUMBER, "fraction of the ground light that falls on the ceiling"},
    {"u_w", PP_UNIT_NUMBER,
     "fraction of the light on the walls that reaches the plane"},
    {"u_c", PP_UNIT_NUMBER,
     "fraction of the light on the ceiling that reaches the plane"},
    {"u_p", PP_UNIT_NUMBER, "fraction of the light from the plane that returns to it"},
    {"rho_p", PP_UNIT_NUMBER, "effective reflectance of the cavity below the plane"},
    {0},
};
static const struct pp_formula_quantity of_average[] = {
    {"T", PP_UNIT_NUMBER, "diffuse transmittance of the glass"},
    {"Ag", PP_UNIT_SQUARE_METRE, "net glass area"},
    {"S", PP_UNIT_SQUARE_METRE, "area of the working plane"},
    {"E_o", PP_UNIT_DAYLIGHT_FACTOR,
     "illuminance on the glass from sky and obstructions"},
    {"C_g", PP_UNIT_DAYLIGHT_FACTOR, "illuminance on the glass from the ground"},
    {"eta", PP_UNIT_NUMBER, "efficiency for light from above"},
    {"eta_g", PP_UNIT_NUMBER, "efficiency for light from the ground"},
    {"M", PP_UNIT_NUMBER, "maintenance factor (dirt)"},
    {0},
};

static const struct pp_formula on_plane =
    OWN("d", "min(f / C_hv, 1)", PP_UNIT_NUMBER,
        "fraction of the sky light that falls on the plane", of_sky);
static const struct pp_formula on_plane_diffuse = OWN(
    "d", "f_d", PP_UNIT_NUMBER,
    "fraction of the light from a horizontal diffusing pane that falls on the plane",
    of_diffuse);
static const struct pp_formula on_plane_from_well = OWN(
    "d", "(N_d f_s + (N - N_d) f_d) / N", PP_UNIT_NUMBER,
    "fraction of the light through a well that falls on the plane", of_light_of_well);
static const struct pp_formula on_ceiling =
    OWN("g", "min(2 f_c / (1 - cos(beta)), 1)", PP_UNIT_NUMBER,
        "fraction of the ground light that falls on the ceiling", of_ground);
static const struct pp_formula efficiency =
    OWN("eta", "(d + (1 - d) u_w) / (1 - rho_p u_p)", PP_UNIT_NUMBER,
        "efficiency for light from above", of_efficiency);
static const struct pp_formula efficiency_of_ground =
    OWN("eta_g", "(g u_c + (1 - g) u_w) / (1 - rho_p u_p)", PP_UNIT_NUMBER,
        "efficiency for light from the ground", of_efficiency);
static const struct pp_formula average = {
    .symbol = "df",
    .sum = "T Ag (E_o eta + C_g eta_g) M / S",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "FRU28",
    .what = "average daylight factor over the working plane",
    .quantities = of_average,
};
static const struct pp_formula average_level = {
    .symbol = "df",
    .sum = "T Ag E_o eta M / S",
    .unit = PP_UNIT_DAYLIGHT_FACTOR,
    .source = "FRU28",
    .what = "average daylight factor over the working plane, for horizontal glass",
    .quantities = of_average,
};

static const struct pp_formula *const formulae[] = {&glass,
                                                    &glass_of_well,
                                                    &on_window,
                                                    &on_sloping,
                                                    &pp_entering_light_C_g,
                                                    PP_ROOM_ZONES_FORMULAE,
                                                    &on_plane,
                                                    &on_ceiling,
                                                    &efficiency,
                                                    &efficiency_of_ground,
                                                    &average,
                                                    &average_level,
                                                    NULL};

/* ---- the sum ---- */

static bool is_level(const struct pp_opening *opening)
{
    return sin(opening->slope_rad) < 1e-6;
}

static void put_glass(struct pp_worksheet *sheet, const struct pp_world *world,
                      const struct pp_outside_light *light,
                      const struct pp_opening *opening)
{
    double low_m2 = pp_interior_area_below(&opening->inner, world->working_plane_m);
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "T",
                     "diffuse transmittance of the glass");
    pp_worksheet_put(
        sheet, PP_UNIT_SQUARE_METRE, opening->inner.area_m2 - low_m2, "a",
        low_m2 > 0.0
            ? "area of the opening above the working plane (the rest is ignored)"
            : "area of the opening");
    pp_allowance_put(sheet, PP_ALLOWS_FRAME, opening, "B", "frame factor");
    if (pp_well_is(opening))
        pp_well_put(sheet, world, light, opening);
    pp_worksheet_work(sheet, pp_well_is(opening) ? &glass_of_well : &glass,
                      "net glass area");
}

static enum pp_status put_light(struct pp_worksheet *sheet,
                                const struct pp_world *world,
                                const struct pp_outside_light *light,
                                const struct pp_opening *opening, struct pp_error *err)
{
    double alpha_rad;
    bool vertical = pp_refusals_unless_vertical(opening) == NULL;
    enum pp_status status =
        pp_obstruction_angle(&alpha_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, alpha_rad, "alpha",
                     "angle of the obstruction");
    pp_worksheet_put(sheet, PP_UNIT_ANGLE, opening->slope_rad, "beta",
                     "slope of the glass");
    double C_hv =
        pp_outside_light_sky_on_plane(light, pp_vec_scale(opening->inner.normal, -1.0));
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, C_hv, "C_hv",
                     "illuminance on glass of this slope from the open sky");
    pp_worksheet_work(sheet, vertical ? &on_window : &on_sloping,
                      "illuminance on the glass from sky and obstructions");
    if (is_level(opening)) {
        pp_worksheet_know(sheet, PP_UNIT_DAYLIGHT_FACTOR, 0.0, "C_g");
        return PP_OK;
    }
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, light->ground_reflectance, "rho_g",
                     "reflectance of the ground");
    pp_worksheet_work(sheet, &pp_entering_light_C_g,
                      "illuminance on the glass from the ground");
    return PP_OK;
}

/* Middle of the part of the opening above the working plane. */
static struct pp_vec3 middle_above_plane(const struct pp_world *world,
                                         const struct pp_opening *opening)
{
    struct pp_vec3 middle = pp_polygon_middle(&opening->inner);
    double foot_m =
        opening->middle_z_m - opening->height_m * sin(opening->slope_rad) / 2;
    middle.z += fmax(world->working_plane_m - foot_m, 0.0) / 2.0;
    return middle;
}

/* Records d for glass above a well. Light that has met the well's sides is assumed
 * diffuse. */
static void put_direct_of_well(struct pp_worksheet *sheet, const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_opening *opening)
{
    double z = world->working_plane_m;
    const struct pp_polygon *foot = &opening->inner;
    double f_d = pp_well_foot_to_plane(world, opening), f_s = f_d;
    if (foot->count <= 4)
        f_s = pp_point_factor_through(pp_polygon_middle(&opening->outer), foot,
                                      &world->plane, z, &light->sky);
    pp_worksheet_put(
        sheet, PP_UNIT_NUMBER, f_s, "f_s",
        "fraction of the direct light through the well that reaches the plane");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, f_d, "f_d",
                     "form factor from the foot of the well to the plane");
    pp_worksheet_work(sheet, &on_plane_from_well, "fraction of the light on the plane");
}

/* Records d for any other opening. */
static void put_direct(struct pp_worksheet *sheet, const struct pp_world *world,
                       const struct pp_outside_light *light,
                       const struct pp_opening *opening, struct pp_vec3 middle)
{
    double z = world->working_plane_m;
    struct pp_vec3 normal = opening->inner.normal;
    if (opening->glass.diffusing)
        pp_worksheet_put(sheet, PP_UNIT_NUMBER,
                         pp_point_factor(middle, normal, &world->plane, z), "f_d",
                         "form factor from the centre of the opening to the plane");
    else
        pp_worksheet_put(
            sheet, PP_UNIT_DAYLIGHT_FACTOR,
            pp_point_factor_sky(middle, normal, &world->plane, z, &light->sky), "f",
            "illuminance on the centre of the opening from open-sky light that reaches "
            "the plane directly");
    pp_worksheet_work(sheet, opening->glass.diffusing ? &on_plane_diffuse : &on_plane,
                      "fraction of the sky light on the plane");
}

static void put_efficiencies(struct pp_worksheet *sheet, const struct pp_world *world,
                             const struct pp_outside_light *light,
                             const struct pp_opening *opening, double height_m)
{
    double z = world->working_plane_m;
    struct pp_vec3 middle = middle_above_plane(world, opening);
    double f_c = pp_point_factor(middle, opening->inner.normal, &world->plane,
                                 fmax(z + height_m, middle.z));
    pp_worksheet_know(sheet, PP_UNIT_NUMBER, 0.0, "g");
    pp_worksheet_know(sheet, PP_UNIT_NUMBER, 0.0, "eta_g");
    if (pp_well_is(opening))
        put_direct_of_well(sheet, world, light, opening);
    else
        put_direct(sheet, world, light, opening, middle);
    pp_worksheet_work(sheet, &efficiency, "efficiency for light from above");
    if (is_level(opening))
        return;
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, f_c, "f_c",
                     "form factor from the centre of the opening to the ceiling");
    pp_worksheet_work(sheet, &on_ceiling,
                      "fraction of the ground light on the ceiling");
    pp_worksheet_work(sheet, &efficiency_of_ground,
                      "efficiency for light from the ground");
}

static enum pp_status evaluate_efficiency(const struct pp_world *world,
                                          const struct pp_outside_light *light,
                                          const struct pp_opening *opening,
                                          const struct pp_receiver *receiver,
                                          const void *tools, struct pp_part *part,
                                          struct pp_error *err)
{
    (void)receiver, (void)tools;
    struct pp_worksheet *sheet = &part->sheet;
    put_glass(sheet, world, light, opening);
    enum pp_status status = put_light(sheet, world, light, opening, err);
    if (status != PP_OK)
        return status;
    double height_m = pp_room_zones_put(sheet, world);
    put_efficiencies(sheet, world, light, opening, height_m);
    pp_allowance_put(sheet, PP_ALLOWS_DIRT, opening, "M", "maintenance factor");
    part->value =
        pp_worksheet_work(sheet, is_level(opening) ? &average_level : &average,
                          "average daylight factor");
    return PP_OK;
}

static const char *efficiency_refuses(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver)
{
    (void)world, (void)light, (void)receiver;
    if (opening->glass.diffusing && !is_level(opening))
        return "has sloping diffusing glass, but the method covers only clear glass "
               "and horizontal diffusing panes";
    return NULL;
}

const struct pp_method pp_method_efficiency = {
    .name = "efficiency",
    .summary = "average daylight factor by the efficiency of the openings",
    .source = "FRU28",
    .formulae = formulae,
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_ROOM,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .refuses_room = pp_refusals_formula_room,
    .refuses = efficiency_refuses,
    .evaluate = evaluate_efficiency,
};
