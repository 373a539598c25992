/* validate_page.h - what a suite found as one page of HTML that needs nothing else: no
 * network, no script; light and dark, on paper and on narrow screens.
 */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_PAGE_H
#define PP_REPORTS_VALIDATE_VALIDATE_PAGE_H

#include <stdio.h>

#include "reports/validate/validate_known.h"

/* In UTF-8. Every group has a histogram of its differences over their limits, and every
 * case a row. */
void pp_validate_page(const struct pp_known_result *result, FILE *out);

#endif
