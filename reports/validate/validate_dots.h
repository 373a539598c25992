/* validate_dots.h - where the errors of hand methods come from, as dot charts for a page.
 */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_DOTS_H
#define PP_REPORTS_VALIDATE_VALIDATE_DOTS_H

#include <stdio.h>

#include "studies/research/validation/known_case.h"

/* The style of the charts (CSS). */
extern const char pp_validate_dots_style[];

/* A figure of HTML for one group of cases: three rows of dots, one dot a case, for the
 * difference and its two parts, in per cent of what was expected, with the median of each.
 * What is beyond 100 % stands at the edge. Cases without parts, or that expect less than
 * 0.01 % daylight factor, have no dots; a group of such has no figure. */
void pp_validate_dots(const struct pp_known_cases *cases, const char *group, FILE *out);

#endif
