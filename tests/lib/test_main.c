/* test_main.c - main() of the test programs.
 *
 *     PROGRAM [--list] [--full] [--filter NAME]
 *
 * runs every test, or those whose name or file matches the shell pattern NAME:
 * `--filter test_sobol`, `--filter '*horizon*'`. --full adds the long tests and runs
 * the others at full size (sized.h). --list prints the tests and runs none. Exit
 * status: 0 all passed, 1 some failed, 2 the command line is wrong, NAME matches
 * nothing, or there are too many tests.
 */
#include "tests/lib/test_file.h"

#include <fnmatch.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_FILES = 128, MAX_TESTS = 2048 };

struct test_file {
    char name[64];
    struct CMUnitTest *tests;
    size_t count;
    CMFixtureFunction set_up, tear_down;
    bool is_long;
};

static struct test_file files[MAX_FILES];
static struct CMUnitTest tests_of_all[MAX_TESTS];
static size_t file_count, test_count;
static bool full_size;

bool test_file_full_size(void)
{
    return full_size;
}

static struct test_file *add(const char *path, const struct CMUnitTest *tests,
                             size_t count, CMFixtureFunction set_up,
                             CMFixtureFunction tear_down)
{
    if (file_count == MAX_FILES || count > MAX_TESTS - test_count) {
        fprintf(stderr, "%s: too many tests for test_main.c\n", path);
        exit(2);
    }
    struct test_file *file = &files[file_count++];
    const char *slash = strrchr(path, '/');
    snprintf(file->name, sizeof file->name, "%s", slash ? slash + 1 : path);
    file->name[strcspn(file->name, ".")] = '\0';
    file->tests = memcpy(&tests_of_all[test_count], tests, count * sizeof *tests);
    file->count = count;
    file->set_up = set_up;
    file->tear_down = tear_down;
    test_count += count;
    return file;
}

void test_file_add(const char *path, const struct CMUnitTest *tests, size_t count,
                   CMFixtureFunction set_up, CMFixtureFunction tear_down)
{
    add(path, tests, count, set_up, tear_down);
}

void test_file_add_long(const char *path, const struct CMUnitTest *tests, size_t count,
                        CMFixtureFunction set_up, CMFixtureFunction tear_down)
{
    add(path, tests, count, set_up, tear_down)->is_long = true;
}

/* Keeps the tests of a file that match. */
static void filter_tests(struct test_file *file, const char *pattern)
{
    size_t kept = 0;
    if (file->is_long && !full_size)
        file->count = 0;
    bool all = !pattern || fnmatch(pattern, file->name, 0) == 0;
    for (size_t i = 0; i < file->count; i++)
        if (all || fnmatch(pattern, file->tests[i].name, 0) == 0)
            file->tests[kept++] = file->tests[i];
    file->count = kept;
}

static void print_tests(const struct test_file *file)
{
    for (size_t i = 0; i < file->count; i++)
        printf("%s %s\n", file->name, file->tests[i].name);
}

int main(int argc, char **argv)
{
    const char *pattern = NULL;
    bool list = false;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--list") == 0) {
            list = true;
        } else if (strcmp(argv[i], "--full") == 0) {
            full_size = true;
        } else if (strcmp(argv[i], "--filter") == 0 && i + 1 < argc) {
            pattern = argv[++i];
        } else {
            fprintf(stderr, "usage: %s [--list] [--full] [--filter NAME]\n", argv[0]);
            return 2;
        }
    }

    size_t selected = 0;
    int failed = 0;
    for (size_t i = 0; i < file_count; i++) {
        struct test_file *file = &files[i];
        filter_tests(file, pattern);
        selected += file->count;
        if (list)
            print_tests(file);
        else if (file->count > 0)
            failed += _cmocka_run_group_tests(file->name, file->tests, file->count,
                                              file->set_up, file->tear_down);
    }
    if (selected == 0) {
        fprintf(stderr, "%s: no test matches \"%s\"\n", argv[0], pattern);
        return 2;
    }
    return failed != 0;
}
