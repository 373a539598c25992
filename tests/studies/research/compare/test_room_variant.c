/* test_room_variant.c - variants of a room compared with closed forms and hand
 * methods. */
#include "methods/evaluate.h"
#include "model/light/glass.h"
#include "tests/studies/research/compare/compared_room.h"

enum { POINTS = 3 };
static const double ERROR = 0.01;

/* A frame factor of 0.7 and a maintenance factor of 0.8. ground: reflectance of the
 * ground; more: further elements. */
#define ROOM(glazing, ground, more)                                                    \
    "<room version='1'><site ground-reflectance='" ground "'/>"                        \
    "<plan width='3.1' depth='4.3' height='2.7'/>"                                     \
    "<finishes floor='0.3' walls='0.6' ceiling='0.75'/>"                               \
    "<window wall='south' left='0.7' sill='0.9' width='1.9' height='1.3' " glazing     \
    " frame-factor='0.7' maintenance='0.8'/>" more                                     \
    "<working-plane height='0.8'/><point x='1.3' y='0.9'/><point x='1.7' y='2.1'/>"    \
    "<point x='0.6' y='3.2'/></room>"

static const char clear_single[] = ROOM("glazing='clear-single'", "0", "");
static const char clear_double[] = ROOM("glazing='clear-double'", "0", "");
static const char unglazed[] = ROOM("glazing='none'", "0", "");
static const char bright_ground[] = ROOM("glazing='clear-single'", "0.4", "");
static const char street[] =
    ROOM("glazing='clear-single'", "0.2",
         "<block x='-5' y='-16' width='13' depth='6' height='8' reflectance='0.3'/>");

static void values_of(double *values, const char *xml, const char *words)
{
    struct pp_test_compared room;
    double errors[POINTS];
    pp_test_compared_init(&room, xml);
    assert_int_equal(room.study.receiver_count, POINTS);
    pp_test_compared_values(values, errors, &room, words, ERROR, 1);
    for (int i = 0; i < POINTS; i++)
        assert_true(errors[i] <= 1.5 * ERROR * values[i] + 2e-5);
    pp_test_compared_clear(&room);
}

/* The sky component of the closed forms. */
static void exact_of(double *values, const char *xml)
{
    struct pp_test_compared room;
    struct pp_error err = {0};
    pp_test_compared_init(&room, xml);
    struct pp_report report = {.world = room.study.world,
                               .light = room.study.light,
                               .receivers = room.study.receivers,
                               .receiver_count = POINTS,
                               .finished = true};
    assert_int_equal(pp_methods_evaluate(&report, "exact", &err), PP_OK);
    const struct pp_column *column = pp_report_find(&report, PP_SC, "exact");
    for (int i = 0; i < POINTS; i++)
        values[i] = column->points[i].value;
    pp_report_clear(&report);
    pp_test_compared_clear(&room);
}

/* Asserts that each value is `ratio` times the other, within five standard errors of
 * both. */
static void assert_ratio(const double *values, const double *others, double ratio)
{
    for (int i = 0; i < POINTS; i++)
        assert_relative(values[i], ratio * others[i], 5.0 * 1.5 * ERROR);
}

static void without_reflections_the_sky_component_is_left(void **state)
{
    (void)state;
    double cut[POINTS], exact[POINTS];
    values_of(cut, clear_single, "bounces=0");
    exact_of(exact, clear_single);
    assert_ratio(cut, exact, 1.0);
}

static void many_reflections_are_as_good_as_all(void **state)
{
    (void)state;
    double cut[POINTS], all[POINTS];
    values_of(cut, clear_single, "bounces=40");
    values_of(all, clear_single, NULL);
    assert_ratio(cut, all, 1.0);
}

static void each_reflection_more_adds_light(void **state)
{
    (void)state;
    double before[POINTS] = {0.0}, now[POINTS];
    static const char *const words[] = {"ab=0", "bounces=0", "bounces=1", "bounces=2"};
    for (int k = 0; k < 4; k++) {
        values_of(now, clear_single, words[k]);
        for (int i = 0; i < POINTS; i++)
            assert_true(k == 0 ? now[i] == 0.0 : now[i] > before[i]);
        memcpy(before, now, sizeof before);
    }
}

/* With black ground there is no light from the ground to count. */
static void radiance_counts_from_one(void **state)
{
    (void)state;
    double ours[POINTS], letters[POINTS];
    values_of(ours, clear_single, "bounces=2");
    values_of(letters, clear_single, "ab=3");
    for (int i = 0; i < POINTS; i++)
        assert_true(ours[i] == letters[i]);
}

/* Only walls and ceiling see the ground: one reflection there and one at the ground are
 * two. */
static void where_the_ground_counts_one_reflection_leaves_it_black(void **state)
{
    (void)state;
    double counted[POINTS], black[POINTS], glowing[POINTS];
    values_of(counted, bright_ground, "ab=2");
    values_of(black, bright_ground, "bounces=1,ground=0");
    values_of(glowing, bright_ground, "bounces=1");
    assert_ratio(counted, black, 1.0);
    for (int i = 0; i < POINTS; i++)
        assert_true(glowing[i] > counted[i]);
    assert_true(glowing[POINTS - 1] > 1.1 * counted[POINTS - 1]);
}

/* Before any reflection all light has passed the frame and the dirt once. */
static void dirt_and_frames_are_factors_of_the_direct_light(void **state)
{
    (void)state;
    double is[POINTS], clean[POINTS], frameless[POINTS];
    values_of(is, clear_single, "bounces=0");
    values_of(clean, clear_single, "bounces=0,dirt=none");
    values_of(frameless, clear_single, "bounces=0,frame=none");
    assert_ratio(clean, is, 1.0 / 0.8);
    assert_ratio(frameless, is, 1.0 / 0.7);
}

static void glass_by_its_normal_transmittance_is_a_factor_of_no_glass(void **state)
{
    (void)state;
    double normal[POINTS], none[POINTS], exact[POINTS];
    values_of(normal, clear_single, "bounces=0,glass=normal");
    values_of(none, clear_single, "bounces=0,glass=none");
    exact_of(exact, unglazed);
    assert_ratio(none, exact, 1.0);
    assert_ratio(normal, exact, pp_glass_clear_single().normal);
}

/* (1 - rho)^2 t / (1 - rho^2 t^2) at t = 0.9, rho = 0.0425800: 0.8262. */
static void a_transmittance_taken_for_a_transmissivity_loses_a_twelfth(void **state)
{
    (void)state;
    double is[POINTS], wrong[POINTS];
    values_of(is, clear_single, "bounces=0");
    values_of(wrong, clear_single, "bounces=0,glass=transmissivity");
    assert_ratio(wrong, is, 0.826170 / 0.900070);
}

static void one_of_two_panes_is_the_single_pane(void **state)
{
    (void)state;
    double one[POINTS], single[POINTS];
    values_of(one, clear_double, "bounces=0,panes=1");
    values_of(single, clear_single, "bounces=0");
    assert_ratio(one, single, 1.0);
}

static void a_factor_is_one(void **state)
{
    (void)state;
    double is[POINTS], more[POINTS];
    values_of(is, clear_single, "bounces=0");
    values_of(more, clear_single, "bounces=0,factor=1.17");
    for (int i = 0; i < POINTS; i++)
        assert_relative(more[i], 1.17 * is[i], 1e-12);
}

static void with_nothing_outside_all_sky_is_seen(void **state)
{
    (void)state;
    double cleared[POINTS], exact[POINTS];
    values_of(cleared, street, "bounces=0,outside=none");
    exact_of(exact, clear_single);
    assert_ratio(cleared, exact, 1.0);
}

static void a_uniform_sky_is_brighter_at_the_window(void **state)
{
    (void)state;
    double switched[POINTS], exact[POINTS];
    values_of(switched, clear_single, "bounces=0,sky=uniform");
    char xml[1024];
    snprintf(xml, sizeof xml, "<room version='1'><sky type='uniform'/>%s",
             strstr(clear_single, "<site"));
    exact_of(exact, xml);
    assert_ratio(switched, exact, 1.0);
}

static void points_on_another_plane_are_there(void **state)
{
    (void)state;
    double moved[POINTS], exact[POINTS];
    values_of(moved, clear_single, "bounces=0,plane=1.1");
    char xml[1024];
    const char *at = strstr(clear_single, "height='0.8'");
    snprintf(xml, sizeof xml, "%.*sheight='1.1'%s", (int)(at - clear_single),
             clear_single, at + strlen("height='0.8'"));
    exact_of(exact, xml);
    assert_ratio(moved, exact, 1.0);
}

static void an_unknown_switch_is_rejected_with_the_expected_ones(void **state)
{
    (void)state;
    static const char *const wrong[][2] = {
        {"bounce=2", "did you mean bounces?"},
        {"bounces=2.5", "expected a whole number"},
        {"bounces=-1", "expected a whole number"},
        {"glass=norml", "did you mean normal?"},
        {"panes=3", "expected 1"},
        {"plane=high", "expected a number"},
        {"sky=gensy", "did you mean gensky?"},
        {"ground=1.5", "expected a number from 0 to 1"},
        {"lowest", "neither a switch nor a preset"},
        {"", "neither a switch nor a preset"},
        {"frame=none,", "neither a switch nor a preset"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        struct pp_room_variant variant = pp_room_variant_nothing();
        struct pp_error err = {0};
        assert_int_equal(pp_room_variant_add(&variant, wrong[i][0], &err),
                         PP_BAD_INPUT);
        if (!strstr(err.message, wrong[i][1]))
            fail_msg("\"%s\" of \"%s\"", err.message, wrong[i][0]);
    }
}

static void a_preset_equals_its_switches(void **state)
{
    (void)state;
    const struct pp_room_variant_preset *preset;
    for (int i = 0; (preset = pp_room_variant_preset_at(i)) != NULL; i++) {
        struct pp_room_variant by_name = pp_room_variant_nothing(),
                               by_words = pp_room_variant_nothing();
        assert_int_equal(pp_room_variant_add(&by_name, preset->name, NULL), PP_OK);
        assert_int_equal(pp_room_variant_add(&by_words, preset->words, NULL), PP_OK);
        assert_int_equal(by_name.bounces, by_words.bounces);
        assert_true(by_name.dark == by_words.dark);
        assert_true(by_name.dark || by_name.bounces >= 1);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_reflections_the_sky_component_is_left),
        cmocka_unit_test(many_reflections_are_as_good_as_all),
        cmocka_unit_test(each_reflection_more_adds_light),
        cmocka_unit_test(radiance_counts_from_one),
        cmocka_unit_test(where_the_ground_counts_one_reflection_leaves_it_black),
        cmocka_unit_test(dirt_and_frames_are_factors_of_the_direct_light),
        cmocka_unit_test(glass_by_its_normal_transmittance_is_a_factor_of_no_glass),
        cmocka_unit_test(a_transmittance_taken_for_a_transmissivity_loses_a_twelfth),
        cmocka_unit_test(one_of_two_panes_is_the_single_pane),
        cmocka_unit_test(a_factor_is_one),
        cmocka_unit_test(with_nothing_outside_all_sky_is_seen),
        cmocka_unit_test(a_uniform_sky_is_brighter_at_the_window),
        cmocka_unit_test(points_on_another_plane_are_there),
        cmocka_unit_test(an_unknown_switch_is_rejected_with_the_expected_ones),
        cmocka_unit_test(a_preset_equals_its_switches),
    };
    add_tests(tests, NULL, NULL);
}
