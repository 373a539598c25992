#include "methods/daylight_curves.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/contour/contour.h"
#include "methods/exact/exact.h"
#include "methods/view/exterior.h"
#include "methods/plane_inset.h"

/* Sky of a smaller solid angle than this (sr) is none: 1e-9 sr is what a slit of a
 * metre by a micrometre shows at 30 m. */
#define NO_SKY_SR 1e-9

/* How far off the walls the plane's edge is evaluated, over its diagonal, and at most
 * (m). On it, in a window's plane or under one, the daylight factor has no value of its
 * own, and just before it all levels crowd together; this is less than a drawn wall. */
#define DAYLIGHT_INSET (1.0 / 500.0)
#define DAYLIGHT_INSET_MOST_M 0.02
#define SKY_INSET_M 0.001

struct contoured_plane {
    const struct pp_world *world;
    double irc;
    double inset_m; /* the plane's edge itself is in the walls */
};

/* ---- what is contoured ---- */

static enum pp_status daylight_at(void *context, double x, double y, double *value,
                                  struct pp_error *err)
{
    const struct contoured_plane *scene = context;
    const struct pp_world *world = scene->world;
    struct pp_receiver receiver = {
        .position =
            pp_plane_inset(&world->plane, world->working_plane_m, scene->inset_m, x, y),
        .normal = pp_vec(0, 0, 1)};
    *value = scene->irc;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_part part = {0};
        enum pp_status status = pp_method_exact.evaluate_roughly(
            world, opening, &receiver, NULL, &part, err);
        if (status != PP_OK)
            return status;
        *value += (part.sky + part.external)
                  * pp_allowance_factor(pp_method_exact.allowances, opening);
    }
    return PP_OK;
}

static enum pp_status sky_seen_at(void *context, double x, double y, double *value,
                                  struct pp_error *err)
{
    const struct contoured_plane *scene = context;
    const struct pp_world *world = scene->world;
    struct pp_vec3 eye =
        pp_plane_inset(&world->plane, world->working_plane_m, scene->inset_m, x, y);
    return pp_exterior_sky_solid_angle(value, world, eye, err);
}

/* ---- levels ---- */

enum { LEVELS_MOST = 9 };

/* Those of the usual levels that the range holds, the lowest left out where there are
 * too many; where there are too few, multiples of a round step. */
static int choose_levels(double levels[LEVELS_MOST], double low, double high)
{
    static const double percent[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05,
                                     0.1,   0.2,   0.5,   1,    2,    3,
                                     5,     10,    20,    30,   50,   100};
    int count = 0;
    for (int i = 17; i >= 0 && count < LEVELS_MOST; i--)
        if (percent[i] / 100.0 > low && percent[i] / 100.0 < high)
            levels[LEVELS_MOST - 1 - count++] = percent[i] / 100.0;
    memmove(levels, levels + LEVELS_MOST - count, (size_t)count * sizeof *levels);
    if (count >= 3 || !(high - low > 1e-7))
        return count;

    double least = (high - low) / 6.0, power = pow(10.0, floor(log10(least)));
    double step = least <= 2.0 * power   ? 2.0 * power
                  : least <= 5.0 * power ? 5.0 * power
                                         : 10.0 * power;
    count = 0;
    for (double i = floor(low / step) + 1.0; i * step < high && count < LEVELS_MOST;
         i += 1.0)
        levels[count++] = i * step;
    return count;
}

/* ---- the plan ---- */

static enum pp_status add_contours(struct pp_daylight_plan *plan,
                                   struct contoured_plane *scene, double tolerance,
                                   const double *levels, int level_count,
                                   struct pp_error *err)
{
    struct pp_field *field;
    double usual[LEVELS_MOST];
    enum pp_status status = pp_field_create(&field, &scene->world->plane, daylight_at,
                                            scene, tolerance, err);
    if (status != PP_OK)
        return status;
    pp_field_range(field, &plan->lowest, plan->lowest_xy, &plan->highest,
                   plan->highest_xy);
    if (level_count == 0) {
        level_count = choose_levels(usual, plan->lowest, plan->highest);
        levels = usual;
    }
    for (int i = 0; i < level_count && status == PP_OK; i++)
        status = pp_contour_curves(field, levels[i], &plan->contours, err);
    /* Refining near the levels may have come upon a higher or lower place. */
    pp_field_range(field, &plan->lowest, plan->lowest_xy, &plan->highest,
                   plan->highest_xy);
    pp_field_destroy(field);
    return status;
}

static enum pp_status add_no_sky_line(struct pp_daylight_plan *plan,
                                      struct contoured_plane *scene, double tolerance,
                                      struct pp_error *err)
{
    struct pp_field *field;
    enum pp_status status = pp_field_create(&field, &scene->world->plane, sky_seen_at,
                                            scene, tolerance, err);
    if (status != PP_OK)
        return status;
    status = pp_contour_curves(field, NO_SKY_SR, &plan->no_sky, err);
    if (status == PP_OK)
        status = pp_contour_below(field, NO_SKY_SR, &plan->dark, err);
    pp_field_destroy(field);
    double share =
        pp_curve_list_area(&plan->dark) / pp_region_area(&scene->world->plane);
    plan->sky_share = fmin(fmax(1.0 - share, 0.0), 1.0);
    return status;
}

static double diagonal_of(const struct pp_region *plane)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int r = 0; r < plane->count; r++)
        for (int i = 0; i < plane->rings[r].count; i++)
            for (int k = 0; k < 2; k++) {
                low[k] = fmin(low[k], plane->rings[r].xy[i][k]);
                high[k] = fmax(high[k], plane->rings[r].xy[i][k]);
            }
    return plane->count ? hypot(high[0] - low[0], high[1] - low[1]) : 0.0;
}

double pp_daylight_curves_tolerance(const struct pp_region *plane)
{
    return fmax(1e-3, diagonal_of(plane) / 5000.0);
}

enum pp_status pp_daylight_curves(struct pp_daylight_plan *plan,
                                  const struct pp_world *world, double irc,
                                  const char *irc_name, const double *levels,
                                  int level_count, struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){0};
    struct contoured_plane scene = {world, irc_name ? irc : 0.0, 0.0};
    if (irc_name && !(isfinite(irc) && irc >= 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "internally reflected component is %g; contours need a number "
                       "of 0 or more",
                       irc);
    snprintf(plan->name, sizeof plan->name, "%s%s%s", pp_method_exact.name,
             irc_name ? "+" : "", irc_name ? irc_name : "");
    double diagonal = diagonal_of(&world->plane);
    double tolerance = pp_daylight_curves_tolerance(&world->plane);
    scene.inset_m = fmin(DAYLIGHT_INSET * diagonal, DAYLIGHT_INSET_MOST_M);
    enum pp_status status =
        add_contours(plan, &scene, tolerance, levels, level_count, err);
    scene.inset_m = SKY_INSET_M;
    if (status == PP_OK)
        status = add_no_sky_line(plan, &scene, tolerance, err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}

enum pp_status pp_daylight_curves_no_sky(struct pp_daylight_plan *plan,
                                         const struct pp_world *world,
                                         struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){0};
    struct contoured_plane scene = {world, 0.0, SKY_INSET_M};
    enum pp_status status =
        add_no_sky_line(plan, &scene, pp_daylight_curves_tolerance(&world->plane), err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}
