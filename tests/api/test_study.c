/* test_study.c - the public interface as a program uses it: with pepperpot.h only. */
#include "tests/lib/near.h"

#include <stdio.h>
#include <stdlib.h>

#include "pepperpot.h"

#define PI 3.14159265358979323846

/* The window is unglazed, so that its sky component is an integral over its area. */
#define OPENING                                                                        \
    "<window wall='south' left='0.2' sill='0.9' width='2.6' height='1.4'"              \
    " glazing='none'/>"
#define ROOM(inside)                                                                   \
    "<room version='1' name='Test room'><site latitude='51.5'/>"                       \
    "<plan width='3.0' depth='9.0' height='2.7'/>" inside "</room>"
#define POINT "<point x='1.1' y='2.0' z='0.8'/>"

/* A study of one room, and the objects it depends on. */
struct opened {
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

static enum pp_status open_text(struct opened *opened, const char *text,
                                struct pp_error *err)
{
    *opened = (struct opened){.mistakes = pp_mistakes_create("test.xml")};
    assert_non_null(opened->mistakes);
    enum pp_status status =
        pp_building_parse(&opened->building, text, strlen(text), opened->mistakes, err);
    return status == PP_OK ? pp_study_create(&opened->study, opened->building, 0, NULL,
                                             opened->mistakes, err)
                           : status;
}

static struct opened open_room(const char *text)
{
    struct opened opened;
    struct pp_error err = {0};
    if (open_text(&opened, text, &err) != PP_OK)
        fail_msg("%s", err.message);
    return opened;
}

static void close_room(struct opened *opened)
{
    pp_study_destroy(opened->study);
    pp_building_destroy(opened->building);
    pp_mistakes_destroy(opened->mistakes);
}

static void simulate(struct pp_study *study, long samples, int threads)
{
    const struct pp_simulation_request request = {
        .samples = samples, .seed = 7, .threads = threads};
    struct pp_error err = {0};
    if (pp_study_simulate(study, &request, &err) != PP_OK)
        fail_msg("%s", err.message);
    while (!pp_study_done(study))
        if (pp_study_advance(study, 10.0, &err) != PP_OK)
            fail_msg("%s", err.message);
}

static struct pp_reading reading_of(const struct pp_study *study,
                                    enum pp_component component, const char *name,
                                    int point)
{
    int column = pp_study_find(study, component, name);
    assert_true(column >= 0);
    return pp_study_reading(study, column, point);
}

/* Sky component of the opening at (1.1, 2.0, 0.8), by the midpoint rule:
 *
 *    SC = 9/(7 pi) sum of (1 + 2 s)/3 s d/r^3 dA
 *
 *  r  distance of the centre of the cell
 *  s  sine of its altitude
 *  d  distance from the window's plane
 */
static double sky_component_by_quadrature(void)
{
    enum { CELLS = 1000 };
    double sum = 0.0, d = 2.0, area = 2.6 / CELLS * 1.4 / CELLS;
    for (int i = 0; i < CELLS; i++)
        for (int k = 0; k < CELLS; k++) {
            double x = 0.2 + 2.6 * (i + 0.5) / CELLS - 1.1;
            double z = 0.9 + 1.4 * (k + 0.5) / CELLS - 0.8;
            double r = sqrt(x * x + d * d + z * z), s = z / r;
            sum += (1.0 + 2.0 * s) / 3.0 * s * d / (r * r * r) * area;
        }
    return 9.0 / (7.0 * PI) * sum;
}

static void a_hand_figure_is_the_integral_over_the_window(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_error err = {0};
    double xyz[3];
    assert_string_equal(pp_study_name(opened.study), "Test room");
    assert_int_equal(pp_study_point_count(opened.study), 1);
    pp_study_point(opened.study, 0, xyz);
    assert_near(xyz[1], 2.0, 0.0);
    assert_int_equal(pp_study_methods(opened.study, "exact+bre", false, &err), PP_OK);
    assert_true(pp_study_column_count(opened.study) > 0);
    assert_relative(reading_of(opened.study, PP_SC, "exact", 0).value,
                    sky_component_by_quadrature(), 1e-6);

    /* A daylight factor is the sum of its components; here the externally reflected
     * component is zero. */
    struct pp_reading sum = reading_of(opened.study, PP_DF, "exact+bre", 0);
    double parts = reading_of(opened.study, PP_SC, "exact", 0).value
                   + reading_of(opened.study, PP_IRC, "bre", 0).value;
    assert_relative(sum.value, parts, 1e-12);
    close_room(&opened);
}

/* The BRE formula is proportional to its transmittance of 0.85. */
static void a_variant_of_a_formula_has_a_column_beside_the_original(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_error err = {0};
    assert_int_equal(pp_study_formula(opened.study,
                                      "irc = 0.17 W / (A (1 - R)) (C R_fw + 5 R_cw)",
                                      &err),
                     PP_OK);
    assert_int_equal(pp_study_formula(opened.study, "irc = 0.85 W / A", &err), PP_OK);
    assert_int_equal(pp_study_methods(opened.study, "exact+bre", false, &err), PP_OK);
    double published = reading_of(opened.study, PP_IRC, "bre", 0).value;
    assert_true(published > 0.0);
    assert_relative(reading_of(opened.study, PP_IRC, "bre-variant", 0).value,
                    0.2 * published, 1e-12);
    assert_true(pp_study_find(opened.study, PP_DF, "exact+bre-variant-2") >= 0);
    close_room(&opened);
}

static void the_traced_sky_component_agrees_with_the_exact_one(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_error err = {0};
    assert_int_equal(pp_study_methods(opened.study, "exact", false, &err), PP_OK);
    simulate(opened.study, 512, 2);
    struct pp_reading exact = reading_of(opened.study, PP_SC, "exact", 0);
    struct pp_reading traced = reading_of(opened.study, PP_SC, "traced", 0);
    assert_true(traced.std_error > 0.0 && traced.std_error < 0.05 * traced.value);
    assert_near(traced.value, exact.value, 4.0 * traced.std_error);
    assert_near(pp_study_progress(opened.study), 1.0, 1e-12);
    assert_true(pp_study_error(opened.study) > 0.0);
    close_room(&opened);
}

static void a_seed_gives_the_same_bits_on_any_number_of_threads(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    double values[3][2];
    for (int run = 0; run < 3; run++) {
        simulate(opened.study, 64, run == 0 ? 1 : 2);
        values[run][0] = reading_of(opened.study, PP_DF, "traced", 0).value;
        values[run][1] = reading_of(opened.study, PP_DF, "traced", -1).value;
    }
    assert_true(values[0][0] > 0.0 && values[0][1] > 0.0);
    assert_memory_equal(values[0], values[1], sizeof values[0]);
    assert_memory_equal(values[0], values[2], sizeof values[0]);
    close_room(&opened);
}

/* A second simulation, by photons, has its own column beside the first. */
static void photons_have_a_column_beside_traced_values(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_simulation_request request = pp_simulation_request_default();
    struct pp_error err = {0};
    simulate(opened.study, 64, 1);
    request.engine = "photons";
    request.samples = 64;
    assert_int_equal(pp_study_simulate(opened.study, &request, &err), PP_OK);
    while (!pp_study_done(opened.study))
        assert_int_equal(pp_study_advance(opened.study, 10.0, &err), PP_OK);
    struct pp_reading photons = reading_of(opened.study, PP_DF, "photons", 0);
    struct pp_reading traced = reading_of(opened.study, PP_DF, "traced", 0);
    assert_near(photons.value, traced.value,
                4.0 * hypot(photons.std_error, traced.std_error));
    assert_true(photons.value != traced.value);
    close_room(&opened);
}

static void mistakes_have_lines(void **state)
{
    (void)state;
    struct opened opened;
    struct pp_error err = {0};
    assert_int_equal(open_text(&opened,
                               "<room version='1'>\n"
                               "<plan width='3' depth='4' height='2.7'/>\n"
                               "<window wall='south' left='0.2' sill='0.9' width='5'"
                               " height='1.4'/>\n"
                               "<window wall='north' left='0.2' sill='0.9' width='1'"
                               " height='3'/>\n"
                               "</room>\n",
                               &err),
                     PP_BAD_INPUT);
    assert_null(opened.study);
    assert_int_equal(pp_mistakes_count(opened.mistakes), 2);
    assert_int_equal(pp_mistakes_line(opened.mistakes, 0), 3);
    assert_int_equal(pp_mistakes_line(opened.mistakes, 1), 4);
    assert_non_null(strstr(pp_mistakes_text(opened.mistakes, 0), "south"));
    close_room(&opened);
}

static void an_unreadable_file_is_an_error(void **state)
{
    (void)state;
    struct opened opened = {.mistakes = pp_mistakes_create("none.xml")};
    struct pp_error err = {0};
    assert_int_not_equal(
        pp_building_read(&opened.building, "/nowhere/none.xml", opened.mistakes, &err),
        PP_OK);
    assert_null(opened.building);
    assert_true(err.message[0] != '\0');
    close_room(&opened);
}

static void check_refused(enum pp_status status, const struct pp_error *err,
                          const char *words)
{
    assert_int_equal(status, PP_BAD_INPUT);
    if (!strstr(err->message, words))
        fail_msg("\"%s\" does not say \"%s\"", err->message, words);
}

static void what_makes_no_sense_is_refused(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_study *study = opened.study, *other;
    struct pp_error err = {0};
    struct pp_size_found found;
    char *bytes;
    size_t length;

    check_refused(
        pp_study_create(&other, opened.building, 1, NULL, opened.mistakes, &err), &err,
        "no room 1");
    check_refused(pp_study_methods(study, "exakt", false, &err), &err, "exakt");
    check_refused(pp_study_formula(study, "irc = 0.85 W / (A", &err), &err,
                  "column 18");
    check_refused(pp_study_simulate(
                      study, &(struct pp_simulation_request){.engine = "pth"}, &err),
                  &err, "pth");
    check_refused(
        pp_study_simulate(study, &(struct pp_simulation_request){.samples = -1}, &err),
        &err, "-1");
    check_refused(
        pp_study_simulate(study, &(struct pp_simulation_request){.error = -0.1}, &err),
        &err, "-0.1");
    check_refused(pp_study_advance(study, 1.0, &err), &err, "no simulation");
    check_refused(
        pp_study_set_points(study, (const double[][3]){{1.0, -2.0, 0.8}}, 1, &err),
        &err, "1,-2,0.8");
    check_refused(pp_study_set_points(study, NULL, 0, &err), &err, "0 points");
    check_refused(pp_study_chart(study, "paln", NULL, &bytes, &length, &err), &err,
                  "paln");
    check_refused(pp_study_chart(NULL, "plan", NULL, &bytes, &length, &err), &err,
                  "room");
    check_refused(pp_study_judge(study, "en17038", 0.0, &err), &err, "en17038");
    check_refused(pp_study_size(study, 0.0, PP_CHANGE_WIDTH, NULL, &found, NULL, &err),
                  &err, "target");

    /* The study is unchanged, and a missing reading is reported. */
    assert_int_equal(pp_study_point_count(study), 1);
    assert_int_equal(pp_study_find(study, PP_SC, "traced"), -1);
    struct pp_reading none = pp_study_reading(study, 99, 0);
    assert_true(isnan(none.value));
    assert_non_null(none.why);
    close_room(&opened);
}

static void a_report_begins_with_its_format(void **state)
{
    (void)state;
    static const struct {
        enum pp_format format;
        const char *begins;
    } expected[] = {
        {PP_FORMAT_JSON, "{\n  \"format\": \"pepperpot-df-1\""},
        {PP_FORMAT_CSV, "file,room,place,x,y,z,"},
        {PP_FORMAT_TEXT, "Test room"},
    };
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_error err = {0};
    assert_int_equal(pp_study_methods(opened.study, NULL, false, &err), PP_OK);
    for (int i = 0; i < 3; i++) {
        char *bytes;
        size_t length;
        assert_int_equal(
            pp_study_report(opened.study, expected[i].format, &bytes, &length, &err),
            PP_OK);
        assert_int_equal(strlen(bytes), length);
        if (strncmp(bytes, expected[i].begins, strlen(expected[i].begins)) != 0)
            fail_msg("begins \"%.60s\"", bytes);
        pp_free(bytes);
    }
    close_room(&opened);
}

static void check_signature(const struct pp_study *study, const char *kind,
                            enum pp_chart_format format, const char *signature)
{
    const struct pp_chart_request request = {.format = format, .dpi = 30};
    struct pp_error err = {0};
    char *bytes;
    size_t length;
    if (pp_study_chart(study, kind, &request, &bytes, &length, &err) != PP_OK)
        fail_msg("%s: %s", kind, err.message);
    assert_true(length > strlen(signature));
    assert_memory_equal(bytes, signature, strlen(signature));
    pp_free(bytes);
}

static void charts_are_files_of_their_format(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    check_signature(opened.study, "plan", PP_CHART_PNG, "\x89PNG\r\n\x1a\n");
    check_signature(opened.study, "section", PP_CHART_SVG, "<?xml");
    check_signature(NULL, "waldram", PP_CHART_PDF, "%PDF-");
    assert_int_equal(pp_study_point_count(opened.study), 1);
    close_room(&opened);
}

/* Number of findings of the study that depend on sampled figures. */
static int judge_and_count_sampled(struct pp_study *study)
{
    struct pp_error err = {0};
    int sampled = 0;
    if (pp_study_judge(study, "en17037", 14900.0, &err) != PP_OK)
        fail_msg("%s", err.message);
    assert_true(pp_study_judgement_count(study) > 0);
    for (int i = 0; i < pp_study_judgement_count(study); i++) {
        struct pp_judgement judgement = pp_study_judgement(study, i);
        assert_string_equal(judgement.criterion, "en17037");
        assert_true(judgement.what[0] != '\0');
        if (isfinite(judgement.figure) && isfinite(judgement.wanted)
            && judgement.verdict == PP_MET)
            assert_true(judgement.at_most ? judgement.figure <= judgement.wanted
                                          : judgement.figure >= judgement.wanted);
        sampled += isfinite(judgement.std_error);
    }
    return sampled;
}

static void judgements_rest_on_the_simulated_grid_where_it_is_there(void **state)
{
    (void)state;
    struct opened opened = open_room(ROOM(OPENING POINT));
    struct pp_error err = {0};
    assert_int_equal(judge_and_count_sampled(opened.study), 0);
    assert_int_equal(pp_study_set_grid(opened.study, &err), PP_OK);
    assert_true(pp_study_point_count(opened.study) > 10);
    assert_int_equal(pp_study_judgement_count(opened.study), 0);
    simulate(opened.study, 64, 2);
    assert_true(judge_and_count_sampled(opened.study) > 0);
    close_room(&opened);
}

static void the_room_file_with_the_window_found_reaches_the_target(void **state)
{
    (void)state;
    const double target = 0.01;
    struct opened opened = open_room(ROOM(OPENING POINT)), changed;
    struct pp_error err = {0};
    struct pp_size_found found;
    char *file;
    if (pp_study_size(opened.study, target, PP_CHANGE_WIDTH, "average-df", &found,
                      &file, &err)
        != PP_OK)
        fail_msg("%s", err.message);
    assert_int_equal(found.verdict, PP_SIZE_REACHED);
    assert_string_equal(found.method, "average-df");
    assert_true(found.value >= target && found.value < 1.02 * target);
    assert_non_null(file);

    changed = open_room(file);
    assert_int_equal(pp_study_methods(changed.study, "average-df", false, &err), PP_OK);
    assert_relative(reading_of(changed.study, PP_DF, "average-df", -1).value,
                    found.value, 1e-12);
    close_room(&changed);
    pp_free(file);
    close_room(&opened);
}

static void lists_name_the_available_items(void **state)
{
    (void)state;
    static const struct {
        enum pp_list list;
        const char *name;
    } known[] = {{PP_LIST_METHODS, "exact"},
                 {PP_LIST_ENGINES, "path"},
                 {PP_LIST_CHARTS, "waldram"},
                 {PP_LIST_CRITERIA, "en17037"}};
    for (int i = 0; i < 4; i++) {
        bool there = false;
        const char *name;
        for (int k = 0; (name = pp_list_name(known[i].list, k)) != NULL; k++) {
            there = there || strcmp(name, known[i].name) == 0;
            assert_non_null(pp_list_summary(known[i].list, k));
        }
        assert_true(there);
    }
    assert_null(pp_list_name(PP_LIST_METHODS, -1));
    assert_int_equal(pp_version(), PP_VERSION_NUMBER);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hand_figure_is_the_integral_over_the_window),
        cmocka_unit_test(a_variant_of_a_formula_has_a_column_beside_the_original),
        cmocka_unit_test(the_traced_sky_component_agrees_with_the_exact_one),
        cmocka_unit_test(a_seed_gives_the_same_bits_on_any_number_of_threads),
        cmocka_unit_test(photons_have_a_column_beside_traced_values),
        cmocka_unit_test(mistakes_have_lines),
        cmocka_unit_test(an_unreadable_file_is_an_error),
        cmocka_unit_test(what_makes_no_sense_is_refused),
        cmocka_unit_test(a_report_begins_with_its_format),
        cmocka_unit_test(charts_are_files_of_their_format),
        cmocka_unit_test(judgements_rest_on_the_simulated_grid_where_it_is_there),
        cmocka_unit_test(the_room_file_with_the_window_found_reaches_the_target),
        cmocka_unit_test(lists_name_the_available_items),
    };
    add_tests(tests, NULL, NULL);
}
