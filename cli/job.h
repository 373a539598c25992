/* job.h - opens the output of a command, computes, and prints. Because the output is
 * opened first, an invalid path does not waste hours of computation. */
#ifndef PP_CLI_JOB_H
#define PP_CLI_JOB_H

#include <stdbool.h>
#include <stdio.h>

#include "cli/exit_status.h"
#include "model/base/error.h"

struct pp_job {
    const char *output; /* output file; NULL or "-": standard output */
    enum pp_status (*compute)(void *data, struct pp_error *err);
    enum pp_status (*print)(const void *data, FILE *out, struct pp_error *err);
    bool (*is_finished)(const void *data); /* false if the simulation was interrupted;
                                            * function NULL: there is no simulation */
    void *data;                            /* first argument of the functions */
};

/* Opens the output, computes, prints, and closes the output. Stops at the first
 * failure. Reports errors, and warns if the simulation is unfinished. */
enum pp_exit pp_job_run(const struct pp_job *job);

#endif
