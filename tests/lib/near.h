/* near.h - cmocka, the list of a file's tests, and assertions about numbers. */
#ifndef PP_TESTS_LIB_NEAR_H
#define PP_TESTS_LIB_NEAR_H

#include "tests/lib/test_file.h"

#include <math.h>
#include <string.h>

#define assert_near(value, expected, tolerance)                                        \
    do {                                                                               \
        double value_ = (value), expected_ = (expected);                               \
        if (!(fabs(value_ - expected_) <= (tolerance)))                                \
            fail_msg("%s is %.17g, expected %.17g +- %g", #value, value_, expected_,   \
                     (double)(tolerance));                                             \
    } while (0)

#define assert_relative(value, expected, tolerance)                                    \
    assert_near(value, expected, (tolerance)*fabs(expected))

#endif
