/* report_bytes.h - converts the columns of a report to bytes and back, for another
 * process of the same program on the same kind of machine. Steps and figures of the
 * plane are omitted. */
#ifndef PP_CLI_RANKS_REPORT_BYTES_H
#define PP_CLI_RANKS_REPORT_BYTES_H

#include <stddef.h>

#include "model/results/report.h"

/* The caller frees *bytes. */
enum pp_status pp_report_bytes_write(const struct pp_report *report, char **bytes,
                                     size_t *length, struct pp_error *err);

/* Adds the columns in `bytes` to a report. They must have as many points as the report.
 * The report counts as finished only if both are. */
enum pp_status pp_report_bytes_read(struct pp_report *report, const char *bytes,
                                    size_t length, struct pp_error *err);

#endif
