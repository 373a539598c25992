/* diffuse_light.h - the horizontal illuminance from the sky alone through a year: from
 * a weather file, or under a permanently overcast sky. */
#ifndef PP_STUDIES_CLIMATE_DIFFUSE_LIGHT_H
#define PP_STUDIES_CLIMATE_DIFFUSE_LIGHT_H

#include "model/results/sheets/availability_sheet.h"
#include "formats/epw/epw.h"

/* A stretch of time in which the illuminance is taken to be constant. */
struct pp_diffuse_hour {
    struct pp_month_day date;
    int weekday;              /* 0 Monday to 6 Sunday, or PP_WEEKDAY_UNKNOWN */
    double start_h, length_h; /* local standard time, 0 to 24 */
    double lx;                /* diffuse horizontal illuminance; NAN: not known */
};

struct pp_diffuse_light {
    enum pp_light_origin origin;
    int count;
    struct pp_diffuse_hour *list; /* owned */
    int filled;     /* hours whose illuminance was calculated from their irradiance */
    int missing;    /* hours with neither illuminance nor irradiance */
    double total_h; /* total length of all hours */
};

/* Reads the diffuse horizontal illuminance of a weather file. An hour without
 * illuminance gets one from its diffuse irradiance by [PISMS90] (luminous_efficacy.h);
 * so do all hours if the file's illuminances are all 0 or missing. The sun's altitude
 * is its mean over the part of the hour with the sun above the horizon. PP_BAD_INPUT if
 * the file has no light although the sun is up; `file` is its name in that message. On
 * success the caller clears *light. */
enum pp_status pp_diffuse_light_of_epw(struct pp_diffuse_light *light,
                                       const struct pp_epw *epw, const char *file,
                                       struct pp_error *err);

/* Diffuse light of a sky that is overcast all year, every 5 minutes of a year of 365 days
 * that begins on a Monday (2018):
 *
 *     Eh = 300 + 21000 sin(gamma) lx,   0 while the sun is down             [KRO63]
 *
 *     gamma  altitude of the sun
 *
 * Latitude north and longitude east are positive; time zone in hours ahead of UT. */
enum pp_status pp_diffuse_light_overcast(struct pp_diffuse_light *light,
                                         double latitude_rad, double longitude_rad,
                                         double time_zone_h, struct pp_error *err);

/* Eh of [KRO63] above (lx) for one altitude of the sun. */
double pp_diffuse_light_overcast_lx(double sun_altitude_rad);

/* Median diffuse illuminance of [EN17037] (lx): that of the brightest 4380 hours of the
 * year, or of the brighter half of the known hours if fewer than 8760 are known. NAN if
 * the data cover less than a year; fails only if out of memory. */
enum pp_status pp_diffuse_light_median(double *median_lx,
                                       const struct pp_diffuse_light *light,
                                       struct pp_error *err);

void pp_diffuse_light_clear(struct pp_diffuse_light *light);

#endif
