/* assess_sweep.h - the command assess with --sweep. */
#ifndef PP_CLI_ASSESS_ASSESS_SWEEP_H
#define PP_CLI_ASSESS_ASSESS_SWEEP_H

#include "cli/assess/assess_words.h"
#include "cli/exit_status.h"

/* Assesses the rooms once for each combination of swept values. `print` prints one run
 * as CSV or JSON; the `data` of `print` is a struct pp_assess_run. */
enum pp_exit pp_assess_sweep_run(struct pp_assess_words *words, char **files,
                                 int file_count,
                                 enum pp_status (*print)(const void *data, FILE *out,
                                                         struct pp_error *err));

#endif
