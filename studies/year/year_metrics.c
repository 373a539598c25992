/* year_metrics.c - see year_metrics.h. */
#include "studies/year/year_metrics.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- the clock ---- */

struct ranked_sky {
    double diffuse_lx, length_h;
    int sky;
};

/* Sorts the brightest first, and the earlier of two equals. */
static int compare_skies(const void *a, const void *b)
{
    const struct ranked_sky *x = a, *y = b;
    if (x->diffuse_lx != y->diffuse_lx)
        return x->diffuse_lx < y->diffuse_lx ? 1 : -1;
    return x->sky - y->sky;
}

/* Marks the brightest half of the year, and finds the median's rank in it. */
static enum pp_status mark_daylight(struct pp_year_clock *clock,
                                    const struct pp_weather_year *year,
                                    struct pp_error *err)
{
    static const double HALF_YEAR_H = 4380.0, QUARTER_YEAR_H = 2190.0;
    struct ranked_sky *list = malloc((size_t)clock->sky_count * sizeof *list);
    double sum_h = 0.0;
    if (!list)
        return pp_fail_memory(err);
    for (int i = 0; i < clock->sky_count; i++)
        list[i] = (struct ranked_sky){year->skies[i].diffuse_lx, clock->length_h[i], i};
    qsort(list, (size_t)clock->sky_count, sizeof *list, compare_skies);
    clock->median_rank = clock->sky_count;
    for (int i = 0; i < clock->sky_count && sum_h < HALF_YEAR_H - 1e-9; i++) {
        clock->is_daylight[list[i].sky] = true;
        sum_h += list[i].length_h;
        if (clock->median_rank == clock->sky_count && sum_h >= QUARTER_YEAR_H - 1e-9) {
            clock->median_rank = i;
            clock->diffuse_median_lx = list[i].diffuse_lx;
        }
    }
    free(list);
    return PP_OK;
}

enum pp_status pp_year_clock_init(struct pp_year_clock *clock,
                                  const struct pp_weather_year *year,
                                  const struct pp_working_hours *hours,
                                  const struct pp_summer_time *summer,
                                  struct pp_error *err)
{
    size_t count = (size_t)year->sky_count + 1;
    *clock = (struct pp_year_clock){.sky_count = year->sky_count};
    clock->occupied_h = calloc(count, sizeof *clock->occupied_h);
    clock->length_h = calloc(count, sizeof *clock->length_h);
    clock->is_daylight = calloc(count, sizeof *clock->is_daylight);
    enum pp_status status = PP_OK;
    if (!clock->occupied_h || !clock->length_h || !clock->is_daylight)
        status = pp_fail_memory(err);
    for (int i = 0; i < year->count && status == PP_OK; i++) {
        const struct pp_weather_hour *hour = &year->hours[i];
        struct pp_diffuse_hour at = {.date = hour->date,
                                     .weekday = hour->weekday,
                                     .start_h = hour->start_h,
                                     .length_h = hour->length_h};
        double occupied_h =
            hour->known ? pp_working_hours_share_h(hours, summer, &at) : 0.0;
        clock->all_occupied_h += occupied_h;
        if (hour->sky < 0)
            continue;
        clock->occupied_h[hour->sky] = occupied_h;
        clock->length_h[hour->sky] = hour->length_h;
    }
    if (status == PP_OK && !(clock->all_occupied_h > 0.0))
        status =
            pp_fail(err, PP_BAD_INPUT,
                    "no record of the weather file is in the chosen hours and days");
    if (status == PP_OK)
        status = mark_daylight(clock, year, err);
    if (status != PP_OK)
        pp_year_clock_clear(clock);
    return status;
}

void pp_year_clock_clear(struct pp_year_clock *clock)
{
    free(clock->occupied_h);
    free(clock->length_h);
    free(clock->is_daylight);
    *clock = (struct pp_year_clock){.sky_count = 0};
}

/* ---- a point ---- */

/* Value with that rank in descending order, counted from 0, by quickselect. */
static float value_of_rank(float *values, int count, int rank)
{
    int low = 0, high = count - 1;
    while (low < high) {
        float pivot = values[(low + high) / 2];
        int i = low, k = high;
        while (i <= k) {
            while (values[i] > pivot)
                i++;
            while (values[k] < pivot)
                k--;
            if (i <= k) {
                float swap = values[i];
                values[i++] = values[k];
                values[k--] = swap;
            }
        }
        if (rank <= k)
            high = k;
        else if (rank >= i)
            low = i;
        else
            break;
    }
    return values[rank];
}

static double median_of(const struct pp_year_values *values,
                        const struct pp_year_clock *clock)
{
    int count = 0;
    for (int i = 0; i < clock->sky_count; i++)
        if (clock->is_daylight[i])
            values->space[count++] = values->open[i];
    return clock->median_rank < count
               ? value_of_rank(values->space, count, clock->median_rank)
               : 0.0;
}

/* Adds up all figures in one pass: additions to one sum wait for each other, but those
 * to several sums overlap. A factor 0 or 1 takes less time than a branch. */
void pp_year_metrics_of(struct pp_annual_figures *figures,
                        const struct pp_year_values *values,
                        const struct pp_year_clock *clock,
                        const double *illuminances_lx, int illuminance_count)
{
    double low_h = 0.0, good_h = 0.0, above_h = 0.0, sun_h = 0.0, blinds_h = 0.0;
    double mean = 0.0, year = 0.0, sky = 0.0, sun = 0.0, reflected = 0.0;
    double with_h[PP_ANNUAL_ILLUMINANCES_MOST] = {0.0},
           continuous_h[PP_ANNUAL_ILLUMINANCES_MOST] = {0.0};
    const float *blinds = values->blinds ? values->blinds : values->open;
    for (int i = 0; i < clock->sky_count; i++) {
        float E = values->open[i];
        double occupied_h = clock->occupied_h[i], length_h = clock->length_h[i];
        for (int k = 0; k < illuminance_count; k++) {
            double lx = illuminances_lx[k];
            with_h[k] += occupied_h * (E >= (float)lx);
            continuous_h[k] += occupied_h * (E >= lx ? 1.0 : E / lx);
        }
        low_h += occupied_h * (E >= 100.0f);
        good_h += occupied_h * (E >= 300.0f);
        above_h += occupied_h * (E > 3000.0f);
        sun_h += occupied_h * (values->sun[i] > 1000.0f);
        blinds_h += occupied_h * (blinds[i] >= 300.0f);
        mean += E * occupied_h;
        year += E * length_h;
        sky += values->sky[i] * length_h;
        sun += values->sun[i] * length_h;
        reflected += values->sun_reflected[i] * length_h;
    }
    double all_h = clock->all_occupied_h;
    *figures = (struct pp_annual_figures){.udi_below = {1.0 - low_h / all_h, 0.0}};
    for (int k = 0; k < illuminance_count; k++) {
        figures->autonomy[k].value = with_h[k] / all_h;
        figures->continuous[k].value = continuous_h[k] / all_h;
    }
    figures->autonomy_300.value = good_h / all_h;
    figures->udi_low.value = (low_h - good_h) / all_h;
    figures->udi_good.value = (good_h - above_h) / all_h;
    figures->udi_above.value = above_h / all_h;
    figures->sun_h.value = sun_h;
    figures->mean_lx.value = mean / all_h;
    figures->median_lx.value = median_of(values, clock);
    figures->year_lxh.value = year;
    figures->sky_lxh.value = sky;
    figures->sun_lxh.value = sun;
    figures->sun_reflected_lxh.value = reflected;
    figures->blinds_autonomy.value = values->blinds ? blinds_h / all_h : NAN;
}

double pp_year_metrics_error(const double *without, int count)
{
    double mean = 0.0, squares = 0.0;
    for (int i = 0; i < count; i++)
        mean += without[i] / count;
    for (int i = 0; i < count; i++)
        squares += (without[i] - mean) * (without[i] - mean);
    /* Rounding errors of sums do not count as spread. */
    double error = sqrt((count - 1.0) / count * squares);
    return error > 1e-9 * fabs(mean) ? error : 0.0;
}
