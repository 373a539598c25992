/* report_bytes.h - the columns of a report as bytes, from one process to another of the
 * same program on the same kind of machine. No steps, and nothing of the plane.
 */
#ifndef PP_CLI_RANKS_REPORT_BYTES_H
#define PP_CLI_RANKS_REPORT_BYTES_H

#include <stddef.h>

#include "model/results/report.h"

/* *bytes are the caller's to free. */
enum pp_status pp_report_bytes_write(const struct pp_report *report, char **bytes,
                                     size_t *length, struct pp_error *err);

/* Adds the columns, of as many points as the report has; finished only if both are. */
enum pp_status pp_report_bytes_read(struct pp_report *report, const char *bytes,
                                    size_t length, struct pp_error *err);

#endif
