/* test_study_vectors.c - a room's geometry and contours as JSON agree with the room. */
#include "tests/lib/near.h"

#include <json.h>
#include <stdlib.h>
#include <string.h>

#include "pepperpot.h"

/* The corner of the block is not on the axes of the room; the window is not in the
 * middle. */
static const char room_text[] =
    "<room version='1' name='Cell'>\n"
    "<plan width='3.0' depth='5.0' height='2.7'/>\n"
    "<window wall='south' left='0.4' sill='0.9' width='1.1' height='1.3'\n"
    "        glazing='none' reveal='0.2'/>\n"
    "<block x='-2' y='-12' width='9' depth='4' height='6'/>\n"
    "<point x='1.3' y='2.1'/></room>";

struct drawn {
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

static struct drawn open_drawn(void)
{
    struct drawn drawn = {.mistakes = pp_mistakes_create("test.xml")};
    struct pp_error err = {0};
    if (pp_building_parse(&drawn.building, room_text, strlen(room_text), drawn.mistakes,
                          &err)
            != PP_OK
        || pp_study_create(&drawn.study, drawn.building, 0, NULL, drawn.mistakes, &err)
               != PP_OK)
        fail_msg("%s", err.message);
    return drawn;
}

static void close_drawn(struct drawn *drawn)
{
    pp_study_destroy(drawn->study);
    pp_building_destroy(drawn->building);
    pp_mistakes_destroy(drawn->mistakes);
}

static struct json_object *get(struct json_object *object, const char *key)
{
    struct json_object *found;
    if (!json_object_object_get_ex(object, key, &found))
        fail_msg("there is no \"%s\"", key);
    return found;
}

static double number(struct json_object *object, const char *key)
{
    return json_object_get_double(get(object, key));
}

static double entry(struct json_object *list, size_t index)
{
    return json_object_get_double(json_object_array_get_idx(list, index));
}

static struct json_object *parsed(char *bytes)
{
    struct json_object *object = json_tokener_parse(bytes);
    assert_non_null(object);
    pp_free(bytes);
    return object;
}

/* The elevation of the south wall is seen from outside, where x increases to the right:
 * the opening extends from x = 0.4 to 1.5 and z = 0.9 to 2.2, its glass is 0.2 m
 * outside. */
static void scene_has_the_opening_where_the_elevation_has_it(void **state)
{
    (void)state;
    struct drawn drawn = open_drawn();
    char *bytes;
    size_t length;
    assert_int_equal(pp_study_scene(drawn.study, &bytes, &length, NULL), PP_OK);
    assert_int_equal(strlen(bytes), length);
    struct json_object *scene = parsed(bytes);
    struct json_object *opening = json_object_array_get_idx(get(scene, "openings"), 0);
    struct json_object *outer = get(opening, "outer");
    assert_int_equal(json_object_array_length(outer), 12);
    double least[3] = {9, 9, 9}, most[3] = {-9, -9, -9};
    for (size_t i = 0; i < 12; i++) {
        least[i % 3] = fmin(least[i % 3], entry(outer, i));
        most[i % 3] = fmax(most[i % 3], entry(outer, i));
    }
    assert_near(least[0], 0.4, 1e-9);
    assert_near(most[0], 1.5, 1e-9);
    assert_near(least[1], -0.2, 1e-9);
    assert_near(most[1], -0.2, 1e-9);
    assert_near(least[2], 0.9, 1e-9);
    assert_near(most[2], 2.2, 1e-9);
    assert_int_equal(number(opening, "line"), 3);
    struct json_object *block = json_object_array_get_idx(get(scene, "blocks"), 0);
    assert_near(number(block, "y"), -12.0, 1e-9);
    assert_int_equal(json_object_array_length(get(scene, "points")), 1);
    json_object_put(scene);
    close_drawn(&drawn);
}

static double factor_at(struct pp_study *study, double x, double y)
{
    const double at[1][3] = {{x, y, NAN}};
    assert_int_equal(pp_study_set_points(study, at, 1, NULL), PP_OK);
    assert_int_equal(pp_study_methods(study, "exact+bre", false, NULL), PP_OK);
    return pp_study_reading(study, pp_study_find(study, PP_DF, "exact+bre"), 0).value;
}

/* The vertex farthest from the walls; near the walls figures are extrapolated. */
static size_t inmost(struct json_object *xy)
{
    size_t best = 0;
    double most = -1.0;
    for (size_t i = 0; i < json_object_array_length(xy); i += 2) {
        double x = entry(xy, i), y = entry(xy, i + 1);
        double off = fmin(fmin(x, 3.0 - x), fmin(y, 5.0 - y));
        if (off > most) {
            most = off;
            best = i;
        }
    }
    return best;
}

/* Each contour is where the closed form has its level, to 1 %: its position is accurate
 * to a millimetre, which is 0.5 % where the figure changes by a factor of e in 0.2 m. */
static void contours_lie_where_the_closed_form_has_their_level(void **state)
{
    (void)state;
    struct drawn drawn = open_drawn();
    char *bytes;
    size_t length;
    assert_int_equal(
        pp_study_plan(drawn.study, "exact+bre", 0.001, &bytes, &length, NULL), PP_OK);
    struct json_object *plan = parsed(bytes);
    struct json_object *contours = get(plan, "contours");
    assert_true(json_object_array_length(contours) >= 3);
    for (size_t i = 0; i < json_object_array_length(contours); i++) {
        struct json_object *contour = json_object_array_get_idx(contours, i);
        struct json_object *xy = get(contour, "xy");
        size_t middle = inmost(xy);
        double level = number(contour, "level");
        double found =
            100.0 * factor_at(drawn.study, entry(xy, middle), entry(xy, middle + 1));
        assert_near(found, level, 0.01 * level);
    }
    json_object_put(plan);
    close_drawn(&drawn);
}

/* The average is the only difference; with it left out, averages of pp_study_methods stay. */
static void a_plan_without_average_has_the_same_lines(void **state)
{
    (void)state;
    struct drawn drawn = open_drawn();
    char *bytes, *same;
    size_t length;
    assert_int_equal(
        pp_study_plan(drawn.study, "exact+bre", 0.01, &bytes, &length, NULL), PP_OK);
    pp_study_plan_without_average(drawn.study, true);
    assert_int_equal(
        pp_study_plan(drawn.study, "exact+bre", 0.01, &same, &length, NULL), PP_OK);
    struct json_object *with = parsed(bytes), *without = parsed(same);
    assert_true(number(with, "average") > 0.0);
    assert_null(get(without, "average"));
    json_object_object_del(with, "average");
    json_object_object_del(without, "average");
    assert_true(json_object_equal(with, without));
    json_object_put(with);
    json_object_put(without);
    assert_int_equal(pp_study_methods(drawn.study, "exact+bre", false, NULL), PP_OK);
    int column = pp_study_find(drawn.study, PP_DF, "exact+bre");
    assert_true(pp_study_reading(drawn.study, column, -1).value > 0.0);
    close_drawn(&drawn);
}

static void a_plan_of_a_method_without_contours_is_refused(void **state)
{
    (void)state;
    struct drawn drawn = open_drawn();
    struct pp_error err = {0};
    char *bytes;
    size_t length;
    assert_int_equal(
        pp_study_plan(drawn.study, "average-df", 0.01, &bytes, &length, &err),
        PP_BAD_INPUT);
    assert_null(bytes);
    assert_non_null(strstr(err.message, "does not give a value at every point"));
    close_drawn(&drawn);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scene_has_the_opening_where_the_elevation_has_it),
        cmocka_unit_test(contours_lie_where_the_closed_form_has_their_level),
        cmocka_unit_test(a_plan_without_average_has_the_same_lines),
        cmocka_unit_test(a_plan_of_a_method_without_contours_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
