/* lumen.c - `lumen` and `lumen-one`: the lumen method, which gives a daylight factor in
 * one step [IES84].
 *
 * For light from the side, the method gives values at five points and an average.
 * `lumen` calculates the light from sky and ground separately; `lumen-one` uses a
 * single coefficient, for a ground reflectance of 0.2. For light from above, the method
 * gives only the average. The coefficients come from tables (lumen_table.h). For light
 * from the side they depend on the room's reflectances and on its depth and width in
 * window heights; for light from above, on the reflectances and the room cavity ratio.
 *
 * The table's window fills a wall; windows spread along a wall are calculated as that
 * window times their fraction of its area. A point's value depends only on its distance
 * from the window, from 10 to 90 % of the room's depth. The results of windows in two
 * opposite walls are added. lumen_scope.h defines the rooms and openings that the
 * method covers; there is no extrapolation. tau contains glass, frame and dirt.
 */
#include <stdio.h>
#include <stdlib.h>

#include "methods/lumen/lumen_cavity.h"
#include "methods/lumen/lumen_scope.h"
#include "methods/lumen/lumen_table.h"
#include "methods/method.h"
#include "methods/reflected/entering_light.h"
#include "methods/reflected/obstruction.h"
#include "methods/reflected/well.h"
#include "methods/refusals.h"

/* A skyline with a larger altitude than this counts as an obstruction (rad). */
static const double free_below_rad = 1e-3;

/* ---- formulae ---- */

#define OF_GLASS                                                                       \
    {"A", PP_UNIT_SQUARE_METRE, "area of the opening"},                                \
        {"B", PP_UNIT_NUMBER, "frame factor: ratio of glass area to opening area"},    \
        {"T", PP_UNIT_NUMBER, "diffuse transmittance of the glass"},                   \
    {                                                                                  \
        "M", PP_UNIT_NUMBER, "maintenance factor (dirt)"                               \
    }
#define OF_WINDOW                                                                      \
    {"H", PP_UNIT_METRE, "window height"},                                             \
        {"W", PP_UNIT_METRE, "width of the room, along the window wall"},              \
    {                                                                                  \
        "D", PP_UNIT_METRE, "depth of the room, from the window wall"                  \
    }
#define OF_ENTERING                                                                    \
    {"tau", PP_UNIT_NUMBER, "total transmittance"},                                    \
        {"E_s", PP_UNIT_DAYLIGHT_FACTOR, "illuminance on the window from the sky"},    \
        {"rho_g", PP_UNIT_NUMBER, "ground reflectance"},                               \
        {"E_g", PP_UNIT_DAYLIGHT_FACTOR, "illuminance on the window from the ground"}, \
        {"CU_s", PP_UNIT_NUMBER,                                                       \
         "coefficient of utilization for the sky, from the table"},                    \
    {                                                                                  \
        "CU_g", PP_UNIT_NUMBER,                                                        \
            "coefficient of utilization for the ground, from the table"                \
    }
#define OF_ROOFLIGHT                                                                   \
    {"N", PP_UNIT_NUMBER, "efficiency of the well"},                                   \
        {"L", PP_UNIT_METRE, "length of the first side of the plan"},                  \
        {"W", PP_UNIT_METRE, "length of the second side of the plan"},                 \
    {                                                                                  \
        "h", PP_UNIT_METRE, "height of the ceiling above the working plane"            \
    }

static const struct pp_formula_quantity of_window[] = {OF_GLASS, OF_WINDOW, {0}};
static const struct pp_formula_quantity of_transmittance[] = {
    OF_GLASS,
    OF_WINDOW,
    {"R_a", PP_UNIT_NUMBER, "net glass area divided by the area of the window band"},
    {0}};
static const struct pp_formula_quantity of_ground[] = {
    {"rho_g", PP_UNIT_NUMBER, "ground reflectance"}, {0}};
static const struct pp_formula_quantity of_two[] = {OF_ENTERING, {0}};
static const struct pp_formula_quantity of_one[] = {
    OF_ENTERING,
    {"CU", PP_UNIT_NUMBER, "single coefficient of utilization for sky and ground"},
    {0}};
static const struct pp_formula_quantity of_well[] = {
    OF_GLASS, {"N", PP_UNIT_NUMBER, "efficiency of the well"}, {0}};
static const struct pp_formula_quantity of_cavity[] = {OF_ROOFLIGHT, {0}};
static const struct pp_formula_quantity of_rooflight[] = {
    OF_GLASS,
    OF_ROOFLIGHT,
    {"tau", PP_UNIT_NUMBER, "total transmittance"},
    {"RCR", PP_UNIT_NUMBER, "room cavity ratio"},
    {"E_h", PP_UNIT_DAYLIGHT_FACTOR, "illuminance on the rooflight from the sky"},
    {"CU", PP_UNIT_NUMBER, "coefficient of utilization, from the table"},
    {0}};

#define IES(left, right, what_of, of, quantities_of)                                   \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = of, .source = "IES84", .what = what_of,  \
        .quantities = quantities_of                                                    \
    }

static const struct pp_formula share_of_band = IES(
    "R_a", "A B / (W H)",
    "net glass area divided by the area of a band as high as the window and as wide as "
    "the wall",
    PP_UNIT_NUMBER, of_window);
static const struct pp_formula side_transmittance =
    IES("tau", "T R_a M", "total transmittance of a window", PP_UNIT_NUMBER,
        of_transmittance);
static const struct pp_formula ground_light =
    IES("E_g", "100 rho_g / 2", "illuminance on the window from the ground",
        PP_UNIT_DAYLIGHT_FACTOR, of_ground);
static const struct pp_formula depth_in_heights =
    IES("", "D / H", "ratio of room depth to window height", PP_UNIT_NUMBER, of_window);
static const struct pp_formula width_in_heights =
    IES("", "W / H", "ratio of room width to window height", PP_UNIT_NUMBER, of_window);
static const struct pp_formula side =
    IES("df", "tau (E_s CU_s + E_g CU_g)", "daylight factor from a window",
        PP_UNIT_DAYLIGHT_FACTOR, of_two);
/* The ground with a reflectance of 0.2 adds 10 per cent of Eh to the illuminance of the
 * window. */
static const struct pp_formula one_coefficient =
    IES("CU", "(E_s CU_s + 10 CU_g) / (E_s + 10)",
        "single coefficient of utilization, for a ground reflectance of 0.2",
        PP_UNIT_NUMBER, of_two);
static const struct pp_formula side_by_one =
    IES("df", "tau (E_s + E_g) CU", "daylight factor from a window",
        PP_UNIT_DAYLIGHT_FACTOR, of_one);
static const struct pp_formula top_transmittance = IES(
    "tau", "T N B M", "total transmittance of a rooflight", PP_UNIT_NUMBER, of_well);
static const struct pp_formula cavity_ratio = {.symbol = "RCR",
                                               .sum = "5 h (L + W) / (L W)",
                                               .unit = PP_UNIT_NUMBER,
                                               .source = "IES84",
                                               .what = "room cavity ratio",
                                               .quantities = of_cavity,
                                               .fixed = true};
static const struct pp_formula top =
    IES("df", "tau A / (L W) E_h CU", "average daylight factor from a rooflight",
        PP_UNIT_DAYLIGHT_FACTOR, of_rooflight);

static const struct pp_formula *const formulae[] = {
    &share_of_band,     &side_transmittance, &ground_light, &side,
    &top_transmittance, &cavity_ratio,       &top,          NULL};
static const struct pp_formula *const formulae_of_one[] = {&share_of_band,
                                                           &side_transmittance,
                                                           &ground_light,
                                                           &one_coefficient,
                                                           &side_by_one,
                                                           &top_transmittance,
                                                           &cavity_ratio,
                                                           &top,
                                                           NULL};

/* ---- independent of the point ---- */

struct reading {
    const char *why; /* reason why the opening is not covered (static, or `text`); NULL:
                      * the opening is covered */
    char text[160];
    double height_m;         /* height of the window; for a rooflight, height of the
                              * room above the plane */
    double width_m, depth_m; /* size of the room */
    double E_s, rho_g;
    double ceiling, walls;
    double cu_sky[PP_LUMEN_POSITIONS], cu_ground[PP_LUMEN_POSITIONS];
    double well, E_h, cu_top; /* rooflights only */
};

/* One reading for each opening. */
struct tools {
    struct reading readings[1];
};

static enum pp_status read_window(struct reading *r, const struct pp_world *world,
                                  const struct pp_outside_light *light,
                                  const struct pp_opening *opening,
                                  const struct pp_lumen_table *table,
                                  struct pp_error *err)
{
    double alpha_rad;
    enum pp_status status =
        pp_obstruction_angle(&alpha_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;
    if (alpha_rad > free_below_rad) {
        r->why = "has an external obstruction, but the tables are for an unobstructed "
                 "sky";
        return PP_OK;
    }
    r->height_m = opening->height_m;
    pp_lumen_scope_room_size(&r->width_m, &r->depth_m, world, opening);
    r->ceiling = pp_lumen_scope_ceiling_reflectance(world);
    r->walls = pp_lumen_scope_wall_reflectance(world, opening->face);
    r->E_s =
        pp_outside_light_sky_on_plane(light, pp_vec_scale(opening->inner.normal, -1.0));
    r->rho_g = light->ground_reflectance;

    struct pp_lumen_query query = {
        .ev_over_eh = r->E_s,
        .overcast = light->sky.kind == PP_SKY_OVERCAST || light->sky.iso == 1,
        .at = {[PP_LUMEN_CEILING] = r->ceiling,
               [PP_LUMEN_WALLS] = r->walls,
               [PP_LUMEN_DEPTH] = r->depth_m / r->height_m,
               [PP_LUMEN_WIDTH] = r->width_m / r->height_m},
    };
    bool covered =
        pp_lumen_table_side(r->cu_sky, table, &query, r->text, sizeof r->text);
    query.ev_over_eh = NAN;
    covered =
        covered
        && pp_lumen_table_side(r->cu_ground, table, &query, r->text, sizeof r->text);
    r->why = covered ? NULL : r->text;
    return PP_OK;
}

static enum pp_status read_rooflight(struct reading *r, const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_lumen_table *table,
                                     struct pp_error *err)
{
    double alpha_rad;
    enum pp_status status =
        pp_obstruction_angle(&alpha_rad, world, light, opening, err);
    if (status != PP_OK)
        return status;
    pp_lumen_scope_room_size(&r->width_m, &r->depth_m, world, opening);
    r->height_m = world->height_m - world->working_plane_m;
    r->ceiling = pp_lumen_scope_ceiling_reflectance(world);
    r->walls = pp_lumen_scope_wall_reflectance(world, -1);
    const double cavity[] = {NAN, r->width_m, r->depth_m, r->height_m};
    const double C[] = {1.0, alpha_rad};
    double rcr = pp_formula_value(&cavity_ratio, cavity);
    r->E_h = pp_formula_value(&pp_entering_light_C, C);
    r->well = pp_well_of(world, light, opening).whole;
    r->cu_top =
        pp_lumen_table_top(table, rcr, r->ceiling, r->walls, r->text, sizeof r->text);
    r->why = isnan(r->cu_top) ? r->text : NULL;
    return PP_OK;
}

static enum pp_status read_openings(struct tools *tools, const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_lumen_table *table,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct reading *r = &tools->readings[i];
        *r = (struct reading){.why = pp_lumen_scope_refuses_opening(world, opening)};
        if (r->why)
            continue;
        status = pp_lumen_scope_is_rooflight(opening)
                     ? read_rooflight(r, world, light, opening, table, err)
                     : read_window(r, world, light, opening, table, err);
    }
    return status;
}

static enum pp_status prepare_lumen(void **result, const struct pp_world *world,
                                    const struct pp_outside_light *light,
                                    const struct pp_method_options *options,
                                    struct pp_error *err)
{
    struct pp_lumen_table *own = NULL;
    size_t count = (size_t)world->opening_count + 1;
    struct tools *tools = malloc(count * sizeof(struct reading));
    enum pp_status status = tools ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK && !options->lumen_table)
        status = pp_lumen_table_create(&own, err);
    if (status == PP_OK)
        status = read_openings(tools, world, light,
                               options->lumen_table ? options->lumen_table : own, err);
    pp_lumen_table_destroy(own);
    if (status == PP_OK)
        *result = tools;
    else
        free(tools);
    return status;
}

static const char *lumen_refuses_room(const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_receiver *receiver)
{
    (void)light;
    const char *why = pp_refusals_unless_up(receiver);
    if (!why && receiver && fabs(receiver->position.z - world->working_plane_m) > 0.01)
        why = "the tables apply to points on the working plane only";
    return why ? why : pp_lumen_scope_refuses_room(world);
}

static void put_glass(struct pp_worksheet *sheet, const struct pp_opening *opening)
{
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, opening->inner.area_m2, "A",
                     "area of the opening");
    pp_allowance_put(sheet, PP_ALLOWS_FRAME, opening, "B",
                     "frame factor: ratio of glass area to opening area");
    pp_allowance_put(sheet, PP_ALLOWS_OWN_GLASS, opening, "T",
                     "diffuse transmittance of the glass");
    pp_allowance_put(sheet, PP_ALLOWS_DIRT, opening, "M", "maintenance factor (dirt)");
}

/* The coefficient at a fraction of the depth from the window; NAN: the average. */
static double coefficient(const double cu[PP_LUMEN_POSITIONS], double share)
{
    return isnan(share) ? cu[PP_LUMEN_AVERAGE] : pp_lumen_table_at_depth(cu, share);
}

/* Records the light that enters through a window. */
static void put_window(struct pp_worksheet *sheet, const struct reading *r,
                       const struct pp_opening *opening)
{
    put_glass(sheet, opening);
    pp_worksheet_put(sheet, PP_UNIT_METRE, r->height_m, "H", "window height");
    pp_worksheet_put(sheet, PP_UNIT_METRE, r->width_m, "W",
                     "width of the room, along the window wall");
    pp_worksheet_put(sheet, PP_UNIT_METRE, r->depth_m, "D",
                     "depth of the room, from the window wall");
    pp_worksheet_work(
        sheet, &share_of_band,
        "net glass area divided by the area of a band as high as the window and as "
        "wide as the wall");
    pp_worksheet_work(sheet, &side_transmittance, "total transmittance");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, r->E_s, "E_s",
                     "illuminance on the window from the sky");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, r->rho_g, "rho_g", "ground reflectance");
    pp_worksheet_work(sheet, &ground_light,
                      "illuminance on the window from the ground");
}

static double window_value(const struct reading *r, const struct pp_opening *opening,
                           double share, bool one, struct pp_worksheet *sheet)
{
    put_window(sheet, r, opening);
    pp_worksheet_work(sheet, &depth_in_heights, "ratio of room depth to window height");
    pp_worksheet_work(sheet, &width_in_heights, "ratio of room width to window height");
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, r->ceiling, "ceiling reflectance");
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, r->walls,
                      "mean reflectance of the other walls");
    if (!isnan(share))
        pp_worksheet_note(sheet, PP_UNIT_NUMBER, share,
                          "distance of the point from the window wall, divided by D");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, coefficient(r->cu_sky, share), "CU_s",
                     "coefficient of utilization for the sky, from the table");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, coefficient(r->cu_ground, share), "CU_g",
                     "coefficient of utilization for the ground, from the table");
    if (one)
        pp_worksheet_work(
            sheet, &one_coefficient,
            "single coefficient of utilization, for a ground reflectance of 0.2");
    return pp_worksheet_work(sheet, one ? &side_by_one : &side,
                             "daylight factor from this window");
}

static double rooflight_value(const struct reading *r, const struct pp_opening *opening,
                              struct pp_worksheet *sheet)
{
    put_glass(sheet, opening);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, r->well, "N", "efficiency of the well");
    pp_worksheet_work(sheet, &top_transmittance, "total transmittance");
    pp_worksheet_put(sheet, PP_UNIT_METRE, r->width_m, "L",
                     "length of the first side of the plan");
    pp_worksheet_put(sheet, PP_UNIT_METRE, r->depth_m, "W",
                     "length of the second side of the plan");
    pp_worksheet_put(sheet, PP_UNIT_METRE, r->height_m, "h",
                     "height of the ceiling above the working plane");
    pp_worksheet_work(sheet, &cavity_ratio, "room cavity ratio");
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, r->ceiling, "ceiling reflectance");
    pp_worksheet_note(sheet, PP_UNIT_NUMBER, r->walls, "mean reflectance of the walls");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, r->cu_top, "CU",
                     "coefficient of utilization, from the table");
    pp_worksheet_put(sheet, PP_UNIT_DAYLIGHT_FACTOR, r->E_h, "E_h",
                     "illuminance on the rooflight from the sky");
    return pp_worksheet_work(sheet, &top,
                             "average daylight factor from this rooflight");
}

/* The point's distance from the opening's wall, divided by the room's depth; NAN if
 * there is no point. */
static double depth_share(const struct reading *r, const struct pp_opening *opening,
                          const struct pp_receiver *receiver)
{
    if (!receiver)
        return NAN;
    struct pp_vec3 from = pp_vec_sub(receiver->position, opening->inner.vertices[0]);
    return pp_vec_dot(from, opening->inner.normal) / r->depth_m;
}

static enum pp_status evaluate_by(const struct pp_world *world,
                                  const struct pp_opening *opening,
                                  const struct pp_receiver *receiver, const void *made,
                                  struct pp_part *part, bool one)
{
    const struct tools *tools = made;
    const struct reading *r = &tools->readings[opening - world->openings];
    part->why = r->why;
    if (part->why)
        return PP_OK;
    if (pp_lumen_scope_is_rooflight(opening)) {
        if (receiver)
            part->why = "lights the room from above; for rooflights the method gives "
                        "only an average";
        else
            part->value = rooflight_value(r, opening, &part->sheet);
        return PP_OK;
    }
    double share = depth_share(r, opening, receiver);
    if (share < 0.1 - 1e-9 || share > 0.9 + 1e-9)
        part->why = "is too close to this point or too far from it; the tables cover "
                    "distances of 0.1 to 0.9 times the room depth";
    else
        part->value = window_value(r, opening, share, one, &part->sheet);
    return PP_OK;
}

static enum pp_status evaluate_lumen(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     const void *tools, struct pp_part *part,
                                     struct pp_error *err)
{
    (void)light, (void)err;
    return evaluate_by(world, opening, receiver, tools, part, false);
}

static enum pp_status evaluate_one(const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_opening *opening,
                                   const struct pp_receiver *receiver,
                                   const void *tools, struct pp_part *part,
                                   struct pp_error *err)
{
    (void)light, (void)err;
    return evaluate_by(world, opening, receiver, tools, part, true);
}

const struct pp_method pp_method_lumen = {
    .name = "lumen",
    .summary = "lumen method with separate coefficients of utilization for sky and "
               "ground",
    .source = "IES84",
    .formulae = formulae,
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .has_average = true,
    .refuses_room = lumen_refuses_room,
    .prepare_with_options = prepare_lumen,
    .destroy_tools = free,
    .evaluate = evaluate_lumen,
};

const struct pp_method pp_method_lumen_one = {
    .name = "lumen-one",
    .summary = "lumen method with a single coefficient of utilization",
    .source = "IES84",
    .formulae = formulae_of_one,
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .has_average = true,
    .refuses_room = lumen_refuses_room,
    .prepare_with_options = prepare_lumen,
    .destroy_tools = free,
    .evaluate = evaluate_one,
};
