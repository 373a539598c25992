/* assess_words.h - options of commands that assess rooms: criteria, methods, and the
 * state used for comparison. */
#ifndef PP_CLI_ASSESS_ASSESS_WORDS_H
#define PP_CLI_ASSESS_ASSESS_WORDS_H

#include <stdbool.h>

#include "cli/room_options.h"
#include "model/room/building.h"
#include "model/room/project.h"
#include "pepperpot.h"
#include "studies/climate/sunshine.h"
#include "studies/climate/year_light.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/section_line.h"
#include "studies/criteria/profile.h"
#include "studies/criteria/rules/rule_set.h"
#include "studies/year/weather_year.h"

/* Line about which the building is mirrored, if given. */
struct pp_boundary_words {
    bool given;
    struct pp_mirror_line line;
};

struct pp_assess_words {
    struct pp_room_options room;
    const char *criteria;     /* criteria as typed; NULL: all */
    const char *profile_name; /* name of the profile or rules, as typed; NULL: none */
    const struct pp_profile *profile;
    struct pp_rule_set rules; /* rules of that name, if it is not the name of a
                               * profile */
    bool has_rules;
    bool list_rules;      /* only print the table of rules */
    bool withdrawn;       /* --withdrawn: include withdrawn standards */
    bool table;           /* one table of all rooms instead of one sheet for each
                           * room */
    const char *schedule; /* file for the schedule of windows; NULL: none */
    const char *before;   /* file with the rooms in their former state; NULL: none */
    struct pp_boundary_words mirror_image;
    const char *place; /* a capital from the table in the standard; NULL: the location
                        * of the room */
    double median_lux; /* median illuminance given by the user, used instead of the
                        * median of the place; 0: not given */
    struct pp_grid_choice grid;  /* grid of assessment points, from --spacing */
    double least_altitude_rad;   /* from --least-altitude; 0: not given */
    double shortest_h;           /* from --shortest; 0: not given */
    struct pp_section_place cut; /* position of the sections in a report */
    double french_m;     /* height of the reference point on French windows, m; 0:
                          * middle of the window */
    const char *weather; /* weather file for the median, the probability of sunshine and
                          * a simulated year; NULL: none */
    struct pp_sunshine sunshine;  /* probability of sunshine from the weather file */
    struct pp_year_options light; /* contents of the weather file, once loaded */
    struct pp_weather_year year;  /* hours of the weather file, if a criterion needs a
                                   * simulated year */
    enum pp_format format;
    const char *report_format; /* report: format as typed; NULL: by the extension of the
                                * file */
    struct pp_project project; /* report: facts of the project, which replace those in
                                * the room file */
    bool with_year;            /* report: include a section on the simulated year */
    bool full;                 /* report: print all sections for every room */
    int gains_rooms;           /* report: improvements are searched for only if there
                                * are at most this many rooms, because a longer report
                                * does not show them; 0: any number */
    bool of_averages;          /* report: averages are printed, so the target error of
                                * the simulation applies to averages too */
};

/* Lists for struct pp_option_group; the values are stored in a struct
 * pp_assess_words. */
extern const struct pp_option pp_assess_words_choice[]; /* options for the choice of
                                                         * criteria */
extern const struct pp_option pp_assess_words_table[];  /* the option --table */

/* Callbacks for struct pp_command. */
void pp_assess_words_init(void *words);
void pp_assess_words_clear(void *words);
enum pp_status pp_assess_words_check(void *words, char **files, int file_count,
                                     struct pp_error *err);

/* True if the report or a selected criterion requires a simulated year. */
bool pp_assess_words_need_year(const struct pp_assess_words *words);

/* True if a simulated year is required, or is used if there is a weather file. */
bool pp_assess_words_use_year(const struct pp_assess_words *words);

/* Prints the end of the help text: criteria and profiles. */
void pp_assess_words_help(FILE *out);

#endif
