/* test_text.c - text built piece by piece, and suggestions for mistyped names. */
#include "model/base/text.h"
#include "tests/lib/near.h"

static void pieces_follow_one_another(void **state)
{
    (void)state;
    char text[32] = "";
    pp_text_append(text, sizeof text, "%d windows", 2);
    pp_text_append(text, sizeof text, ", %.1f m", 1.25);
    pp_text_append(text, sizeof text, "%s", "");
    assert_string_equal(text, "2 windows, 1.2 m");
}

/* Additions to a full text do not change any byte behind it. */
static void text_beyond_the_buffer_is_cut_off(void **state)
{
    (void)state;
    char text[12] = "a wall";
    text[11] = '#';
    pp_text_append(text, 11, " of %s", "bricks");
    assert_string_equal(text, "a wall of ");
    pp_text_append(text, 11, "%s", "more");
    assert_string_equal(text, "a wall of ");
    assert_int_equal(text[11], '#');
}

static void names_are_listed_as_in_a_sentence(void **state)
{
    (void)state;
    const char *const names[] = {"dirt", "frame", "glass", NULL};
    const char *const wanted[] = {"", "dirt", "dirt and frame",
                                  "dirt, frame and glass"};
    for (int count = 0; count <= 3; count++) {
        char text[32] = "";
        pp_text_append_list(text, sizeof text, names, count, " and ");
        assert_string_equal(text, wanted[count]);
    }
    char text[32] = "no ";
    pp_text_append_list(text, sizeof text, names, -1, " or ");
    assert_string_equal(text, "no dirt, frame or glass");
}

static void an_unknown_name_is_answered_with_the_nearest_or_with_all(void **state)
{
    (void)state;
    const char *const names[] = {"dirt", "frame", "glass", NULL};
    struct pp_error err = {0};
    assert_int_equal(pp_text_unknown(&err, "galss", names, 3, NULL,
                                     "there is no loss \"%s\"", "galss"),
                     PP_BAD_INPUT);
    assert_string_equal(err.message, "there is no loss \"galss\"; did you mean glass?");
    pp_text_unknown(&err, "wind", names, -1, NULL, "there is no loss \"%s\"", "wind");
    assert_string_equal(err.message,
                        "there is no loss \"wind\"; expected dirt, frame or glass");
    pp_text_unknown(&err, "wind", names, 3, "", "there is no loss");
    assert_string_equal(err.message, "there is no loss");
    assert_int_equal(pp_text_unknown(NULL, "wind", names, 3, "", "no loss"),
                     PP_BAD_INPUT);

    char question[64];
    assert_string_equal(
        pp_text_did_you_mean(question, sizeof question, "--", "glass", ", twice"),
        "did you mean --glass, twice?");
    assert_string_equal(pp_text_did_you_mean(question, sizeof question, "", NULL, "x"),
                        "");

    char text[64] = "no loss";
    pp_text_append_nearest(text, sizeof text, "wind", names, 3);
    assert_string_equal(text, "no loss");
    pp_text_append_nearest(text, sizeof text, "fram", names, 3);
    assert_string_equal(text, "no loss; did you mean \"frame\"?");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_follow_one_another),
        cmocka_unit_test(text_beyond_the_buffer_is_cut_off),
        cmocka_unit_test(names_are_listed_as_in_a_sentence),
        cmocka_unit_test(an_unknown_name_is_answered_with_the_nearest_or_with_all),
    };
    add_tests(tests, NULL, NULL);
}
