/* validate_page.h - results of a suite as one self-contained page of HTML: no network,
 * no script; light or dark, for paper and narrow screens. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_PAGE_H
#define PP_REPORTS_VALIDATE_VALIDATE_PAGE_H

#include <stdio.h>

#include "reports/validate/validate_known.h"

/* Writes a page in UTF-8: for each group a histogram of differences over their limits,
 * for each case a row. */
void pp_validate_page(const struct pp_known_result *result, FILE *out);

#endif
