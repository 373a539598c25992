/* sweep_text.h - the results of all runs of a sweep as one text table. */
#ifndef PP_REPORTS_SWEEP_SWEEP_TEXT_H
#define PP_REPORTS_SWEEP_SWEEP_TEXT_H

#include <stdio.h>

#include "reports/assess/assess_text.h"
#include "reports/df_result.h"
#include "reports/parts/table.h"
#include "reports/size_report.h"
#include "studies/sweep.h"

/* Writes one row for each run and room, with the average by each method. With --points,
 * writes one row for each point and one for the average, with the value by each method.
 * runs: results of each run. */
enum pp_status pp_sweep_df_text(const struct pp_sweep *sweep,
                                const struct pp_results *const *runs, int width,
                                bool utf8, FILE *out, struct pp_error *err);

/* Writes one row for each finding and one column for each run. */
enum pp_status pp_sweep_assess_text(const struct pp_sweep *sweep,
                                    const struct pp_assessments *const *runs, int width,
                                    bool utf8, FILE *out, struct pp_error *err);

/* Writes one row for each run and room: the size, the value by the method, the
 * simulated value, and whether the target is reached. */
enum pp_status pp_sweep_size_text(const struct pp_sweep *sweep,
                                  const struct pp_size_results *const *runs, int width,
                                  bool utf8, FILE *out, struct pp_error *err);

/* Adds the key columns with the swept values. of_run[i]: index of the run in row i.
 * Returns false if memory is exhausted. */
bool pp_sweep_text_keys(struct pp_table *table, const struct pp_sweep *sweep,
                        const int *of_run);

/* Writes a value in per cent, "2.31" or "2.31 +-0.02", or "-" if there is none. */
void pp_sweep_text_reading(char cell[PP_CELL_BYTES], const struct pp_reading *reading,
                           bool utf8);

#endif
