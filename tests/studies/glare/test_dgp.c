/* test_dgp.c - daylight glare probability and position index compared with values
 * calculated independently. */
#include "tests/lib/near.h"

#include "model/results/sheets/glare_sheet.h"
#include "studies/glare/dgp.h"

/* A horizontal view with this bearing, in axes with y to the north. */
static struct pp_frame view_to(double bearing_deg)
{
    struct pp_vec3 z = pp_vec_at_bearing(bearing_deg * PP_RAD, 0.0);
    return (struct pp_frame){pp_vec_cross(z, pp_vec(0.0, 0.0, 1.0)),
                             pp_vec(0.0, 0.0, 1.0), z};
}

static double index_of(double view_deg, double bearing_deg, double altitude_deg)
{
    struct pp_frame view = view_to(view_deg);
    return pp_dgp_position_index(
        &view, pp_vec_at_bearing(bearing_deg * PP_RAD, altitude_deg * PP_RAD));
}

/* Position indices of suns in pictures, calculated by evalglare 3.06 of Radiance, whose
 * upper limit is 16. */
static void index_above_the_line_of_sight_is_guths(void **state)
{
    (void)state;
    assert_near(index_of(200.0, 180.0, 30.0), 3.4439, 1e-4);
    assert_near(index_of(200.0, 135.0, 20.0), 7.5760, 1e-4);
    assert_near(index_of(120.0, 195.0, 40.0), 16.0, 0.0);
    assert_near(index_of(77.0, 77.0, 0.0), 1.0, 1e-9);
    assert_near(index_of(0.0, 180.0, 10.0), 16.0, 0.0);
}

/* s 30, t 0: tan B = 0.57735 x 1.15, B = 33.583, exp(0.21795 + 0.23684). */
static void index_below_the_line_of_sight_is_iwatas(void **state)
{
    (void)state;
    assert_near(index_of(0.0, 0.0, -30.0), 1.5758, 1e-4);
    assert_true(index_of(0.0, 0.0, -30.0) < index_of(0.0, 0.0, 30.0));
}

/* Ev, sum and DGP of given views, calculated independently. */
static void dgp_of_given_views(void **state)
{
    (void)state;
    static const double given[][3] = {{7028.24, 3.64419e7, 0.6206},
                                      {4481.44, 1.01909e7, 0.4598},
                                      {1315.84, 1.50573e6, 0.2838},
                                      {642.174, 0.0, 0.1977},
                                      {989.459, 640639.0, 0.2562}};
    for (int i = 0; i < 5; i++)
        assert_near(pp_dgp(given[i][0], given[i][1]), given[i][2], 6e-5);
}

static void dgp_is_a_share_of_people(void **state)
{
    (void)state;
    assert_near(pp_dgp(65425.7, 1e13), 1.0, 0.0);
    assert_near(pp_dgp(0.0, 1e6), 0.0, 0.0);
    assert_true(pp_dgp(1.0, 0.0) < 0.005);
}

/* 5 % of 3650 hours are 182.5. */
static void levels_allow_5_per_cent_of_the_hours(void **state)
{
    (void)state;
    struct pp_glare_year year = {.above_h = {{182.5, 0.0}, {90.0, 0.0}, {3.0, 0.0}}};
    assert_string_equal(pp_glare_sheet_level(&year, 3650.0), "high");
    year.above_h[0].value = 182.6;
    assert_string_equal(pp_glare_sheet_level(&year, 3650.0), "medium");
    year.above_h[1].value = 190.0;
    assert_string_equal(pp_glare_sheet_level(&year, 3650.0), "minimum");
    year.above_h[2].value = 183.0;
    assert_string_equal(pp_glare_sheet_level(&year, 3650.0), "none");
    assert_string_equal(pp_glare_sheet_class(0.3499), "imperceptible");
    assert_string_equal(pp_glare_sheet_class(0.35), "perceptible");
    assert_string_equal(pp_glare_sheet_class(0.45), "intolerable");
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(index_above_the_line_of_sight_is_guths),
        cmocka_unit_test(index_below_the_line_of_sight_is_iwatas),
        cmocka_unit_test(dgp_of_given_views),
        cmocka_unit_test(dgp_is_a_share_of_people),
        cmocka_unit_test(levels_allow_5_per_cent_of_the_hours),
    };
    add_tests(tests, NULL, NULL);
}
