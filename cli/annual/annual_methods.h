/* annual_methods.h - the options of annual for hand methods: --methods, --df, --explain,
 * --when. */
#ifndef PP_CLI_ANNUAL_ANNUAL_METHODS_H
#define PP_CLI_ANNUAL_ANNUAL_METHODS_H

#include "cli/moment_choice.h"
#include "cli/rooms.h"
#include "studies/year/hand/hand_year.h"

struct pp_annual_methods {
    const char *methods; /* as typed; NULL: none */
    const char *df;      /* NULL or "simulated": simulated */
    bool explain;
    struct pp_moment_choice moment; /* --when alone */
    struct pp_hand_year_options options;
};

/* Options stored in a struct pp_annual_methods. */
extern const struct pp_option pp_annual_methods_options[];

/* Reads the names. PP_BAD_INPUT if options need others that are missing. */
enum pp_status pp_annual_methods_settle(struct pp_annual_methods *methods, bool csv,
                                        struct pp_error *err);

/* PP_BAD_INPUT if an explanation is for more than one point. */
enum pp_status pp_annual_methods_check_rooms(const struct pp_annual_methods *methods,
                                             const struct pp_rooms *rooms,
                                             struct pp_error *err);

/* Prints the list of methods, for the end of the help. */
void pp_annual_methods_help(FILE *out);

#endif
