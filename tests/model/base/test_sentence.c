/* Text put together piece by piece. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "model/base/text.h"

static void pieces_follow_one_another(void **state)
{
    (void)state;
    char text[32] = "";
    pp_text_append(text, sizeof text, "%d windows", 2);
    pp_text_append(text, sizeof text, ", %.1f m", 1.25);
    pp_text_append(text, sizeof text, "%s", "");
    assert_string_equal(text, "2 windows, 1.2 m");
}

/* Whatever is added to a full text, no byte behind it changes. */
static void what_has_no_room_is_cut_off(void **state)
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pieces_follow_one_another),
        cmocka_unit_test(what_has_no_room_is_cut_off),
        cmocka_unit_test(names_are_listed_as_in_a_sentence),
    };
    return cmocka_run_group_tests_name("sentences", tests, NULL, NULL);
}
