/* year_light.h - the light outside through a year, from a weather file or under
 * overcast skies at a latitude, the hours that count, and descriptions of both. */
#ifndef PP_STUDIES_CLIMATE_YEAR_LIGHT_H
#define PP_STUDIES_CLIMATE_YEAR_LIGHT_H

#include "formats/epw/epw.h"
#include "model/room/world.h"
#include "studies/climate/availability.h"
#include "studies/climate/diffuse_light.h"
#include "studies/climate/working_hours.h"

struct pp_clock_times {
    int count;
    struct pp_working_hours list[PP_PERIODS_MOST]; /* the same for all working days */
};

struct pp_illuminances {
    int count;
    double lx[PP_ILLUMINANCES_MOST];
};

struct pp_summer_choice {
    bool of_file;
    struct pp_summer_time time; /* used unless of_file is set; month 0: no summer
                                 * time */
};

/* Options of a study of a year. Numbers are NAN if they are not given. */
struct pp_year_options {
    const char *weather;                /* name of the weather file; NULL: overcast
                                         * sky */
    double latitude_deg, longitude_deg; /* location for the overcast sky */
    double time_zone_h;                 /* time zone of clock time at that location,
                                         * hours ahead of UT */
    struct pp_clock_times hours;
    unsigned days; /* bit mask of working days, bit 0: Monday */
    struct pp_summer_choice summer;
    struct pp_illuminances illuminances;

    struct pp_epw *epw; /* contents of the weather file; NULL: none; not owned */
};

/* Default options: 8-18 and 9-17 h, all days, no summer time, 300 and 500 lx, no
 * location. */
extern const struct pp_year_options pp_year_options_default;

/* Short names of the days of the week, Monday first, such as "Mon". */
extern const char *const pp_year_light_day_names[7];

/* Light outside of a room, and its description. */
struct pp_year_light {
    struct pp_diffuse_light light;
    char words[640], calendar[160];
    struct pp_working_hours periods[PP_PERIODS_MOST];
    double latitude_deg;
};

/* Finds the light outside of a room; world may be NULL. PP_BAD_INPUT if the latitude is
 * unknown, or if days of the week are requested but unknown. The caller clears
 * *outside, also after a failure. */
enum pp_status pp_year_light_of_room(struct pp_year_light *outside,
                                     const struct pp_year_options *options,
                                     const struct pp_world *world,
                                     struct pp_error *err);
void pp_year_light_clear(struct pp_year_light *outside);

/* Makes the question for an availability study, with pointers to the options and the
 * light. */
struct pp_availability_question pp_year_light_question(
    const struct pp_year_options *options, const struct pp_year_light *outside);

#endif
