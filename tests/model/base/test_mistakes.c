/* test_mistakes.c - mistakes are collected, without duplicates, and sorted by line. */
#include "model/base/mistakes.h"

#include "tests/lib/near.h"

static void the_same_text_on_a_line_is_noted_once(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "a room.xml");
    for (int i = 0; i < 3; i++) {
        pp_mistakes_add(&mistakes, 7, "left is %g", 1.5);
        pp_mistakes_add(&mistakes, 7, "left is %g", 2.5);
        pp_mistakes_add(&mistakes, 8, "left is %g", 1.5);
    }
    assert_int_equal(mistakes.count, 3);
    assert_string_equal(mistakes.file, "a room.xml");
    assert_false(mistakes.truncated);
    pp_mistakes_clear(&mistakes);
    assert_null(mistakes.list);
}

static void sorting_keeps_the_order_within_a_line(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "-");
    static const int lines[] = {9, 2, 9, 0, 2, 9, 4, 4, 2, 11, 2};
    int count = sizeof lines / sizeof lines[0];
    for (int i = 0; i < count; i++)
        pp_mistakes_add(&mistakes, lines[i], "%02d", i);
    pp_mistakes_sort(&mistakes);
    assert_int_equal(mistakes.count, count);
    for (int i = 1; i < count; i++) {
        const struct pp_input_mistake *a = &mistakes.list[i - 1],
                                      *b = &mistakes.list[i];
        assert_true(a->line < b->line
                    || (a->line == b->line && strcmp(a->text, b->text) < 0));
    }
    pp_mistakes_clear(&mistakes);
}

static void no_more_than_a_bounded_number_is_kept(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "-");
    for (int i = 0; i < PP_MISTAKES_MOST; i++)
        pp_mistakes_add(&mistakes, i, "wrong");
    assert_false(mistakes.truncated);
    pp_mistakes_add(&mistakes, PP_MISTAKES_MOST, "wrong");
    assert_true(mistakes.truncated);
    assert_int_equal(mistakes.count, PP_MISTAKES_MOST);
    pp_mistakes_clear(&mistakes);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_text_on_a_line_is_noted_once),
        cmocka_unit_test(sorting_keeps_the_order_within_a_line),
        cmocka_unit_test(no_more_than_a_bounded_number_is_kept),
    };
    add_tests(tests, NULL, NULL);
}
