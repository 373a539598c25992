/* validate_dots.h - dot charts of the two parts of the errors of hand methods, for an
 * HTML page. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_DOTS_H
#define PP_REPORTS_VALIDATE_VALIDATE_DOTS_H

#include <stdio.h>

#include "studies/research/validation/known_case.h"

/* The style of the charts (CSS). */
extern const char pp_validate_dots_style[];

/* Writes an HTML figure for one group of cases, with one dot per case in each of three
 * rows: the difference and its two parts. The scale is per cent of the expected value.
 * Each row also shows the median. Dots beyond 100 % are at the edge. A case without
 * parts, or with an expected daylight factor below 0.01 %, has no dots. If no case has
 * dots, there is no figure. */
void pp_validate_dots(const struct pp_known_cases *cases, const char *group, FILE *out);

#endif
