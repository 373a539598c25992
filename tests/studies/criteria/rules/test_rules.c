/* test_rules.c - the rules of tables/rules.csv, in rooms with figures calculated by
 * hand. */
#include <stdlib.h>

#include "studies/criteria/factors.h"
#include "studies/criteria/rules/rule_quantity.h"
#include "studies/criteria/rules/rule_set.h"
#include "studies/criteria/windows/traced_windows.h"
#include "tests/lib/room_of.h"

#define PLAN                                                                           \
    "<plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>"                               \
    "<finishes floor=\"0.2\" walls=\"0.5\" ceiling=\"0.7\"/>"
#define WINDOW(sill)                                                                   \
    "<window wall=\"south\" left=\"0.7\" sill=\"" #sill                                \
    "\" width=\"2.6\" height=\"1.3\" maintenance=\"1\"/>"
#define SITE "<site latitude=\"51.5\" longitude=\"0\"/>"

/* Findings for a room by the rules with this name, with hand figures on a coarse grid.
 * The caller clears them. */
static struct pp_finding_list found_by_rules(const char *name, const char *use,
                                             const char *body)
{
    struct pp_outside_light light;
    struct pp_rule_set set;
    struct pp_plane_grid grid;
    char text[2048];
    snprintf(text, sizeof text,
             "<room version=\"1\" name=\"Test\" use=\"%s\">%s</room>", use, body);
    struct pp_world *world = pp_test_lit_world(&light, text);
    assert_true(pp_rule_set_init(&set, name));
    const struct pp_grid_choice choice = {.spacing_m = 0.8, .margin_m = 0.5};
    assert_int_equal(pp_plane_grid_make(&grid, world, NULL, &choice, 0, NULL), PP_OK);
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = grid.receivers,
                               .receiver_count = grid.count};
    assert_int_equal(pp_factors_by_hand(&report, NULL), PP_OK);
    const struct pp_inquiry inquiry = {.world = world,
                                       .light = &light,
                                       .factors = &report,
                                       .grid = &grid,
                                       .rules = &set};
    struct pp_finding_list findings = {0};
    assert_int_equal(set.criterion.evaluate(&inquiry, &findings, NULL), PP_OK);
    pp_report_clear(&report);
    pp_plane_grid_clear(&grid);
    pp_world_destroy(world);
    return findings;
}

/* DF = T W theta / (A (1 - R^2)) with T = 0.827, W = 3.38 m2, theta = 90 degrees,
 * A = 111.98 m2 and R = 0.46486: 2.866 %. */
static void norway_requires_a_mean_of_two_per_cent_or_enough_glass(void **state)
{
    (void)state;
    struct pp_finding_list findings =
        found_by_rules("no-tek17", "living-room", PLAN WINDOW(0.95));
    assert_int_equal(findings.count, 3);
    assert_near(findings.list[0].figure, 0.02866, 2e-5);
    assert_int_equal(findings.list[0].verdict, PP_MET);
    /* All the glass is above 0.8 m: 3.38 x 0.9 / 25.83. */
    assert_near(findings.list[1].figure, 0.11777, 1e-5);
    assert_near(findings.list[2].figure, 2.0, 0.0);
    assert_true(findings.list[0].is_optional && !findings.list[2].is_optional);
    assert_non_null(strstr(findings.list[0].note, "seen at dibk.no"));
    assert_non_null(strstr(findings.list[0].what, "overcast sky"));
    pp_finding_list_clear(&findings);
}

/* A window of 1.3 m with its sill at 0.5 m has 1.0 m above 0.8 m: 9.06 %. */
static void glass_below_0_8_m_does_not_count_in_norway(void **state)
{
    (void)state;
    struct pp_finding_list findings =
        found_by_rules("no-tek17", "living-room", PLAN WINDOW(0.5));
    assert_near(findings.list[1].figure, 2.6 * 0.9 / 25.83, 1e-5);
    pp_finding_list_clear(&findings);
    findings = found_by_rules(
        "no-tek17", "living-room",
        PLAN WINDOW(0.95) "<skyline wall=\"south\" angle=\"50\" distance=\"9\"/>");
    assert_int_equal(findings.list[1].verdict, PP_NOT_JUDGED);
    pp_finding_list_clear(&findings);
    findings = found_by_rules("no-tek17", "office", PLAN WINDOW(0.95));
    assert_int_equal(findings.count, 2); /* the glass rule is for dwellings */
    pp_finding_list_clear(&findings);
}

/* One of two alternatives is enough: the German rule on points of the room file is not
 * assessed here, since the room has none. */
static void one_alternative_is_enough(void **state)
{
    (void)state;
    struct pp_finding_list findings =
        found_by_rules("de-asr-a3.4", "office", PLAN WINDOW(0.95));
    assert_int_equal(findings.count, 3);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    assert_near(findings.list[1].figure, 3.38 / 25.83, 1e-6);
    assert_int_equal(findings.list[1].verdict, PP_MET);
    assert_int_equal(findings.list[2].verdict, PP_MET);
    pp_finding_list_clear(&findings);
    /* Denmark's corrections are unknown, so more glass than required does not prove
     * compliance. */
    findings = found_by_rules("dk-br18", "office", PLAN WINDOW(0.95));
    assert_int_equal(findings.list[0].verdict, PP_UNDECIDED);
    assert_int_equal(findings.list[findings.count - 1].verdict, PP_UNDECIDED);
    pp_finding_list_clear(&findings);
    findings = found_by_rules(
        "dk-br18", "office",
        PLAN "<window wall=\"south\" left=\"1\" sill=\"1\" width=\"1\" height=\"1\"/>");
    assert_int_equal(findings.list[0].verdict, PP_NOT_MET); /* 3.9 % */
    pp_finding_list_clear(&findings);
}

/* Vertical: 39.62 % from the overcast sky, and half of the ground's 0.2. */
static void an_open_window_has_a_vertical_daylight_factor_of_49_6(void **state)
{
    (void)state;
    struct pp_finding_list findings = found_by_rules(
        "hk-app-130", "kitchen",
        "<site ground=\"open\" ground-reflectance=\"0.2\"/>" PLAN WINDOW(0.95));
    assert_int_equal(findings.count, 1);
    assert_near(findings.list[0].figure, 0.396177 + 0.1, 1e-5);
    assert_near(findings.list[0].wanted, 0.04, 1e-12);
    pp_finding_list_clear(&findings);
}

/* A wall hides the whole sky in front of a window: the rest of the vertical daylight
 * factor is reflected light, whose figure is too high between buildings. */
static void reflected_light_alone_does_not_meet_a_vertical_factor(void **state)
{
    (void)state;
    struct pp_finding_list findings = found_by_rules(
        "hk-app-130", "kitchen",
        "<site ground=\"open\" ground-reflectance=\"0.2\"/>" PLAN WINDOW(
            0.95) "<block x=\"-500\" y=\"-3.2\" width=\"1000\" depth=\"0.2\" "
                  "height=\"500\"/>");
    assert_true(findings.list[0].figure > 0.1);
    assert_int_equal(findings.list[0].verdict, PP_UNDECIDED);
    assert_non_null(strstr(findings.list[0].note, "overestimated"));
    pp_finding_list_clear(&findings);
}

/* The first finding of hk-app-130 with simulated windows. */
static struct pp_finding simulated_vertical_factor(const char *body)
{
    struct pp_outside_light light;
    struct pp_rule_set set;
    struct pp_reading *windows;
    struct pp_study_options study = PP_STUDY_OPTIONS_NONE;
    char text[2048];
    bool finished = true, by_clock = false;
    snprintf(text, sizeof text,
             "<room version=\"1\" name=\"Test\" use=\"kitchen\">%s</room>", body);
    struct pp_world *world = pp_test_lit_world(&light, text);
    study.error = 0.01;
    study.threads = 1;
    assert_true(pp_rule_set_init(&set, "hk-app-130"));
    assert_true(set.of_windows);
    assert_int_equal(pp_traced_windows_light(&windows, world, &light, &study, &finished,
                                             &by_clock, NULL),
                     PP_OK);
    assert_true(finished && !by_clock);
    const struct pp_inquiry inquiry = {
        .world = world, .light = &light, .windows = windows, .rules = &set};
    struct pp_finding_list findings = {0};
    assert_int_equal(set.criterion.evaluate(&inquiry, &findings, NULL), PP_OK);
    struct pp_finding finding = findings.list[0];
    pp_finding_list_clear(&findings);
    free(windows);
    pp_world_destroy(world);
    return finding;
}

/* Without obstructions: the sky's 39.62 % and half of the ground's 0.2. Before the wall
 * of the test above, no light comes from the sky, and the ground is dark as well. */
static void simulated_vertical_factors_have_the_light_of_their_surroundings(
    void **state)
{
    (void)state;
    struct pp_finding open = simulated_vertical_factor(
        "<site ground=\"open\" ground-reflectance=\"0.2\"/>" PLAN WINDOW(0.95));
    assert_near(open.figure, 0.496177, 4.0 * open.std_error);
    assert_true(open.std_error < 0.006);
    assert_int_equal(open.verdict, PP_MET);
    struct pp_finding dark = simulated_vertical_factor(PLAN WINDOW(
        0.95) "<facade wall=\"south\" left=\"500\" right=\"500\" up=\"497\"/>"
              "<block x=\"-500\" y=\"-3.2\" width=\"1000\" depth=\"0.2\" "
              "height=\"500\"/>");
    assert_true(dark.figure < 0.01);
    assert_int_equal(dark.verdict, PP_NOT_MET);
}

/* A room without windows has no daylight. */
static void a_room_without_windows_does_not_meet_a_rule(void **state)
{
    (void)state;
    static const char *const names[] = {"hk-app-130", "se-bbr", "no-tek17-cabin"};
    for (int i = 0; i < 3; i++) {
        struct pp_finding_list findings = found_by_rules(names[i], "bedroom", PLAN);
        assert_near(findings.list[0].figure, 0.0, 0.0);
        assert_int_equal(findings.list[0].verdict, PP_NOT_MET);
        pp_finding_list_clear(&findings);
    }
}

/* Below a horizontal overhang there may be more floor, so 13.1 % of glass is undecided;
 * a fin adds no floor. Neither is an obstruction. */
static void shades_of_windows_are_no_obstructions_in_norway(void **state)
{
    (void)state;
    static const char *const shades[] = {"<overhang depth=\"0.9\"/>",
                                         "<fin depth=\"0.3\"/>"};
    static const enum pp_verdict verdicts[] = {PP_UNDECIDED, PP_MET};
    for (int i = 0; i < 2; i++) {
        char body[1024];
        snprintf(body, sizeof body,
                 PLAN "<window wall=\"south\" left=\"0.7\" sill=\"0.95\" "
                      "width=\"2.6\" height=\"1.3\" maintenance=\"1\">%s</window>",
                 shades[i]);
        struct pp_finding_list findings =
            found_by_rules("no-tek17-cabin", "living-room", body);
        assert_near(findings.list[0].figure, 3.38 / 25.83, 1e-6);
        assert_int_equal(findings.list[0].verdict, verdicts[i]);
        pp_finding_list_clear(&findings);
    }
}

/* Hours of sun are one of several conditions in Slovakia, so enough hours do not prove
 * compliance. */
static void enough_sun_alone_does_not_meet_the_slovak_rule(void **state)
{
    (void)state;
    struct pp_finding_list findings =
        found_by_rules("sk-stn-734301", "living-room", SITE PLAN WINDOW(0.95));
    assert_true(findings.list[0].figure > 1.5);
    assert_int_equal(findings.list[0].verdict, PP_UNDECIDED);
    pp_finding_list_clear(&findings);
    findings = found_by_rules("sk-stn-734301", "living-room", SITE PLAN);
    assert_int_equal(findings.list[0].verdict, PP_NOT_MET);
    pp_finding_list_clear(&findings);
}

/* BREEAM 4a: one mean for each room, 2 % in kitchens and 1.5 % in living rooms. */
static void a_kitchen_has_one_required_mean_and_a_bedroom_none(void **state)
{
    (void)state;
    static const char *const uses[] = {"kitchen", "living-kitchen", "living-room"};
    static const double wanted[] = {0.02, 0.02, 0.015};
    for (int i = 0; i < 3; i++) {
        struct pp_finding_list findings =
            found_by_rules("breeam-4a", uses[i], PLAN WINDOW(0.95));
        assert_int_equal(findings.count,
                         4); /* including two alternatives and their combination */
        assert_near(findings.list[0].wanted, wanted[i], 1e-12);
        pp_finding_list_clear(&findings);
    }
    struct pp_finding_list findings =
        found_by_rules("breeam-4a", "bedroom", PLAN WINDOW(0.95));
    assert_int_equal(findings.count, 1);
    assert_int_equal(findings.list[0].verdict, PP_NOT_JUDGED);
    pp_finding_list_clear(&findings);
}

/* Finding of a rule on hours of sun in a room. */
static struct pp_finding sun_finding(const struct pp_rule *rule, const char *body)
{
    struct pp_outside_light light;
    char text[2048];
    snprintf(text, sizeof text, "<room version=\"1\">%s</room>", body);
    struct pp_world *world = pp_test_lit_world(&light, text);
    const struct pp_inquiry inquiry = {.world = world, .light = &light};
    struct pp_finding_list findings = {0};
    assert_int_equal(pp_rule_sun_hours.evaluate(rule, &inquiry, "sun", &findings, NULL),
                     PP_OK);
    struct pp_finding finding = findings.list[0];
    pp_finding_list_clear(&findings);
    pp_world_destroy(world);
    return finding;
}

static const struct pp_rule equinox = {.point = "centre",
                                       .from = "03-20",
                                       .to = "03-20",
                                       .threshold = 4.0,
                                       .from_h = NAN,
                                       .to_h = NAN,
                                       .altitude_deg = NAN,
                                       .plan_angle_deg = NAN,
                                       .breaks = NAN};

/* At the equinox the sun is above the horizon from 6 to 18 h. At 51.5 degrees its
 * azimuth is 65 degrees from south at the hour angle H with tan H = sin 51.5 tan 65:
 * 59.2 degrees. The sun is therefore at 25 degrees or more to the glass for 7.89 h. */
static void grazing_sun_can_be_left_out(void **state)
{
    (void)state;
    struct pp_rule rule = equinox;
    assert_near(sun_finding(&rule, SITE PLAN WINDOW(0.95)).figure, 12.0, 0.02);
    rule.plan_angle_deg = 25.0;
    assert_near(sun_finding(&rule, SITE PLAN WINDOW(0.95)).figure, 7.89, 0.02);
    rule.from_h = 9.0; /* the afternoon ends at 15:57 */
    rule.to_h = 17.0;
    assert_near(sun_finding(&rule, SITE PLAN WINDOW(0.95)).figure, 3.0 + 7.89 / 2.0,
                0.02);
    assert_int_equal(sun_finding(&rule, PLAN WINDOW(0.95)).verdict, PP_NOT_JUDGED);
}

/* A high screen due south, from 20 degrees east to 20 degrees west of the middle,
 * divides the day into two intervals. */
static void without_breaks_the_longest_interval_counts(void **state)
{
    (void)state;
    static const char screened[] =
        SITE PLAN WINDOW(0.95) "<block x=\"-1.64\" y=\"-10.2\" width=\"7.28\" "
                               "depth=\"0.2\" height=\"90\"/>";
    struct pp_rule rule = equinox;
    double both = sun_finding(&rule, screened).figure;
    rule.breaks = 0.0;
    assert_near(sun_finding(&rule, screened).figure, both / 2.0, 0.02);
    rule.breaks = 1.0;
    assert_near(sun_finding(&rule, screened).figure, both, 1e-9);
    assert_true(both > 8.0 && both < 10.0);
}

/* The day of the period with the least sun decides: in a south window the December sun
 * is above the horizon for less time than the March sun. */
static void the_worst_day_of_a_period_decides(void **state)
{
    (void)state;
    struct pp_rule rule = equinox;
    rule.from = "11-01";
    rule.to = "12-24";
    struct pp_finding finding = sun_finding(&rule, SITE PLAN WINDOW(0.95));
    assert_true(finding.figure > 7.5 && finding.figure < 8.0);
    assert_non_null(strstr(finding.note, "December"));
}

/* Four quarters of 500 h, two points. Means 350, 300, 75 and 0 lx; minima 300, 250, 50
 * and 0 lx. */
static void hours_with_an_illuminance_are_counted_by_mean_and_least(void **state)
{
    (void)state;
    float lx[] = {400, 250, 100, 0, 300, 350, 50, 0}, none[8] = {0};
    struct pp_annual_hour hours[4];
    struct pp_annual_figures points[2] = {{.year_lxh = {1.0, 0.0}},
                                          {.year_lxh = {1.0, 0.0}}};
    for (int i = 0; i < 4; i++)
        hours[i] = (struct pp_annual_hour){.length_h = 500.0, .known = true, .sky = i};
    const struct pp_annual_sheet year = {.receiver_count = 2,
                                         .finished = true,
                                         .points = points,
                                         .hour_count = 4,
                                         .hours = hours,
                                         .sky_count = 4,
                                         .lx = lx,
                                         .sun_lx = none};
    const struct pp_inquiry inquiry = {.year = &year};
    struct pp_rule rule = {.lux = 300.0, .threshold = 1000.0};
    struct pp_finding_list findings = {0};
    pp_rule_mean_lux_hours.evaluate(&rule, &inquiry, "mean", &findings, NULL);
    pp_rule_least_lux_hours.evaluate(&rule, &inquiry, "least", &findings, NULL);
    rule.lux = 90.0;
    pp_rule_least_lux_hours.evaluate(&rule, &inquiry, "least", &findings, NULL);
    assert_near(findings.list[0].figure, 1000.0, 1e-9);
    assert_int_equal(findings.list[0].verdict, PP_MET); /* equality counts */
    assert_near(findings.list[1].figure, 500.0, 1e-9);
    assert_int_equal(findings.list[1].verdict, PP_NOT_MET);
    assert_near(findings.list[2].figure, 1000.0, 1e-9);
    pp_finding_list_clear(&findings);
}

static int compare_falling_factors(const void *a, const void *b)
{
    double x = ((const struct pp_reading *)a)->value;
    double y = ((const struct pp_reading *)b)->value;
    return (x < y) - (x > y);
}

/* A share of 33 % of n points is reached by the ceil(0.33 n)-th brightest point. */
static void a_share_of_the_plane_is_that_of_its_brightest_points(void **state)
{
    (void)state;
    static const char body[] = PLAN WINDOW(0.95) "<sky type=\"uniform\"/>";
    struct pp_outside_light light;
    struct pp_plane_grid grid;
    char text[2048];
    snprintf(text, sizeof text, "<room version=\"1\">%s</room>", body);
    struct pp_world *world = pp_test_lit_world(&light, text);
    const struct pp_grid_choice choice = {.spacing_m = 0.8, .margin_m = 0.5};
    assert_int_equal(pp_plane_grid_make(&grid, world, NULL, &choice, 0, NULL), PP_OK);
    struct pp_report report = {.world = world,
                               .light = light,
                               .receivers = grid.receivers,
                               .receiver_count = grid.count};
    assert_int_equal(pp_factors_by_hand(&report, NULL), PP_OK);
    struct pp_reading *points = report.columns[report.column_count - 1].points;
    for (int i = 0; i < report.column_count; i++)
        if (strcmp(report.columns[i].name, "exact+split-flux") == 0)
            points = report.columns[i].points;
    qsort(points, (size_t)grid.count, sizeof *points, compare_falling_factors);
    double expected = points[(int)ceil(0.33 * grid.count) - 1].value;
    struct pp_finding_list findings =
        found_by_rules("bess-non-residential", "office", body);
    assert_near(findings.list[0].figure, expected, 1e-12);
    assert_near(findings.list[1].figure, points[grid.count - 1].value, 1e-12);
    assert_non_null(strstr(findings.list[0].what, "uniform sky"));
    pp_finding_list_clear(&findings);
    pp_report_clear(&report);
    pp_plane_grid_clear(&grid);
    pp_world_destroy(world);
}

/* Rows with one name have the same sky, plane, scheme and edition; each quantity is
 * known; texts fit; rules quoted from memory have no verdict. */
static void the_table_of_rules_is_consistent(void **state)
{
    (void)state;
    const struct pp_rule *rule, *last = NULL;
    struct pp_rule_set set;
    int judged = 0;
    for (int i = 0; (rule = pp_rule_table_at(i)) != NULL; i++) {
        char words[PP_RULE_WORDS], bound[PP_RULE_WORDS];
        pp_rule_table_words(words, rule);
        pp_rule_table_bound(bound, rule);
        assert_true(strlen(words) > 0 && strlen(words) < PP_RULE_WORDS - 1);
        if (last && strcmp(last->name, rule->name) == 0) {
            assert_string_equal(last->scheme, rule->scheme);
            assert_string_equal(last->edition, rule->edition);
            assert_true(!pp_rule_table_has(last->sky) || !pp_rule_table_has(rule->sky)
                        || strcmp(last->sky, rule->sky) == 0);
            assert_true(isnan(last->plane_m) || isnan(rule->plane_m)
                        || last->plane_m == rule->plane_m);
        }
        assert_true(pp_rule_table_has_use(rule, PP_USE_UNKNOWN));
        assert_true(strcmp(rule->quantity, "other") == 0 || bound[0]);
        if (strncmp(rule->certainty, "recalled", 8) == 0)
            assert_false(pp_rule_table_is_judged(rule));
        judged += pp_rule_table_is_judged(rule);
        /* The sDA of the simulated year is that of 300 lx. */
        if (strcmp(rule->quantity, "sda") == 0 && pp_rule_table_is_judged(rule))
            assert_near(rule->lux, 300.0, 0.0);
        assert_true(pp_rule_set_init(&set, rule->name));
        last = rule;
    }
    assert_true(judged > 50);
    assert_false(pp_rule_set_init(&set, "no-such-rule"));
    assert_true(pp_rule_set_init(&set, "bess-homes"));
    assert_string_equal(set.sky, "uniform");
    assert_true(pp_rule_set_init(&set, "at-oib-3"));
    assert_false(set.is_judged);
    assert_true(pp_rule_set_init(&set, "breeam-4b-office") && set.only_year);
    assert_true(pp_rule_set_init(&set, "dk-br18") && set.of_year && !set.only_year);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(norway_requires_a_mean_of_two_per_cent_or_enough_glass),
        cmocka_unit_test(glass_below_0_8_m_does_not_count_in_norway),
        cmocka_unit_test(one_alternative_is_enough),
        cmocka_unit_test(an_open_window_has_a_vertical_daylight_factor_of_49_6),
        cmocka_unit_test(reflected_light_alone_does_not_meet_a_vertical_factor),
        cmocka_unit_test(
            simulated_vertical_factors_have_the_light_of_their_surroundings),
        cmocka_unit_test(a_room_without_windows_does_not_meet_a_rule),
        cmocka_unit_test(shades_of_windows_are_no_obstructions_in_norway),
        cmocka_unit_test(enough_sun_alone_does_not_meet_the_slovak_rule),
        cmocka_unit_test(a_kitchen_has_one_required_mean_and_a_bedroom_none),
        cmocka_unit_test(grazing_sun_can_be_left_out),
        cmocka_unit_test(without_breaks_the_longest_interval_counts),
        cmocka_unit_test(the_worst_day_of_a_period_decides),
        cmocka_unit_test(hours_with_an_illuminance_are_counted_by_mean_and_least),
        cmocka_unit_test(a_share_of_the_plane_is_that_of_its_brightest_points),
        cmocka_unit_test(the_table_of_rules_is_consistent),
    };
    add_tests(tests, NULL, NULL);
}
