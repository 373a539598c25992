/* self_test.h - the program against answers that are known on paper: closed forms,
 * limits, and cases worked by hand or by quadrature.
 */
#ifndef PP_STUDIES_VALIDATION_SELF_TEST_H
#define PP_STUDIES_VALIDATION_SELF_TEST_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"

/* One case; expected and answer are fractions of the open sky, or plain numbers. */
struct pp_self_test_case {
    char what[80];
    const char *by; /* the method, or "traced" */
    double expected;
    double tolerance; /* largest difference allowed: the rounding of `expected`, or four
                       * standard errors of the answer */
    double answer;
    double std_error; /* of the answer; NAN: not sampled */
};

enum { PP_SELF_TEST_CASES_MOST = 64 };

struct pp_self_test_cases {
    int count;
    struct pp_self_test_case list[PP_SELF_TEST_CASES_MOST];
};

/* Is the answer within its tolerance? */
bool pp_self_test_passes(const struct pp_self_test_case *one);

/* Runs all cases; takes a second or two. seed and threads are for the traced ones. */
enum pp_status pp_self_test_run(struct pp_self_test_cases *cases, uint64_t seed,
                                int threads, struct pp_error *err);

#endif
