/* test_advice_report.c - made-up advice as text and as JSON has all its contents. */
#include "tests/lib/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reports/atlas/advice_report.h"

enum { POINTS = 6, WIDTH = 76 };

static struct pp_receiver receivers[POINTS];
static int indices[POINTS] = {0, 1, 2, 3, 4, 5};

/* A method whose figures are a quarter too low at all points, because of its
 * formula. */
static struct pp_advice_item item_of(const char *column, double median)
{
    return (struct pp_advice_item){
        .best = {.column = column,
                 .entry = {.regime = {.ratio = {0.9 * median, median, 1.2 * median},
                                      .rooms = 417},
                           .formula = {1.1, 1.25, 1.5},
                           .assumption = {0.97, 1.0, 1.03}}},
        .others = {{.column = "exact+sphere",
                    .entry = {.regime = {.ratio = {0.5, 0.8, 1.75}}}}},
        .other_count = 1,
        .points = indices,
        .point_count = POINTS};
}

/* The advice as text, with each line trimmed; *widest: width of the widest line. */
static char *words_of(const struct pp_advice *advice, size_t *widest)
{
    const struct pp_report report = {.receivers = receivers, .receiver_count = POINTS};
    char *text = NULL, *line, *rest;
    size_t length;
    for (int i = 0; i < POINTS; i++)
        receivers[i].position = pp_vec(1.5, 0.5 * (i + 1), 0.85);
    FILE *out = open_memstream(&text, &length);
    assert_non_null(out);
    pp_advice_report(advice, &report, WIDTH, out);
    fclose(out);
    char *words = calloc(length + 2, 1);
    assert_non_null(words);
    *widest = 0;
    for (line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        *widest = strlen(line) > *widest ? strlen(line) : *widest;
        strcat(words, line + strspn(line, " "));
        strcat(words, " ");
    }
    free(text);
    return words;
}

static void points_are_matched_by_position(void **state)
{
    (void)state;
    struct pp_advice_item items[] = {item_of("exact+bre", 1.25)};
    size_t widest;
    char *words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_non_null(strstr(words, "For 6 points (1.5,0.5; 1.5,1; 1.5,1.5; ...; 1.5,3) "
                                  "use exact+bre. In 417 similar rooms of the atlas"));
    assert_true(widest <= WIDTH);
    free(words);
    items[0].point_count = 1;
    words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_non_null(strstr(words, "For 1 point (1.5,0.5) use"));
    free(words);
}

/* 2.5 % at the first point, 0.5 % less at each of the next. */
static double corrected[] = {0.025, 0.02, 0.015, 0.01, 0.005, 0.0};

static void corrected_figures_are_beside_the_average_and_the_points(void **state)
{
    (void)state;
    struct pp_advice_item items[] = {item_of("exact+bre", 1.25)};
    items[0].corrected = corrected;
    const struct pp_advice advice = {.items = items, .count = 1};
    size_t widest;
    char *words = words_of(&advice, &widest);
    assert_non_null(strstr(words,
                           "For 6 points (1.5,0.5: 2.5 %; 1.5,1: 2 %; 1.5,1.5: 1.5 "
                           "%; ...; 1.5,3: 0 %) use exact+bre, corrected by the "
                           "median of its range. In 417 similar rooms"));
    free(words);
    struct json_object *object = json_object_new_object();
    assert_true(pp_advice_report_json(object, &advice));
    struct json_object *one =
        json_object_array_get_idx(json_object_object_get(object, "advice"), 0);
    struct json_object *list = json_object_object_get(one, "corrected");
    assert_int_equal(json_object_array_length(list), POINTS);
    assert_near(json_object_get_double(json_object_array_get_idx(list, 1)), 2.0, 1e-9);
    json_object_put(object);
    items[0].of_average = true;
    words = words_of(&advice, &widest);
    assert_non_null(strstr(words, "Use exact+bre for the average, corrected by the "
                                  "median of its range: 2.5 %. In 417 similar rooms"));
    free(words);
}

/* The correction factor is the median of the true value divided by the figure. */
static void a_bias_is_reported_with_its_correction_factor(void **state)
{
    (void)state;
    struct pp_advice_item items[] = {item_of("exact+bre", 1.25)};
    size_t widest;
    char *words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_non_null(strstr(words, "the method tends to be too low there; 1.25 times "
                                  "its value is a better estimate"));
    free(words);
    items[0] = item_of("exact+bre", 0.8);
    words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_non_null(strstr(words, "the method tends to be too high there; 0.80 times "
                                  "its value is a better estimate"));
    free(words);
    items[0] = item_of("exact+bre", 1.02);
    words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_null(strstr(words, "times the value"));
    free(words);
}

static void formula_and_assumption_are_separate_and_followed_by_the_next_best(
    void **state)
{
    (void)state;
    struct pp_advice_item items[] = {item_of("exact+bre", 1.0)};
    items[0].of_average = true;
    size_t widest;
    char *words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_non_null(strstr(words, "Use exact+bre for the average"));
    assert_non_null(strstr(words, "0.90 to 1.20 times the method's in 95 %"));
    assert_non_null(strstr(words, "the formula alone accounts for 1.10 to 1.50"));
    assert_non_null(strstr(words, "ground and surroundings for 0.97 to 1.03"));
    assert_non_null(strstr(words, "Next: exact+sphere 0.50 to 1.75"));
    free(words);
    items[0].best.entry.formula.low = NAN;
    words = words_of(&(struct pp_advice){.items = items, .count = 1}, &widest);
    assert_null(strstr(words, "the formula alone accounts for"));
    free(words);
}

static void where_there_is_none_it_says_why(void **state)
{
    (void)state;
    struct pp_advice none = {.why_not = "the sky is not overcast"};
    size_t widest;
    char *words = words_of(&none, &widest);
    assert_non_null(strstr(words, "the sky is not overcast"));
    free(words);
    struct json_object *object = json_object_new_object();
    assert_true(pp_advice_report_json(object, &none));
    assert_true(json_object_object_get_ex(object, "advice", NULL));
    assert_null(json_object_object_get(object, "advice"));
    assert_string_equal(
        json_object_get_string(json_object_object_get(object, "no-advice")),
        none.why_not);
    json_object_put(object);
}

static double number_at(struct json_object *list, size_t index)
{
    return json_object_get_double(json_object_array_get_idx(list, index));
}

static void json_has_low_middle_and_high_of_each_ratio(void **state)
{
    (void)state;
    struct pp_advice_item items[] = {item_of("exact+bre", 1.25)};
    struct json_object *object = json_object_new_object(), *list, *ratio;
    assert_true(
        pp_advice_report_json(object, &(struct pp_advice){.items = items, .count = 1}));
    assert_true(json_object_object_get_ex(object, "advice", &list));
    assert_int_equal(json_object_array_length(list), 1);
    struct json_object *one = json_object_array_get_idx(list, 0);
    assert_string_equal(json_object_get_string(json_object_object_get(one, "use")),
                        "exact+bre");
    assert_int_equal(json_object_array_length(json_object_object_get(one, "points")),
                     POINTS);
    ratio = json_object_object_get(one, "ratio");
    assert_near(number_at(ratio, 0), 1.125, 1e-12);
    assert_near(number_at(ratio, 1), 1.25, 1e-12);
    assert_near(number_at(ratio, 2), 1.5, 1e-12);
    ratio =
        json_object_object_get(json_object_object_get(one, "others"), "exact+sphere");
    assert_near(number_at(ratio, 2), 1.75, 1e-12);
    json_object_put(object);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_matched_by_position),
        cmocka_unit_test(corrected_figures_are_beside_the_average_and_the_points),
        cmocka_unit_test(a_bias_is_reported_with_its_correction_factor),
        cmocka_unit_test(
            formula_and_assumption_are_separate_and_followed_by_the_next_best),
        cmocka_unit_test(where_there_is_none_it_says_why),
        cmocka_unit_test(json_has_low_middle_and_high_of_each_ratio),
    };
    add_tests(tests, NULL, NULL);
}
