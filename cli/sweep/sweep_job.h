/* sweep_job.h - the course of a command with --sweep: all runs are loaded, then all are
 * computed, and then they are printed together. */
#ifndef PP_CLI_SWEEP_SWEEP_JOB_H
#define PP_CLI_SWEEP_SWEEP_JOB_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "pepperpot.h"

struct pp_sweep_job {
    struct pp_room_options *room; /* its sweep gives the runs */
    enum pp_format format;
    /* Loads the rooms of a run, with the current values of room->sweep. */
    enum pp_exit (*load)(void *data, int run);
    enum pp_status (*compute)(void *data, int run, struct pp_error *err);
    bool (*is_finished)(const void *data, int run);
    /* Prints a run alone, as CSV or JSON. */
    enum pp_status (*print)(const void *data, int run, FILE *out, struct pp_error *err);
    /* Prints all runs as text. */
    enum pp_status (*print_text)(const void *data, FILE *out, struct pp_error *err);
    void *data; /* passed to the functions */
};

/* Runs the sweep. A wrong value in any run is reported before anything is computed. */
enum pp_exit pp_sweep_job_run(const struct pp_sweep_job *job);

#endif
