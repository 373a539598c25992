/* availability_options.h - where the light outside comes from, and when and how much of
 * it is wanted.
 */
#ifndef PP_CLI_AVAILABILITY_AVAILABILITY_OPTIONS_H
#define PP_CLI_AVAILABILITY_AVAILABILITY_OPTIONS_H

#include "cli/exit_status.h"
#include "cli/options.h"
#include "studies/climate/availability.h"
#include "model/room/world.h"

struct pp_clock_times {
    int count;
    struct pp_working_hours list[PP_PERIODS_MOST]; /* of all days */
};

struct pp_illuminances {
    int count;
    double lx[PP_ILLUMINANCES_MOST];
};

struct pp_summer_choice {
    bool of_file;
    struct pp_summer_time time; /* else; months 0: none */
};

/* NAN: not said. */
struct pp_availability_options {
    const char *weather;                /* file; NULL: an overcast sky */
    double latitude_deg, longitude_deg; /* of that sky, */
    double time_zone_h;                 /* and of its clock */
    struct pp_clock_times hours;
    unsigned days; /* bits, from Monday */
    struct pp_summer_choice summer;
    struct pp_illuminances illuminances;

    struct pp_epw
        *epw; /* by pp_availability_options_load; NULL without a weather file */
};

/* 8-18 and 9-17, all days, no summer time, 300 and 500 lx. */
extern const struct pp_availability_options pp_availability_options_default;

/* For struct pp_option_group, with a struct pp_availability_options as values: the
 * light outside and the hours; and the illuminances wanted. */
extern const struct pp_option pp_light_options[];
extern const struct pp_option pp_illuminance_options[];

/* Do the options make sense together, and with the room files? */
enum pp_status pp_availability_options_check(
    const struct pp_availability_options *options, char *const *files, int file_count,
    struct pp_error *err);

/* Reads the weather file, if there is one, and says on standard error what is wrong
 * with it. */
enum pp_exit pp_availability_options_load(struct pp_availability_options *options);
/* Reads a weather file for the median of its diffuse illuminance over the brightest
 * 4380 hours alone, and says on standard error why it has none. */
enum pp_exit pp_availability_options_median(const char *path, double *median_lx);

void pp_availability_options_clear(struct pp_availability_options *options);

/* The light outside of one room (world may be NULL), and what is said of it. */
struct pp_environment_light {
    struct pp_diffuse_light light;
    char words[640], calendar[160];
    struct pp_working_hours periods[PP_PERIODS_MOST];
    double latitude_deg;
};

/* *outside is to be cleared, in any case. PP_BAD_INPUT where nothing says at which
 * latitude, or where days of the week are asked for and not known. */
enum pp_status pp_availability_options_light(
    struct pp_environment_light *outside, const struct pp_availability_options *options,
    const struct pp_world *world, struct pp_error *err);
void pp_availability_options_light_clear(struct pp_environment_light *outside);

/* The question that options and light make; good as long as they are. */
struct pp_availability_question pp_availability_options_question(
    const struct pp_availability_options *options,
    const struct pp_environment_light *outside);

#endif
