/* garden_sun.c - see garden_sun.h. */
#include "studies/site/garden_sun.h"

#include <math.h>
#include <stdlib.h>

#include "methods/exact/sunlit_hours.h"
#include "model/geometry/clipper.h"
#include "model/geometry/contour/contour.h"

#define HOURS 2.0
#define MONTH 3
#define DATE 21
#define TOLERANCE_M 0.01

void pp_garden_sun_clear(struct pp_garden_sun *sun)
{
    pp_curve_list_clear(&sun->dark);
    *sun = (struct pp_garden_sun){0};
}

static enum pp_status hours_at(void *context, double x, double y, double *value,
                               struct pp_error *err)
{
    const struct pp_world *world = context;
    const struct pp_hidden_view view = {.eye = pp_vec(x, y, world->ground_level_m),
                                        .out = pp_vec(0.0, 0.0, 1.0),
                                        .face = -1};
    const struct pp_sunlit_place place = {world->latitude_rad, world->north_rad,
                                          world->longitude_rad};
    struct pp_hidden_cones cones;
    struct pp_sunlit_day day = {0};
    enum pp_status status = pp_hidden_cones_init(&cones, world, &view, err);
    if (status != PP_OK)
        return status;
    status = pp_sunlit_hours_of_day(&day, &cones, place, MONTH, DATE, err);
    *value = pp_sunlit_hours_sum(&day);
    pp_sunlit_hours_clear(&day);
    pp_hidden_cones_clear(&cones);
    return status;
}

static enum pp_status find_region(struct pp_region *region,
                                  const struct pp_garden *garden, struct pp_error *err)
{
    int count = garden->outline.count;
    struct pp_clipper *clipper = NULL;
    double(*xy)[2] = malloc(count * sizeof *xy);
    if (!xy)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        xy[i][0] = garden->outline.vertices[i].x;
        xy[i][1] = garden->outline.vertices[i].y;
    }
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status =
            pp_clipper_of_ring(clipper, region, (const double(*)[2])xy, count, err);
    pp_clipper_destroy(clipper);
    free(xy);
    return status;
}

static enum pp_status trace_garden_sun(struct pp_garden_sun *sun,
                                       const struct pp_world *world,
                                       const struct pp_region *region,
                                       struct pp_error *err)
{
    const struct pp_bounds2 box = pp_region_bounds(region);
    double tolerance =
        fmax(TOLERANCE_M,
             hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]) / 2000.0);
    struct pp_curve_list lines = {0};
    struct pp_field *field;
    enum pp_status status =
        pp_field_create(&field, region, hours_at, (void *)world, tolerance, err);
    if (status != PP_OK)
        return status;
    /* Slightly below HOURS, so that exactly two hours of sun are sufficient. */
    status = pp_contour_curves(field, HOURS - 1e-9, &lines, err);
    if (status == PP_OK)
        status = pp_contour_below(field, HOURS - 1e-9, &sun->dark, err);
    for (int i = 0; i < lines.count; i++)
        sun->error_m2 += pp_curve_length(&lines.list[i]) * tolerance;
    pp_curve_list_clear(&lines);
    pp_field_destroy(field);
    return status;
}

enum pp_status pp_garden_sun_find(struct pp_garden_sun *sun,
                                  const struct pp_world *world,
                                  const struct pp_garden *garden, struct pp_error *err)
{
    struct pp_region region = {0};
    *sun = (struct pp_garden_sun){0};
    enum pp_status status = find_region(&region, garden, err);
    if (status == PP_OK)
        status = trace_garden_sun(sun, world, &region, err);
    sun->area_m2 = pp_region_area(&region);
    sun->sunlit_m2 =
        fmax(sun->area_m2 - fmax(pp_curve_list_area(&sun->dark), 0.0), 0.0);
    pp_region_clear(&region);
    if (status != PP_OK)
        pp_garden_sun_clear(sun);
    return status;
}
