/* sized.h - the size of tests with many cases or paths.
 *
 * `make check` runs them at gate size; `make check-long` runs the test programs with
 * --full. A build with AddressSanitizer is up to ten times slower and, without --full,
 * uses the smallest size, since memory errors appear in the first cases as well.
 * Tolerances follow the size.
 */
#ifndef PP_TESTS_LIB_SIZED_H
#define PP_TESTS_LIB_SIZED_H

#include "tests/lib/test_file.h"

#if defined __SANITIZE_ADDRESS__
#define PP_WATCHED 1
#elif defined __has_feature
#if __has_feature(address_sanitizer)
#define PP_WATCHED 1
#endif
#endif
#ifndef PP_WATCHED
#define PP_WATCHED 0
#endif

/* Selects one of three numbers by size. */
#define PP_SIZED(full, gate, watched)                                                  \
    (test_file_full_size() ? (full) : PP_WATCHED ? (watched) : (gate))

#endif
