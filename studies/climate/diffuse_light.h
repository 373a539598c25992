/* diffuse_light.h - horizontal illuminance from the sky alone (without sun) through a
 * year, from a weather file or under a permanently overcast sky. */
#ifndef PP_STUDIES_CLIMATE_DIFFUSE_LIGHT_H
#define PP_STUDIES_CLIMATE_DIFFUSE_LIGHT_H

#include "model/results/sheets/availability_sheet.h"
#include "formats/epw/epw.h"

/* A period in which the illuminance is assumed constant. */
struct pp_diffuse_hour {
    struct pp_month_day date;
    int weekday;              /* 0 Monday to 6 Sunday, or PP_WEEKDAY_UNKNOWN */
    double start_h, length_h; /* hours; start in local standard time, 0 to 24 */
    double lx;                /* diffuse horizontal illuminance; NAN: not known */
};

struct pp_diffuse_light {
    enum pp_light_origin origin;
    int count;
    struct pp_diffuse_hour *list; /* owned */
    int filled;     /* PP_LIGHT_ILLUMINANCE: number of hours whose illuminance, missing
                     * in the file, was calculated from irradiance */
    int missing;    /* number of hours with neither illuminance nor irradiance */
    double total_h; /* total length of all hours, h */
};

/* Reads the diffuse horizontal illuminance of a weather file. If the illuminance of an
 * hour is missing, it is calculated from the diffuse irradiance according to [PISMS90]
 * (luminous_efficacy.h). The same applies to all hours if all illuminances in the file
 * are 0 or missing. The sun's altitude is the mean over the part of the hour in which
 * the sun is above the horizon. PP_BAD_INPUT if no value is known, or if the file has
 * no light although the sun is up; file: its name in that message. On success the
 * caller clears *light. */
enum pp_status pp_diffuse_light_of_epw(struct pp_diffuse_light *light,
                                       const struct pp_epw *epw, const char *file,
                                       struct pp_error *err);

/* Diffuse light of a sky that is always overcast, at intervals of 5 minutes in a year
 * of 365 days that begins on a Monday (2018):
 *
 *     Eh = 300 + 21000 sin(gamma) lx,   0 while the sun is down             [KRO63]
 *
 *     gamma  altitude of the sun
 *
 * Latitude north and longitude east are positive. The time zone is in hours ahead of
 * UT. */
enum pp_status pp_diffuse_light_overcast(struct pp_diffuse_light *light,
                                         double latitude_rad, double longitude_rad,
                                         double time_zone_h, struct pp_error *err);

/* Illuminance Eh of [KRO63] above (lx) for an altitude of the sun. */
double pp_diffuse_light_overcast_lx(double sun_altitude_rad);

/* Median diffuse illuminance of [EN17037] (lx): the median of the brightest 4380 hours
 * of the year, or of the brighter half of the known hours if fewer than 8760 are known.
 * NAN if the data cover less than a year. Fails only if memory is exhausted. */
enum pp_status pp_diffuse_light_median(double *median_lx,
                                       const struct pp_diffuse_light *light,
                                       struct pp_error *err);

void pp_diffuse_light_clear(struct pp_diffuse_light *light);

#endif
