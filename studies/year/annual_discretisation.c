/* annual_discretisation.c - the error of patches and cells, on a sample of points and
 * hours.
 *
 * Paths evaluated with the true sky and sun (plain_year.h) are the reference. The same
 * paths are evaluated with the sky by patches: the difference has hardly any noise. The
 * difference between the year's own values and the reference has the noise of both.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/sampling/hash.h"
#include "studies/year/annual_work.h"

enum { POINTS_MOST = 8, HOURS_MOST = 16, PATHS = 256 };

/* Light of a sample point in a sample hour, by batch. sky, by_patch: from sky and
 * ground, with the true sky and by patches. all, of_year: all light except direct sun,
 * of the reference and of the year. */
struct sampled_light {
    double sky[PP_YEAR_BATCHES], by_patch[PP_YEAR_BATCHES], all[PP_YEAR_BATCHES],
        of_year[PP_YEAR_BATCHES];
};

struct discretisation_work {
    struct pp_annual_work *work;
    struct pp_plain_year *plain;
    struct pp_light_columns columns; /* columns of the sample's hours */
    int point_count, hour_count;
    int points[POINTS_MOST], hours[HOURS_MOST];
    struct pp_perez_sky skies[HOURS_MOST];
    struct sampled_light light[POINTS_MOST][HOURS_MOST];
    enum pp_status status[POINTS_MOST];
};

/* Chooses an index at random from each of `count` equal parts of the range 0 to all -
 * 1. */
static void choose(int *list, int count, int all, uint64_t seed)
{
    for (int i = 0; i < count; i++) {
        double part = ldexp((double)(pp_hash(seed, (uint64_t)i) >> 11), -53);
        list[i] = (int)((i + part) * all / count);
    }
}

/* Sum over groups of the light of one batch in one hour. */
static double sum_at(const float *rows, int groups, size_t step, int batch, int hour)
{
    double sum = 0.0;
    for (int g = 0; g < groups; g++)
        sum += rows[(size_t)(g * PP_YEAR_BATCHES + batch) * step + (size_t)hour];
    return sum;
}

static enum pp_status sample_paths(struct discretisation_work *d, int p,
                                   struct pp_year_point *point)
{
    int groups = d->work->groups.count;
    size_t step = (size_t)d->columns.tiles * PP_LIGHT_LANES;
    enum pp_status status =
        pp_plain_year_point(d->plain, d->points[p], &d->columns, false, point, NULL);
    if (status != PP_OK)
        return status;
    for (int t = 0; t < d->hour_count; t++)
        for (int b = 0; b < PP_YEAR_BATCHES; b++) {
            struct sampled_light *light = &d->light[p][t];
            light->sky[b] = sum_at(point->sky, groups, step, b, t);
            light->all[b] = light->sky[b] + sum_at(point->sun, groups, step, b, t);
        }
    status =
        pp_plain_year_point(d->plain, d->points[p], &d->columns, true, point, NULL);
    for (int t = 0; t < d->hour_count && status == PP_OK; t++)
        for (int b = 0; b < PP_YEAR_BATCHES; b++)
            d->light[p][t].by_patch[b] = sum_at(point->sky, groups, step, b, t);
    return status;
}

static enum pp_status sample_year(struct discretisation_work *d, int p,
                                  struct pp_year_point *point)
{
    const struct pp_annual_state *open = &d->work->open;
    int groups = d->work->groups.count;
    size_t row =
        (size_t)d->points[p] * (size_t)groups * (size_t)open->columns.column_count;
    enum pp_status status = pp_year_coefficients_sky(
        open->coefficients, d->points[p], 1, open->direct + row, point->sky, NULL);
    if (status == PP_OK)
        status = pp_year_coefficients_sun(open->coefficients, d->points[p], 1,
                                          point->sun, NULL);
    for (int t = 0; t < d->hour_count && status == PP_OK; t++)
        for (int b = 0; b < PP_YEAR_BATCHES; b++)
            d->light[p][t].of_year[b] =
                sum_at(point->sky, groups, open->step, b, d->hours[t])
                + sum_at(point->sun, groups, open->step, b, d->hours[t]);
    return status;
}

static bool sample_point(void *data, int worker, int p)
{
    (void)worker;
    struct discretisation_work *d = data;
    size_t numbers =
        (size_t)d->work->groups.count * PP_YEAR_BATCHES * d->work->open.step + 1;
    struct pp_year_point point = {malloc(numbers * sizeof(float)),
                                  malloc(numbers * sizeof(float))};
    d->status[p] = point.sky && point.sun ? PP_OK : PP_SYSTEM;
    if (d->status[p] == PP_OK)
        d->status[p] = sample_paths(d, p, &point);
    if (d->status[p] == PP_OK)
        d->status[p] = sample_year(d, p, &point);
    free(point.sky);
    free(point.sun);
    return d->status[p] == PP_OK;
}

/* ---- errors ---- */

/* Sum of the values of all batches except `left` (-1: of all), over a point's hours
 * from `first` to end - 1. */
static double light_of_hours(const struct discretisation_work *d, int p, size_t member,
                             int first, int end, int left)
{
    double sum = 0.0;
    for (int t = first; t < end; t++) {
        const double *values = (const double *)((const char *)&d->light[p][t] + member);
        for (int b = 0; b < PP_YEAR_BATCHES; b++)
            sum += b == left ? 0.0 : values[b];
    }
    return sum;
}

/* Mean over the points of (value - reference)/reference, over all hours; left_...: the
 * batch left out of each. */
static double mean_error(const struct discretisation_work *d, size_t value,
                         size_t reference, int left_value, int left_reference)
{
    double sum = 0.0;
    int count = 0, hours = d->hour_count;
    for (int p = 0; p < d->point_count; p++) {
        double a = light_of_hours(d, p, value, 0, hours, left_value);
        double b = light_of_hours(d, p, reference, 0, hours, left_reference);
        a /= PP_YEAR_BATCHES - (left_value >= 0);
        b /= PP_YEAR_BATCHES - (left_reference >= 0);
        if (b > 0.0) {
            sum += a / b - 1.0;
            count++;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

#define LIGHT(member) offsetof(struct sampled_light, member)

static double hourly_rms(const struct discretisation_work *d)
{
    double squares = 0.0;
    int count = 0;
    for (int p = 0; p < d->point_count; p++)
        for (int t = 0; t < d->hour_count; t++) {
            double a = light_of_hours(d, p, LIGHT(by_patch), t, t + 1, -1);
            double b = light_of_hours(d, p, LIGHT(sky), t, t + 1, -1);
            if (b > 0.0) {
                squares += (a / b - 1.0) * (a / b - 1.0);
                count++;
            }
        }
    return count > 0 ? sqrt(squares / count) : 0.0;
}

static void judge_sample(struct discretisation_work *d)
{
    double patches[PP_YEAR_BATCHES], of_year[PP_YEAR_BATCHES], paths[PP_YEAR_BATCHES];
    for (int b = 0; b < PP_YEAR_BATCHES; b++) {
        patches[b] = mean_error(d, LIGHT(by_patch), LIGHT(sky), b, b);
        of_year[b] = mean_error(d, LIGHT(of_year), LIGHT(all), b, -1);
        paths[b] = mean_error(d, LIGHT(of_year), LIGHT(all), -1, b);
    }
    d->work->sheet->discretisation = (struct pp_annual_discretisation){
        .points = d->point_count,
        .hours = d->hour_count,
        .sky = {mean_error(d, LIGHT(by_patch), LIGHT(sky), -1, -1),
                pp_year_metrics_error(patches, PP_YEAR_BATCHES)},
        .sky_rms = hourly_rms(d),
        .all = {mean_error(d, LIGHT(of_year), LIGHT(all), -1, -1),
                hypot(pp_year_metrics_error(of_year, PP_YEAR_BATCHES),
                      pp_year_metrics_error(paths, PP_YEAR_BATCHES))}};
}

/* ---- the measurement ---- */

static void choose_sample(struct discretisation_work *d)
{
    const struct pp_annual_work *work = d->work;
    uint64_t seed = pp_hash(work->options->seed, UINT64_C(0xd15c));
    int skies = work->year->sky_count, points = work->receiver_count;
    d->point_count = points < POINTS_MOST ? points : POINTS_MOST;
    d->hour_count = skies < HOURS_MOST ? skies : HOURS_MOST;
    choose(d->points, d->point_count, points, pp_hash(seed, 1));
    choose(d->hours, d->hour_count, skies, pp_hash(seed, 2));
    for (int t = 0; t < d->hour_count; t++)
        d->skies[t] = work->open.skies[d->hours[t]];
}

enum pp_status pp_annual_discretisation_measure(struct pp_annual_work *work,
                                                struct pp_error *err)
{
    struct discretisation_work *d = calloc(1, sizeof *d);
    if (!d)
        return pp_fail_memory(err);
    d->work = work;
    choose_sample(d);
    enum pp_status status = pp_light_columns_init(
        &d->columns, work->open.environment, d->skies, d->hour_count,
        work->options->patches, work->world->north_rad, work->pool, err);
    if (status == PP_OK)
        status = pp_plain_year_create(
            &d->plain, work->open.scene, work->open.environment, work->receivers,
            work->groups.of_opening, work->groups.count, PATHS,
            pp_hash(work->options->seed, UINT64_C(0xd15d)), err);
    if (status == PP_OK)
        pp_thread_pool_run(work->pool, 0, d->point_count, sample_point, d);
    for (int p = 0; p < d->point_count && status == PP_OK; p++)
        if (d->status[p] != PP_OK)
            status = pp_fail_memory(err);
    if (status == PP_OK && d->point_count > 0)
        judge_sample(d);
    pp_plain_year_destroy(d->plain);
    pp_light_columns_clear(&d->columns);
    free(d);
    return status;
}
