/* annual_text.h - annual results of rooms, as text. */
#ifndef PP_REPORTS_ANNUAL_ANNUAL_TEXT_H
#define PP_REPORTS_ANNUAL_ANNUAL_TEXT_H

#include <stdio.h>

#include "model/base/error.h"
#include "reports/annual/annual_result.h"

/* Writes lines of at most `width` columns. utf8: also use characters outside ASCII. */
enum pp_status pp_annual_text(const struct pp_annual_results *results, int width,
                              bool utf8, FILE *out, struct pp_error *err);

#endif
