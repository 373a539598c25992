/* validate_known.h - comparison of results with known values as text, JSON and CSV. */
#ifndef PP_REPORTS_VALIDATE_VALIDATE_KNOWN_H
#define PP_REPORTS_VALIDATE_VALIDATE_KNOWN_H

#include <stdio.h>

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/suite.h"

/* Results of a suite. */
struct pp_known_result {
    const struct pp_suite *suite;
    struct pp_known_cases cases;
};

/* Prints the cases by group: result, expected value, their difference, its limit, and
 * the verdict. Then prints how many cases are correct, and why cases have no verdict.
 * These sentences are wrapped at `width`. */
void pp_validate_known_text(const struct pp_known_result *result, int width, FILE *out);
enum pp_status pp_validate_known_json(const struct pp_known_result *result, FILE *out,
                                      struct pp_error *err);
void pp_validate_known_csv(const struct pp_known_result *result, FILE *out);

#endif
