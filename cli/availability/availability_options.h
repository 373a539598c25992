/* availability_options.h - options for daylight outside, working hours and target
 * illuminances. */
#ifndef PP_CLI_AVAILABILITY_AVAILABILITY_OPTIONS_H
#define PP_CLI_AVAILABILITY_AVAILABILITY_OPTIONS_H

#include "cli/exit_status.h"
#include "cli/options.h"
#include "studies/climate/sunshine.h"
#include "studies/climate/year_light.h"
#include "model/room/world.h"

/* Option lists for struct pp_option_group; the values are stored in a struct
 * pp_year_options. */
extern const struct pp_option pp_light_options[];
extern const struct pp_option pp_working_time_options[];
extern const struct pp_option pp_illuminance_options[];

/* Checks that the options are consistent. */
enum pp_status pp_availability_options_check(const struct pp_year_options *options,
                                             struct pp_error *err);

/* First of the options --hours, --days, --summer-time and --illuminance whose value is
 * not the default; NULL: none. Static string. */
const char *pp_availability_options_typed(const struct pp_year_options *options);

/* Reads the weather file, if there is one, and reports its errors on standard error. */
enum pp_exit pp_availability_options_load(struct pp_year_options *options, bool strict);
/* Finds, in a loaded weather file, the median diffuse illuminance over the brightest
 * 4380 hours (diffuse_light.h), and the probability of sunshine. If there is no median,
 * reports the reason on standard error. */
enum pp_exit pp_availability_options_median(const struct pp_year_options *options,
                                            double *median_lx,
                                            struct pp_sunshine *sunshine);

void pp_availability_options_clear(struct pp_year_options *options);

#endif
