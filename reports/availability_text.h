/* availability_text.h - how often daylight does, as text for people. */
#ifndef PP_REPORTS_AVAILABILITY_TEXT_H
#define PP_REPORTS_AVAILABILITY_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "reports/availability_result.h"

/* Text `width` columns wide (60 or more); utf8: with a true plus-minus sign. */
enum pp_status pp_availability_text(const struct pp_availability_results *results,
                                    int width, bool utf8, FILE *out,
                                    struct pp_error *err);

#endif
