/* weather_year.h - sky and sun of every hour of a weather file.
 *
 * Sky and sun are calculated for the middle of a record plus the sun shift
 * (sun_closure.h). If the sun's centre is below the horizon then, but the record has
 * direct light, the sun is at the mean of its positions above the horizon within the
 * record; without such a position the direct light is left out. Records of 29 February
 * are left out unless `leap_day` keeps them. A record without direct or diffuse
 * irradiance is unknown and left out of all counts of hours.
 */
#ifndef PP_STUDIES_YEAR_WEATHER_YEAR_H
#define PP_STUDIES_YEAR_WEATHER_YEAR_H

#include "formats/epw/epw.h"
#include "model/light/perez_sky.h"
#include "studies/year/sun_closure.h"

struct pp_weather_hour {
    struct pp_month_day date;
    int weekday;              /* 0 Monday to 6 Sunday, or PP_WEEKDAY_UNKNOWN */
    double start_h, length_h; /* local standard time */
    double direct_w_m2;       /* direct normal irradiance; NAN: not known */
    bool known;
    bool lit;           /* true: the hour has a sky or a sun */
    int sky;            /* index in skies; -1: dark, or not known */
    double cloud_cover; /* fraction of the sky covered by clouds; NAN: not known */
};

struct pp_weather_options {
    double sun_shift_h; /* hours; NAN: found from the file's radiation */
    bool leap_day;
};

struct pp_weather_year {
    const struct pp_epw *epw; /* not owned; NULL: the skies are not from a file */
    const char *words;        /* sentence on skies that are not from a file */
    int count;
    struct pp_weather_hour *hours;
    int sky_count;
    struct pp_perez_sky *skies; /* axes: x east, y north, z up */
    struct pp_sun_closure closure;
    double sun_shift_h; /* sun shift in use, hours */
    int sun_year;       /* year of all sun positions */

    int leap_records;  /* records of 29 February that were left out */
    int missing;       /* records without direct or diffuse irradiance */
    int no_dew_point;  /* records with light for which a dew point of 11 degrees Celsius
                        * was assumed */
    int moved_suns;    /* records with the sun at the mean of its positions above the
                        * horizon */
    int sunless_beams; /* records whose direct light was left out, as the sun is down */
    int no_diffuse;    /* records with direct light alone: a black sky */
    struct pp_weather_hour first_no_diffuse; /* the first of them */
    int positive_b; /* skies whose coefficient b was above 0 and is set to 0 */
    int brightness, clearness; /* number of skies beyond the model's limits of each
                                * quantity */
};

/* PP_BAD_INPUT if the file covers less than a year, or has no light. file: the file's
 * name, for that message. On success the caller clears *year. */
enum pp_status pp_weather_year_of_epw(struct pp_weather_year *year,
                                      const struct pp_epw *epw,
                                      const struct pp_weather_options *options,
                                      const char *file, struct pp_error *err);
void pp_weather_year_clear(struct pp_weather_year *year);

/* The sky at a moment of the file, given by date and clock time (h): the sky of the
 * record that contains the moment. PP_BAD_INPUT if there is no such record, or if it is
 * dark or unknown. */
enum pp_status pp_weather_year_moment(struct pp_perez_sky *sky,
                                      const struct pp_weather_year *year,
                                      struct pp_month_day date, double clock_h,
                                      struct pp_error *err);

/* The same sky in a room's axes; north_rad: bearing of the room's y axis. */
struct pp_perez_sky pp_weather_year_turned(const struct pp_perez_sky *sky,
                                           double north_rad);

/* Counts of the records that were ignored or needed a decision, such as those of 29
 * February; empty if there are none. Returns text. */
const char *pp_weather_year_notes(char *text, size_t room,
                                  const struct pp_weather_year *year);

/* Writes a warning on the file's radiation and the sun shift. Returns text; NULL: there
 * is no warning. */
const char *pp_weather_year_warning(char *text, size_t room,
                                    const struct pp_weather_year *year);

#endif
