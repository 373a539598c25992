/* test_protractor_scale.c - the scales of the ten protractors, and of other
 * protractors. */
#include "methods/protractor/protractor_scale.h"

#include "tests/lib/near.h"

static struct pp_protractor published(int number)
{
    struct pp_protractor protractor;
    assert_int_equal(pp_protractor_scale_published(&protractor, number, NULL), PP_OK);
    assert_int_equal(pp_protractor_scale_number(&protractor), number);
    return protractor;
}

/* Per cent at 10 to 90 degrees, three printed decimals of an independent integration
 * for glass with the same normal transmittance of 0.900. */
static void primary_scales_of_vertical_windows(void **state)
{
    (void)state;
    static const double no10[] = {.390,   1.796,  4.519,  8.755, 14.571,
                                  21.886, 30.476, 39.994, 50.0};
    static const double no2[] = {.344,   1.585,  3.978,  7.662, 12.600,
                                 18.495, 24.634, 29.656, 31.628};
    static const double no9[] = {.760,   3.015,  6.699,  11.698, 17.861,
                                 25.000, 32.899, 41.318, 50.0};
    static const double no1[] = {.670,   2.655,  5.878,  10.196, 15.383,
                                 21.070, 26.628, 30.982, 32.652};
    const double *printed[] = {no1, no2, no9, no10};
    const int number[] = {1, 2, 9, 10};
    for (int p = 0; p < 4; p++) {
        struct pp_protractor protractor = published(number[p]);
        for (int i = 0; i < 9; i++)
            assert_near(
                100.0
                    * pp_protractor_scale_primary(&protractor, (i + 1) * 10.0 * PP_RAD),
                printed[p][i], 6e-4);
    }
}

/* Light on a horizontal receiver through an infinite pane overhead, or at any slope,
 * does not depend on the direction of the section. Quadrature in altitude and azimuth
 * instead of along strips. */
static double all_through_glass(const struct pp_protractor *protractor)
{
    enum { STEPS = 700 };
    double sum = 0.0;
    struct pp_vec3 glass =
        pp_vec(sin(protractor->slope_rad), 0.0, cos(protractor->slope_rad));
    for (int i = 0; i < STEPS; i++) {
        double z = sqrt((i + 0.5) / STEPS), r = sqrt(1.0 - z * z);
        for (int j = 0; j < STEPS; j++) {
            double azimuth = 2.0 * PP_PI * (j + 0.5) / STEPS;
            struct pp_vec3 u = pp_vec(r * cos(azimuth), r * sin(azimuth), z);
            double cos_i = pp_vec_dot(glass, u);
            if (cos_i > 0.0)
                sum += pp_sky_luminance(&protractor->sky, u)
                       * pp_glass_transmittance(&protractor->glass, cos_i);
        }
    }
    return sum * PP_PI / ((double)STEPS * STEPS);
}

static void whole_scale_is_all_that_glass_of_that_slope_lets_through(void **state)
{
    (void)state;
    for (int number = 1; number <= 10; number++) {
        struct pp_protractor protractor = published(number);
        double whole = pp_protractor_scale_primary(&protractor, PP_PI);
        double expected = number <= 8 ? all_through_glass(&protractor) : 1.0;
        assert_near(whole, expected, 2e-5);
    }
}

/* CF at azimuths 10 to 80 degrees, three printed digits. */
static void auxiliary_scale_of_protractor_10(void **state)
{
    (void)state;
    static const struct {
        double gamma;
        double cf[8];
    } row[] = {{0, {.110, .213, .304, .379, .435, .471, .491, .499}},
               {30, {.103, .202, .292, .369, .429, .469, .491, .499}},
               {45, {.086, .171, .254, .332, .400, .453, .485, .498}},
               {60, {.062, .125, .191, .261, .334, .406, .465, .495}},
               {75, {.032, .066, .104, .148, .203, .276, .371, .471}}};
    struct pp_protractor protractor = published(10);
    for (int r = 0; r < 5; r++)
        for (int i = 0; i < 8; i++) {
            double gamma = row[r].gamma * PP_RAD;
            double theta = pp_protractor_scale_theta(
                cos(gamma), pp_angle_of((i + 1) * 10.0 * PP_RAD));
            assert_near(pp_protractor_scale_auxiliary(&protractor, gamma, theta),
                        row[r].cf[i], 5.1e-4);
            assert_near(pp_protractor_scale_auxiliary(&protractor, gamma, -theta),
                        -row[r].cf[i], 5.1e-4);
        }
    double gamma = 30.0 * PP_RAD;
    assert_near(pp_protractor_scale_auxiliary(
                    &protractor, gamma,
                    pp_protractor_scale_theta(cos(gamma), pp_angle_of(40.0 * PP_RAD))),
                0.3692, 5e-5);
}

static void an_endless_window_has_half_its_light_on_each_side(void **state)
{
    (void)state;
    for (int number = 1; number <= 10; number++) {
        struct pp_protractor protractor = published(number);
        for (double gamma = 0.0; gamma < 1.5; gamma += 0.37)
            assert_near(
                pp_protractor_scale_auxiliary(
                    &protractor, gamma,
                    pp_protractor_scale_theta(cos(gamma), pp_angle_of(PP_PI / 2.0))),
                0.5, 1e-9);
    }
}

/* Two ways to calculate the unglazed scales: the closed form, and the quadrature for
 * glass, with glass that transmits all light. ISO type 5 is the uniform sky. */
static void quadrature_agrees_with_the_closed_form(void **state)
{
    (void)state;
    struct pp_protractor closed = published(9), summed = closed;
    assert_int_equal(pp_sky_iso(&summed.sky, 5, pp_vec(0, 0, 1), NULL), PP_OK);
    for (double gamma = 0.11; gamma < 3.1; gamma += 0.29) {
        assert_relative(pp_protractor_scale_primary(&summed, gamma),
                        pp_protractor_scale_primary(&closed, gamma), 1e-9);
        assert_relative(pp_protractor_scale_auxiliary(&summed, gamma, 0.7),
                        pp_protractor_scale_auxiliary(&closed, gamma, 0.7), 1e-9);
    }
}

static void a_reading_leads_back_to_its_angle(void **state)
{
    (void)state;
    for (int number = 1; number <= 10; number++) {
        struct pp_protractor protractor = published(number);
        for (double gamma = 0.2; gamma < 1.4; gamma += 0.43) {
            double share = pp_protractor_scale_primary(&protractor, gamma);
            assert_near(pp_protractor_scale_angle(&protractor, share, 0.0, PP_PI / 2.0),
                        gamma, 1e-8);
        }
    }
}

static void there_are_ten_and_no_more(void **state)
{
    (void)state;
    struct pp_protractor protractor;
    struct pp_error err;
    assert_int_equal(pp_protractor_scale_published(&protractor, 11, &err),
                     PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "1 to 10"));
    assert_int_equal(pp_protractor_scale_published(&protractor, 0, &err), PP_BAD_INPUT);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(primary_scales_of_vertical_windows),
        cmocka_unit_test(whole_scale_is_all_that_glass_of_that_slope_lets_through),
        cmocka_unit_test(auxiliary_scale_of_protractor_10),
        cmocka_unit_test(an_endless_window_has_half_its_light_on_each_side),
        cmocka_unit_test(quadrature_agrees_with_the_closed_form),
        cmocka_unit_test(a_reading_leads_back_to_its_angle),
        cmocka_unit_test(there_are_ten_and_no_more),
    };
    add_tests(tests, NULL, NULL);
}
