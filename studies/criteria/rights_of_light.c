/* rights_of_light.c - the area of a room that is adequately lit in the English law of
 * easements, and the part of it that was lost.
 *
 * The sky factor is the share of a uniform sky's light that reaches a level point
 * directly, without glass, frame or dirt: 0.2 % of 500 foot-candles outside is one
 * foot-candle, the least to read by ("grumble line", [WW23]). It is taken at 0.85 m
 * above the floor, whatever the room's own sky and working plane:
 *
 *   SF = (1/pi) integral of sin(gamma) over the visible sky
 *
 *   gamma  altitude of a point of the sky
 *
 * A room is adequately lit where the 0.2 % contour encloses half of its area or more.
 * The contour is a true curve, to the tolerance of methods/daylight_curves.h.
 */
#include <math.h>

#include "studies/criteria/criteria.h"
#include "model/geometry/contour/contour.h"
#include "methods/daylight_curves.h"
#include "methods/direct_plane.h"
#include "methods/exact/direct.h"
#include "model/room/section.h"

#define SKY_FACTOR 0.002
#define SHARE_WANTED 0.5
#define PLANE_M 0.85
#define INSET_M 0.001 /* points on the plane's edge are moved this far inside */

/* The law's sky, and no ground. */
static struct pp_outside_light legal_light(void)
{
    return (struct pp_outside_light){.sky = pp_sky_uniform()};
}

static enum pp_status sky_factor_at(void *context, double x, double y, double *value,
                                    struct pp_error *err)
{
    const struct pp_world *world = context;
    const struct pp_glass none = pp_glass_none();
    const struct pp_receiver receiver = {
        .position = pp_direct_plane_off_walls(&world->plane, world->working_plane_m,
                                              INSET_M, x, y),
        .normal = pp_vec(0.0, 0.0, 1.0)};
    const struct pp_outside_light light = legal_light();
    struct pp_direct sum = {.rough = true};
    for (int i = 0; i < world->opening_count; i++) {
        enum pp_status status = pp_direct_through(
            &sum, world, &light, &world->openings[i], &receiver, &none, err);
        if (status != PP_OK)
            return status;
    }
    *value = sum.sky;
    return PP_OK;
}

struct adequately_lit_area {
    double plane_m2; /* of the room at 0.85 m */
    double lit_m2;   /* within the contour */
    double error_m2; /* of lit_m2, by the tolerance of the contour */
};

/* The area where the sky factor is above 0.2 %, in a world with the plane at 0.85 m. */
static enum pp_status measure(struct adequately_lit_area *area, struct pp_world *world,
                              struct pp_error *err)
{
    area->plane_m2 = pp_region_area(&world->plane);
    if (!(area->plane_m2 > 0.0))
        return PP_OK;
    struct pp_field *field;
    struct pp_curve_list below = {0}, lines = {0};
    double tolerance = pp_daylight_curves_tolerance(&world->plane);
    enum pp_status status =
        pp_field_create(&field, &world->plane, sky_factor_at, world, tolerance, err);
    if (status != PP_OK)
        return status;
    status = pp_contour_curves(field, SKY_FACTOR, &lines, err);
    if (status == PP_OK)
        status = pp_contour_below(field, SKY_FACTOR, &below, err);
    pp_field_destroy(field);
    area->lit_m2 = fmax(area->plane_m2 - pp_curve_list_area(&below), 0.0);
    for (int i = 0; i < lines.count; i++)
        area->error_m2 += pp_curve_length(&lines.list[i]) * tolerance;
    pp_curve_list_clear(&lines);
    pp_curve_list_clear(&below);
    return status;
}

static enum pp_status find_area(struct adequately_lit_area *area,
                                const struct pp_world *world, struct pp_error *err)
{
    *area = (struct adequately_lit_area){0};
    double floor_z = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            floor_z = fmin(floor_z, world->surfaces[i].outline.vertices[k].z);

    /* A shallow copy of the world with the law's plane; it owns its plane only. */
    struct pp_world legal = *world;
    legal.working_plane_m = floor_z + PLANE_M;
    enum pp_status status =
        pp_section_at(&legal.plane, world, legal.working_plane_m, err);
    if (status != PP_OK)
        return status;
    status = measure(area, &legal, err);
    pp_region_clear(&legal.plane);
    return status;
}

/* Adds the area enclosed before, and the area lost since. */
static enum pp_status add_loss(const struct adequately_lit_area *now,
                               const struct pp_inquiry *inquiry,
                               struct pp_finding_list *findings, struct pp_error *err)
{
    struct adequately_lit_area then;
    enum pp_status status = find_area(&then, inquiry->before, err);
    if (status != PP_OK)
        return status;
    struct pp_finding former =
        pp_finding_of(PP_FIGURE_AREA, then.lit_m2, NAN, false, "area enclosed before");
    struct pp_finding lost = pp_finding_of(PP_FIGURE_AREA, then.lit_m2 - now->lit_m2,
                                           NAN, true, "area lost");
    if (then.lit_m2 > 0.0)
        pp_finding_note(&lost, "%.1f %% of what was enclosed before",
                        100.0 * (then.lit_m2 - now->lit_m2) / then.lit_m2);
    status = pp_finding_list_add(findings, &former, err);
    return status == PP_OK ? pp_finding_list_add(findings, &lost, err) : status;
}

static enum pp_status evaluate(const struct pp_inquiry *inquiry,
                               struct pp_finding_list *findings, struct pp_error *err)
{
    struct adequately_lit_area now;
    enum pp_status status = find_area(&now, inquiry->world, err);
    if (status != PP_OK)
        return status;
    if (!(now.plane_m2 > 0.0)) {
        struct pp_finding finding = pp_finding_not_judged(
            "the room does not reach 0.85 m above its floor", "room within 0.2 %%");
        return pp_finding_list_add(findings, &finding, err);
    }
    struct pp_finding area = pp_finding_of(PP_FIGURE_AREA, now.lit_m2, NAN, false,
                                           "area the 0.2 %% contour encloses");
    struct pp_finding share = pp_finding_of(PP_FIGURE_SHARE, now.lit_m2 / now.plane_m2,
                                            SHARE_WANTED, false, "share of the room");
    pp_finding_within(&share, now.error_m2 / now.plane_m2);
    status = pp_finding_list_add(findings, &area, err);
    if (status == PP_OK)
        status = pp_finding_list_add(findings, &share, err);
    if (status == PP_OK && inquiry->before)
        status = add_loss(&now, inquiry, findings, err);
    return status;
}

const struct pp_criterion pp_criterion_rights_of_light = {
    .name = "rights-of-light",
    .title = "Rights of light",
    .source = "WW23",
    .summary = "a sky factor of 0.2 % at 0.85 m over half of the room",
    .countries = "GB IE",
    .evaluate = evaluate,
};
