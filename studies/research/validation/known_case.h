/* known_case.h - an answer of the program beside one that is known otherwise: on paper, in
 * print, or by a part of the program that shares no way of finding it.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_KNOWN_CASE_H
#define PP_STUDIES_RESEARCH_VALIDATION_KNOWN_CASE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"

/* Values are fractions of the open sky's horizontal illuminance, or plain numbers. */
struct pp_known_case {
    char group[48]; /* group of related cases: a method, a table, an experiment */
    char what[80];
    const char *by; /* the method, or "traced" */
    double answer, expected;
    double limit;     /* the largest difference allowed: the rounding of `expected`, or
                       * standard errors of the answer; NAN: there is no verdict */
    double least;     /* the smallest, -limit unless a band says otherwise */
    double std_error; /* of a sampled result; NAN: not sampled */
    double assumption,
        formula;             /* the parts of the difference (own_world.h); NAN: it has
                                 * none */
    const char *room, *file; /* of a user's room; NULL: it is no user's. Not owned */
    const char *why; /* why there is no verdict; NULL: there is one. Not owned */
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

/* Adds a case of a simulated value, whose limit is this many of its standard errors. */
void pp_known_case_add_traced(struct pp_known_cases *cases, const char *what,
                              struct pp_reading reading, double expected,
                              double std_errors);

/* Traced, and expected in per cent, rounded to that number of decimals: within that and
 * four standard errors. */
void pp_known_case_add_traced_printed(struct pp_known_cases *cases, const char *what,
                                      struct pp_reading reading, double per_cent,
                                      int decimals);

/* True if the answer is within its limits; false without a verdict. */
bool pp_known_case_is_right(const struct pp_known_case *one);

/* True if it has limits. A case without limits is neither right nor wrong. */
bool pp_known_case_is_judged(const struct pp_known_case *one);

/* Reason `index` among the distinct reasons why cases have no verdict, and the number
 * of its cases; NULL at the end. */
const char *pp_known_case_reason(const struct pp_known_cases *cases, int index,
                                 int *count);

/* True if any has the two parts of its difference. */
bool pp_known_case_has_parts(const struct pp_known_cases *cases);

/* The difference over its limit on that side: -1 and 1 at the limits, 0 where there is none;
 * where none at all would be outside, 0 is in the middle between the limits. */
double pp_known_case_share(const struct pp_known_case *one);

#endif
