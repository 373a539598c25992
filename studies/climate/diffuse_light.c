/* diffuse_light.c - diffuse horizontal illuminance through a year, from a weather file
 * or under overcast skies, and its median.
 */
#include "studies/climate/diffuse_light.h"

#include <math.h>
#include <stdlib.h>

#include "studies/climate/luminous_efficacy.h"
#include "model/light/sun.h"
#include "model/geometry/vec.h"

static enum pp_status reserve_hours(struct pp_diffuse_light *light, int count,
                                    struct pp_error *err)
{
    light->list = calloc((size_t)count + 1, sizeof *light->list);
    return light->list ? PP_OK : pp_fail_memory(err);
}

void pp_diffuse_light_clear(struct pp_diffuse_light *light)
{
    free(light->list);
    *light = (struct pp_diffuse_light){0};
}

/* ---- from a weather file ---- */

/* Position of the sun in a record. The sine of its altitude is the mean over those of
 * STEPS instants in the record at which the sun is above the horizon. If it is never
 * above, the altitude is 0 and *up is false. */
static struct pp_sun sun_of(const struct pp_epw *epw,
                            const struct pp_epw_record *record, bool *up)
{
    enum { STEPS = 6 };
    struct pp_sun sun = {.altitude_rad = 0.0};
    double height = 0.0;
    int count = 0;
    for (int i = 0; i < STEPS; i++) {
        double hour = record->start_h + epw->record_h * (i + 0.5) / STEPS;
        double n = pp_sun_days_since_2000(record->year, record->date.month,
                                          record->date.day, hour - epw->time_zone_h);
        sun = pp_sun_at(n, epw->latitude_rad, epw->longitude_rad);
        if (sun.altitude_rad <= 0.0)
            continue;
        height += sin(sun.altitude_rad);
        count++;
    }
    *up = count > 0;
    sun.altitude_rad = count ? asin(height / count) : 0.0;
    return sun;
}

/* Diffuse illuminance from diffuse irradiance according to [PISMS90]; NAN if the
 * diffuse irradiance is missing. A missing direct irradiance is calculated as (global -
 * diffuse) / sin(altitude), with the sine at least 0.05; it is 0 if the global
 * irradiance is also missing. A missing dew point is assumed to be 11 degrees
 * Celsius. */
static double by_efficacy(const struct pp_epw *epw, const struct pp_epw_record *record,
                          bool *up)
{
    double diffuse = record->diffuse_w_m2, direct = record->direct_w_m2;
    struct pp_sun sun = sun_of(epw, record, up);
    if (!(diffuse > 0.0))
        return diffuse;
    double height = fmax(sin(sun.altitude_rad), 0.05);
    if (isnan(direct))
        direct = fmax(0.0, (record->global_w_m2 - diffuse) / height);
    if (isnan(direct))
        direct = 0.0;
    double dew_point = isnan(record->dew_point_c) ? 11.0 : record->dew_point_c;
    return diffuse
           * pp_luminous_efficacy_diffuse(diffuse, direct,
                                          PP_PI / 2.0 - sun.altitude_rad,
                                          sun.distance_au, dew_point);
}

static bool has_illuminance(const struct pp_epw *epw)
{
    for (int i = 0; i < epw->record_count; i++)
        if (epw->records[i].diffuse_lx > 0.0)
            return true;
    return false;
}

/* Sets hour i from record i: from its illuminance or, if that is missing, from its
 * irradiance. */
static void fill_hour(struct pp_diffuse_light *light, const struct pp_epw *epw, int i,
                      bool *sun_was_up)
{
    const struct pp_epw_record *record = &epw->records[i];
    struct pp_diffuse_hour *hour = &light->list[i];
    *hour = (struct pp_diffuse_hour){.date = record->date,
                                     .weekday = record->weekday,
                                     .start_h = record->start_h,
                                     .length_h = epw->record_h,
                                     .lx = record->diffuse_lx};
    bool from_file = light->origin == PP_LIGHT_ILLUMINANCE;
    if (!from_file || isnan(hour->lx)) {
        bool up = false;
        hour->lx = by_efficacy(epw, record, &up);
        *sun_was_up |= up;
        light->filled += from_file && !isnan(hour->lx);
    }
    light->missing += isnan(hour->lx);
    light->total_h += hour->length_h;
}

enum pp_status pp_diffuse_light_of_epw(struct pp_diffuse_light *light,
                                       const struct pp_epw *epw, const char *file,
                                       struct pp_error *err)
{
    *light = (struct pp_diffuse_light){
        .origin = has_illuminance(epw) ? PP_LIGHT_ILLUMINANCE : PP_LIGHT_IRRADIANCE};
    enum pp_status status = reserve_hours(light, epw->record_count, err);
    bool sun_was_up = false;
    double most = 0.0;
    for (int i = 0; status == PP_OK && i < epw->record_count; i++) {
        fill_hour(light, epw, i, &sun_was_up);
        light->count++;
        most = fmax(most, isnan(light->list[i].lx) ? 0.0 : light->list[i].lx);
    }
    bool dark = light->origin == PP_LIGHT_IRRADIANCE && sun_was_up && !(most > 0.0);
    if (status == PP_OK && (light->missing == light->count || dark))
        status = pp_fail(
            err, PP_BAD_INPUT,
            "%s: diffuse illuminance (field 19) and diffuse irradiance (field 16) are "
            "0 or missing in all %d records; expected values in one of these fields",
            file, epw->record_count);
    if (status != PP_OK)
        pp_diffuse_light_clear(light);
    return status;
}

/* ---- under overcast skies ---- */

double pp_diffuse_light_overcast_lx(double sun_altitude_rad)
{
    return sun_altitude_rad > 0.0 ? 300.0 + 21000.0 * sin(sun_altitude_rad) : 0.0;
}

enum pp_status pp_diffuse_light_overcast(struct pp_diffuse_light *light,
                                         double latitude_rad, double longitude_rad,
                                         double time_zone_h, struct pp_error *err)
{
    enum { DAYS = 365, STEPS = 288 };
    static const double step_h = 24.0 / STEPS;
    *light =
        (struct pp_diffuse_light){.origin = PP_LIGHT_OVERCAST, .total_h = 24.0 * DAYS};
    enum pp_status status = reserve_hours(light, DAYS * STEPS, err);
    struct pp_month_day date = {1, 1};
    for (int day = 0; status == PP_OK && day < DAYS; day++) {
        double midnight =
            pp_sun_days_since_2000(2018, date.month, date.day, -time_zone_h);
        for (int i = 0; i < STEPS; i++) {
            double n = midnight + (i + 0.5) / STEPS;
            struct pp_sun sun = pp_sun_at(n, latitude_rad, longitude_rad);
            light->list[light->count++] = (struct pp_diffuse_hour){
                .date = date,
                .weekday = day % 7,
                .start_h = i * step_h,
                .length_h = step_h,
                .lx = pp_diffuse_light_overcast_lx(sun.altitude_rad)};
        }
        bool month_ends =
            date.day == (date.month == 2 ? 28 : pp_month_day_days_of_month(date.month));
        date.day = month_ends ? 1 : date.day + 1;
        date.month += month_ends;
    }
    return status;
}

/* ---- median ---- */

static int compare_falling(const void *a, const void *b)
{
    double p = ((const double *)a)[0], q = ((const double *)b)[0];
    return p > q ? -1 : p < q;
}

enum pp_status pp_diffuse_light_median(double *median_lx,
                                       const struct pp_diffuse_light *light,
                                       struct pp_error *err)
{
    *median_lx = NAN;
    if (light->total_h < 8760.0 - 0.01 || light->missing == light->count)
        return PP_OK;
    double(*known)[2] = malloc((size_t)light->count * sizeof *known);
    if (!known)
        return pp_fail_memory(err);
    int count = 0;
    double known_h = 0.0, median = NAN;
    for (int i = 0; i < light->count; i++) {
        const struct pp_diffuse_hour *hour = &light->list[i];
        if (isnan(hour->lx))
            continue;
        known[count][0] = hour->lx;
        known[count++][1] = hour->length_h;
        known_h += hour->length_h;
    }
    qsort(known, (size_t)count, sizeof *known, compare_falling);

    /* Illuminance exceeded in half of the brightest 4380 h, or in half of the brighter
     * half of the known time if that is shorter. If the limit is between two hours, it
     * is the mean of both illuminances. */
    double half_h = 0.5 * fmin(4380.0, 0.5 * known_h), passed_h = 0.0;
    for (int i = 0; i < count; i++) {
        passed_h += known[i][1];
        if (passed_h < half_h - 1e-6)
            continue;
        bool between = passed_h < half_h + 1e-6 && i + 1 < count;
        median = between ? 0.5 * (known[i][0] + known[i + 1][0]) : known[i][0];
        break;
    }
    free(known);
    *median_lx = median;
    return PP_OK;
}
