/* test_report_bytes.c - a report's columns sent to another process: identical numbers
 * and texts; truncated data are rejected. */
#include "cli/ranks/report_bytes.h"

#include <stdlib.h>
#include <string.h>

#include "tests/lib/near.h"

enum { POINTS = 2 };

static struct pp_report empty(void)
{
    return (struct pp_report){.receiver_count = POINTS, .finished = true};
}

/* A column with a figure that has no exact decimal form, a missing figure, and an
 * average. */
static struct pp_report made(void)
{
    struct pp_report report = empty();
    struct pp_column *column = pp_report_add(&report, PP_ERC, "traced", true);
    assert_non_null(column);
    column->points[0] =
        (struct pp_reading){.value = 1.0 / 3.0, .std_error = 1.7e-5 / 3.0};
    column->points[1] = pp_reading_of(NAN);
    column->points[1].why = pp_report_say(&report, "the point is %d m too high", 3);
    column->average = (struct pp_reading){.value = 0.1, .std_error = 2.3e-6};
    column->common = 0.37;
    column->common_near = 0.61;
    column = pp_report_add(&report, PP_DF, "average-df", false);
    assert_non_null(column);
    column->average = pp_reading_of(0.0231);
    return report;
}

static void numbers_arrive_to_the_bit_and_sentences_whole(void **state)
{
    (void)state;
    struct pp_report sent = made(), got = empty();
    char *bytes;
    size_t length;
    assert_int_equal(pp_report_bytes_write(&sent, &bytes, &length, NULL), PP_OK);
    assert_int_equal(pp_report_bytes_read(&got, bytes, length, NULL), PP_OK);
    free(bytes);
    const struct pp_column *column = pp_report_find(&got, PP_ERC, "traced");
    assert_int_equal(got.column_count, 2);
    assert_non_null(column);
    assert_true(column->points[0].value == 1.0 / 3.0);
    assert_true(column->points[0].std_error == 1.7e-5 / 3.0);
    assert_true(isnan(column->points[1].value));
    assert_null(column->points[0].why);
    assert_string_equal(column->points[1].why, "the point is 3 m too high");
    assert_true(column->average.value == 0.1 && column->average.std_error == 2.3e-6);
    assert_true(column->common == 0.37 && column->common_near == 0.61);
    column = pp_report_find(&got, PP_DF, "average-df");
    assert_non_null(column);
    assert_null(column->points);
    assert_true(column->average.value == 0.0231);
    assert_true(got.finished);
    pp_report_clear(&sent);
    pp_report_clear(&got);
}

/* A report is unfinished if either of its parts was stopped. */
static void a_report_with_a_stopped_part_is_unfinished(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct pp_report sent = made(), got = empty();
        char *bytes;
        size_t length;
        sent.finished = i != 1;
        got.finished = i != 2;
        assert_int_equal(pp_report_bytes_write(&sent, &bytes, &length, NULL), PP_OK);
        assert_int_equal(pp_report_bytes_read(&got, bytes, length, NULL), PP_OK);
        assert_int_equal(got.finished, i == 0);
        free(bytes);
        pp_report_clear(&sent);
        pp_report_clear(&got);
    }
}

/* Data truncated at every length. */
static void bytes_that_are_cut_short_are_refused(void **state)
{
    (void)state;
    struct pp_report sent = made();
    char *bytes;
    size_t length;
    assert_int_equal(pp_report_bytes_write(&sent, &bytes, &length, NULL), PP_OK);
    for (size_t cut = 0; cut < length; cut++) {
        struct pp_report got = empty();
        struct pp_error err = {0};
        char *some = malloc(cut + 1);
        assert_non_null(some);
        memcpy(some, bytes, cut);
        assert_int_equal(pp_report_bytes_read(&got, some, cut, &err), PP_SYSTEM);
        free(some);
        pp_report_clear(&got);
    }
    free(bytes);
    pp_report_clear(&sent);
}

/* A report of three points does not accept columns of two. */
static void columns_of_another_room_are_refused(void **state)
{
    (void)state;
    struct pp_report sent = made(), got = empty();
    char *bytes;
    size_t length;
    got.receiver_count = POINTS + 1;
    assert_int_equal(pp_report_bytes_write(&sent, &bytes, &length, NULL), PP_OK);
    assert_int_equal(pp_report_bytes_read(&got, bytes, length, NULL), PP_SYSTEM);
    free(bytes);
    pp_report_clear(&sent);
    pp_report_clear(&got);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_arrive_to_the_bit_and_sentences_whole),
        cmocka_unit_test(a_report_with_a_stopped_part_is_unfinished),
        cmocka_unit_test(bytes_that_are_cut_short_are_refused),
        cmocka_unit_test(columns_of_another_room_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
