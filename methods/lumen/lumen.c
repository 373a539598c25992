/* lumen.c - `lumen` and `lumen-one`: the lumen method, a daylight factor in one step.
 *
 * Light from the side, at five points and on average                       [IES84]:
 *
 *     E = tau (E_s CU_s + E_g CU_g)      lumen: sky and ground apart
 *     E = tau (E_s + E_g) CU             lumen-one: one coefficient
 *
 *   E_s   illuminance of the window from the open sky, over Eh
 *   E_g   the same from the ground: rho_g / 2
 *   tau   T R_a M: diffuse transmittance of the glass; its net area over that of the
 *         band as high as the window along the whole wall; light loss by dirt
 *   CU    coefficients of utilization, from tables (lumen_table.h) by depth and width
 * of the room in window heights, and reflectances; the one coefficient is (E_s CU_s +
 * 0.1 CU_g) / (E_s + 0.1), that of a ground of reflectance 0.2
 *
 * The table's window is all of a wall; windows spread along a wall are taken as that
 * window with their share of its area. A point's value depends on its depth from the
 * window alone, between the 10 and 90 % of the table. Windows in two opposite walls add
 * up.
 *
 * Light from above, on average only:
 *
 *     E = tau (A_s / A_w) E_h CU         tau = T N B M
 *
 *   A_s, A_w   areas of rooflight and working plane; B glass over opening area
 *   N     efficiency of the well; T and M as above
 *   E_h   illuminance on the rooflight, over Eh
 *   CU    by the room cavity ratio 5 h (L + W) / (L W) and reflectances
 *
 * lumen_scope.h has the rooms and openings that the method covers; there is no
 * extrapolation. tau contains glass, frame and dirt.
 */
#include <stdio.h>
#include <stdlib.h>

#include "methods/lumen/lumen_cavity.h"
#include "methods/lumen/lumen_scope.h"
#include "methods/lumen/lumen_table.h"
#include "methods/method.h"
#include "methods/reflected/obstruction.h"
#include "methods/refusals.h"

/* The ground reflectance in the one coefficient. */
static const double one_ground = 0.2;

/* A skyline higher than this is an obstruction (rad). */
static const double free_below_rad = 1e-3;

/* The terms of a window's or rooflight's sum that do not depend on the point. */
struct reading {
    const char *why; /* static, or `text`; NULL: the opening is covered */
    char text[160];
    double height_m;         /* of the window */
    double width_m, depth_m; /* of the room */
    double area_m2;
    double T, R_a, M, tau;
    double E_s, E_g;
    double ceiling, walls;
    double cu_sky[PP_LUMEN_POSITIONS], cu_ground[PP_LUMEN_POSITIONS];
    /* of rooflights: */
    double rcr, well, plane_m2, E_h, cu_top;
};

/* One for each opening. */
struct tools {
    struct reading readings[1];
};

static enum pp_status read_window(struct reading *r, const struct pp_world *world,
                                  const struct pp_opening *opening,
                                  const struct pp_lumen_table *table,
                                  struct pp_error *err)
{
    double alpha_rad;
    enum pp_status status = pp_obstruction_angle(&alpha_rad, world, opening, err);
    if (status != PP_OK)
        return status;
    if (alpha_rad > free_below_rad) {
        r->why = "has something outside before it; the tables are for open skies";
        return PP_OK;
    }
    r->height_m = opening->height_m;
    pp_lumen_scope_room_size(&r->width_m, &r->depth_m, world, opening);
    r->ceiling = pp_lumen_scope_ceiling_reflectance(world);
    r->walls = pp_lumen_scope_wall_reflectance(world, opening->face);
    r->E_s = pp_sky_on_plane(&world->sky, pp_vec_scale(opening->inner.normal, -1.0));
    r->E_g = world->ground_reflectance / 2.0;
    r->R_a = r->area_m2 * opening->frame_factor / (r->width_m * r->height_m);
    r->tau = r->T * r->R_a * r->M;

    struct pp_lumen_query query = {
        .ev_over_eh = r->E_s,
        .overcast = world->sky.kind == PP_SKY_OVERCAST || world->sky.iso == 1,
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
                                     const struct pp_opening *opening,
                                     const struct pp_lumen_table *table,
                                     struct pp_error *err)
{
    double alpha_rad;
    enum pp_status status = pp_obstruction_angle(&alpha_rad, world, opening, err);
    if (status != PP_OK)
        return status;
    pp_lumen_scope_room_size(&r->width_m, &r->depth_m, world, opening);
    r->height_m = world->height_m - world->working_plane_m;
    r->plane_m2 = r->width_m * r->depth_m;
    r->ceiling = pp_lumen_scope_ceiling_reflectance(world);
    r->walls = pp_lumen_scope_wall_reflectance(world, -1);
    r->rcr = 5.0 * r->height_m * (r->width_m + r->depth_m) / r->plane_m2;
    r->E_h = 1.0 - alpha_rad / (PP_PI / 2.0);
    r->well = pp_lumen_cavity_well_efficiency(opening->width_m, opening->height_m,
                                              opening->reveal_m, r->ceiling);
    r->R_a = opening->frame_factor;
    r->tau = r->T * r->well * r->R_a * r->M;
    r->cu_top = pp_lumen_table_top(table, r->rcr, r->ceiling, r->walls, r->text,
                                   sizeof r->text);
    r->why = isnan(r->cu_top) ? r->text : NULL;
    return PP_OK;
}

static enum pp_status read_openings(struct tools *tools, const struct pp_world *world,
                                    const struct pp_lumen_table *table,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct reading *r = &tools->readings[i];
        *r = (struct reading){.why = pp_lumen_scope_refuses_opening(world, opening),
                              .area_m2 = opening->inner.area_m2,
                              .T = opening->glass.diffuse,
                              .M = opening->maintenance};
        if (r->why)
            continue;
        status = pp_lumen_scope_is_rooflight(opening)
                     ? read_rooflight(r, world, opening, table, err)
                     : read_window(r, world, opening, table, err);
    }
    return status;
}

static enum pp_status prepare(void **result, const struct pp_world *world,
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
        status = read_openings(tools, world,
                               options->lumen_table ? options->lumen_table : own, err);
    pp_lumen_table_destroy(own);
    if (status == PP_OK)
        *result = tools;
    else
        free(tools);
    return status;
}

static const char *refuses_room(const struct pp_world *world,
                                const struct pp_receiver *receiver)
{
    const char *why = pp_refusals_unless_up(receiver);
    if (!why && receiver && fabs(receiver->position.z - world->working_plane_m) > 0.01)
        why = "its tables are for points on the working plane";
    return why ? why : pp_lumen_scope_refuses_room(world);
}

static void add_glass_steps(const struct reading *r, const struct pp_opening *opening,
                            struct pp_steps *steps)
{
    pp_steps_add_named(steps, PP_UNIT_SQUARE_METRE, r->area_m2, "A",
                       "opening on line %d: area", opening->line);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, opening->frame_factor, "B",
                       "glass over opening area");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->T, "T",
                       "diffuse transmittance of its glass");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->M, "M", "light loss by dirt");
}

/* The coefficient at a share of the depth; the average for NAN. */
static double coefficient(const double cu[PP_LUMEN_POSITIONS], double share)
{
    return isnan(share) ? cu[PP_LUMEN_AVERAGE] : pp_lumen_table_at_depth(cu, share);
}

static double window_value(const struct reading *r, const struct pp_opening *opening,
                           double share, bool one, struct pp_steps *steps)
{
    double cu_s = coefficient(r->cu_sky, share),
           cu_g = coefficient(r->cu_ground, share);
    double cu_one =
        (r->E_s * cu_s + one_ground / 2.0 * cu_g) / (r->E_s + one_ground / 2.0);
    double value = one ? r->tau * (r->E_s + r->E_g) * cu_one
                       : r->tau * (r->E_s * cu_s + r->E_g * cu_g);
    if (!steps)
        return value;
    add_glass_steps(r, opening, steps);
    pp_steps_add_named(steps, PP_UNIT_METRE, r->height_m, "H", "window height");
    pp_steps_add_named(steps, PP_UNIT_METRE, r->width_m, "W",
                       "room along the window's wall");
    pp_steps_add_named(steps, PP_UNIT_METRE, r->depth_m, "D", "room away from it");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, r->R_a, "R_a", "A B / (W H)",
                        "net glass over the band along the wall");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, r->tau, "tau", "T R_a M",
                        "transmittance in all");
    pp_steps_add_named(steps, PP_UNIT_SHARE, r->E_s, "E_s",
                       "on the window from the sky");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, 2.0 * r->E_g, "rho_g",
                       "ground reflectance");
    pp_steps_add_worked(steps, PP_UNIT_SHARE, r->E_g, "E_g", "100 rho_g / 2",
                        "on the window from the ground");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, r->depth_m / r->height_m, "", "D / H",
                        "room depth over window height");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, r->width_m / r->height_m, "", "W / H",
                        "room width over window height");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->ceiling, "", "ceiling reflectance");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->walls, "",
                       "mean reflectance of the other walls");
    if (!isnan(share))
        pp_steps_add_named(steps, PP_UNIT_NUMBER, share, "",
                           "the point's distance from the wall over D");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, cu_s, "CU_s",
                       "coefficient for the sky, by its table");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, cu_g, "CU_g",
                       "coefficient for the ground, by its table");
    if (one) {
        pp_steps_add_worked(steps, PP_UNIT_NUMBER, cu_one, "CU",
                            "(E_s CU_s + 10 CU_g) / (E_s + 10)",
                            "one coefficient, of a ground of 0.2");
        pp_steps_add_worked(steps, PP_UNIT_SHARE, value, "df", "tau (E_s + E_g) CU",
                            "daylight factor from this window");
    } else {
        pp_steps_add_worked(steps, PP_UNIT_SHARE, value, "df",
                            "tau (E_s CU_s + E_g CU_g)",
                            "daylight factor from this window");
    }
    return value;
}

static double rooflight_value(const struct reading *r, const struct pp_opening *opening,
                              struct pp_steps *steps)
{
    double value = r->tau * r->area_m2 / r->plane_m2 * r->E_h * r->cu_top;
    if (!steps)
        return value;
    add_glass_steps(r, opening, steps);
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->well, "N",
                       "what its well lets through");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, r->tau, "tau", "T N B M",
                        "transmittance in all");
    pp_steps_add_named(steps, PP_UNIT_METRE, r->width_m, "L", "one side of the plan");
    pp_steps_add_named(steps, PP_UNIT_METRE, r->depth_m, "W", "the other");
    pp_steps_add_named(steps, PP_UNIT_METRE, r->height_m, "h",
                       "ceiling above the working plane");
    pp_steps_add_worked(steps, PP_UNIT_NUMBER, r->rcr, "RCR", "5 h (L + W) / (L W)",
                        "room cavity ratio");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->ceiling, "", "ceiling reflectance");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->walls, "",
                       "mean reflectance of the walls");
    pp_steps_add_named(steps, PP_UNIT_NUMBER, r->cu_top, "CU",
                       "coefficient, by its table");
    pp_steps_add_named(steps, PP_UNIT_SHARE, r->E_h, "E_h",
                       "on the rooflight from the sky");
    pp_steps_add_worked(steps, PP_UNIT_SHARE, value, "df", "tau A / (L W) E_h CU",
                        "average daylight factor from this rooflight");
    return value;
}

/* The point's distance from the opening's wall over the room's depth; NAN for no
 * point. */
static double share_of(const struct reading *r, const struct pp_opening *opening,
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
            part->why = "lights the room from above, of which the method gives the "
                        "average only";
        else
            part->value = rooflight_value(r, opening, part->steps);
        return PP_OK;
    }
    double share = share_of(r, opening, receiver);
    if (share < 0.1 - 1e-9 || share > 0.9 + 1e-9)
        part->why =
            "has this point nearer than a tenth of the room's depth, or farther "
            "than nine tenths, where the tables end";
    else
        part->value = window_value(r, opening, share, one, part->steps);
    return PP_OK;
}

static enum pp_status evaluate(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err)
{
    (void)err;
    return evaluate_by(world, opening, receiver, tools, part, false);
}

static enum pp_status evaluate_one(const struct pp_world *world,
                                   const struct pp_opening *opening,
                                   const struct pp_receiver *receiver,
                                   const void *tools, struct pp_part *part,
                                   struct pp_error *err)
{
    (void)err;
    return evaluate_by(world, opening, receiver, tools, part, true);
}

const struct pp_method pp_method_lumen = {
    .name = "lumen",
    .summary = "the lumen method, sky and ground apart",
    .source = "IES84",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .has_average = true,
    .refuses_room = refuses_room,
    .prepare_with_options = prepare,
    .destroy_tools = free,
    .evaluate = evaluate,
};

const struct pp_method pp_method_lumen_one = {
    .name = "lumen-one",
    .summary = "the lumen method with one coefficient",
    .source = "IES84",
    .gives = PP_GIVES_WHOLE,
    .speaks_for = PP_FOR_POINT,
    .allowances = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT,
    .has_average = true,
    .refuses_room = refuses_room,
    .prepare_with_options = prepare,
    .destroy_tools = free,
    .evaluate = evaluate_one,
};
