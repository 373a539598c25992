/* suite.h - suites of cases with independently known results, one entry each. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_SUITE_H
#define PP_STUDIES_RESEARCH_VALIDATION_SUITE_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/known_room.h"

struct pp_suite {
    const char *name, *summary;
    const char *limits; /* description of the limits of its cases, a sentence */
    /* Fraction of traced cases that may be outside their limits by chance; 0: none. */
    double chance;
    bool of_rooms; /* the cases are from a user's rooms; `run` is NULL */
    long samples;  /* default for simulated cases: paths per point in each
                    * randomisation */
    enum pp_status (*run)(struct pp_known_cases *cases,
                          const struct pp_known_trace *how, struct pp_error *err);
};

/* suites[index]; NULL at the end. index is at most one past the last. */
const struct pp_suite *pp_suite_at(int index);

/* The suite with this name, or NULL. */
const struct pp_suite *pp_suite_find(const char *name);

/* The suites of a user's rooms. */
extern const struct pp_suite pp_suite_rooms, pp_suite_radiance, pp_suite_engines;

/* The quick suite, which takes one or two seconds: closed forms and worked examples. */
extern const struct pp_suite pp_suite_quick;

/* Outcome of a suite's cases. */
struct pp_suite_score {
    int count, wrong; /* cases that are not traced */
    int traced, traced_wrong;
    int unjudged; /* cases without a verdict, not counted above */
    bool passes;
};
struct pp_suite_score pp_suite_score(const struct pp_suite *suite,
                                     const struct pp_known_cases *cases);

#endif
