/* test_file.h - the tests of one file; a folder's test program runs them with those of
 * its other files. Instead of main() a file ends with
 *
 *     TEST_FILE
 *     {
 *         const struct CMUnitTest tests[] = {cmocka_unit_test(a_fact), ...};
 *         add_tests(tests, NULL, NULL);
 *     }
 *
 * add_tests also takes a set-up and a tear-down for all of them. add_long_tests is for
 * tests that take too long for every build; they run only with --full, in `make
 * check-long`. test_main.c has main().
 */
#ifndef PP_TESTS_LIB_TEST_FILE_H
#define PP_TESTS_LIB_TEST_FILE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Runs before main(), which finds the tests registered. */
#define TEST_FILE                                                                      \
    static void list_tests(void) __attribute__((constructor));                         \
    static void list_tests(void)

#define add_tests(tests, set_up, tear_down)                                            \
    test_file_add(__FILE__, tests, sizeof(tests) / sizeof *(tests), set_up, tear_down)

#define add_long_tests(tests, set_up, tear_down)                                       \
    test_file_add_long(__FILE__, tests, sizeof(tests) / sizeof *(tests), set_up,       \
                       tear_down)

/* True if the program was started with --full. */
bool test_file_full_size(void);

/* Copies the tests, and the name of the source file `path`. */
void test_file_add(const char *path, const struct CMUnitTest *tests, size_t count,
                   CMFixtureFunction set_up, CMFixtureFunction tear_down);
void test_file_add_long(const char *path, const struct CMUnitTest *tests, size_t count,
                        CMFixtureFunction set_up, CMFixtureFunction tear_down);

#endif
