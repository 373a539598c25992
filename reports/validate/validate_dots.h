/* validate_dots.h - the two parts of hand methods' errors, as dot charts for a
 * page. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_DOTS_H
#define PP_REPORTS_VALIDATE_VALIDATE_DOTS_H

#include <stdio.h>

#include "studies/research/validation/known_case.h"

/* The style of the charts (CSS). */
extern const char pp_validate_dots_style[];

/* Writes an HTML figure for one group of cases: three rows of dots, one dot per case,
 * for the difference and its two parts, in per cent of the expected value, with the
 * median of each. Dots beyond 100 % are at the edge. Cases without parts, or with less
 * than 0.01 % daylight factor expected, have no dots; a group of such cases has no
 * figure. */
void pp_validate_dots(const struct pp_known_cases *cases, const char *group, FILE *out);

#endif
