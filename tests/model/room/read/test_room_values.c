/* test_room_values.c - numbers, names and tables used to read room files. */
#include <locale.h>
#include <stdbool.h>
#include <stdlib.h>

#include "model/light/finishes.h"
#include "model/light/glazings.h"
#include "model/base/text.h"
#include "tests/lib/near.h"

static void numbers_are_read_to_the_last_bit(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value;
    } numbers[] = {{"0.1", 0.1},
                   {"2.675", 2.675},
                   {"9007199254740993", 9007199254740992.0}, /* ties to even */
                   {"1e23", 1e23},
                   {"4.9e-324", 4.9e-324},
                   {"1e-400", 0.0},
                   {" -.5\n", -0.5},
                   {"+3.", 3.0},
                   {"1.7976931348623157e308", 1.7976931348623157e308}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        double value = -1.0;
        assert_true(pp_text_parse_number(numbers[i].text, &value));
        assert_true(value == numbers[i].value);
    }
}

static void text_instead_of_a_number_leaves_the_value_unchanged(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "",    " ",     "-",   ".",     "e5",    "1e",  "1e+",      "0x10",
        "inf", "nan",   "1,5", "1 2",   "1.2.3", "--1", "infinity", "1f",
        "1m",  "1e400", "½",   "1_000", "1'0",   "+ 1"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        double value = 0.75;
        assert_false(pp_text_parse_number(texts[i], &value));
        assert_true(value == 0.75);
    }
}

/* Uses a locale with a decimal comma, if installed. */
static void numbers_have_a_point_in_every_locale(void **state)
{
    (void)state;
    static const char *const locales[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8",
                                          "pt_BR.UTF-8", "de_DE"};
    bool found = false;
    for (size_t i = 0; i < sizeof locales / sizeof *locales && !found; i++)
        found = setlocale(LC_ALL, locales[i]) != NULL;
    if (!found)
        skip();
    double value = 0.0;
    bool point = pp_text_parse_number("2.5", &value),
         comma = pp_text_parse_number("2,5", &value);
    setlocale(LC_ALL, "C");
    assert_true(point && !comma);
    assert_true(value == 2.5);
}

static void slips_of_the_keyboard_are_near(void **state)
{
    (void)state;
    assert_int_equal(pp_text_edit_distance("window", "window"), 0);
    assert_int_equal(pp_text_edit_distance("windwo", "window"),
                     1); /* two letters exchanged */
    assert_int_equal(pp_text_edit_distance("windw", "window"), 1);
    assert_int_equal(pp_text_edit_distance("Window", "window"), 0);
    assert_int_equal(pp_text_edit_distance("", "sill"), 4);
    assert_int_equal(pp_text_edit_distance("kitten", "sitting"), 3);

    static const char *const names[] = {"sill", "width", "oak-floor", "frame-factor",
                                        NULL};
    assert_string_equal(pp_text_nearest("sil", names, -1), "sill");
    assert_string_equal(pp_text_nearest("widht", names, -1), "width");
    assert_string_equal(pp_text_nearest("framefactor", names, 4), "frame-factor");
    assert_string_equal(pp_text_nearest("oak", names, -1), "oak-floor");
    assert_null(pp_text_nearest("door", names, -1));
    assert_null(pp_text_nearest("x", names, -1));
    assert_null(pp_text_nearest("", names, -1));
    char endless[1000];
    memset(endless, 'w', sizeof endless - 1);
    endless[sizeof endless - 1] = '\0';
    assert_null(pp_text_nearest(endless, names, -1));
}

static void lists_read_as_people_write_them(void **state)
{
    (void)state;
    static const char *const names[] = {"x", "y", "z", NULL};
    char text[64], little[5];
    assert_string_equal(pp_text_list_names(text, sizeof text, names, 1), "x");
    assert_string_equal(pp_text_list_names(text, sizeof text, names, 2), "x or y");
    assert_string_equal(pp_text_list_names(text, sizeof text, names, -1), "x, y or z");
    assert_string_equal(pp_text_list_names(text, sizeof text, names, 0), "");
    assert_string_equal(pp_text_list_names(little, sizeof little, names, -1), "x, y");
}

/* Contents of a file cannot send control characters to the terminal or fill it. */
static void excerpts_are_short_and_plain(void **state)
{
    (void)state;
    char text[200], little[8];
    assert_string_equal(pp_text_excerpt(text, sizeof text, "Küche"), "Küche");
    assert_string_equal(pp_text_excerpt(text, sizeof text, "a\tb\x1b[31m\x7f"),
                        "a?b?[31m?");
    assert_string_equal(pp_text_excerpt(text, sizeof text, "\xC2\x9B"), "?");
    char endless[1000];
    memset(endless, 'w', sizeof endless - 1);
    endless[sizeof endless - 1] = '\0';
    assert_int_equal(strlen(pp_text_excerpt(text, sizeof text, endless)), 43);
    assert_string_equal(pp_text_excerpt(little, sizeof little, "ääää"), "ää...");
    /* A letter that is cut off is not read beyond the end of the text. */
    assert_int_equal(strlen(pp_text_excerpt(text, sizeof text, "\xE2")), 1);
}

static void glazings_let_through_what_their_table_says(void **state)
{
    (void)state;
    struct pp_glass brs = pp_glass_clear_single();
    assert_non_null(pp_glazings_find("clear-single"));
    assert_null(pp_glazings_find("none"));
    assert_null(pp_glazings_find("Clear-Single"));
    for (int i = 0; i < pp_glazings_count(); i++) {
        const struct pp_glazing *row = pp_glazings_at(i);
        struct pp_glass glass = pp_glazings_glass(row);
        assert_ptr_equal(pp_glazings_find(row->name), row);
        assert_true(glass.normal > 0.0 && glass.normal < 1.0);
        assert_true(glass.panes == row->panes && glass.panes >= 1);
        if (!isnan(row->normal))
            assert_true(glass.normal == row->normal);
        if (glass.diffusing)
            assert_true(glass.diffuse == glass.normal);
        else
            assert_true(glass.diffuse < glass.normal && glass.diffuse > 0.0);
    }
    assert_true(pp_glazings_glass(pp_glazings_find("clear-single")).diffuse
                == brs.diffuse);
    /* Four printed digits of the reference: 0.8154 and 0.7292. */
    struct pp_glass two = pp_glazings_glass(pp_glazings_find("clear-double"));
    assert_near(two.normal, 0.8154, 5e-5);
    assert_near(two.diffuse, 0.7292, 5e-5);
    /* The published correction for the type of glass, to three digits. */
    static const struct {
        const char *name;
        double over_clear;
    } types[] = {
        {"wired-polished", 0.95}, {"wired-cast", 0.90}, {"tinted-single", 0.85}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
        struct pp_glass glass = pp_glazings_glass(pp_glazings_find(types[i].name));
        assert_near(glass.diffuse / brs.diffuse, types[i].over_clear, 5e-4);
    }
}

static void finishes_are_in_order_of_their_words(void **state)
{
    (void)state;
    static const struct {
        const char *word;
        double reflectance;
    } words[] = {{"very-dark", 0.1},
                 {"dark", 0.3},
                 {"medium", 0.5},
                 {"light", 0.7},
                 {"very-light", 0.85}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        assert_true(pp_finishes_find(words[i].word)->reflectance
                    == words[i].reflectance);
    assert_null(pp_finishes_find("mauve"));
    for (int i = 0; i < pp_finishes_count(); i++) {
        const struct pp_finish *row = pp_finishes_at(i);
        assert_ptr_equal(pp_finishes_find(row->name), row);
        assert_true(row->reflectance >= 0.05 && row->reflectance <= 0.85);
    }
    assert_non_null(pp_finishes_find("white-paint"));
    assert_non_null(pp_finishes_find("brick"));
    assert_non_null(pp_finishes_find("oak-floor"));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_read_to_the_last_bit),
        cmocka_unit_test(text_instead_of_a_number_leaves_the_value_unchanged),
        cmocka_unit_test(numbers_have_a_point_in_every_locale),
        cmocka_unit_test(slips_of_the_keyboard_are_near),
        cmocka_unit_test(lists_read_as_people_write_them),
        cmocka_unit_test(excerpts_are_short_and_plain),
        cmocka_unit_test(glazings_let_through_what_their_table_says),
        cmocka_unit_test(finishes_are_in_order_of_their_words),
    };
    add_tests(tests, NULL, NULL);
}
