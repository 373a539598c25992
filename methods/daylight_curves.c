/* daylight_curves.c - contours of the daylight factor and of the solid angle of the
 * visible sky, traced by model/geometry/contour. */
#include "methods/daylight_curves.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/contour/contour.h"
#include "methods/direct_plane.h"
#include "methods/exact/exterior.h"
#include "methods/method.h"
#include "model/geometry/bounds.h"

/* Least solid angle (sr) at which sky counts as visible: about that of a slit 1 m long
 * and 0.001 mm wide at 30 m. */
#define NO_SKY_SR 1e-9

/* Least distance (m) from the plane's edge at which the view of the sky is evaluated.
 * Nearer points have the value at this distance, so that contours reach the walls. */
#define SKY_INSET_M 0.001

/* A direct component, and a constant to add to it everywhere. */
struct added_to {
    const struct pp_direct_plane *direct;
    double irc;
    struct pp_stop stop;
};

struct sky_seen {
    const struct pp_world *world;
    struct pp_stop stop;
};

/* ---- the contoured functions ---- */

static enum pp_status daylight_at(void *context, double x, double y, double *value,
                                  struct pp_error *err)
{
    const struct added_to *added = context;
    double sky = 0.0, external = 0.0;
    enum pp_status status = pp_stop_check(added->stop, err);
    if (status == PP_OK)
        status = pp_direct_plane_at(added->direct, x, y, &sky, &external, err);
    *value = added->irc + sky + external;
    return status;
}

static enum pp_status sky_seen_at(void *context, double x, double y, double *value,
                                  struct pp_error *err)
{
    const struct sky_seen *seen = context;
    const struct pp_world *world = seen->world;
    if (pp_stop_check(seen->stop, err) != PP_OK)
        return PP_INTERRUPTED;
    struct pp_vec3 eye = pp_direct_plane_off_walls(
        &world->plane, world->working_plane_m, SKY_INSET_M, x, y);
    return pp_exterior_sky_solid_angle(value, world, eye, err);
}

/* ---- levels ---- */

enum { LEVELS_USUAL = 9, LEVELS_MOST = 14 };

/* Largest fraction of the plane's area between two contours. It may be exceeded only if
 * no round level divides that area. */
static const double largest_gap = 0.2;

/* Chooses the usual levels within the range, at most the highest LEVELS_USUAL of them;
 * if there are fewer than three, multiples of a round step. Returns the number of
 * levels. */
static int choose_levels(double levels[LEVELS_MOST], double low, double high)
{
    static const double percent[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05,
                                     0.1,   0.2,   0.5,   1,    2,    3,
                                     5,     10,    20,    30,   50,   100};
    int count = 0;
    for (int i = 17; i >= 0 && count < LEVELS_USUAL; i--)
        if (percent[i] / 100.0 > low && percent[i] / 100.0 < high)
            levels[LEVELS_USUAL - 1 - count++] = percent[i] / 100.0;
    memmove(levels, levels + LEVELS_USUAL - count, (size_t)count * sizeof *levels);
    if (count >= 3 || !(high - low > 1e-7))
        return count;

    double least = (high - low) / 6.0, power = pow(10.0, floor(log10(least)));
    double step = least <= 2.0 * power   ? 2.0 * power
                  : least <= 5.0 * power ? 5.0 * power
                                         : 10.0 * power;
    count = 0;
    for (double i = floor(low / step) + 1.0; i * step < high && count < LEVELS_USUAL;
         i += 1.0)
        levels[count++] = i * step;
    return count;
}

/* The round level between two levels that divides the area between them most evenly.
 * Returns 0 if that area is small or no round level divides it well. */
static double level_between(const struct pp_field *field, double low, double high)
{
    static const double steps[] = {1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6,
                                   1.8, 2.0, 2.2, 2.5, 2.7, 3.0, 3.5,
                                   4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0};
    enum { STEPS = sizeof steps / sizeof *steps };
    double from = pp_field_share_below(field, low);
    double to = pp_field_share_below(field, high), best = 0.0, found = 0.0;
    if (to - from <= largest_gap)
        return 0.0;
    double power = pow(10.0, floor(log10(fmax(low, 1e-6 * high))));
    for (; power < high; power *= 10.0)
        for (int i = 0; i < STEPS; i++) {
            /* Converts by way of the printed digits, to get the double nearest to 0.015
             * and not its neighbour. */
            char digits[32];
            snprintf(digits, sizeof digits, "%.6g", steps[i] * power);
            double level = strtod(digits, NULL);
            if (!(level > low * 1.0001 && level < high / 1.0001))
                continue;
            double share = pp_field_share_below(field, level);
            double part = fmin(share - from, to - share);
            if (part > best) {
                best = part;
                found = level;
            }
        }
    return best > 0.25 * (to - from) ? found : 0.0;
}

/* Inserts levels between the usual ones while more than largest_gap of the plane lies
 * between two contours. */
static int divide_gaps(double levels[LEVELS_MOST], int count,
                       const struct pp_field *field, double low, double high)
{
    for (int i = 0; i <= count && count < LEVELS_MOST;) {
        double more =
            level_between(field, i ? levels[i - 1] : low, i < count ? levels[i] : high);
        if (more == 0.0) {
            i++;
            continue;
        }
        memmove(levels + i + 1, levels + i, (size_t)(count - i) * sizeof *levels);
        levels[i] = more;
        count++;
    }
    return count;
}

/* ---- the plan ---- */

/* A function to contour and the requested curves. */
struct contours_wanted {
    const struct pp_region *plane;
    pp_field_function values, errors; /* errors NULL: no bands */
    void *context;
    double tolerance;
    const double *levels;
    int level_count; /* 0: chosen by the program */
    struct pp_stop stop;
};

/* The function plus or minus its standard error: the two edges of a band. */
struct band_edge {
    const struct contours_wanted *of;
    double errors;
};

static enum pp_status edge_at(void *context, double x, double y, double *value,
                              struct pp_error *err)
{
    const struct band_edge *edge = context;
    double error = 0.0;
    enum pp_status status = edge->of->values(edge->of->context, x, y, value, err);
    if (status == PP_OK)
        status = edge->of->errors(edge->of->context, x, y, &error, err);
    *value += edge->errors * error;
    return status;
}

/* Adds uncertainty bands: the area where the level lies between value - error and value
 * + error. Both outlines are filled by the even-odd rule. */
static enum pp_status add_bands(struct pp_daylight_plan *plan,
                                const struct contours_wanted *wanted,
                                const double *levels, int level_count,
                                struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int side = -1; side <= 1 && status == PP_OK; side += 2) {
        struct band_edge edge = {wanted, side};
        struct pp_field *field;
        status = pp_field_create(&field, wanted->plane, edge_at, &edge,
                                 wanted->tolerance, err);
        if (status != PP_OK)
            return status;
        for (int i = 0; i < level_count && status == PP_OK; i++)
            status = pp_contour_below(field, levels[i], &plan->bands, err);
        pp_field_destroy(field);
    }
    return status;
}

static enum pp_status add_contours(struct pp_daylight_plan *plan,
                                   const struct contours_wanted *wanted,
                                   struct pp_error *err)
{
    struct pp_field *field;
    double usual[LEVELS_MOST];
    const double *levels = wanted->levels;
    int level_count = wanted->level_count;
    enum pp_status status = pp_field_create(&field, wanted->plane, wanted->values,
                                            wanted->context, wanted->tolerance, err);
    if (status != PP_OK)
        return status;
    pp_field_range(field, &plan->lowest, plan->lowest_xy, &plan->highest,
                   plan->highest_xy);
    if (level_count == 0) {
        level_count = choose_levels(usual, plan->lowest, plan->highest);
        level_count =
            divide_gaps(usual, level_count, field, plan->lowest, plan->highest);
        levels = usual;
    }
    for (int i = 0; i < level_count && status == PP_OK; i++)
        status = pp_contour_curves(field, levels[i], &plan->contours, err);
    for (int i = 0; i < level_count && status == PP_OK; i++)
        status = pp_contour_below(field, levels[i], &plan->below, err);
    /* Refining near the levels may have found a higher or lower point. */
    pp_field_range(field, &plan->lowest, plan->lowest_xy, &plan->highest,
                   plan->highest_xy);
    pp_field_destroy(field);
    if (status == PP_OK && wanted->errors)
        status = add_bands(plan, wanted, levels, level_count, err);
    return status;
}

static enum pp_status add_no_sky_line(struct pp_daylight_plan *plan,
                                      const struct pp_world *world, double tolerance,
                                      struct pp_stop stop, struct pp_error *err)
{
    struct pp_field *field;
    struct sky_seen seen = {world, stop};
    enum pp_status status =
        pp_field_create(&field, &world->plane, sky_seen_at, &seen, tolerance, err);
    if (status != PP_OK)
        return status;
    status = pp_contour_curves(field, NO_SKY_SR, &plan->no_sky, err);
    if (status == PP_OK)
        status = pp_contour_below(field, NO_SKY_SR, &plan->dark, err);
    pp_field_destroy(field);
    double share = pp_curve_list_area(&plan->dark) / pp_region_area(&world->plane);
    plan->sky_share = fmin(fmax(1.0 - share, 0.0), 1.0);
    return status;
}

double pp_daylight_curves_tolerance(const struct pp_region *plane)
{
    const struct pp_bounds2 box = pp_region_bounds(plane);
    double diagonal =
        plane->count ? hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]) : 0.0;
    return fmax(1e-3, diagonal / 5000.0);
}

/* Adds the contours of a function and the no-sky line. Clears the plan on failure. */
static enum pp_status add_all(struct pp_daylight_plan *plan,
                              const struct pp_world *world,
                              const struct contours_wanted *wanted,
                              struct pp_error *err)
{
    enum pp_status status = add_contours(plan, wanted, err);
    if (status == PP_OK)
        status = add_no_sky_line(plan, world, wanted->tolerance, wanted->stop, err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}

enum pp_status pp_daylight_curves_by(
    struct pp_daylight_plan *plan, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_method *direct, double irc,
    const char *irc_name, struct pp_daylight_curves_choice choice, struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){.direct = !irc_name};
    if (irc_name && !(isfinite(irc) && irc >= 0.0))
        return pp_fail(
            err, PP_BAD_INPUT,
            "the internally reflected component is %g; contours need a value of 0 or "
            "more",
            irc);
    snprintf(plan->name, sizeof plan->name, "%s%s%s", direct->name, irc_name ? "+" : "",
             irc_name ? irc_name : "");
    struct pp_direct_plane *plane;
    enum pp_status status = pp_direct_plane_create(&plane, world, light, direct, err);
    if (status != PP_OK)
        return status;
    struct added_to added = {
        .direct = plane, .irc = irc_name ? irc : 0.0, .stop = choice.stop};
    const struct contours_wanted wanted = {
        .plane = &world->plane,
        .values = daylight_at,
        .context = &added,
        .tolerance = choice.tolerance_m > 0.0
                         ? choice.tolerance_m
                         : pp_daylight_curves_tolerance(&world->plane),
        .levels = choice.levels,
        .level_count = choice.level_count,
        .stop = choice.stop};
    status = add_all(plan, world, &wanted, err);
    pp_direct_plane_destroy(plane);
    return status;
}

enum pp_status pp_daylight_curves(struct pp_daylight_plan *plan,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light, double irc,
                                  const char *irc_name, const double *levels,
                                  int level_count, struct pp_error *err)
{
    return pp_daylight_curves_by(plan, world, light, &pp_method_exact, irc, irc_name,
                                 (struct pp_daylight_curves_choice){
                                     .levels = levels, .level_count = level_count},
                                 err);
}

enum pp_status pp_daylight_curves_of(struct pp_daylight_plan *plan,
                                     const struct pp_world *world, const char *name,
                                     pp_field_function values, pp_field_function errors,
                                     void *context, struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){0};
    snprintf(plan->name, sizeof plan->name, "%s", name);
    const struct contours_wanted wanted = {
        .plane = &world->plane,
        .values = values,
        .errors = errors,
        .context = context,
        .tolerance = pp_daylight_curves_tolerance(&world->plane)};
    return add_all(plan, world, &wanted, err);
}

enum pp_status pp_daylight_curves_no_sky(struct pp_daylight_plan *plan,
                                         const struct pp_world *world,
                                         struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){0};
    enum pp_status status =
        add_no_sky_line(plan, world, pp_daylight_curves_tolerance(&world->plane),
                        (struct pp_stop){0}, err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}
