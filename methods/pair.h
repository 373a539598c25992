/* pair.h - a daylight factor by two methods: the direct component by one, the internally
 * reflected by another. */
#ifndef PP_METHODS_PAIR_H
#define PP_METHODS_PAIR_H

#include "model/base/error.h"
#include "model/results/report.h"

/* Adds the column "direct+internal" from the columns of these names, which are there,
 * unless the report has it already. */
enum pp_status pp_pair_add(struct pp_report *report, const char *direct,
                           const char *internal, struct pp_error *err);

#endif
