/* job.h - opens the output of a command, computes, and prints. The output is opened
 * before the computation, so that a wrong path does not cost hours of work. */
#ifndef PP_CLI_JOB_H
#define PP_CLI_JOB_H

#include <stdbool.h>
#include <stdio.h>

#include "cli/exit_status.h"
#include "model/base/error.h"

struct pp_job {
    const char *output; /* path of the output; NULL or "-": standard output */
    enum pp_status (*compute)(void *data, struct pp_error *err);
    enum pp_status (*print)(const void *data, FILE *out, struct pp_error *err);
    bool (*is_finished)(const void *data); /* false if the simulation was interrupted;
                                            * NULL: there is no simulation */
    void *data;                            /* passed to the functions */
};

/* Opens the output, computes, prints and closes the output; stops at the first failure.
 * Reports errors, and warns if the simulation was not finished. */
enum pp_exit pp_job_run(const struct pp_job *job);

#endif
