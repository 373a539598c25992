/* estimate.c - standard errors, bounds on light that was never found, and plans. */
#include "simulate/tracer/estimate.h"

#include <math.h>

const double PP_LEAST_ERROR = 0.00002;

/* The plan is for this share of the error asked for, since its variances are estimates.
 * Chosen by trial. */
static const double PLANNED_SHARE = 0.92;

/* How the variance of a randomisation's mean falls with its paths, n to the minus
 * this: chosen on the safe side. */
static const double FALL[PP_ESTIMATORS] = {1.5, 1.2, 1.05};

/* The cost of a path beside its rays, in rays. Chosen by trial. */
static const double PATH_COST = 1.0;

double pp_estimate_student_factor(int count)
{
    return sqrt((count - 1.0) / (count - 3.0));
}

/* Mean and variance of some figure of the begun randomisations; returns how many there
 * are. */
struct randomisation_spread {
    double mean, variance;
    int count;
};

static struct randomisation_spread spread_of(
    const struct pp_randomisation *randomisations, int count,
    double (*value)(const struct pp_randomisation *, int), int which)
{
    struct randomisation_spread spread = {0.0, 0.0, 0};
    for (int i = 0; i < count; i++)
        if (pp_randomisation_is_begun(&randomisations[i])) {
            spread.mean += value(&randomisations[i], which);
            spread.count++;
        }
    if (spread.count < 2)
        return spread;
    spread.mean /= spread.count;
    for (int i = 0; i < count; i++)
        if (pp_randomisation_is_begun(&randomisations[i])) {
            double off = value(&randomisations[i], which) - spread.mean;
            spread.variance += off * off;
        }
    spread.variance /= spread.count - 1;
    return spread;
}

struct pp_reading pp_estimate(const struct pp_randomisation *randomisations, int count,
                              int component, const struct pp_component_bound *most)
{
    struct randomisation_spread spread =
        spread_of(randomisations, count, pp_randomisation_value, component);
    if (spread.count < 4)
        return pp_reading_none("not sampled yet");
    struct pp_reading reading = {.value = spread.mean};
    reading.std_error =
        sqrt(spread.variance / spread.count) * pp_estimate_student_factor(spread.count);
    if (reading.std_error > 1e-15 * fabs(spread.mean))
        return reading;

    double could = 0.0, paths = 0.0;
    for (int i = 0; i < 3; i++)
        if (component == i || component == PP_DF)
            could += most->part[i];
    for (int i = 0; i < count; i++)
        paths +=
            randomisations[i].done.of[component == PP_IRC ? PP_CORRECTION : PP_DIRECT];
    reading.std_error = could > 0.0 ? fmax(could, fabs(spread.mean)) / paths : 0.0;
    return reading;
}

/* ---- bounds ---- */

/* About the daylight factor by an opening if nothing stood before it: pi times the
 * luminance of an overcast horizon is 3/7 of Eh, the unit of the importance. */
static double share_of(const struct pp_ray_scene *scene, const struct pp_start *start,
                       const struct pp_pane *pane)
{
    if (start->anywhere)
        return fmin(1.0, pane->target.area_m2 / scene->plane_area_m2);
    struct pp_brightness even = {.ground = 1.0};
    return fmin(1.0, 3.0 / (7.0 * PP_PI)
                         * pp_sample_polygon_importance(&pane->target, start->position,
                                                        start->normal, even));
}

/* Does the point see the opening in a direction that rises (falls)? On the safe side:
 * an opening partly behind the point's own plane counts whole. */
static bool shows(const struct pp_start *start, const struct pp_pane *pane, bool rising)
{
    const struct pp_target *target = &pane->target;
    struct pp_vec3 n = start->normal;
    if (pane->opening->glass.diffusing || start->anywhere)
        return rising || pane->opening->glass.diffusing;
    if (!rising && n.z > 0.0 && n.x == 0.0 && n.y == 0.0)
        return false;
    for (int i = 0; i < target->triangle_count; i++)
        for (int k = 0; k < 3; k++) {
            double over = target->triangles[i][k].z - start->position.z;
            if (rising ? over > 0.0 : over < 0.0)
                return true;
        }
    return false;
}

struct pp_component_bound pp_estimate_bound(const struct pp_ray_scene *scene,
                                            const struct pp_start *start)
{
    struct pp_component_bound most = {{0.0, 0.0, 0.0}};
    double exitance = scene->most_exitance;
    if (!scene->has_room) {
        most.part[PP_SC] = 1.0;
        most.part[PP_ERC] = 1.0 + exitance;
        return most;
    }
    double area = 0.0;
    bool skylines = scene->environment.far_count + scene->environment.near_count > 0;
    for (int i = 0; i < scene->pane_count; i++) {
        const struct pp_pane *pane = &scene->panes[i];
        double share = share_of(scene, start, pane);
        if (shows(start, pane, true))
            most.part[PP_SC] += share;
        if (!pane->unobstructed || skylines || shows(start, pane, false))
            most.part[PP_ERC] += share * (1.0 + exitance);
        area += pane->target.area_m2;
    }
    if (exitance > 0.0 || (area > 0.0 && scene->reflects))
        most.part[PP_IRC] =
            scene->decorations
            * (exitance + fmin(1.0, area / (scene->size_m * scene->size_m)));
    return most;
}

/* ---- plans ---- */

static double part_of(const struct pp_randomisation *randomisation, int estimator)
{
    return pp_randomisation_part(randomisation, (enum pp_estimator)estimator);
}

/* Variances of the estimators, with what one path costs. */
struct outlook {
    double variance[PP_ESTIMATORS], cost[PP_ESTIMATORS];
};

static struct outlook look(const struct pp_randomisation *randomisations, int count)
{
    struct outlook outlook;
    for (int k = 0; k < PP_ESTIMATORS; k++) {
        outlook.variance[k] = spread_of(randomisations, count, part_of, k).variance;
        double rays = 0.0, paths = 0.0;
        for (int i = 0; i < count; i++) {
            rays += (double)randomisations[i].rays[k];
            paths += randomisations[i].done.of[k];
        }
        outlook.cost[k] = rays / paths + PATH_COST;
    }
    return outlook;
}

static double total_variance(const struct outlook *outlook)
{
    double sum = 0.0;
    for (int k = 0; k < PP_ESTIMATORS; k++)
        sum += outlook->variance[k];
    return sum;
}

static double total_cost(const struct outlook *outlook, struct pp_counts counts)
{
    double sum = 0.0;
    for (int k = 0; k < PP_ESTIMATORS; k++)
        sum += outlook->cost[k] * counts.of[k];
    return sum;
}

/* Twice the paths of estimator k. */
static void double_paths(struct outlook *outlook, struct pp_counts *counts, int k)
{
    counts->of[k] *= 2;
    outlook->variance[k] *= pow(2.0, -FALL[k]);
}

/* The estimator whose doubling takes away most variance for its cost; -1: none. */
static int most_rewarding(const struct outlook *outlook, struct pp_counts counts)
{
    int best = -1;
    double most = 0.0;
    for (int k = 0; k < PP_ESTIMATORS; k++) {
        double gain = outlook->variance[k] * (1.0 - pow(2.0, -FALL[k]))
                      / (outlook->cost[k] * counts.of[k]);
        if (gain > most && counts.of[k] < PP_MOST_PATHS) {
            best = k;
            most = gain;
        }
    }
    return best;
}

struct pp_plan pp_estimate_plan(const struct pp_randomisation *randomisations,
                                int count, double error, struct pp_counts least)
{
    struct outlook outlook = look(randomisations, count);
    struct pp_counts counts = randomisations[0].done;
    /* The variance that one of so few randomisations may have. */
    double planned =
        PLANNED_SHARE * error / pp_estimate_student_factor(PP_RANDOMISATIONS);
    double allowed = planned * planned * PP_RANDOMISATIONS;

    for (int k = 0; k < PP_ESTIMATORS; k++)
        while (counts.of[k] < least.of[k])
            double_paths(&outlook, &counts, k);

    struct pp_plan plan = {counts, 0};
    double cheapest = INFINITY;
    for (;;) {
        double variance = total_variance(&outlook);
        double more = fmax(1.0, variance / allowed);
        int next = variance > allowed ? most_rewarding(&outlook, counts) : -1;
        if (more <= 2.0 || next < 0) {
            int wanted = (int)ceil(PP_RANDOMISATIONS * fmin(more, 1000.0));
            double cost = wanted * total_cost(&outlook, counts);
            if (cost < cheapest) {
                cheapest = cost;
                plan = (struct pp_plan){counts, wanted};
            }
        }
        if (next < 0)
            return plan;
        double_paths(&outlook, &counts, next);
    }
}
