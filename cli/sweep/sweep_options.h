/* sweep_options.h - the options --set and --sweep. */
#ifndef PP_CLI_SWEEP_SWEEP_OPTIONS_H
#define PP_CLI_SWEEP_SWEEP_OPTIONS_H

#include "cli/options.h"
#include "studies/sweep.h"

/* Options --set and --sweep. The values are stored in a struct pp_sweep. */
extern const struct pp_option pp_sweep_options[];

/* Checks the number of runs: PP_BAD_INPUT if it exceeds PP_SWEEP_RUNS_MOST. */
enum pp_status pp_sweep_options_check(const struct pp_sweep *sweep,
                                      struct pp_error *err);

#endif
