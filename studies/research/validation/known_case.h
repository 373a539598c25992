/* known_case.h - comparison of a result of the program with a known value, which was
 * calculated by hand, published, or calculated by an independent part of the
 * program. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_KNOWN_CASE_H
#define PP_STUDIES_RESEARCH_VALIDATION_KNOWN_CASE_H

#include <stdbool.h>

#include "model/base/error.h"
#include "model/results/reading.h"

/* Values are fractions of the open sky's horizontal illuminance, or dimensionless. */
struct pp_known_case {
    char group[48]; /* group of related cases: a method, a table, an experiment */
    char what[80];
    const char *by; /* the method, or "traced" */
    double answer, expected;
    double limit;     /* largest difference allowed: the rounding of `expected`, or a
                       * number of standard errors of the answer; NAN: no verdict */
    double least;     /* least difference allowed: -limit, unless a band specifies
                       * another value */
    double std_error; /* error of a sampled result; NAN: not sampled */
    double assumption,
        formula;             /* the two parts of the difference (own_world.h); NAN: not
                              * available */
    const char *room, *file; /* room and file of a user; NULL: not a user's room. Not
                              * owned */
    const char *why;         /* reason if there is no verdict, otherwise NULL. Not
                              * owned */
};

struct pp_known_cases {
    int count;
    struct pp_known_case *list;
    const char *group; /* group of the cases to be added; NULL: each case has its
                        * method as group */
    bool whole;        /* false: out of memory, and cases are missing */
};

/* An empty list, to be cleared. */
struct pp_known_cases pp_known_case_none(void);
void pp_known_case_clear(struct pp_known_cases *cases);

/* Adds a case; if memory runs out, list->whole becomes false. */
void pp_known_case_add(struct pp_known_cases *cases, const char *what, const char *by,
                       double answer, double expected, double limit);

/* Adds a case whose expected value is in per cent, rounded to `decimals` decimals. */
void pp_known_case_add_per_cent(struct pp_known_cases *cases, const char *what,
                                const char *by, double answer, double per_cent,
                                int decimals);

/* Adds a case for a simulated value, with this number of its standard errors as
 * limit. */
void pp_known_case_add_traced(struct pp_known_cases *cases, const char *what,
                              struct pp_reading reading, double expected,
                              double std_errors);

/* Adds a case of a simulated value. The expected value is in per cent, rounded to
 * `decimals` decimals. The limit is the rounding plus four standard errors. */
void pp_known_case_add_traced_printed(struct pp_known_cases *cases, const char *what,
                                      struct pp_reading reading, double per_cent,
                                      int decimals);

/* True if the difference is within its limits; false without a verdict. */
bool pp_known_case_is_right(const struct pp_known_case *one);

/* True if the case has limits. A case without limits is neither right nor wrong. */
bool pp_known_case_is_judged(const struct pp_known_case *one);

/* Reason `index` among the distinct reasons why cases have no verdict, and the number
 * of its cases; NULL at the end. */
const char *pp_known_case_reason(const struct pp_known_cases *cases, int index,
                                 int *count);

/* True if any case has the two parts of its difference. */
bool pp_known_case_has_parts(const struct pp_known_cases *cases);

/* Position of the difference between its limits: -1 and 1 at the limits, 0 at no
 * difference. If the limits do not enclose 0, the position is 0 midway between them. */
double pp_known_case_share(const struct pp_known_case *one);

#endif
