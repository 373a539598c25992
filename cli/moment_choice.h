/* moment_choice.h - options that select sky and sun of one moment: --when and
 * --weather, or --sky with irradiances or illuminances. These options replace the sky
 * in the room file. */
#ifndef PP_CLI_MOMENT_CHOICE_H
#define PP_CLI_MOMENT_CHOICE_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "studies/climate/year_light.h"
#include "studies/year/moment.h"

struct pp_moment_choice {
    const char *when; /* as typed, such as "2023-03-21 15:00"; NULL: not given */
    const char *weather;
    const char *sky; /* value of --sky with irradiances or illuminances; NULL: not
                      * given */
    struct pp_moment_standard standard; /* sky and illuminances, if the sky is not
                                         * perez */
    char standard_name[16];
    struct pp_moment_irradiances of;

    struct pp_year_options light; /* weather file, once loaded */
    struct pp_weather_year year;
};

/* Options --when, and --weather for commands that do not have this option otherwise.
 * The values are stored in a struct pp_moment_choice. */
extern const struct pp_option pp_moment_when_option[];
extern const struct pp_option pp_moment_weather_option[];

/* Reader of --when. Sets `when`, and the time in `of`, of a struct pp_moment_choice. */
pp_option_reader pp_moment_choice_read_when;

/* Moves a sky with irradiances or illuminances from the room's options to *choice.
 * PP_BAD_INPUT if options are missing, or apply only to daylight factors. */
enum pp_status pp_moment_choice_settle(struct pp_moment_choice *choice,
                                       struct pp_room_options *room,
                                       struct pp_error *err);

/* Checks the number of light paths, which must be a power of two for a moment or a
 * year. */
enum pp_status pp_moment_choice_check_paths(const struct pp_room_options *room,
                                            struct pp_error *err);

/* True if the options select one moment. */
bool pp_moment_choice_said(const struct pp_moment_choice *choice);

/* Reads the weather file, if there is one. The caller clears the choice, also after a
 * failure. */
enum pp_exit pp_moment_choice_load(struct pp_moment_choice *choice, bool strict);
void pp_moment_choice_clear(struct pp_moment_choice *choice);

/* Source of the moment for a loaded choice. The choice must exist as long as the
 * source. */
struct pp_moment_source pp_moment_choice_source(const struct pp_moment_choice *choice);

/* Computes sky and sun of the moment at a room's site. */
enum pp_status pp_moment_choice_find(struct pp_moment *moment,
                                     const struct pp_moment_choice *choice,
                                     const struct pp_world *world,
                                     struct pp_error *err);

#endif
