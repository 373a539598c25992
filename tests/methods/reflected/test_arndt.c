/* test_arndt.c - the formula of one mean reflectance. */
#include "methods/method.h"

#include "tests/methods/box_method.h"

/* Calculated by hand: the entering light, reflected by R once and then infinitely
 * often. */
static void window_is_the_sum_of_all_reflections_by_the_mean(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_clear_single());
    double enters = s.tau * s.Ag * (s.C + s.rho_g / 2);
    double sum = 0.0, flux = enters * s.R;
    for (int i = 0; i < 400; i++, flux *= s.R)
        sum += flux;
    assert_relative(box_method_value(&pp_method_arndt, &box, 0), sum / s.A, 1e-12);
}

/* If all surfaces have the same reflectance, it does not matter on which the light
 * falls first. The opening has another reflectance, but is too small to matter. */
static void room_of_one_colour_is_that_of_the_sphere(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.43, 0.43, 0.43);
    box_room_south(&box, 0.7, 1.3, 1e-3, 1e-3);
    assert_relative(box_method_value(&pp_method_arndt, &box, 0),
                    box_method_value(&pp_method_sphere, &box, 0), 1e-7);
}

/* Light first falls on the floor of 0.1, below a ceiling of 0.9, so the mean
 * reflectance of 0.5 is too high. */
static void dark_floor_is_overrated(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.1, 0.5, 0.9);
    box_room_south(&box, 0.7, 0.9, 1.9, 1.1);
    assert_true(box_method_value(&pp_method_arndt, &box, 0)
                > 1.2 * box_method_value(&pp_method_sphere, &box, 0));
}

static void diffusing_pane_is_as_clear_glass_of_its_transmittance(void **state)
{
    (void)state;
    struct box_room box;
    box_method_awkward_room(&box, pp_glass_clear_single());
    double clear = box_method_value(&pp_method_arndt, &box, 0);
    double tau = box.openings[0].glass.diffuse;
    box.openings[0].glass = pp_glass_diffusing(0.52);
    assert_relative(box_method_value(&pp_method_arndt, &box, 0), clear * 0.52 / tau,
                    1e-12);
}

/* Horizontal glass receives light from the whole sky and none from the ground. */
static void rooflight_lets_the_whole_sky_in(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.4);
    box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7)->glass =
        pp_glass_none();
    double A = 2 * 3.3 * 4.9 + 2 * 8.2 * 2.6, R = 0.4 - 0.3 * 0.77 / A;
    assert_relative(box_method_value(&pp_method_arndt, &box, 0),
                    0.77 * R / (A * (1 - R)), 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(window_is_the_sum_of_all_reflections_by_the_mean),
        cmocka_unit_test(room_of_one_colour_is_that_of_the_sphere),
        cmocka_unit_test(dark_floor_is_overrated),
        cmocka_unit_test(diffusing_pane_is_as_clear_glass_of_its_transmittance),
        cmocka_unit_test(rooflight_lets_the_whole_sky_in),
    };
    add_tests(tests, NULL, NULL);
}
