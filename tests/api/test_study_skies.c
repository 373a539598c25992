/* test_study_skies.c - a study whose sky changes keeps the scene of its room. */
#include "tests/lib/counted_builds.h"
#include "tests/lib/near.h"

#include "pepperpot.h"

static const char room[] =
    "<room version='1'><site latitude='51.5'/><sky type='uniform'/>"
    "<plan width='3.1' depth='5.3' height='2.6'/>"
    "<window wall='south' left='0.4' sill='0.7' width='2.2' height='1.5'/>"
    "<skyline wall='south' angle='12' distance='17'/>"
    "<point x='1.4' y='1.7'/><point x='1.1' y='4.2'/></room>";

static const char *const skies[] = {"overcast", "iso-12,40,180", "iso-1",
                                    "iso-7,10,300", NULL};
enum { SKIES = 5 };

struct opened {
    struct pp_mistakes *mistakes;
    struct pp_building *building;
    struct pp_study *study;
};

static struct opened open_under(const char *sky)
{
    struct opened opened = {.mistakes = pp_mistakes_create("test.xml")};
    struct pp_error err = {0};
    if (pp_building_parse(&opened.building, room, strlen(room), opened.mistakes, &err)
            != PP_OK
        || pp_study_create(&opened.study, opened.building, 0, sky, opened.mistakes,
                           &err)
               != PP_OK)
        fail_msg("%s", err.message);
    return opened;
}

static void close_room(struct opened *opened)
{
    pp_study_destroy(opened->study);
    pp_building_destroy(opened->building);
    pp_mistakes_destroy(opened->mistakes);
}

/* Calculates all hand methods and a simulation; engine NULL: the default. */
static void work_out(struct pp_study *study, const char *engine)
{
    const struct pp_simulation_request request = {
        .engine = engine, .samples = 8, .seed = 7, .threads = 1};
    struct pp_error err = {0};
    if (pp_study_methods(study, "exact+split-flux", false, &err) != PP_OK
        || pp_study_simulate(study, &request, &err) != PP_OK)
        fail_msg("%s", err.message);
    while (!pp_study_done(study))
        assert_int_equal(pp_study_advance(study, 10.0, &err), PP_OK);
}

static void assert_same_figures(const struct pp_study *a, const struct pp_study *b)
{
    assert_int_equal(pp_study_column_count(a), pp_study_column_count(b));
    assert_true(pp_study_column_count(a) > 4);
    for (int c = 0; c < pp_study_column_count(a); c++)
        for (int i = -1; i < 2; i++) {
            struct pp_reading one = pp_study_reading(a, c, i);
            struct pp_reading other = pp_study_reading(b, c, i);
            assert_true(one.value == other.value
                        || (isnan(one.value) && isnan(other.value)));
            assert_true(one.std_error == other.std_error
                        || (isnan(one.std_error) && isnan(other.std_error)));
        }
}

/* Builds the scene once for five skies; the figures are identical to those of a study
 * created under each sky. */
static void skies_share_a_scene(void **state)
{
    (void)state;
    struct opened opened = open_under(NULL);
    struct pp_error err = {0};
    builds = 0;
    double last = 0.0;
    for (int i = 0; i < SKIES; i++) {
        int before = builds;
        assert_int_equal(pp_study_set_sky(opened.study, skies[i], &err), PP_OK);
        assert_int_equal(pp_study_column_count(opened.study), 0);
        work_out(opened.study, NULL);
        assert_int_equal(builds, i ? before : before + 1);
        struct opened own = open_under(skies[i]);
        work_out(own.study, NULL);
        assert_int_equal(builds, before + (i ? 1 : 2));
        assert_same_figures(opened.study, own.study);
        close_room(&own);
        int column = pp_study_find(opened.study, PP_DF, "traced");
        double now = pp_study_reading(opened.study, column, 0).value;
        assert_true(now != last);
        last = now;
    }
    close_room(&opened);
}

/* Other points and another engine need no other scene. */
static void points_and_engines_share_a_scene(void **state)
{
    (void)state;
    const double points[2][3] = {{1.2, 2.0, NAN}, {0.9, 3.0, NAN}};
    struct opened opened = open_under(NULL), own = open_under("iso-3");
    struct pp_error err = {0};
    builds = 0;
    work_out(opened.study, NULL);
    assert_int_equal(pp_study_set_points(opened.study, points, 2, &err), PP_OK);
    work_out(opened.study, "path");
    assert_int_equal(pp_study_set_sky(opened.study, "iso-3", &err), PP_OK);
    work_out(opened.study, "cache");
    assert_int_equal(builds, 1);
    assert_int_equal(pp_study_set_points(own.study, points, 2, &err), PP_OK);
    work_out(own.study, "cache");
    assert_same_figures(opened.study, own.study);
    close_room(&own);
    close_room(&opened);
}

static void a_sky_that_is_not_one_leaves_all_as_it_was(void **state)
{
    (void)state;
    struct opened opened = open_under(NULL), own = open_under(NULL);
    struct pp_error err = {0};
    work_out(opened.study, NULL);
    work_out(own.study, NULL);
    assert_int_equal(pp_study_set_sky(opened.study, "iso-16", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "iso-16"));
    assert_int_equal(pp_study_set_sky(opened.study, "iso-12", &err), PP_BAD_INPUT);
    assert_same_figures(opened.study, own.study);
    close_room(&own);
    close_room(&opened);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(skies_share_a_scene),
        cmocka_unit_test(points_and_engines_share_a_scene),
        cmocka_unit_test(a_sky_that_is_not_one_leaves_all_as_it_was),
    };
    add_tests(tests, NULL, NULL);
}
