/* validate_page.h - results of a suite as one self-contained HTML page, without network
 * access or scripts. The page is light or dark, and suitable for print and narrow
 * screens. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_PAGE_H
#define PP_REPORTS_VALIDATE_VALIDATE_PAGE_H

#include <stdio.h>

#include "reports/validate/validate_known.h"

/* Writes the page in UTF-8. Each group has a histogram of differences divided by their
 * limits. Each case has a row. */
void pp_validate_page(const struct pp_known_result *result, FILE *out);

#endif
