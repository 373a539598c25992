/* availability_text.h - availability of daylight, as text. */
#ifndef PP_REPORTS_AVAILABILITY_TEXT_H
#define PP_REPORTS_AVAILABILITY_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/availability_result.h"

/* Writes text in lines of `width` columns (60 or more). utf8: use the character ±. */
enum pp_status pp_availability_text(const struct pp_availability_results *results,
                                    int width, bool utf8, FILE *out,
                                    struct pp_error *err);

#endif
