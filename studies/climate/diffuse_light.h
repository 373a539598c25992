/* diffuse_light.h - the horizontal illuminance by the sky alone, through a year: as a
 * weather file has it, or of a sky that is always overcast.
 */
#ifndef PP_STUDIES_CLIMATE_DIFFUSE_LIGHT_H
#define PP_STUDIES_CLIMATE_DIFFUSE_LIGHT_H

#include "model/results/availability_sheet.h"
#include "formats/epw/epw.h"

/* A stretch of time in which it is taken to be constant. */
struct pp_diffuse_hour {
    struct pp_month_day date;
    int weekday;              /* 0 Monday to 6 Sunday, or PP_WEEKDAY_UNKNOWN */
    double start_h, length_h; /* local standard time, 0 to 24 */
    double lx;                /* NAN where it is not known */
};

struct pp_diffuse_light {
    enum pp_light_origin origin;
    int count;
    struct pp_diffuse_hour *list; /* owned */
    int filled;  /* hours without illuminance, made of their irradiance */
    int missing; /* hours without either */
    double total_h;
};

/* From a weather file: its diffuse horizontal illuminance; an hour that has none gets
 * it from its diffuse irradiance by [PISMS90] (luminous_efficacy.h), and so do all
 * where the file's illuminances are 0 or missing throughout. The sun stands where it
 * does on average over the part of the hour that has it above the horizon. PP_BAD_INPUT
 * where there is no light although the sun is up. *light is to be cleared. */
enum pp_status pp_diffuse_light_of_epw(struct pp_diffuse_light *light,
                                       const struct pp_epw *epw, const char *file,
                                       struct pp_error *err);

/* Of a CIE overcast sky, every 5 minutes of a year of 365 days that begins on a Monday
 * (2018):
 *
 *     Eh = 300 + 21000 sin(altitude of the sun) lx,  0 while it is down     [KRO63]
 *
 * latitude north and longitude east positive; time zone in hours ahead of UT. */
enum pp_status pp_diffuse_light_overcast(struct pp_diffuse_light *light,
                                         double latitude_rad, double longitude_rad,
                                         double time_zone_h, struct pp_error *err);

/* Eh above (lx) for one altitude of the sun. */
double pp_diffuse_light_overcast_lx(double sun_altitude_rad);

/* The median of the brightest 4380 hours of the year (lx), as [EN17037] wants it; of
 * the brighter half of those that are known where there are fewer than 8760. NAN where
 * the data cover less than a year. */
double pp_diffuse_light_median_lx(const struct pp_diffuse_light *light);

void pp_diffuse_light_clear(struct pp_diffuse_light *light);

#endif
