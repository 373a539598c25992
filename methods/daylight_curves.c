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

/* The distance from an upright opening at which the places before it are evaluated, over
 * the plane's diagonal, and at most (m). In a window's plane or under one the daylight
 * factor is not defined, and just before it all contours crowd together; the distance is
 * less than the thickness of a wall on the drawing. Elsewhere the plane's edge is evaluated
 * at SKY_INSET_M, so that lines meet walls as they are. */
#define DAYLIGHT_INSET (1.0 / 500.0)
#define DAYLIGHT_INSET_MOST_M 0.02
#define SKY_INSET_M 0.001

/* The context of the contoured functions. */
struct contoured_plane {
    const struct pp_world *world;
    const struct pp_outside_light *light; /* NULL: of the no-sky line */
    const struct pp_method *direct;
    const void *tools; /* the method's own */
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

/* The place moved off the upright openings that it lies before. */
static struct pp_vec3 off_openings(const struct pp_world *world, double inset_m,
                                   struct pp_vec3 place)
{
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if (fabs(opening->inner.normal.z) > 0.1)
            continue;
        double low = INFINITY, high = -INFINITY;
        for (int k = 0; k < opening->inner.count; k++) {
            double along = pp_vec_dot(opening->along, opening->inner.vertices[k]);
            low = fmin(low, along);
            high = fmax(high, along);
        }
        double along = pp_vec_dot(opening->along, place);
        double off = pp_vec_dot(pp_vec_sub(place, opening->inner.vertices[0]),
                                opening->inner.normal);
        if (along > low && along < high && off >= 0.0 && off < inset_m) {
            place.x += (inset_m - off) * opening->inner.normal.x;
            place.y += (inset_m - off) * opening->inner.normal.y;
        }
    }
    return place;
}

static enum pp_status daylight_at(void *context, double x, double y, double *value,
                                  struct pp_error *err)
{
    const struct contoured_plane *contoured = context;
    const struct pp_world *world = contoured->world;
    const struct pp_method *method = contoured->direct;
    struct pp_receiver receiver = {
        .position =
            off_openings(world, contoured->inset_m,
                         pp_daylight_curves_off_walls(
                             &world->plane, world->working_plane_m, SKY_INSET_M, x, y)),
        .normal = pp_vec(0, 0, 1)};
    *value = contoured->irc;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_part part = {0};
        enum pp_status status = (method->evaluate_roughly ? method->evaluate_roughly
                                                          : method->evaluate)(
            world, contoured->light, opening, &receiver, contoured->tools, &part, err);
        if (status == PP_OK && part.why)
            status = pp_fail(err, PP_BAD_INPUT, "%s: the opening on line %d %s",
                             method->name, opening->line, part.why);
        if (status != PP_OK)
            return status;
        *value += (part.sky + part.external)
                  * pp_allowance_factor(method->allowances, opening);
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

enum { LEVELS_USUAL = 9, LEVELS_MOST = 14 };

/* The most of the plane that is left without a line through it where a round level is at
 * hand. */
static const double largest_gap = 0.2;

/* The usual levels within the range, the highest LEVELS_USUAL of them; where fewer than
 * three are within, multiples of a round step. */
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

/* The round level between two that divides the area between them most evenly; 0: there is
 * none. */
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
            /* By way of the printed digits: 0.015, not its neighbour. */
            char digits[32];
            snprintf(digits, sizeof digits, "%.6g", steps[i] * power);
            double level = strtod(digits, NULL);
            double share = pp_field_share_below(field, level);
            double part = fmin(share - from, to - share);
            if (level > low * 1.0001 && level < high / 1.0001 && part > best) {
                best = part;
                found = level;
            }
        }
    return best > 0.25 * (to - from) ? found : 0.0;
}

/* Puts levels between the usual ones as long as much of the plane has none. */
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

/* A contoured function and what is wanted of it. */
struct contours_wanted {
    const struct pp_region *plane;
    pp_field_function values, errors; /* no errors: NULL */
    void *context;
    double tolerance;
    const double *levels;
    int level_count; /* 0: to be chosen */
};

/* The function plus or less its error, for a band's two edges. */
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

/* The part of the plane that is below a level with the errors taken off and not with them
 * added lies within one of it: both outlines filled even-odd. */
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

static double inset_of(const struct pp_region *plane)
{
    return fmin(DAYLIGHT_INSET * diagonal_of(plane), DAYLIGHT_INSET_MOST_M);
}

/* The contours of any function, and the no-sky line. */
static enum pp_status add_all(struct pp_daylight_plan *plan,
                              const struct pp_world *world,
                              const struct contours_wanted *wanted,
                              struct pp_error *err)
{
    struct contoured_plane sky = {.world = world, .inset_m = SKY_INSET_M};
    enum pp_status status = add_contours(plan, wanted, err);
    if (status == PP_OK)
        status = add_no_sky_line(plan, &sky, wanted->tolerance, err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}

/* Why the method does not cover the room. */
static enum pp_status check_method(const struct pp_method *method,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   struct pp_error *err)
{
    const char *why =
        method->refuses_room ? method->refuses_room(world, light, NULL) : NULL;
    if (why)
        return pp_fail(err, PP_BAD_INPUT, "%s: %s", method->name, why);
    for (int i = 0; i < world->opening_count && method->refuses; i++) {
        why = method->refuses(world, light, &world->openings[i], NULL);
        if (why)
            return pp_fail(err, PP_BAD_INPUT, "%s: the opening on line %d %s",
                           method->name, world->openings[i].line, why);
    }
    return PP_OK;
}

enum pp_status pp_daylight_curves_by(struct pp_daylight_plan *plan,
                                     const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_method *direct, double irc,
                                     const char *irc_name, const double *levels,
                                     int level_count, struct pp_error *err)
{
    *plan = (struct pp_daylight_plan){.direct = !irc_name};
    if (irc_name && !(isfinite(irc) && irc >= 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "internally reflected component is %g; contours need a number "
                       "of 0 or more",
                       irc);
    snprintf(plan->name, sizeof plan->name, "%s%s%s", direct->name, irc_name ? "+" : "",
             irc_name ? irc_name : "");
    void *tools = NULL;
    enum pp_status status = check_method(direct, world, light, err);
    if (status == PP_OK && direct->prepare_for_plane)
        status = direct->prepare_for_plane(&tools, world, light, err);
    else if (status == PP_OK && direct->prepare)
        status = direct->prepare(&tools, world, light, err);
    if (status != PP_OK)
        return status;
    struct contoured_plane contoured = {.world = world,
                                        .light = light,
                                        .direct = direct,
                                        .tools = tools,
                                        .irc = irc_name ? irc : 0.0,
                                        .inset_m = inset_of(&world->plane)};
    const struct contours_wanted wanted = {
        .plane = &world->plane,
        .values = daylight_at,
        .context = &contoured,
        .tolerance = pp_daylight_curves_tolerance(&world->plane),
        .levels = levels,
        .level_count = level_count};
    status = add_all(plan, world, &wanted, err);
    if (direct->destroy_tools)
        direct->destroy_tools(tools);
    return status;
}

enum pp_status pp_daylight_curves(struct pp_daylight_plan *plan,
                                  const struct pp_world *world,
                                  const struct pp_outside_light *light, double irc,
                                  const char *irc_name, const double *levels,
                                  int level_count, struct pp_error *err)
{
    return pp_daylight_curves_by(plan, world, light, &pp_method_exact, irc, irc_name,
                                 levels, level_count, err);
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
    struct contoured_plane contoured = {.world = world, .inset_m = SKY_INSET_M};
    enum pp_status status = add_no_sky_line(
        plan, &contoured, pp_daylight_curves_tolerance(&world->plane), err);
    if (status != PP_OK)
        pp_daylight_plan_clear(plan);
    return status;
}
