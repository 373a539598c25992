/* self_test.h - the program against answers that are known on paper. */
#ifndef PP_STUDIES_VALIDATION_SELF_TEST_H
#define PP_STUDIES_VALIDATION_SELF_TEST_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"

/* One question; fractions of the open sky, or plain numbers. */
struct pp_self_test_case {
    char what[80];
    const char *by; /* the method, or "traced" */
    double expected;
    double tolerance; /* how far the answer may be off: the rounding of what is
                       * expected, or four standard errors */
    double answer;
    double std_error; /* NAN: not sampled */
};

enum { PP_SELF_TEST_CASES_MOST = 64 };

struct pp_self_test_cases {
    int count;
    struct pp_self_test_case list[PP_SELF_TEST_CASES_MOST];
};

bool pp_self_test_passes(const struct pp_self_test_case *known);

/* Puts all questions to the program; takes a second or two. The seed is that of what is
 * traced. */
enum pp_status pp_self_test_run(struct pp_self_test_cases *known, uint64_t seed,
                                int threads, struct pp_error *err);

#endif
