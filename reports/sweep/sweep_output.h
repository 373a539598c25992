/* sweep_output.h - the results of all runs of a sweep as one CSV table or JSON
 * object. */
#ifndef PP_REPORTS_SWEEP_SWEEP_OUTPUT_H
#define PP_REPORTS_SWEEP_SWEEP_OUTPUT_H

#include <stdio.h>

#include "model/base/error.h"
#include "studies/sweep.h"

/* Callback that prints the results of one run, in the format used without --sweep. */
typedef enum pp_status pp_sweep_output_run(const void *data, int run, FILE *out,
                                           struct pp_error *err);

/* Writes the lines of all runs below one header. Each line begins with the swept
 * values. The header must be the same in all runs. */
enum pp_status pp_sweep_output_csv(const struct pp_sweep *sweep,
                                   pp_sweep_output_run *print, const void *data,
                                   FILE *out, struct pp_error *err);

/* Writes {"format": "pepperpot-sweep-1", "runs": [{"set": {ADDRESS: VALUE}, "result":
 * ...}]}. */
enum pp_status pp_sweep_output_json(const struct pp_sweep *sweep,
                                    pp_sweep_output_run *print, const void *data,
                                    FILE *out, struct pp_error *err);

#endif
