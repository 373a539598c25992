/* block_height_report.h - the greatest height of a block
 * (studies/sizing/block_height.h), as text and JSON. */
#ifndef PP_REPORTS_BLOCK_HEIGHT_REPORT_H
#define PP_REPORTS_BLOCK_HEIGHT_REPORT_H

#include <stdio.h>

#include "studies/sizing/block_height.h"

/* Writes text in lines of `width` columns (60 or more). */
enum pp_status pp_block_height_report(const struct pp_block_height *found,
                                      const struct pp_block_height_task *task,
                                      int width, FILE *out, struct pp_error *err);
enum pp_status pp_block_height_report_json(const struct pp_block_height *found,
                                           const struct pp_block_height_task *task,
                                           FILE *out, struct pp_error *err);

#endif
