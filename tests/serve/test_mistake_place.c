/* test_mistake_place.c - a mistake is marked at its attribute or element. */
#include "tests/lib/near.h"

#include "serve/answers/base64.h"
#include "serve/answers/mistake_place.h"
#include "serve/stores/sha256.h"

#include <stdlib.h>

static const char text[] = "<room version='1'>\n"
                           "  <!-- <plan depth='9'/> -->\n"
                           "  <plan width='\xC3\xA9' depth='abc' height='2.7'/>\n"
                           "  <window wall='south'\n"
                           "          hight='1'/>\n"
                           "  <widow/>\n"
                           "</room>\n";

static void assert_place(int line, const char *sentence, struct pp_mistake_place wanted)
{
    struct pp_mistake_place place =
        pp_mistake_place_find(text, sizeof text - 1, line, sentence);
    assert_int_equal(place.line, wanted.line);
    assert_int_equal(place.column, wanted.column);
    assert_int_equal(place.end_line, wanted.end_line);
    assert_int_equal(place.end_column, wanted.end_column);
}

/* Columns are counted in characters, one of which has two bytes here. */
static void an_attribute_is_found_with_its_value(void **state)
{
    (void)state;
    assert_place(3, "plan: depth is \"abc\"; expected a number of metres",
                 (struct pp_mistake_place){3, 19, 3, 30});
}

static void an_attribute_has_a_line_of_its_own(void **state)
{
    (void)state;
    assert_place(5,
                 "window: attribute \"hight\" is not known; did you mean \"height\"?",
                 (struct pp_mistake_place){5, 11, 5, 20});
    assert_place(4, "window: width is missing", (struct pp_mistake_place){4, 3, 5, 22});
}

static void an_element_is_found_by_its_name(void **state)
{
    (void)state;
    assert_place(6, "room: element \"widow\" is not known",
                 (struct pp_mistake_place){6, 3, 6, 11});
}

static void other_mistakes_are_of_their_line(void **state)
{
    (void)state;
    assert_place(6, "the file breaks off", (struct pp_mistake_place){6, 3, 6, 11});
    assert_place(0, "there is no plan", (struct pp_mistake_place){1, 1, 1, 19});
    assert_place(99, "beyond the end", (struct pp_mistake_place){8, 1, 8, 1});
}

/* Examples of FIPS 180-4, of one block and two, and the empty text. */
static void hashes_are_the_standards(void **state)
{
    (void)state;
    static const struct {
        const char *text, *hash;
    } examples[] = {
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
    };
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char hex[65];
        pp_sha256_hex(hex, examples[i].text, strlen(examples[i].text));
        assert_string_equal(hex, examples[i].hash);
    }
}

/* RFC 4648, section 10. */
static void letters_are_the_standards(void **state)
{
    (void)state;
    static const char *const examples[][2] = {
        {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}};
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char *letters = pp_base64_of(examples[i][0], strlen(examples[i][0]));
        assert_string_equal(letters, examples[i][1]);
        free(letters);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_attribute_is_found_with_its_value),
        cmocka_unit_test(an_attribute_has_a_line_of_its_own),
        cmocka_unit_test(an_element_is_found_by_its_name),
        cmocka_unit_test(other_mistakes_are_of_their_line),
        cmocka_unit_test(hashes_are_the_standards),
        cmocka_unit_test(letters_are_the_standards),
    };
    add_tests(tests, NULL, NULL);
}
