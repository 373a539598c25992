/* lit_line.c - see lit_line.h. */
#include "studies/lit_line.h"

#include <math.h>

#include "methods/daylight_curves.h"
#include "methods/direct_plane.h"
#include "methods/exact/direct.h"
#include "model/geometry/contour/contour.h"
#include "model/room/section.h"

#define SKY_FACTOR 0.002
#define LEGAL_PLANE_M 0.85
#define INSET_M 0.001 /* inset of points on the plane's edge, m */

/* The uniform sky that is assumed in law, without light from the ground. */
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

/* Traces the contour and the area outside it, in a world whose working plane is at 0.85
 * m. */
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

    /* Shallow copy of the world, with the working plane at the height used in law. */
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

/* Maximum for the number of triangles times the number of openings. 5,000 triangles in
 * front of one opening take 0.9 s (no-sky line) and 2.2 s (sky factor). */
static const double mesh_triangles_most = 10000.0;

static bool is_too_fine(const struct pp_world *world)
{
    double triangles = world->surface_count - pp_world_before_meshes(world);
    return triangles * world->opening_count > mesh_triangles_most;
}

const char *pp_lit_line_refuses(const struct pp_world *world,
                                const struct pp_world *before)
{
    return is_too_fine(world) || (before && is_too_fine(before))
               ? "the external meshes are too fine for the no-sky line; expected at "
                 "most 10,000 triangles times openings"
               : NULL;
}

enum pp_status pp_lit_line_find(struct pp_lit_area *area, const struct pp_world *world,
                                enum pp_lit_line line, struct pp_error *err)
{
    *area = (struct pp_lit_area){0};
    const char *why = pp_lit_line_refuses(world, NULL);
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "%s", why);
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
