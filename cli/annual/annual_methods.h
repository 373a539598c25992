/* annual_methods.h - options of `annual` for hand methods: --methods, --df, --explain
 * and --when. */
#ifndef PP_CLI_ANNUAL_ANNUAL_METHODS_H
#define PP_CLI_ANNUAL_ANNUAL_METHODS_H

#include "cli/moment_choice.h"
#include "cli/rooms.h"
#include "studies/year/hand/hand_year.h"

struct pp_annual_methods {
    const char *methods; /* names of the methods as typed; NULL: none */
    const char *df;      /* method of the daylight factor; NULL or "simulated":
                          * simulation */
    bool explain;
    struct pp_moment_choice moment; /* moment given by --when */
    struct pp_hand_year_options options;
};

/* Options stored in a struct pp_annual_methods. */
extern const struct pp_option pp_annual_methods_options[];

/* Finds the methods by name. PP_BAD_INPUT if an option lacks another option that it
 * requires. csv: the results are written as CSV, which excludes explanations. */
enum pp_status pp_annual_methods_settle(struct pp_annual_methods *methods, bool csv,
                                        struct pp_error *err);

/* Checks the rooms: PP_BAD_INPUT if an explanation would be for more than one point. */
enum pp_status pp_annual_methods_check_rooms(const struct pp_annual_methods *methods,
                                             const struct pp_rooms *rooms,
                                             struct pp_error *err);

/* Prints the list of methods, which is the last part of the help text. */
void pp_annual_methods_help(FILE *out);

#endif
