/* moment_choice.h - the options --when and --weather, or a --sky with its irradiances
 * or illuminances: sky and sun of one moment, which replace the room file's sky. */
#ifndef PP_CLI_MOMENT_CHOICE_H
#define PP_CLI_MOMENT_CHOICE_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "studies/climate/year_light.h"
#include "studies/year/moment.h"

struct pp_moment_choice {
    const char *when; /* as typed, "2023-03-21 15:00"; NULL: not given */
    const char *weather;
    const char *sky; /* --sky with irradiances or illuminances; NULL: not given */
    struct pp_moment_standard standard; /* the sky, if it is not perez */
    char standard_name[16];
    struct pp_moment_irradiances of;

    struct pp_year_options light; /* loaded */
    struct pp_weather_year year;
};

/* Options stored in a struct pp_moment_choice: --when, and --weather for commands without
 * a weather file of their own. */
extern const struct pp_option pp_moment_when_option[];
extern const struct pp_option pp_moment_weather_option[];

/* Reader of --when; the value is a struct pp_moment_choice, of which it sets `when` and
 * the time in `of`. */
pp_option_reader pp_moment_choice_read_when;

/* Moves a sky with irradiances or illuminances from the room's options to the choice. PP_BAD_INPUT if
 * options are missing, or apply to daylight factors only. */
enum pp_status pp_moment_choice_settle(struct pp_moment_choice *choice,
                                       struct pp_room_options *room,
                                       struct pp_error *err);

/* Checks the number of paths, which for a moment or a year must be a power of two. */
enum pp_status pp_moment_choice_check_paths(const struct pp_room_options *room,
                                            struct pp_error *err);

/* True if the options select one moment. */
bool pp_moment_choice_said(const struct pp_moment_choice *choice);

/* Reads the weather file, if there is one. The caller clears the choice in any case. */
enum pp_exit pp_moment_choice_load(struct pp_moment_choice *choice, bool strict);
void pp_moment_choice_clear(struct pp_moment_choice *choice);

/* Source of the moment, for a loaded choice, which must outlive it. */
struct pp_moment_source pp_moment_choice_source(const struct pp_moment_choice *choice);

/* Computes sky and sun of the moment at a room's site. */
enum pp_status pp_moment_choice_find(struct pp_moment *moment,
                                     const struct pp_moment_choice *choice,
                                     const struct pp_world *world,
                                     struct pp_error *err);

#endif
