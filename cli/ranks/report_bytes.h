/* report_bytes.h - converts the columns of a report to bytes and back, for transfer to
 * another process of the same program on the same kind of machine. Steps and plane
 * figures are omitted. */
#ifndef PP_CLI_RANKS_REPORT_BYTES_H
#define PP_CLI_RANKS_REPORT_BYTES_H

#include <stddef.h>

#include "model/results/report.h"

/* Converts the columns to bytes. The caller frees *bytes. */
enum pp_status pp_report_bytes_write(const struct pp_report *report, char **bytes,
                                     size_t *length, struct pp_error *err);

/* Adds the columns in `bytes` to a report with the same number of points. Afterwards
 * the report is finished only if it was finished before and the columns are
 * finished. */
enum pp_status pp_report_bytes_read(struct pp_report *report, const char *bytes,
                                    size_t length, struct pp_error *err);

#endif
