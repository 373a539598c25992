/* room_options.h - options common to all commands on a room. */
#ifndef PP_CLI_ROOM_OPTIONS_H
#define PP_CLI_ROOM_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "cli/options.h"
#include "model/base/ranks.h"
#include "model/room/project.h"
#include "model/room/world.h"
#include "studies/study_options.h"
#include "studies/sweep.h"

struct pp_room_options {
    struct pp_study_options study;
    double plane_m;           /* height of the working plane; 0: as in the file */
    const char *room;         /* only the rooms of that name; NULL: all */
    enum pp_site_state state; /* state of the site; PP_STATE_BOTH: not given */
    const char *output;       /* NULL: standard output */
    bool quiet;
    struct pp_sweep sweep;        /* --set and --sweep, with the current run */
    bool by_hand;                 /* no simulation, for a command that simulates by
                                   * default */
    const struct pp_ranks *ranks; /* not owned; NULL: this process is alone */
};

/* Reads "existing", "proposed" or "cumulative" (enum pp_site_state), as options do. */
enum pp_status pp_room_options_read_state(const char *text, void *place,
                                          struct pp_error *err);

/* Default options: seed 1, all else empty. */
extern const struct pp_room_options pp_room_options_none;

/* Lists for struct pp_option_group; the values are stored in a struct
 * pp_room_options. */
extern const struct pp_option pp_room_methods_option[];
extern const struct pp_option pp_room_points_option[];
extern const struct pp_option pp_room_sky_options[]; /* sky, room */
extern const struct pp_option pp_room_external_option[];
/* vsc-point-french. Its value is one double, 0 if the option is not given. */
extern const struct pp_option pp_room_french_option[];
/* Facts for the title block, except the project number; the values are stored in a
 * struct pp_project. */
extern const struct pp_option pp_room_project_options[];
/* cut. Its value is a struct pp_section_place (section_line.h). */
extern const struct pp_option pp_room_cut_option[];
/* spacing. Its value is a struct pp_grid_choice, empty if the option is not given. */
extern const struct pp_option pp_room_spacing_option[];
extern const struct pp_option pp_room_simulate_option[];
/* Options of commands that simulate by default: simulate, and its opposite by-hand. */
extern const struct pp_option pp_room_by_hand_options[];
extern const struct pp_option pp_room_stop_options[]; /* error, samples, time */
extern const struct pp_option pp_room_plain_option[];
extern const struct pp_option pp_room_seed_options[];   /* seed, threads */
extern const struct pp_option pp_room_output_options[]; /* output, quiet */

/* Rows of a command's list of groups. at: offset of the struct pp_room_options. */
#define PP_ROOM_CHOICE_GROUPS(title, at)                                               \
    {title, pp_room_methods_option, at}, {title, pp_room_points_option, at},           \
    {                                                                                  \
        title, pp_room_sky_options, at                                                 \
    }
#define PP_ROOM_PLACE_GROUPS(title, at)                                                \
    {title, pp_room_points_option, at},                                                \
    {                                                                                  \
        title, pp_room_sky_options, at                                                 \
    }
#define PP_ROOM_STOP_GROUPS(at)                                                        \
    {"Simulation", pp_room_stop_options, at},                                          \
    {                                                                                  \
        "Simulation", pp_room_seed_options, at                                         \
    }
#define PP_ROOM_BY_HAND_GROUPS(at)                                                     \
    {"Simulation", pp_room_by_hand_options, at}, PP_ROOM_STOP_GROUPS(at)
#define PP_ROOM_SIMULATION_GROUPS(at)                                                  \
    {"Simulation", pp_room_simulate_option, at}, PP_ROOM_STOP_GROUPS(at)

/* Resolves --simulate, --by-hand and the options that stop a simulation, for a command
 * that simulates by default. Call it before pp_room_options_settle. */
enum pp_status pp_room_options_settle_by_hand(struct pp_room_options *options,
                                              struct pp_error *err);

/* PP_BAD_INPUT if the options are inconsistent. A simulation without a stop option runs
 * to a standard error of 1 %. */
enum pp_status pp_room_options_settle(struct pp_room_options *options,
                                      struct pp_error *err);

void pp_room_options_clear(struct pp_room_options *options);

#endif
