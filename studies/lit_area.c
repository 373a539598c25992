/* lit_area.c - see lit_area.h. */
#include "studies/lit_area.h"

#include <math.h>

#include "methods/daylight_curves.h"
#include "methods/direct_plane.h"
#include "methods/exact/direct.h"
#include "model/geometry/contour/contour.h"
#include "model/room/section.h"

#define SKY_FACTOR 0.002
#define LEGAL_PLANE_M 0.85
#define INSET_M 0.001 /* points on the plane's edge are moved this far inside */

void pp_lit_area_clear(struct pp_lit_area *area)
{
    pp_region_clear(&area->plane);
    pp_curve_list_clear(&area->line);
    pp_curve_list_clear(&area->dark);
    *area = (struct pp_lit_area){0};
}

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

/* The line and what lies behind it, in a world with the plane at 0.85 m. */
static enum pp_status trace_sky_factor(struct pp_lit_area *area, struct pp_world *legal,
                                       struct pp_error *err)
{
    struct pp_field *field;
    enum pp_status status =
        pp_field_create(&field, &legal->plane, sky_factor_at, legal,
                        pp_daylight_curves_tolerance(&legal->plane), err);
    if (status != PP_OK)
        return status;
    status = pp_contour_curves(field, SKY_FACTOR, &area->line, err);
    if (status == PP_OK)
        status = pp_contour_below(field, SKY_FACTOR, &area->dark, err);
    pp_field_destroy(field);
    return status;
}

static enum pp_status find_adequately_lit(struct pp_lit_area *area,
                                          const struct pp_world *world,
                                          struct pp_error *err)
{
    double floor_z = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++)
            floor_z = fmin(floor_z, world->surfaces[i].outline.vertices[k].z);
    area->plane_m = floor_z + LEGAL_PLANE_M;
    enum pp_status status = pp_section_at(&area->plane, world, area->plane_m, err);
    if (status != PP_OK || area->plane.count == 0)
        return status;

    /* A shallow copy of the world with the law's plane. */
    struct pp_world legal = *world;
    legal.working_plane_m = area->plane_m;
    legal.plane = area->plane;
    return trace_sky_factor(area, &legal, err);
}

static enum pp_status find_sky_view(struct pp_lit_area *area,
                                    const struct pp_world *world, struct pp_error *err)
{
    struct pp_daylight_plan plan;
    area->plane_m = world->working_plane_m;
    enum pp_status status = pp_region_copy(&area->plane, &world->plane, err);
    if (status != PP_OK || area->plane.count == 0)
        return status;
    status = pp_daylight_curves_no_sky(&plan, world, err);
    if (status != PP_OK)
        return status;
    area->line = plan.no_sky;
    area->dark = plan.dark;
    plan.no_sky = plan.dark = (struct pp_curve_list){0};
    pp_daylight_plan_clear(&plan);
    return PP_OK;
}

enum pp_status pp_lit_area_find(struct pp_lit_area *area, const struct pp_world *world,
                                enum pp_lit_line line, struct pp_error *err)
{
    *area = (struct pp_lit_area){0};
    enum pp_status status = line == PP_LIT_NO_SKY
                                ? find_sky_view(area, world, err)
                                : find_adequately_lit(area, world, err);
    if (status != PP_OK) {
        pp_lit_area_clear(area);
        return status;
    }
    area->plane_m2 = pp_region_area(&area->plane);
    double dark_m2 = fmax(pp_curve_list_area(&area->dark), 0.0);
    area->lit_m2 = fmax(area->plane_m2 - dark_m2, 0.0);
    for (int i = 0; i < area->line.count; i++)
        area->error_m2 += pp_curve_length(&area->line.list[i])
                          * pp_daylight_curves_tolerance(&area->plane);
    return PP_OK;
}

struct pp_lit_loss pp_lit_area_loss(double plane_m2, double before_m2, double now_m2)
{
    static const double weights[PP_ZONE_COUNT] = {1.5, 1.0, 0.5, 0.25};
    struct pp_lit_loss loss = {0};
    for (int i = 0; i < PP_ZONE_COUNT; i++) {
        double low = plane_m2 * i / PP_ZONE_COUNT;
        double high = plane_m2 * (i + 1) / PP_ZONE_COUNT;
        loss.zones_m2[i] = fmax(fmin(before_m2, high) - fmax(now_m2, low), 0.0);
        loss.equivalent_m2 += weights[i] * loss.zones_m2[i];
    }
    return loss;
}

const char *pp_lit_area_zone_name(enum pp_lit_zone zone)
{
    static const char *const names[] = {[PP_ZONE_FRONT] = "front zone",
                                        [PP_ZONE_FIRST] = "first zone",
                                        [PP_ZONE_SECOND] = "second zone",
                                        [PP_ZONE_MAKEWEIGHT] = "makeweight"};
    return names[zone];
}
