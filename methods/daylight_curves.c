/* daylight_curves.c - contours of the daylight factor by `exact` and of the solid angle
 * of the visible sky, traced by model/geometry/contour. */
#include "methods/daylight_curves.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/contour/contour.h"
#include "methods/exact/exterior.h"
#include "methods/method.h"
#include "model/geometry/bounds.h"

/* The solid angle (sr) from which on sky counts as seen: that of a slit of a metre by a
 * micrometre at 30 m. */
#define NO_SKY_SR 1e-9

/* The distance from the walls at which the plane's edge is evaluated, over the plane's
 * diagonal, and at most (m). On the edge, in a window's plane or under one, the
 * daylight factor is not defined, and just before the edge all contours crowd together;
 * the distance is less than the thickness of a wall on the drawing. */
#define DAYLIGHT_INSET (1.0 / 500.0)
#define DAYLIGHT_INSET_MOST_M 0.02
#define SKY_INSET_M 0.001

/* The context of the contoured functions. */
struct contoured_plane {
    const struct pp_world *world;
    double irc;
    double inset_m;
};

/* The region's interior lies on the left of its rings. */
struct pp_vec3 pp_daylight_curves_off_walls(const struct pp_region *plane, double z,
                                            double inset_m, double x, double y)
{
    struct pp_vec3 moved = pp_vec(x, y, z);
    for (int r = 0; r < plane->count; r++)
        for (int i = 0; i < plane->rings[r].count; i++) {
            const double *a = plane->rings[r].xy[i];
            const double *b = plane->rings[r].xy[(i + 1) % plane->rings[r].count];
            double dx = b[0] - a[0], dy = b[1] - a[1], length = hypot(dx, dy);
            double share = ((x - a[0]) * dx + (y - a[1]) * dy) / (length * length);
            share = fmin(fmax(share, 0.0), 1.0);
            double off = hypot(a[0] + share * dx - x, a[1] + share * dy - y);
            if (off >= inset_m)
                continue;
            moved.x -= dy / length * (inset_m - off);
            moved.y += dx / length * (inset_m - off);
        }
    return moved;
}

/* ---- the contoured functions ---- */

static enum pp_status daylight_at(void *context, double x, double y, double *value,
                                  struct pp_error *err)
{
    const struct contoured_plane *contoured = context;
    const struct pp_world *world = contoured->world;
    struct pp_receiver receiver = {
        .position = pp_daylight_curves_off_walls(&world->plane, world->working_plane_m,
                                                 contoured->inset_m, x, y),
        .normal = pp_vec(0, 0, 1)};
    *value = contoured->irc;
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
    const struct contoured_plane *contoured = context;
    const struct pp_world *world = contoured->world;
    struct pp_vec3 eye = pp_daylight_curves_off_walls(
        &world->plane, world->working_plane_m, contoured->inset_m, x, y);
    return pp_exterior_sky_solid_angle(value, world, eye, err);
}

/* ---- levels ---- */

enum { LEVELS_MOST = 9 };

/* The usual levels within the range, the highest LEVELS_MOST of them; where fewer than
 * three are within, multiples of a round step. */
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
                                   struct contoured_plane *contoured, double tolerance,
                                   const double *levels, int level_count,
                                   struct pp_error *err)
{
    struct pp_field *field;
    double usual[LEVELS_MOST];
    enum pp_status status = pp_field_create(&field, &contoured->world->plane,
                                            daylight_at, contoured, tolerance, err);
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
    /* Refining near the levels may have found a higher or lower point. */
    pp_field_range(field, &plan->lowest, plan->lowest_xy, &plan->highest,
                   plan->highest_xy);
    pp_field_destroy(field);
    return status;
}

static enum pp_status add_no_sky_line(struct pp_daylight_plan *plan,
                                      struct contoured_plane *contoured,
                                      double tolerance, struct pp_error *err)
{
    struct pp_field *field;
    enum pp_status status = pp_field_create(&field, &contoured->world->plane,
                                            sky_seen_at, contoured, tolerance, err);
    if (status != PP_OK)
        return status;
    status = pp_contour_curves(field, NO_SKY_SR, &plan->no_sky, err);
    if (status == PP_OK)
        status = pp_contour_below(field, NO_SKY_SR, &plan->dark, err);
    pp_field_destroy(field);
    double share =
        pp_curve_list_area(&plan->dark) / pp_region_area(&contoured->world->plane);
    plan->sky_share = fmin(fmax(1.0 - share, 0.0), 1.0);
    return status;
}

static double diagonal_of(const struct pp_region *plane)
{
    struct pp_bounds2 box = pp_bounds2_empty();
    for (int r = 0; r < plane->count; r++)
        for (int i = 0; i < plane->rings[r].count; i++)
            pp_bounds2_add(&box, plane->rings[r].xy[i][0], plane->rings[r].xy[i][1]);
    return plane->count ? hypot(box.high[0] - box.low[0], box.high[1] - box.low[1])
                        : 0.0;
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
    struct contoured_plane contoured = {world, irc_name ? irc : 0.0, 0.0};
    if (irc_name && !(isfinite(irc) && irc >= 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "internally reflected component is %g; contours need a number "
                       "of 0 or more",
                       irc);
    snprintf(plan->name, sizeof plan->name, "%s%s%s", pp_method_exact.name,
             irc_name ? "+" : "", irc_name ? irc_name : "");
    double diagonal = diagonal_of(&world->plane);
    double tolerance = pp_daylight_curves_tolerance(&world->plane);
    contoured.inset_m = fmin(DAYLIGHT_INSET * diagonal, DAYLIGHT_INSET_MOST_M);
    enum pp_status status =
        add_contours(plan, &contoured, tolerance, levels, level_count, err);
    contoured.inset_m = SKY_INSET_M;
    if (status == PP_OK)
        status = add_no_sky_line(plan, &contoured, tolerance, err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}

enum pp_status pp_daylight_curves_no_sky(struct pp_daylight_plan *plan,
                                         const struct pp_world *world,
                                         struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){0};
    struct contoured_plane contoured = {world, 0.0, SKY_INSET_M};
    enum pp_status status = add_no_sky_line(
        plan, &contoured, pp_daylight_curves_tolerance(&world->plane), err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}
