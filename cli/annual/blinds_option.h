/* blinds_option.h - the options --blinds and --blinds-schedule of annual. */
#ifndef PP_CLI_ANNUAL_BLINDS_OPTION_H
#define PP_CLI_ANNUAL_BLINDS_OPTION_H

#include "cli/options.h"
#include "studies/year/annual.h"

struct pp_blinds_choice {
    enum pp_blinds control;
    bool is_given;    /* by --blinds */
    const char *file; /* of --blinds-schedule; NULL: none */
    unsigned char *schedule;
    int count;
};

/* Reads "lm83", "never", "none" or "always" into a struct pp_blinds_choice. */
enum pp_status pp_blinds_option_read(const char *text, void *place,
                                     struct pp_error *err);

/* Settles the control. PP_BAD_INPUT if both options are given. */
enum pp_status pp_blinds_option_check(struct pp_blinds_choice *choice,
                                      struct pp_error *err);

/* Reads the file of a schedule, if there is one: a line for each record of the year,
 * whose last field is 1 (closed) or 0 (open). Lines that begin with # are comments, and
 * the first line may be a heading. PP_BAD_INPUT if the file has another form, or not as
 * many values as the year has records. */
enum pp_status pp_blinds_option_load(struct pp_blinds_choice *choice, int records,
                                     struct pp_error *err);
void pp_blinds_option_clear(struct pp_blinds_choice *choice);

#endif
