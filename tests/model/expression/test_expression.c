/* test_expression.c - expressions of printed formulae: parsed as printed, with
 * dimensions, rejected at the right position, and with the same values as the tests'
 * own evaluator. */
#include "tests/lib/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/method.h"
#include "model/results/worksheet.h"
#include "tests/lib/interval_formula.h"

static const struct pp_expression_name names[] = {
    {"W", {.metres = 2.0}},     {"A", {.metres = 2.0}},    {"h", {.metres = 1.0}},
    {"R", {.metres = 0.0}},     {"R_fw", {.metres = 0.0}}, {"C", {.per_cent = 1.0}},
    {"theta", {.degrees = 1.0}}};
enum { NAMES = sizeof names / sizeof *names };
static const double values[NAMES] = {2.6, 96.4, 1.7, 0.43, 0.31, 27.0, 38.0};

static double value_of(const char *text)
{
    struct pp_expression expression;
    struct pp_expression_mistake mistake;
    if (!pp_expression_parse(&expression, text, 0, names, NAMES, &mistake))
        fail_msg("%s, column %d: %s", text, mistake.column + 1, mistake.what);
    return pp_expression_value(&expression, values, NULL);
}

/* Calculated by hand. */
static void sums_have_the_values_calculated_by_hand(void **state)
{
    (void)state;
    assert_near(value_of("1 + 2 * 3 - 4"), 3.0, 0.0);
    assert_near(value_of("12 / 2 / 3"), 2.0, 1e-15);
    assert_near(value_of("W / (A (1 - R)) C"), 2.6 / (96.4 * 0.57) * 27.0, 1e-14);
    assert_near(value_of("W / A C"), 2.6 / 96.4 * 27.0, 1e-14); /* not W / (A C) */
    assert_near(value_of("-R^2 + 3R"), -0.1849 + 1.29, 1e-14);
    assert_near(value_of("2^3^2"), 512.0, 1e-12);
    assert_near(value_of("2^-1"), 0.5, 0.0);
    assert_near(value_of("sin(30) + cos(60) + tan(45)"), 2.0, 1e-15);
    assert_near(value_of("atan(tan(33.7)) + asin(sin(theta)) + acos(0)"),
                33.7 + 38.0 + 90.0, 1e-12);
    assert_near(value_of("sqrt(A W) / h^2"), sqrt(96.4 * 2.6) / 2.89, 1e-13);
    assert_near(value_of("exp(ln(7)) log10(1000) abs(-2)"), 42.0, 1e-13);
    assert_near(value_of("max(R, 3, -2) min(R, R_fw) sum(1, 2, 3) pi"),
                3.0 * 0.31 * 6.0 * M_PI, 1e-13);
    assert_near(value_of("floor(2.9) + 10 floor(-0.1) + 100 mod(7.5, 2)"),
                2.0 - 10.0 + 150.0, 0.0);
    assert_near(value_of("mod(-1, 4) + mod(h / h, 2)"), 4.0, 0.0);
}

/* Position of each error: the column, counted from 1, and a word of the message. */
static void a_wrong_text_is_refused_at_its_place(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int column;
        const char *word;
    } wrong[] = {
        {"", 1, "expected a number"},
        {"0.85 W / (A (1 - R)", 20, "column 10"},
        {"W)", 2, "no \"(\""},
        {"3 + * R", 5, "expected a number"},
        {"R + Q", 5, "there is no quantity \"Q\""},
        {"W + h", 5, "a length (m)"},
        {"W + 3", 5, "an area (m2)"},
        {"h + W / h + R", 13, "a ratio"},
        {"C + R", 5, "a ratio"},
        {"theta - R_fw", 9, "an angle"},
        {"sin(W)", 5, "an angle"},
        {"sin(R)", 5, "an angle"},
        {"atan(h)", 6, "a ratio"},
        {"exp(W)", 5, "a ratio"},
        {"2^h", 3, "a number as the exponent"},
        {"h^R", 1, "a ratio, because"},
        {"R / 0", 5, "this divisor is 0"},
        {"R / (1 - 1)", 5, "this divisor is 0"},
        {"sin 3", 5, "\"(\" after"},
        {"sin(3, 4)", 8, "one argument"},
        {"max()", 5, "expected a number"},
        {"mod(3)", 6, "two arguments"},
        {"mod(3, 2, 1)", 11, "two arguments"},
        {"floor(3, 2)", 10, "one argument"},
        {"2..3", 1, "not a number"},
        {"R; R", 2, "or the end"},
        {"R = 3", 3, "or the end"},
        {"system(R)", 1, "there is no quantity"},
        {"3 \xcf\x81", 3, "or the end"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct pp_expression expression;
        struct pp_expression_mistake mistake;
        if (pp_expression_parse(&expression, wrong[i].text, 0, names, NAMES, &mistake))
            fail_msg("%s was let through", wrong[i].text);
        if (mistake.column + 1 != wrong[i].column
            || !strstr(mistake.what, wrong[i].word))
            fail_msg("%s: column %d: %s; expected column %d and \"%s\"", wrong[i].text,
                     mistake.column + 1, mistake.what, wrong[i].column, wrong[i].word);
    }
}

static void a_text_has_an_end(void **state)
{
    (void)state;
    char text[PP_EXPRESSION_MOST + 2];
    struct pp_expression expression;
    struct pp_expression_mistake mistake;
    memset(text, '1', sizeof text);
    text[PP_EXPRESSION_MOST] = '\0';
    assert_true(pp_expression_parse(&expression, text, 0, names, NAMES, &mistake));
    text[PP_EXPRESSION_MOST] = '1';
    text[PP_EXPRESSION_MOST + 1] = '\0';
    assert_false(pp_expression_parse(&expression, text, 0, names, NAMES, &mistake));
    memset(text, '(', PP_EXPRESSION_MOST);
    text[PP_EXPRESSION_MOST] = '\0';
    assert_false(pp_expression_parse(&expression, text, 0, names, NAMES, &mistake));
    assert_non_null(strstr(mistake.what, "nested too deeply"));
}

static void an_operation_without_a_result_is_named_with_its_column(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int column;
        const char *what;
    } list[] = {{"W / (R - R)", 3, "divides by zero"},
                {"1 + sqrt(R - 3)", 5, "of a negative number"},
                {"ln(R - 3)", 1, "outside its range"},
                {"asin(3 + R)", 1, "outside its range"},
                {"(R - 3)^0.5", 8, "a finite result"},
                {"10^(1000 R)", 3, "a finite result"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        struct pp_expression expression;
        struct pp_expression_mistake mistake;
        struct pp_expression_fault fault;
        const char *text = list[i].text;
        assert_true(pp_expression_parse(&expression, text, 0, names, NAMES, &mistake));
        pp_expression_value(&expression, values, &fault);
        assert_non_null(fault.what);
        assert_non_null(strstr(fault.what, list[i].what));
        assert_int_equal(fault.column + 1, list[i].column);
    }
}

/* ---- any text ---- */

static unsigned next(unsigned long long *seed)
{
    *seed = *seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (unsigned)(*seed >> 33);
}

/* For any bytes, a text is either parsed and can be evaluated, or rejected at one of
 * its columns. */
static void no_bytes_upset_the_reader(void **state)
{
    (void)state;
    static const char alphabet[] =
        "()+-*/^,.0123456789 WARhCtheta_' sinmaxpi\t\n\xcf=;";
    unsigned long long seed = 20;
    int read = 0;
    for (int i = 0; i < 200000; i++) {
        char text[64];
        int length = (int)(next(&seed) % 60);
        for (int k = 0; k < length; k++)
            text[k] = i % 2 ? (char)(1 + next(&seed) % 255)
                            : alphabet[next(&seed) % (sizeof alphabet - 1)];
        text[length] = '\0';
        struct pp_expression expression;
        struct pp_expression_mistake mistake = {.column = -1};
        struct pp_expression_fault fault;
        if (pp_expression_parse(&expression, text, 0, names, NAMES, &mistake)) {
            pp_expression_value(&expression, values, &fault);
            read++;
        } else {
            assert_true(mistake.column >= 0 && mistake.column <= length);
            assert_true(mistake.what[0]);
        }
    }
    assert_true(read > 100);
}

/* Writes a random sum of ratios, with printed signs. */
static void write_sum(char *text, size_t room, unsigned long long *seed, int depth)
{
    static const char *const leaves[] = {"R", "R_fw", "2", "0.85", "R_fw", "3.1"};
    static const char *const signs[] = {" + ", " - ", " * ", " / ", " "};
    size_t used = strlen(text);
    unsigned choice = next(seed) % 7;
    if (depth == 0 || choice == 0) {
        snprintf(text + used, room - used, "%s", leaves[next(seed) % 6]);
    } else if (choice == 1) {
        snprintf(text + used, room - used, "(");
        write_sum(text, room, seed, depth - 1);
        used = strlen(text);
        snprintf(text + used, room - used, ")^2");
    } else if (choice == 2) {
        snprintf(text + used, room - used, "max(1, -");
        write_sum(text, room, seed, 0);
        used = strlen(text);
        snprintf(text + used, room - used, ")");
    } else {
        bool closed = next(seed) % 2;
        snprintf(text + used, room - used, closed ? "(" : "");
        write_sum(text, room, seed, depth - 1);
        used = strlen(text);
        snprintf(text + used, room - used, "%s", signs[next(seed) % 5]);
        write_sum(text, room, seed, depth - 1);
        used = strlen(text);
        snprintf(text + used, room - used, closed ? ")" : "");
    }
}

/* The tests' evaluator shares no code with the program's. */
static void two_readers_agree_on_random_sums(void **state)
{
    (void)state;
    static struct figures figures;
    figures.count = 0;
    figures_add(&figures, "R", (struct interval){0.43, 0.43});
    figures_add(&figures, "R_fw", (struct interval){0.31, 0.31});
    unsigned long long seed = 7;
    int compared = 0;
    for (int i = 0; i < 20000; i++) {
        char text[400] = "", message[128];
        write_sum(text, sizeof text, &seed, 1 + (int)(next(&seed) % 4));
        struct pp_expression expression;
        struct pp_expression_mistake mistake;
        struct interval other;
        bool good = pp_expression_parse(&expression, text, 0, names, NAMES, &mistake);
        if (!formula_evaluate(&other, text, &figures, message) || !good)
            continue; /* too long, or a division by 0 */
        double value = pp_expression_value(&expression, values, NULL);
        double rounding = 1e-9 * (1.0 + fabs(value));
        if (!(value >= other.low - rounding && value <= other.high + rounding))
            fail_msg("%s: %.12g and %.12g", text, value, other.low);
        compared++;
    }
    assert_true(compared > 15000);
}

/* ---- formulae ---- */

/* All published formulae are parsed; both sides have the same dimension. */
static void published_formulae_are_sound(void **state)
{
    (void)state;
    int count = 0;
    for (int i = 0; pp_methods[i]; i++)
        for (int k = 0; pp_methods[i]->formulae && pp_methods[i]->formulae[k]; k++) {
            const struct pp_formula *formula = pp_methods[i]->formulae[k];
            struct pp_expression expression;
            struct pp_expression_mistake mistake;
            if (!pp_formula_parse(&expression, formula, formula->sum, 0, &mistake))
                fail_msg("%s = %s, column %d: %s", formula->symbol, formula->sum,
                         mistake.column + 1, mistake.what);
            assert_true(pp_formula_comes_out(formula, &expression));
            assert_true(strlen(formula->what) > 0);
            count++;
        }
    assert_true(count > 40);
}

/* A worksheet of two parts: quantities by name, with the number of the part in the
 * text. By hand, for part 2: 0.85 x 2 x 12 % x 1 = 20.4 %. */
static void a_worksheet_works_out_what_it_prints(void **state)
{
    (void)state;
    static const struct pp_formula_quantity quantities[] = {
        {"w", PP_UNIT_NUMBER, "share"},
        {"n", PP_UNIT_COUNT, "number"},
        {"C", PP_UNIT_DAYLIGHT_FACTOR, "light"},
        {0}};
    static const struct pp_formula formula = {.symbol = "sc",
                                              .sum = "0.85 n C w",
                                              .unit = PP_UNIT_DAYLIGHT_FACTOR,
                                              .what = "test",
                                              .quantities = quantities};
    struct pp_steps steps = {0};
    struct pp_worksheet sheet = {.steps = &steps};
    pp_worksheet_put(&sheet, PP_UNIT_NUMBER, 1.0, "w", "a share");
    for (int part = 1; part <= 2; part++) {
        sheet.part = part;
        pp_worksheet_put(&sheet, PP_UNIT_COUNT, part, "n", "a number");
        pp_worksheet_put(&sheet, PP_UNIT_DAYLIGHT_FACTOR, 0.12, "C", "light");
        assert_near(pp_worksheet_work(&sheet, &formula, "by hand"), 0.102 * part,
                    1e-16);
    }
    const struct pp_calculation_step *last = &steps.list[steps.count - 1];
    assert_string_equal(last->symbol, "sc_2");
    assert_string_equal(last->formula, "0.85 n_2 C_2 w");
    pp_steps_clear(&steps);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_have_the_values_calculated_by_hand),
        cmocka_unit_test(a_wrong_text_is_refused_at_its_place),
        cmocka_unit_test(a_text_has_an_end),
        cmocka_unit_test(an_operation_without_a_result_is_named_with_its_column),
        cmocka_unit_test(no_bytes_upset_the_reader),
        cmocka_unit_test(two_readers_agree_on_random_sums),
        cmocka_unit_test(published_formulae_are_sound),
        cmocka_unit_test(a_worksheet_works_out_what_it_prints),
    };
    add_tests(tests, NULL, NULL);
}
