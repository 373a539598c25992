/* test_gains.c - the gain by each change to a room equals that of a room file with this
 * change. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "studies/sizing/gains.h"
#include "studies/criteria/grid/plane_grid.h"
#include "methods/evaluate.h"
#include "tests/lib/room_of.h"

static const char office[] =
    "<room version='1'><plan width='4.1' depth='5.3' height='2.9'/>"
    "<finishes floor='0.2' walls='0.45' ceiling='0.65'/>"
    "<finish wall='west' reflectance='0.8'/>"
    "<window wall='south' left='1.7' sill='1.1' width='1.2' height='1.3' "
    "glazing='solar-control-light' frame-factor='0.7' maintenance='0.8'/>"
    "<skyline wall='south' angle='23'/></room>";

static const struct {
    const char *change;   /* text in the sentence of the gain */
    const char *was, *is; /* text in the file */
} cases[] = {
    {"ceiling with a reflectance of 0.85", "ceiling='0.65'", "ceiling='0.85'"},
    {"walls with a reflectance of 0.7", "walls='0.45'", "walls='0.7'"},
    {"floor with a reflectance of 0.4", "floor='0.2'", "floor='0.4'"},
    {"clean glass", "maintenance='0.8'", "maintenance='1'"},
    {"frames half as wide", "frame-factor='0.7'", "frame-factor='0.85'"},
    {"clear-double glazing", "solar-control-light", "clear-double"},
    {"0.5 m higher", "height='1.3'", "height='1.8'"},
    {"0.25 m lower", "sill='1.1' width='1.2' height='1.3'",
     "sill='0.85' width='1.2' height='1.55'"},
    {"0.3 m wider", "left='1.7' sill='1.1' width='1.2'",
     "left='1.55' sill='1.1' width='1.5'"},
    {"another window", "<skyline",
     "<window wall='south' left='0' sill='1.1' width='1.2' height='1.3' "
     "glazing='solar-control-light' frame-factor='0.7' maintenance='0.8'/><skyline"},
    {"opposite wall, north", "<skyline",
     "<window wall='north' left='1.7' sill='1.1' width='1.2' height='1.3' "
     "glazing='solar-control-light' frame-factor='0.7' maintenance='0.8'/><skyline"},
    {"no external obstructions", "<skyline wall='south' angle='23'/>", ""},
};
enum { CASES = sizeof cases / sizeof *cases };

static void gains_by(struct pp_gains *gains, const char *xml,
                     const struct pp_study_options *simulated)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, &err),
                     PP_OK);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    if (pp_gains_find(gains, pp_building_room(building, 0), world, &light,
                      &(struct pp_watch){0}, &err)
        != PP_OK)
        fail_msg("%s", err.message);
    if (simulated
        && pp_gains_simulate(gains, pp_building_room(building, 0), world, &light,
                             simulated, &err)
               != PP_OK)
        fail_msg("%s", err.message);
    pp_world_destroy(world);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
}

static void gains_of(struct pp_gains *gains, const char *xml)
{
    gains_by(gains, xml, NULL);
}

/* Average and darkest point of a file, without a change made in memory. */
static struct pp_gain_values values_of(const char *xml, const char *method)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_receiver *grid;
    struct pp_report report = {.world = world, .light = light};
    assert_int_equal(pp_plane_grid_largest(&grid, &report.receiver_count, world, NULL),
                     PP_OK);
    report.receivers = grid;
    assert_int_equal(pp_methods_evaluate(&report, method, NULL), PP_OK);
    const struct pp_column *df = pp_report_find(&report, PP_DF, method);
    struct pp_gain_values values = {df->average.value, INFINITY};
    for (int i = 0; i < report.receiver_count; i++)
        if (df->points[i].value < values.darkest)
            values.darkest = df->points[i].value;
    pp_report_clear(&report);
    free(grid);
    pp_world_destroy(world);
    return values;
}

static void each_gain_is_that_of_the_changed_file(void **state)
{
    (void)state;
    struct pp_gains gains;
    gains_of(&gains, office);
    assert_string_equal(gains.method, "exact+bre");
    assert_int_equal(gains.count, CASES);
    struct pp_gain_values now = values_of(office, "exact+bre");
    assert_relative(gains.now.average, now.average, 1e-12);
    assert_relative(gains.now.darkest, now.darkest, 1e-12);
    for (int i = 0; i < CASES; i++) {
        const struct pp_gain *gain = NULL;
        for (int k = 0; k < gains.count; k++)
            if (strstr(gains.list[k].change, cases[i].change))
                gain = &gains.list[k];
        if (!gain)
            fail_msg("no gain says \"%s\"", cases[i].change);
        char file[1024];
        const char *at = strstr(office, cases[i].was);
        assert_non_null(at);
        snprintf(file, sizeof file, "%.*s%s%s", (int)(at - office), office, cases[i].is,
                 at + strlen(cases[i].was));
        struct pp_gain_values values = values_of(file, "exact+bre");
        /* Lengths are those of the file, rounded to a millimetre. */
        assert_relative(gain->values.average, values.average, 1e-6);
        assert_relative(gain->values.darkest, values.darkest, 1e-6);
        assert_true(gain->of_design
                    == (strcmp(cases[i].change, "no external obstructions") != 0));
    }
}

static void the_largest_gain_comes_first(void **state)
{
    (void)state;
    struct pp_gains gains;
    gains_of(&gains, office);
    for (int i = 0; i < gains.count; i++) {
        assert_true(gains.list[i].values.average > gains.now.average);
        if (i > 0)
            assert_true(gains.list[i].values.average
                        <= gains.list[i - 1].values.average);
    }
    char sentence[256];
    pp_gains_sentence(&gains, sentence, sizeof sentence);
    assert_true(strncmp(sentence, "Main causes: ", 13) == 0);
    /* A possible window in another wall is not a deficiency; the first deficiency is
     * named. */
    const char *first = gains.list[0].lacks ? gains.list[0].lacks : gains.list[1].lacks;
    assert_true(strncmp(sentence + 13, first, strlen(first)) == 0);
}

static void gains_relate_to_the_average_of_a_longer_simulation(void **state)
{
    (void)state;
    struct pp_gains gains;
    gains_of(&gains, office);
    const struct pp_gains first = gains;
    pp_gains_relate(&gains, 1.1 * first.now.average);
    assert_relative(gains.now.average, 1.1 * first.now.average, 1e-12);
    for (int i = 0; i < gains.count; i++) {
        assert_relative(gains.list[i].values.average,
                        1.1 * first.list[i].values.average, 1e-12);
        assert_float_equal(gains.list[i].values.darkest, first.list[i].values.darkest,
                           0.0);
    }
    pp_gains_relate(&gains, NAN);
    assert_relative(gains.now.average, 1.1 * first.now.average, 1e-12);
}

static void a_room_that_cannot_be_improved_has_no_gains(void **state)
{
    (void)state;
    struct pp_gains gains;
    gains_of(
        &gains,
        "<room version='1'><plan width='4.1' depth='5.3' height='2.9'/>"
        "<finishes floor='0.4' walls='0.7' ceiling='0.85'/>"
        "<window wall='south' left='0' sill='0' width='4.1' height='2.9'/>"
        "<window wall='north' left='0' sill='0' width='4.1' height='2.9'/></room>");
    assert_int_equal(gains.count, 0);
    char sentence[256];
    pp_gains_sentence(&gains, sentence, sizeof sentence);
    assert_string_equal(sentence, "");
}

/* Cleaning increases the average by as much as the dirt has reduced it. */
static void a_gain_of_a_hundredth_is_reported_but_not_one_of_a_thousandth(void **state)
{
    (void)state;
    static const char *const clean[2] = {"0.99", "0.999"};
    for (int i = 0; i < 2; i++) {
        char file[400];
        snprintf(file, sizeof file,
                 "<room version='1'><plan width='4.1' depth='5.3' height='2.9'/>"
                 "<window wall='south' left='0' sill='0' width='4.1' height='2.9' "
                 "maintenance='%s'/></room>",
                 clean[i]);
        struct pp_gains gains;
        gains_of(&gains, file);
        bool told = false;
        for (int k = 0; k < gains.count; k++)
            told = told || strstr(gains.list[k].change, "clean glass");
        assert_int_equal(told, i == 0);
    }
}

static void where_bre_says_nothing_split_flux_does(void **state)
{
    (void)state;
    char file[1024];
    struct pp_gains gains;
    snprintf(file, sizeof file, "<room version='1'><sky type='uniform'/>%s",
             strstr(office, "<plan"));
    gains_of(&gains, file);
    assert_string_equal(gains.method, "exact+split-flux");
    assert_relative(gains.now.average, values_of(file, "exact+split-flux").average,
                    1e-12);
    assert_in_range(gains.count, CASES - 1, CASES);
}

static void a_room_without_openings_has_nothing_to_gain(void **state)
{
    (void)state;
    struct pp_gains gains;
    gains_of(&gains, "<room version='1'><plan width='4.1' depth='5.3' height='2.9'/>"
                     "<finishes floor='0.1' walls='0.2' ceiling='0.3'/></room>");
    assert_int_equal(gains.count, 0);
}

/* A black wall 1 m in front of the window leaves only a strip of sky. The formulae
 * assume that the wall reflects 0.2; in the simulation it reflects nothing. */
static void simulated_gains_start_from_the_simulated_average(void **state)
{
    (void)state;
    static const char well[] =
        "<room version='1'><plan width='4.1' depth='4.3' height='2.9'/>"
        "<window wall='south' left='1.7' sill='1.1' width='1.2' height='1.3'/>"
        "<block x='-9' y='-1.5' width='22' depth='0.5' height='9' reflectance='0'/>"
        "</room>";
    const struct pp_study_options options = {
        .seed = 1, .simulate = true, .error = 0.05};
    struct pp_gains by_hand, simulated;
    gains_of(&by_hand, well);
    gains_by(&simulated, well, &options);
    assert_string_equal(simulated.method, "traced");
    assert_true(simulated.now.average > 0.0);
    assert_true(simulated.now.average < 0.7 * by_hand.now.average);
    assert_true(simulated.count > 0 && simulated.count <= PP_GAINS_SIMULATED);
    for (int i = 0; i < simulated.count; i++) {
        assert_true(simulated.list[i].values.average > simulated.now.average);
        if (i > 0)
            assert_true(simulated.list[i].values.average
                        <= simulated.list[i - 1].values.average);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_gain_is_that_of_the_changed_file),
        cmocka_unit_test(the_largest_gain_comes_first),
        cmocka_unit_test(gains_relate_to_the_average_of_a_longer_simulation),
        cmocka_unit_test(a_room_that_cannot_be_improved_has_no_gains),
        cmocka_unit_test(a_gain_of_a_hundredth_is_reported_but_not_one_of_a_thousandth),
        cmocka_unit_test(where_bre_says_nothing_split_flux_does),
        cmocka_unit_test(a_room_without_openings_has_nothing_to_gain),
        cmocka_unit_test(simulated_gains_start_from_the_simulated_average),
    };
    add_tests(tests, NULL, NULL);
}
