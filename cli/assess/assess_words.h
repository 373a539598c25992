/* assess_words.h - options of commands that assess rooms: criteria, methods, and the
 * state to compare with. */
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

/* Line at which the building is mirrored, if given. */
struct pp_boundary_words {
    bool given;
    struct pp_mirror_line line;
};

struct pp_assess_words {
    struct pp_room_options room;
    const char *criteria;     /* as typed; NULL: all */
    const char *profile_name; /* as typed; NULL: none */
    const struct pp_profile *profile;
    struct pp_rule_set rules; /* of that name, if it is not a profile */
    bool has_rules;
    bool list_rules;      /* print the table of rules, and nothing else */
    bool withdrawn;       /* --withdrawn: include withdrawn standards */
    bool table;           /* one table of all rooms instead of one sheet for each
                           * room */
    const char *schedule; /* file for the schedule of windows; NULL: none */
    const char *before;   /* the file with the room in its former state; NULL: none */
    struct pp_boundary_words mirror_image;
    const char *place; /* a capital from the table of the standard; NULL: the room's
                        * site */
    double median_lux; /* median illuminance given by the user, which replaces that of
                        * the place; 0: not given */
    struct pp_grid_choice grid;  /* of --spacing */
    double least_altitude_rad;   /* from --least-altitude; 0: not given */
    struct pp_section_place cut; /* of the report's sections */
    double french_m;     /* height of the point on French windows, m; 0: the middle */
    const char *weather; /* weather file for the median; NULL: none */
    struct pp_sunshine sunshine;  /* from that file */
    struct pp_year_options light; /* that file, once loaded */
    struct pp_weather_year year;  /* its hours, if a criterion needs a simulated year */
    enum pp_format format;
    const char *report_format; /* report: as typed; NULL: by the file's name */
    struct pp_project project; /* report: project facts that replace those in the
                                * file */
    bool with_year;            /* report: a section on the simulated year */
    bool full;                 /* report: all sections for every room */
    bool of_averages;          /* report: averages are printed, so the simulation must
                                * reach its standard error for them too */
};

/* Lists for struct pp_option_group; the values are stored in a struct
 * pp_assess_words. */
extern const struct pp_option pp_assess_words_choice[]; /* choice of criteria */
extern const struct pp_option pp_assess_words_table[];  /* table */

/* Initialises the options, for struct pp_command. */
void pp_assess_words_init(void *words);
void pp_assess_words_clear(void *words);
enum pp_status pp_assess_words_check(void *words, char **files, int file_count,
                                     struct pp_error *err);

/* True if the year of the weather file is to be simulated. */
bool pp_assess_words_need_year(const struct pp_assess_words *words);

/* True if the year of the weather file, if any, is used. */
bool pp_assess_words_use_year(const struct pp_assess_words *words);

/* Prints the end of the help: criteria and profiles. */
void pp_assess_words_help(FILE *out);

#endif
