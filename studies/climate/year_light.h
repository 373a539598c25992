/* year_light.h - the light outside through a year, and the hours that count: from a
 * weather file, or of overcast skies at a latitude; and descriptions of both. */
#ifndef PP_STUDIES_CLIMATE_YEAR_LIGHT_H
#define PP_STUDIES_CLIMATE_YEAR_LIGHT_H

#include "formats/epw/epw.h"
#include "model/room/world.h"
#include "studies/climate/availability.h"
#include "studies/climate/diffuse_light.h"
#include "studies/climate/working_hours.h"

struct pp_clock_times {
    int count;
    struct pp_working_hours list[PP_PERIODS_MOST]; /* equal on all working days */
};

struct pp_illuminances {
    int count;
    double lx[PP_ILLUMINANCES_MOST];
};

struct pp_summer_choice {
    bool of_file;
    struct pp_summer_time time; /* if not of_file; months 0: none */
};

/* Options of a study over a year; numbers are NAN if not given. */
struct pp_year_options {
    const char *weather;                /* file; NULL: an overcast sky */
    double latitude_deg, longitude_deg; /* site of the overcast sky */
    double time_zone_h;                 /* time zone of clock time at that site */
    struct pp_clock_times hours;
    unsigned days; /* working days, bit 0: Monday */
    struct pp_summer_choice summer;
    struct pp_illuminances illuminances;

    struct pp_epw *epw; /* the weather file, read; NULL: none; not owned */
};

/* 8-18 and 9-17 h, all days, no summer time, 300 and 500 lx, no place. */
extern const struct pp_year_options pp_year_options_default;

/* The days of the week, Monday first: "Mon". */
extern const char *const pp_year_light_day_names[7];

/* Light outside of one room (world may be NULL), and its description. */
struct pp_year_light {
    struct pp_diffuse_light light;
    char words[640], calendar[160];
    struct pp_working_hours periods[PP_PERIODS_MOST];
    double latitude_deg;
};

/* The caller clears *outside in any case. PP_BAD_INPUT if the latitude is unknown, or
 * if days of the week are requested but unknown. */
enum pp_status pp_year_light_of_room(struct pp_year_light *outside,
                                     const struct pp_year_options *options,
                                     const struct pp_world *world,
                                     struct pp_error *err);
void pp_year_light_clear(struct pp_year_light *outside);

/* Availability question for these options and light; it points to both. */
struct pp_availability_question pp_year_light_question(
    const struct pp_year_options *options, const struct pp_year_light *outside);

#endif
