/* moment.h - sky and sun of one moment, and the illuminances of a room's points under
 * them.
 *
 * Sky and sun come from a record of a weather file, from irradiances, or from the
 * illuminances of a standard sky. With irradiances the position of the sun is given, or
 * follows from a time at the room's site.
 */
#ifndef PP_STUDIES_YEAR_MOMENT_H
#define PP_STUDIES_YEAR_MOMENT_H

#include "studies/year/annual.h"

struct pp_moment {
    struct pp_perez_sky sky;            /* axes: x east, y north, z up */
    struct pp_month_day date;           /* month 0: none */
    double clock_h;                     /* local standard time */
    const struct pp_weather_year *year; /* year of the record; not owned; NULL: none */
    char words[PP_ANNUAL_WORDS];        /* sentence on sky and sun if there is no
                                         * record */
    const char *sky_name;               /* "perez", "iso-12", ... */
};

/* The moment in a record of the file. PP_BAD_INPUT if the hour is dark or unknown. year
 * must outlive *moment. */
enum pp_status pp_moment_of_weather(struct pp_moment *moment,
                                    const struct pp_weather_year *year,
                                    struct pp_month_day date, double clock_h,
                                    struct pp_error *err);

/* A sky given by irradiances, and its sun. */
struct pp_moment_irradiances {
    double direct_w_m2, diffuse_w_m2;         /* direct normal, diffuse horizontal */
    double sun_altitude_rad, sun_bearing_rad; /* NAN: from time and place */
    int year;
    struct pp_month_day date;
    double clock_h,
        zone_h; /* hours ahead of universal time; NAN: longitude in whole hours */
    double latitude_rad, longitude_rad; /* NAN: not known */
};

/* Assumes 2 cm of precipitable water. PP_BAD_INPUT for direct light with the sun below
 * the horizon, for a time without a place, and if there is no light. */
enum pp_status pp_moment_of_irradiances(struct pp_moment *moment,
                                        const struct pp_moment_irradiances *of,
                                        struct pp_error *err);

/* A standard sky given by its illuminances, and its sun. */
struct pp_moment_standard {
    const char *name; /* "overcast", "uniform", "iso-12"; NULL: not given */
    int iso;          /* 1 to 15; 0: overcast or uniform */
    double sun_altitude_rad, sun_bearing_rad;
    double direct_lx, diffuse_lx; /* direct normal, diffuse horizontal */
};

/* PP_BAD_INPUT for a sky without diffuse light, and for direct light with the sun at
 * the horizon. */
enum pp_status pp_moment_of_standard(struct pp_moment *moment,
                                     const struct pp_moment_standard *of,
                                     struct pp_error *err);

/* Source of the moment for any room: a record of a weather file, irradiances, or a
 * standard sky. */
struct pp_moment_source {
    const char *when;                   /* as typed; NULL: no time is given */
    const struct pp_weather_year *year; /* not owned; NULL: irradiances or a standard
                                         * sky */
    struct pp_moment_irradiances of;    /* contains the time, also for a weather file;
                                         * the place in it is not used */
    struct pp_moment_standard standard; /* instead of irradiances, if it has a name */
};

/* The moment at the place of a room. */
enum pp_status pp_moment_at(struct pp_moment *moment,
                            const struct pp_moment_source *source,
                            const struct pp_world *world, struct pp_error *err);

/* Turns the slats of a room's blinds that follow the sun, and sets the season of its
 * trees. */
enum pp_status pp_moment_turn_slats(struct pp_world *world,
                                    const struct pp_moment *moment,
                                    struct pp_error *err);

/* Sky and sun in the axes of a room whose y axis has that bearing, as pictures and
 * other programs use them; the ground's reflectance stays. PP_BAD_INPUT for a black
 * sky. */
enum pp_status pp_moment_light(struct pp_outside_light *light,
                               const struct pp_moment *moment, double north_rad,
                               struct pp_error *err);

/* Fills an annual sheet for this hour alone. year_lxh has the illuminances, and
 * sky_lxh, sun_lxh and sun_reflected_lxh their parts. The caller clears *sheet, even
 * after a failure. */
enum pp_status pp_moment_of_room(struct pp_annual_sheet *sheet,
                                 const struct pp_world *world,
                                 const struct pp_outside_light *light,
                                 const struct pp_receiver *receivers,
                                 int receiver_count, const struct pp_moment *moment,
                                 const struct pp_annual_options *options,
                                 struct pp_error *err);

#endif
