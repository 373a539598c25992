/* annual_lighting.c - see annual_lighting.h. */
#include "studies/year/annual_lighting.h"

#include <math.h>
#include <stdlib.h>

#include "model/results/sheets/point_areas.h"
#include "simulate/year/year_coefficients.h"
#include "studies/lighting/en15193.h"
#include "studies/lighting/lighting_year.h"
#include "studies/year/year_metrics.h"

/* Series of illuminances: means over all batches, then means with each batch left out
 * in turn. */
enum { SERIES = 1 + PP_YEAR_BATCHES };

struct pp_annual_lighting {
    struct pp_annual_sheet *sheet;
    int workers;
    bool has_short_records; /* true: some records are shorter than an hour */
    float *series;          /* [worker][record]: illuminances of one point */
    float *control;         /* [worker][control][series][record]: least illuminance of
                             * the control points */
    float *hourly;          /* the same for hourly means; NULL: records of an hour */
    double *saved;          /* [point][control][series] */
};

static size_t series_index(const struct pp_annual_lighting *lighting, int worker,
                           int control, int series)
{
    size_t controls = (size_t)lighting->sheet->lighting_count;
    size_t row = ((size_t)worker * controls + (size_t)control) * SERIES;
    return (row + (size_t)series) * (size_t)lighting->sheet->hour_count;
}

static bool allocate_series(float **series, size_t count)
{
    *series = malloc((count + 1) * sizeof **series);
    for (size_t i = 0; *series && i < count; i++)
        (*series)[i] = INFINITY;
    return *series != NULL;
}

static bool allocate_lighting(struct pp_annual_lighting *lighting)
{
    struct pp_annual_sheet *sheet = lighting->sheet;
    size_t records = (size_t)sheet->hour_count, points = (size_t)sheet->receiver_count;
    size_t all = series_index(lighting, lighting->workers, 0, 0);
    bool good =
        allocate_series(&lighting->control, all)
        && (!lighting->has_short_records || allocate_series(&lighting->hourly, all));
    lighting->series = calloc((size_t)lighting->workers * records + 1, sizeof(float));
    lighting->saved =
        calloc(points * (size_t)sheet->lighting_count * SERIES + 1, sizeof(double));
    for (int k = 0; k < sheet->lighting_count; k++) {
        struct pp_lighting_sheet *to = &sheet->lighting[k];
        to->points = calloc(points + 1, sizeof *to->points);
        to->fraction = calloc(records + 1, sizeof *to->fraction);
        good = good && to->points && to->fraction;
    }
    return good && lighting->series && lighting->saved;
}

/* Copies the controls to the sheet, with the power both in total and per area. */
static enum pp_status copy_controls(struct pp_annual_sheet *sheet,
                                    const struct pp_annual_options *options,
                                    struct pp_error *err)
{
    double floor_m2 = pp_world_floor_m2(sheet->world);
    sheet->lighting = calloc((size_t)options->lighting_count, sizeof *sheet->lighting);
    if (!sheet->lighting)
        return pp_fail_memory(err);
    sheet->lighting_count = options->lighting_count;
    for (int k = 0; k < options->lighting_count; k++) {
        struct pp_lighting_control *control = &sheet->lighting[k].control;
        *control = options->lighting[k];
        if (control->point > sheet->receiver_count)
            return pp_fail(err, PP_BAD_INPUT,
                           "the control point of the lighting is point %d, but the "
                           "room has %d point%s",
                           control->point, sheet->receiver_count,
                           sheet->receiver_count == 1 ? "" : "s");
        if (!isnan(control->power_w))
            control->power_w_m2 = control->power_w / floor_m2;
        else
            control->power_w = control->power_w_m2 * floor_m2;
    }
    return PP_OK;
}

enum pp_status pp_annual_lighting_create(struct pp_annual_lighting **lighting,
                                         struct pp_annual_sheet *sheet,
                                         double latitude_rad,
                                         const struct pp_annual_options *options,
                                         int workers, struct pp_error *err)
{
    *lighting = NULL;
    if (options->lighting_count == 0)
        return PP_OK;
    enum pp_status status = copy_controls(sheet, options, err);
    if (status != PP_OK)
        return status;
    struct pp_annual_lighting *made = calloc(1, sizeof *made);
    if (!made)
        return pp_fail_memory(err);
    made->sheet = sheet;
    made->workers = workers;
    for (int i = 0; i < sheet->hour_count; i++)
        made->has_short_records |= sheet->hours[i].length_h < 1.0;
    if (!allocate_lighting(made)) {
        pp_annual_lighting_destroy(made);
        return pp_fail_memory(err);
    }
    for (int k = 0; k < sheet->lighting_count; k++)
        pp_en15193_of_room(&sheet->lighting[k].standard, sheet->world, latitude_rad,
                           &sheet->lighting[k].control);
    *lighting = made;
    return PP_OK;
}

void pp_annual_lighting_destroy(struct pp_annual_lighting *lighting)
{
    if (!lighting)
        return;
    free(lighting->series);
    free(lighting->control);
    free(lighting->hourly);
    free(lighting->saved);
    free(lighting);
}

static double saved_by(const struct pp_lighting_year *year)
{
    return 1.0 - year->used_h / year->occupied_h;
}

/* Lowers `least` to E where E is lower. */
static void lower(float *least, const float *E, int count)
{
    for (int i = 0; i < count; i++)
        least[i] = E[i] < least[i] ? E[i] : least[i];
}

void pp_annual_lighting_add(struct pp_annual_lighting *lighting, int worker, int x,
                            int without, const float *open, const float *blinds)
{
    const struct pp_annual_sheet *sheet = lighting->sheet;
    int records = sheet->hour_count;
    float *E = lighting->series + (size_t)worker * (size_t)records;
    for (int k = 0; k < sheet->lighting_count; k++) {
        const struct pp_lighting_control *control = &sheet->lighting[k].control;
        const float *by_sky = control->with_blinds ? blinds : open;
        for (int i = 0; i < records; i++)
            E[i] = sheet->hours[i].sky < 0 ? 0.0f : by_sky[sheet->hours[i].sky];
        struct pp_lighting_year year =
            pp_lighting_year_of(control, sheet->hours, records, E, NULL);
        lighting->saved[((size_t)x * (size_t)sheet->lighting_count + (size_t)k) * SERIES
                        + (size_t)(1 + without)] = saved_by(&year);
        if (control->point > 0 && control->point != x + 1)
            continue;
        size_t at = series_index(lighting, worker, k, 1 + without);
        lower(lighting->control + at, E, records);
        if (!lighting->hourly)
            continue;
        pp_lighting_year_average_hours(E, sheet->hours, records);
        lower(lighting->hourly + at, E, records);
    }
}

/* Combines the least illuminances of all workers in those of the first. */
static void merge_workers(const struct pp_annual_lighting *lighting, float *series)
{
    size_t count = series_index(lighting, 1, 0, 0);
    for (int worker = 1; worker < lighting->workers; worker++)
        for (size_t i = 0; i < count; i++) {
            float E = series[(size_t)worker * count + i];
            series[i] = E < series[i] ? E : series[i];
        }
}

/* Sets a figure from its value in each series. */
static struct pp_annual_value value_of_series(const double *values)
{
    return (struct pp_annual_value){values[0],
                                    pp_year_metrics_error(values + 1, PP_YEAR_BATCHES)};
}

static void fill_figures(const struct pp_annual_lighting *lighting, int k)
{
    struct pp_annual_sheet *sheet = lighting->sheet;
    struct pp_lighting_sheet *to = &sheet->lighting[k];
    double values[PP_LIGHTING_FIGURES][SERIES];
    for (int s = 0; s < SERIES; s++) {
        size_t at = series_index(lighting, 0, k, s);
        struct pp_lighting_year year =
            pp_lighting_year_of(&to->control, sheet->hours, sheet->hour_count,
                                lighting->control + at, s == 0 ? to->fraction : NULL);
        struct pp_lighting_year hourly = year;
        if (lighting->hourly)
            hourly = pp_lighting_year_of(&to->control, sheet->hours, sheet->hour_count,
                                         lighting->hourly + at, NULL);
        values[0][s] = saved_by(&year);
        values[1][s] = year.used_h;
        values[2][s] = year.on_h;
        values[3][s] = saved_by(&hourly);
        values[4][s] = values[3][s] - values[0][s];
    }
    to->figures =
        (struct pp_lighting_figures){.saved = value_of_series(values[0]),
                                     .used_h = value_of_series(values[1]),
                                     .on_h = value_of_series(values[2]),
                                     .saved_by_means = value_of_series(values[3]),
                                     .misjudged = value_of_series(values[4])};
}

static void fill_points(const struct pp_annual_lighting *lighting, int k)
{
    struct pp_annual_sheet *sheet = lighting->sheet;
    struct pp_lighting_sheet *to = &sheet->lighting[k];
    double mean[SERIES] = {0.0};
    double area_m2 = pp_point_areas_sum(sheet->receivers, sheet->receiver_count);
    for (int x = 0; x < sheet->receiver_count; x++) {
        double share =
            pp_point_areas_share(sheet->receivers, sheet->receiver_count, area_m2, x);
        const double *saved =
            lighting->saved
            + ((size_t)x * (size_t)sheet->lighting_count + (size_t)k) * SERIES;
        to->points[x] = value_of_series(saved);
        for (int s = 0; s < SERIES; s++)
            mean[s] += share * saved[s];
    }
    to->mean = value_of_series(mean);
}

void pp_annual_lighting_finish(struct pp_annual_lighting *lighting)
{
    if (!lighting)
        return;
    merge_workers(lighting, lighting->control);
    if (lighting->hourly)
        merge_workers(lighting, lighting->hourly);
    for (int k = 0; k < lighting->sheet->lighting_count; k++) {
        fill_figures(lighting, k);
        fill_points(lighting, k);
    }
}
