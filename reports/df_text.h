/* df_text.h - daylight factors of rooms, as text: a table of the points in per cent of
 * the unobstructed horizontal illuminance, and notes below it. */
#ifndef PP_REPORTS_DF_TEXT_H
#define PP_REPORTS_DF_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/df_result.h"

/* Writes text `width` columns wide if possible (60 or more); utf8: uses the character
 * ±. */
enum pp_status pp_df_text(const struct pp_results *results, int width, bool utf8,
                          FILE *out, struct pp_error *err);

#endif
