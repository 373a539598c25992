/* df_text.h - daylight factors of rooms as text: a table of values in per cent of the
 * unobstructed horizontal illuminance, and notes below it. */
#ifndef PP_REPORTS_DF_TEXT_H
#define PP_REPORTS_DF_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/df_result.h"

/* Writes text in lines of `width` columns (60 or more) if possible. utf8: use the
 * character ±. */
enum pp_status pp_df_text(const struct pp_results *results, int width, bool utf8,
                          FILE *out, struct pp_error *err);

#endif
