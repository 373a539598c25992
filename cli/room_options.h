/* room_options.h - options shared by all commands for rooms. */
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
    double plane_m;           /* height of the working plane; 0: height in the file */
    const char *room;         /* name of the rooms to be used; NULL: all rooms */
    enum pp_site_state state; /* state of the site; PP_STATE_BOTH: not given */
    const char *output;       /* NULL: standard output */
    bool quiet;
    struct pp_sweep sweep;        /* values of --set and --sweep, and the current run of
                                   * the sweep */
    bool by_hand;                 /* --by-hand: no simulation, for a command that
                                   * otherwise simulates */
    const struct pp_ranks *ranks; /* not owned; NULL: this process is alone */
};

/* Option reader for "existing", "proposed" or "cumulative" (enum pp_site_state). */
enum pp_status pp_room_options_read_state(const char *text, void *place,
                                          struct pp_error *err);

/* Default options: seed 1; all other options are empty. */
extern const struct pp_room_options pp_room_options_none;

/* Lists for struct pp_option_group; the values are stored in a struct
 * pp_room_options. */
extern const struct pp_option pp_room_methods_option[];
extern const struct pp_option pp_room_points_option[];
extern const struct pp_option pp_room_sky_options[]; /* --sky, --room, --state */
extern const struct pp_option pp_room_external_option[];
/* Option --vsc-point-french. Its value is one double; 0 if the option is not given. */
extern const struct pp_option pp_room_french_option[];
/* Options for the facts of the title block, except the project number. The values are
 * stored in a struct pp_project. */
extern const struct pp_option pp_room_project_options[];
/* Option --cut. Its value is a struct pp_section_place (section_line.h). */
extern const struct pp_option pp_room_cut_option[];
/* Option --spacing. Its value is a struct pp_grid_choice, empty if the option is not
 * given. */
extern const struct pp_option pp_room_spacing_option[];
extern const struct pp_option pp_room_simulate_option[];
/* Options --simulate and --by-hand, for commands that simulate by default. */
extern const struct pp_option pp_room_by_hand_options[];
extern const struct pp_option pp_room_stop_options[]; /* --error, --samples, --time */
extern const struct pp_option pp_room_plain_option[];
extern const struct pp_option pp_room_seed_options[];   /* --seed, --threads */
extern const struct pp_option pp_room_output_options[]; /* --output, --quiet,
                                                         * --strict */

/* Elements of a command's list of option groups. at: offset of the struct
 * pp_room_options in the command's struct. */
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

/* Settles --simulate, --by-hand and the options that end a simulation, for a command
 * that simulates by default. Call this before pp_room_options_settle. */
enum pp_status pp_room_options_settle_by_hand(struct pp_room_options *options,
                                              struct pp_error *err);

/* Checks the options; PP_BAD_INPUT if they are inconsistent. If no option ends the
 * simulation, sets the target standard error to 1 %. Also sets the first run of a
 * sweep. */
enum pp_status pp_room_options_settle(struct pp_room_options *options,
                                      struct pp_error *err);

void pp_room_options_clear(struct pp_room_options *options);

#endif
