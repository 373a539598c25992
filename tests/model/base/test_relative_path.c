/* test_relative_path.c - relative paths between existing folders, each opened. */
#include "model/base/relative_path.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/lib/near.h"

static char top[] = "/tmp/pepperpot-way-XXXXXX";

static const char *const folders[] = {"a", "a/b", "a/b/c", "ab", "d"};
enum { FOLDERS = sizeof folders / sizeof folders[0] };

static int make(void **state)
{
    (void)state;
    char path[256];
    if (!mkdtemp(top))
        return -1;
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(path, sizeof path, "%s/%s", top, folders[i]);
        if (mkdir(path, 0700) != 0)
            return -1;
    }
    snprintf(path, sizeof path, "%s/link", top);
    return symlink("a/b", path);
}

static int clear(void **state)
{
    (void)state;
    char path[256];
    snprintf(path, sizeof path, "%s/link", top);
    unlink(path);
    for (int i = FOLDERS - 1; i >= 0; i--) {
        snprintf(path, sizeof path, "%s/%s", top, folders[i]);
        rmdir(path);
    }
    return rmdir(top);
}

static void assert_way(const char *from, const char *to, const char *wanted)
{
    char file[256], moved[256], *prefix = NULL;
    snprintf(file, sizeof file, "%s/%s/room.xml", top, from);
    snprintf(moved, sizeof moved, "%s/%s/sized.xml", top, to);
    assert_int_equal(pp_relative_path_prefix(&prefix, file, moved, NULL), PP_OK);
    assert_string_equal(prefix, wanted);
    free(prefix);
}

static void relative_paths_go_up_to_the_common_folder_and_down(void **state)
{
    (void)state;
    assert_way("a", "a", "");
    assert_way("a", "a/b", "../");
    assert_way("a", "a/b/c", "../../");
    assert_way("a/b/c", "a", "b/c/");
    assert_way("a/b/c", "d", "../a/b/c/");
    assert_way("a", "ab", "../a/");
    assert_way("ab", "a", "../ab/");
    assert_way(".", "d", "../");
    assert_way("d", ".", "d/");
    assert_way("a/../d", "./a/./b", "../../d/");
}

/* "link" points to a/b, so a path relative to it is relative to a/b. */
static void links_are_followed(void **state)
{
    (void)state;
    assert_way("link", "a/b", "");
    assert_way("link", "d", "../a/b/");
    assert_way("d", "link", "../../d/");
}

static void a_folder_that_is_not_there_changes_nothing(void **state)
{
    (void)state;
    assert_way("a", "none", "");
}

/* Between any two folders: the prefix with the name of a file leads to that file. */
static void every_way_can_be_walked(void **state)
{
    (void)state;
    for (int i = 0; i < FOLDERS; i++)
        for (int k = 0; k < FOLDERS; k++) {
            char file[256], moved[256], walked[1024], *prefix;
            struct stat there, met;
            snprintf(file, sizeof file, "%s/%s/x", top, folders[i]);
            snprintf(moved, sizeof moved, "%s/%s/y", top, folders[k]);
            assert_int_equal(pp_relative_path_prefix(&prefix, file, moved, NULL),
                             PP_OK);
            snprintf(walked, sizeof walked, "%s/%s/%s.", top, folders[k], prefix);
            file[strlen(file) - 1] = '\0';
            assert_int_equal(stat(file, &there), 0);
            assert_int_equal(stat(walked, &met), 0);
            assert_true(there.st_ino == met.st_ino && there.st_dev == met.st_dev);
            free(prefix);
        }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(relative_paths_go_up_to_the_common_folder_and_down),
        cmocka_unit_test(links_are_followed),
        cmocka_unit_test(a_folder_that_is_not_there_changes_nothing),
        cmocka_unit_test(every_way_can_be_walked),
    };
    add_tests(tests, make, clear);
}
