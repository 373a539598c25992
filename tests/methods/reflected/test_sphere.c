/* test_sphere.c - the integrating-sphere formula, and its relation to `bre` and
 * `split-flux`. */
#include "methods/reflected/interior.h"
#include "methods/method.h"

#include "tests/methods/box_method.h"

static void clear_window_is_the_published_equation_15(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_clear_single());
    double published =
        s.tau * s.Ag / (s.A * (1 - s.R)) * (s.rho_u * s.rho_g / 2 + s.rho_l * s.C);
    assert_relative(box_method_value(&pp_method_sphere, &box, 0), published, 1e-12);
}

/* Half of the light of a diffusing pane goes up, half goes down. */
static void diffusing_window_lights_both_parts_alike(void **state)
{
    (void)state;
    struct box_room box;
    struct box_method_symbols s =
        box_method_awkward_room(&box, pp_glass_diffusing(0.52));
    double expected = s.tau * s.Ag / (s.A * (1 - s.R)) * (s.rho_g / 2 + s.C)
                      * (s.rho_u + s.rho_l) / 2;
    assert_relative(box_method_value(&pp_method_sphere, &box, 0), expected, 1e-12);
}

/* If all surfaces have one reflectance and the glass has the 0.85 of `bre`, the wall of
 * the window and the treatment of the ground (0.1/2 instead of 5 %) make no difference:
 * `sphere` equals `bre`. */
static void one_colour_and_ground_of_0_1_is_the_bre_formula(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.7, 5.3, 2.9, 0.44, 0.44, 0.44);
    box_room_south(&box, 0.4, 0.7, 1.9, 1.3)->glass = box_method_printed_glass();
    box_room_skyline(&box, 34.0 * PP_RAD, 1.35, INFINITY);
    box.light.ground_reflectance = 0.1;
    assert_relative(box_method_value(&pp_method_sphere, &box, 0),
                    box_method_value(&pp_method_bre, &box, 0), 1e-12);
}

/* Ratio of the two formulae, with A (1 - R) of `sphere` in one, and A_u + A_l with
 * their reflectance in the other. This excludes the opening, which counts with 0.1 only
 * in `sphere`. */
static double split_over_sphere(struct box_room *box, double rho)
{
    struct pp_interior all = pp_interior_all(&box->world);
    struct pp_interior_parts parts = pp_interior_split(&box->world, 1.3);
    double without = (parts.lower.area_m2 + parts.upper.area_m2) * (1 - rho);
    double opening = all.area_m2 * (1 - all.reflectance) / without;
    return box_method_value(&pp_method_split_flux, box, 0)
           / (box_method_value(&pp_method_sphere, box, 0) * opening);
}

static void one_colour_and_equal_halves_are_2rho_over_1_plus_rho(void **state)
{
    (void)state;
    for (double rho = 0.1; rho < 0.95; rho += 0.21) {
        struct box_room box;
        box_room_build(&box, 3.3, 4.9, 2.6, rho, rho, rho);
        box_room_south(&box, 0.7, 0.8, 1.7, 1.0); /* its middle is the room's */
        box.light.ground_reflectance = 0.0;
        assert_relative(split_over_sphere(&box, rho), 2 * rho / (1 + rho), 1e-12);
        /* If the ground is as bright as the sky above it, the formulae are equal. */
        box.light.ground_reflectance = 2 * 0.39;
        assert_relative(split_over_sphere(&box, rho), 1.0, 1e-12);
    }
}

/* Without this correction: the smaller the opening, the less its own reflectance
 * matters, in proportion to its share of the room's surface times 0.9/(1 - rho). */
static void a_small_opening_needs_no_taking_out(void **state)
{
    (void)state;
    double rho = 0.6;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, rho, rho, rho);
    box_room_south(&box, 0.7, 1.3 - 5e-4, 1e-3, 1e-3);
    box.light.ground_reflectance = 0.0;
    double share = 1e-6 / pp_interior_all(&box.world).area_m2;
    assert_relative(box_method_value(&pp_method_split_flux, &box, 0)
                        / box_method_value(&pp_method_sphere, &box, 0),
                    2 * rho / (1 + rho), 3 * share);
}

/* An unglazed rooflight above a floor and walls of 0.4: all light comes from the whole
 * sky, C = 1, and none from the ground. */
static void rooflight_lets_the_whole_sky_in(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.8);
    box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7)->glass =
        pp_glass_none();
    double floor = 3.3 * 4.9, A = 2 * floor + 2 * 8.2 * 2.6;
    double loss = A - 0.4 * (A - floor) - 0.8 * (floor - 0.77) - 0.1 * 0.77;
    double expected = 0.77 / loss * 0.4;
    assert_relative(box_method_value(&pp_method_sphere, &box, 0), expected, 1e-12);
    box.light.sky = pp_sky_uniform();
    assert_relative(box_method_value(&pp_method_sphere, &box, 0), expected, 1e-12);
    /* A clear or a diffusing rooflight sends no light upwards. */
    box.openings[0].glass = pp_glass_diffusing(0.53);
    assert_relative(box_method_value(&pp_method_sphere, &box, 0), 0.53 * expected,
                    1e-12);
}

/* Light from the open overcast sky on glass with the slope beta. */
static double open_sky_on_slope(double beta)
{
    return 3.0 / 14.0 * (1 + cos(beta))
           + 4.0 / (7.0 * PP_PI) * (sin(beta) + (PP_PI - beta) * cos(beta));
}

/* A pane in the ceiling, tilted as in a monitor roof: only its normal and slope count.
 * At 90 degrees C is 39 per cent, as in the table. */
static void sloping_glass_has_the_skys_exact_share_and_its_ground(void **state)
{
    (void)state;
    for (double deg = 5.0; deg < 90.0; deg += 17.0) {
        struct box_room box;
        box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.4);
        double beta = deg * PP_RAD;
        struct pp_opening *pane =
            box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7);
        pane->inner.normal = pane->outer.normal = pp_vec(0, -sin(beta), -cos(beta));
        pane->slope_rad = beta;
        double A = 2 * 3.3 * 4.9 + 2 * 8.2 * 2.6;
        double scale = pp_glass_clear_single().diffuse * 0.77
                       / (A - 0.4 * (A - 0.77) - 0.1 * 0.77) * 0.4;
        double ground = 0.2 * (1 - cos(beta)) / 2;
        /* Both parts have one reflectance, so it does not matter where light falls
         * first. */
        assert_relative(box_method_value(&pp_method_sphere, &box, 0),
                        scale * (open_sky_on_slope(beta) + ground), 1e-12);
        box.light.sky = pp_sky_uniform();
        assert_relative(box_method_value(&pp_method_sphere, &box, 0),
                        scale * ((1 + cos(beta)) / 2 + ground), 1e-12);
    }
}

static void rooms_with_light_of_their_own_are_refused(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.8);
    box_room_south(&box, 0.7, 0.8, 1.7, 1.0);
    box.surfaces[BOX_NORTH].exitance = 0.1;
    assert_non_null(pp_method_sphere.refuses_room(&box.world, &box.light, NULL));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clear_window_is_the_published_equation_15),
        cmocka_unit_test(diffusing_window_lights_both_parts_alike),
        cmocka_unit_test(one_colour_and_ground_of_0_1_is_the_bre_formula),
        cmocka_unit_test(one_colour_and_equal_halves_are_2rho_over_1_plus_rho),
        cmocka_unit_test(a_small_opening_needs_no_taking_out),
        cmocka_unit_test(rooflight_lets_the_whole_sky_in),
        cmocka_unit_test(sloping_glass_has_the_skys_exact_share_and_its_ground),
        cmocka_unit_test(rooms_with_light_of_their_own_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
