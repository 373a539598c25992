/* lighting_option.h - options for electric light: --lighting with a control, such as
 * "dimmed,power=8,target=500", and --schedule. */
#ifndef PP_CLI_ANNUAL_LIGHTING_OPTION_H
#define PP_CLI_ANNUAL_LIGHTING_OPTION_H

#include "cli/options.h"
#include "studies/year/annual.h"

/* Lighting controls, in the order of their options. */
struct pp_lighting_choice {
    int count;
    struct pp_lighting_control list[PP_LIGHTING_CONTROLS_MOST]; /* controls; target
                                                                 * illuminance 0: the
                                                                 * default */
    const char *schedule; /* file for the lighting schedule; NULL: none */
};

/* Options for struct pp_option_group; the values are stored in a struct
 * pp_lighting_choice. */
extern const struct pp_option pp_lighting_options[];

/* Checks that the options are consistent. no_blinds: name of the option that excludes
 * blinds; NULL: there are blinds. */
enum pp_status pp_lighting_option_check(const struct pp_lighting_choice *choice,
                                        const char *no_blinds, struct pp_error *err);

/* Copies the controls to *annual. A control without a target gets the first illuminance
 * of *annual. */
void pp_lighting_option_settle(struct pp_annual_options *annual,
                               const struct pp_lighting_choice *choice);

#endif
