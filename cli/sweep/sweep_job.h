/* sweep_job.h - runs a command with --sweep: loads all runs, computes all runs, then
 * prints them together. */
#ifndef PP_CLI_SWEEP_SWEEP_JOB_H
#define PP_CLI_SWEEP_SWEEP_JOB_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "pepperpot.h"

struct pp_sweep_job {
    struct pp_room_options *room; /* options of the room; their sweep defines the
                                   * runs */
    enum pp_format format;
    size_t run_bytes; /* size of the struct for a run; its bytes are 0 initially */
    /* Loads the rooms of a run with the current values of room->sweep. */
    enum pp_exit (*load)(void *run, const void *data);
    enum pp_status (*compute)(void *run, struct pp_error *err);
    bool (*is_finished)(const void *run); /* false if the simulation was interrupted;
                                           * function NULL: there is no simulation */
    /* Prints a single run as CSV or JSON. */
    enum pp_status (*print)(const void *run, FILE *out, struct pp_error *err);
    /* Prints all runs, which are an array, as text. */
    enum pp_status (*print_text)(const void *runs, const void *data, FILE *out,
                                 struct pp_error *err);
    void (*clear)(void *run); /* called for every run, even if it was not loaded */
    const void *data;         /* passed to `load` and `print_text` */
};

/* Runs the sweep. An invalid value in any run is reported before the first run is
 * computed. */
enum pp_exit pp_sweep_job_run(const struct pp_sweep_job *job);

#endif
