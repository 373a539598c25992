/* test_split_flux.c - the split-flux formula, for clear and diffusing glass. */
#include "methods/reflected/interior.h"
#include "methods/method.h"

#include "tests/methods/box_method.h"

static double split_flux_of(struct box_room *box, int index)
{
    return box_method_value(&pp_method_split_flux, box, index);
}

static void worked_room_has_1_2962_per_cent(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 0.2, 0.9, 3.6, 1.5)->glass = box_method_printed_glass();
    box.light.ground_reflectance = 0.1;
    assert_near(100.0 * split_flux_of(&box, 0), 1.2962, 5e-5); /* printed value */
}

static void clear_window_is_the_published_equation_9(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_clear_single());
    double published =
        s.tau * s.Ag / (1 - s.rho_u * s.rho_l)
        * (s.rho_u * s.rho_g / (2 * s.A_u) + s.rho_u * s.rho_l * s.C / s.A_l);
    assert_relative(split_flux_of(&box, 0), published, 1e-12);
}

static void diffusing_window_is_the_published_equation_12(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_diffusing(0.52));
    double published = s.tau * s.Ag / (1 - s.rho_u * s.rho_l) * 0.5
                       * (s.rho_g / 2 + s.C)
                       * (s.rho_u / s.A_u + s.rho_u * s.rho_l / s.A_l);
    assert_relative(split_flux_of(&box, 0), published, 1e-12);
}

/* Room 4 x 6 x 3 m, reflectances 0.2, 0.5, 0.7; a diffusing pane of 0.6, 3.0 x 1.6 m,
 * from 0.9 m up, middle at 1.7 m; a skyline of 20 degrees (C = 31 %), ground 0.3.
 * Calculated by hand:
 *
 *    A_u = 24 + 20 * 1.3 - 2.4 = 47.6   rho_u = (24 * 0.7 + 23.6 * 0.5) / 47.6 = 0.60084
 *    A_l = 24 + 20 * 1.7 - 2.4 = 55.6   rho_l = (24 * 0.2 + 31.6 * 0.5) / 55.6 = 0.37050
 *    IRC = 0.6 * 4.8 / (1 - 0.22261) * (15 + 31) / 2
 *          * (0.60084 / 47.6 + 0.22261 / 55.6) = 1.41672 %
 */
static void a_stated_diffuse_transmittance_enters_as_it_is(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    struct pp_opening *window = box_room_south(&box, 0.5, 0.9, 3.0, 1.6);
    window->glass = pp_glass_diffusing(0.6);
    box.light.ground_reflectance = 0.3;
    box_room_skyline(&box, 20.0 * PP_RAD, 1.7, INFINITY);
    assert_near(100.0 * split_flux_of(&box, 0), 1.41672, 5e-6);
}

/* In an integrating sphere of the same area and reflectance IRC = tau Ag rho C / (A (1
 * - rho)). If all light falls on the lower of two equal halves, split-flux gives 2
 * rho/(1 + rho) of that value, since only light reflected from above counts. */
static void one_colour_and_equal_halves_give_2rho_over_1_plus_rho_of_a_sphere(
    void **state)
{
    (void)state;
    for (double rho = 0.1; rho < 0.95; rho += 0.21) {
        struct box_room box;
        box_room_build(&box, 3.3, 4.9, 2.6, rho, rho, rho);
        box_room_south(&box, 0.7, 0.8, 1.7, 1.0)->glass = /* its middle is the room's */
            box_method_printed_glass();
        box.light.ground_reflectance = 0.0;
        struct pp_interior_parts parts = pp_interior_split(&box.world, 1.3);
        double A = parts.lower.area_m2 + parts.upper.area_m2;
        double sphere = 0.85 * 1.7 * rho * 0.39 / (A * (1 - rho));
        assert_relative(split_flux_of(&box, 0), 2 * rho / (1 + rho) * sphere, 1e-12);
    }
}

/* An unglazed rooflight above a black floor and black walls: light falls down and none
 * is reflected. With reflecting surfaces the result is eq. 9 with C = 1. */
static void rooflight_lights_the_floor_with_the_whole_sky(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.0, 0.0, 0.8);
    struct pp_opening *rooflight =
        box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7);
    rooflight->glass = pp_glass_none();
    assert_near(split_flux_of(&box, 0), 0.0, 0.0);

    box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.8);
    box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7)->glass =
        pp_glass_none();
    double A_l = 3.3 * 4.9 + 2 * 8.2 * 2.6;
    double published = 0.77 / (1 - 0.8 * 0.4) * 0.8 * 0.4 / A_l;
    assert_relative(split_flux_of(&box, 0), published, 1e-12);
    box.light.sky = pp_sky_uniform();
    assert_relative(split_flux_of(&box, 0), published, 1e-12);
}

/* The exact ratio for a vertical plane, times 1 - alpha/90. */
static void other_skies_use_their_own_ratio(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s = box_method_awkward_room(&box, pp_glass_none());
    box.light.sky = pp_sky_uniform();
    s.C = 0.5 * (1 - 34.0 / 90.0);
    double published =
        s.Ag / (1 - s.rho_u * s.rho_l)
        * (s.rho_u * s.rho_g / (2 * s.A_u) + s.rho_u * s.rho_l * s.C / s.A_l);
    assert_relative(split_flux_of(&box, 0), published, 1e-12);

    struct pp_vec3 sun = pp_vec_unit(pp_vec(0.1, -0.8, 0.7));
    assert_int_equal(pp_sky_iso(&box.light.sky, 12, sun, NULL), PP_OK);
    s.C = pp_sky_on_plane(&box.light.sky, pp_vec(0, -1, 0)) * (1 - 34.0 / 90.0);
    published = s.Ag / (1 - s.rho_u * s.rho_l)
                * (s.rho_u * s.rho_g / (2 * s.A_u) + s.rho_u * s.rho_l * s.C / s.A_l);
    assert_relative(split_flux_of(&box, 0), published, 1e-12);
}

static void brighter_surfaces_and_ground_give_more(void **state)
{
    (void)state;
    double last = 0.0;
    for (int k = 1; k <= 9; k++) {
        struct box_room box;
        box_room_build(&box, 3.3, 4.9, 2.6, 0.1 * k, 0.1 * k, 0.1 * k);
        box_room_south(&box, 0.7, 0.8, 1.7, 1.0);
        double now = split_flux_of(&box, 0);
        box.light.ground_reflectance = 0.4;
        assert_true(split_flux_of(&box, 0) > now && now > last);
        last = now;
    }
}

static void a_room_that_keeps_all_its_light_is_refused(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 1.0, 1.0, 1.0);
    struct pp_opening *window = box_room_south(&box, 0.7, 0.8, 1.7, 1.0);
    assert_non_null(pp_method_split_flux.refuses(&box.world, &box.light, window, NULL));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_room_has_1_2962_per_cent),
        cmocka_unit_test(clear_window_is_the_published_equation_9),
        cmocka_unit_test(diffusing_window_is_the_published_equation_12),
        cmocka_unit_test(a_stated_diffuse_transmittance_enters_as_it_is),
        cmocka_unit_test(
            one_colour_and_equal_halves_give_2rho_over_1_plus_rho_of_a_sphere),
        cmocka_unit_test(rooflight_lights_the_floor_with_the_whole_sky),
        cmocka_unit_test(other_skies_use_their_own_ratio),
        cmocka_unit_test(brighter_surfaces_and_ground_give_more),
        cmocka_unit_test(a_room_that_keeps_all_its_light_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
