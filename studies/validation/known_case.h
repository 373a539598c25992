/* known_case.h - an answer of the program beside one that is known otherwise: on paper, in
 * print, or by a part of the program that shares no way of finding it.
 */
#ifndef PP_STUDIES_VALIDATION_KNOWN_CASE_H
#define PP_STUDIES_VALIDATION_KNOWN_CASE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"

/* Values are fractions of the open sky's horizontal illuminance, or plain numbers. */
struct pp_known_case {
    char group[48]; /* what belongs together: a method, a table, an experiment */
    char what[80];
    const char *by; /* the method, or "traced" */
    double answer, expected;
    double limit;     /* the largest difference allowed: the rounding of `expected`, or
                       * standard errors of the answer */
    double std_error; /* of the answer; NAN: not sampled */
};

struct pp_known_cases {
    int count;
    struct pp_known_case *list;
    const char *group; /* of the cases that are added; NULL: each one's method */
    bool whole;        /* false: memory was out, and cases are missing */
};

/* An empty list, to be cleared. */
struct pp_known_cases pp_known_case_none(void);
void pp_known_case_clear(struct pp_known_cases *cases);

/* Adds a case; where memory is out, the list says so by `whole`. */
void pp_known_case_add(struct pp_known_cases *cases, const char *what, const char *by,
                       double answer, double expected, double limit);

/* The same, expected in per cent and rounded to that number of decimals. */
void pp_known_case_add_per_cent(struct pp_known_cases *cases, const char *what,
                                const char *by, double answer, double per_cent,
                                int decimals);

/* The same, of a traced value: within so many of its standard errors. */
void pp_known_case_add_traced(struct pp_known_cases *cases, const char *what,
                              struct pp_reading reading, double expected,
                              double std_errors);

/* Traced, and expected in per cent, rounded to that number of decimals: within that and
 * four standard errors. */
void pp_known_case_add_traced_printed(struct pp_known_cases *cases, const char *what,
                                      struct pp_reading reading, double per_cent,
                                      int decimals);

/* Is the answer within its limit? */
bool pp_known_case_is_right(const struct pp_known_case *one);

#endif
