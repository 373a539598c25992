/* capitals.c - the capitals of [EN17037] table A.3, from tables/en17037_capitals.csv,
 * and the one nearest to a site.
 */
#include "studies/criteria/capitals.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "model/geometry/vec.h"

static const struct pp_capital capitals[] = {
#include "tables/en17037_capitals.inc"
};

static const double earth_km = 6371.0; /* mean radius */

/* Greatest distance, and greatest difference in latitude, of a capital that is used for
 * a site. The distance was chosen; the difference is more than half of the widest gap
 * between latitudes in the table, which is 3.8 degrees. */
static const double farthest_km = 1000.0, farthest_deg = 2.5;

int pp_capitals_count(void)
{
    return sizeof capitals / sizeof *capitals;
}

const struct pp_capital *pp_capitals_at(int index)
{
    return &capitals[index];
}

const struct pp_capital *pp_capitals_find(const char *name)
{
    for (int i = 0; i < pp_capitals_count(); i++)
        if (strcasecmp(capitals[i].name, name) == 0)
            return &capitals[i];
    return NULL;
}

const struct pp_capital *pp_capitals_of_country(const char *country)
{
    for (int i = 0; i < pp_capitals_count(); i++)
        if (strcmp(capitals[i].country, country) == 0)
            return &capitals[i];
    return NULL;
}

static struct pp_vec3 towards(double latitude_rad, double longitude_rad)
{
    return pp_vec(cos(latitude_rad) * cos(longitude_rad),
                  cos(latitude_rad) * sin(longitude_rad), sin(latitude_rad));
}

/* Calculated from the chord, which remains accurate at small distances. */
double pp_capitals_apart_rad(const struct pp_capital *capital, double latitude_rad,
                             double longitude_rad)
{
    struct pp_vec3 a = towards(latitude_rad, longitude_rad);
    struct pp_vec3 b =
        towards(capital->latitude_deg * PP_RAD, capital->longitude_deg * PP_RAD);
    return 2.0 * asin(fmin(pp_vec_length(pp_vec_sub(a, b)) / 2.0, 1.0));
}

struct pp_median pp_capitals_median(double latitude_rad, double longitude_rad,
                                    const char *country)
{
    struct pp_median median = {.lux = NAN};
    const struct pp_capital *own = pp_capitals_of_country(country);
    if (own) {
        median.lux = own->median_lux;
        snprintf(median.how, sizeof median.how, "%s, the capital of %s%s", own->name,
                 own->country,
                 own->recalled_only ? " (value not checked against the standard)" : "");
        return median;
    }
    const char *warning =
        country[0] ? "the table of the standard has no capital for the site's country"
                   : "the site has no country from which to determine the capital";
    if (isnan(latitude_rad)) {
        snprintf(median.how, sizeof median.how,
                 "the room file has no latitude; expected a site with a latitude "
                 "(for assess and report also --place NAME or --median-diffuse LUX)");
        return median;
    }
    bool known = !isnan(longitude_rad);
    const struct pp_capital *nearest = NULL;
    double least = INFINITY;
    for (int i = 0; i < pp_capitals_count(); i++) {
        double off = known ? earth_km
                                 * pp_capitals_apart_rad(&capitals[i], latitude_rad,
                                                         longitude_rad)
                           : fabs(capitals[i].latitude_deg - latitude_rad / PP_RAD);
        if (off < least)
            nearest = &capitals[i], least = off;
    }
    if (least > (known ? farthest_km : farthest_deg)) {
        char off[48];
        snprintf(off, sizeof off, known ? "%.0f km" : "%.1f degrees of latitude",
                 least);
        snprintf(median.how, sizeof median.how,
                 "the nearest capital in the standard's table, %s, is %s away; "
                 "expected --median-diffuse LUX (of assess and report)",
                 nearest->name, off);
        return median;
    }
    median.lux = nearest->median_lux;
    if (known)
        snprintf(median.how, sizeof median.how,
                 "%s, the nearest capital, %.0f km away; %s", nearest->name, least,
                 warning);
    else
        snprintf(median.how, sizeof median.how,
                 "%s, the capital at the nearest latitude; %s", nearest->name, warning);
    return median;
}
