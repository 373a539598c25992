/* test_irc_atlas.c - the formulae fitted to traced rooms: compared with a calculation
 * by hand, and at their physical limits. */
#include <stdlib.h>

#include "methods/fitted/fitted_constants.h"
#include "methods/fitted/fitted_position.h"
#include "methods/method.h"
#include "tests/lib/near.h"

#include "tests/lib/box_room.h"

/* Value of one opening for a receiver that faces up; with receiver NULL, the
 * average. */
static double value_of(const struct pp_method *method, struct box_room *box, int index,
                       const struct pp_receiver *receiver)
{
    struct pp_part part = {0};
    void *tools = NULL;
    const struct pp_opening *opening = box->openings + index;
    assert_null(method->refuses_room(&box->world, &box->light, receiver));
    assert_null(method->refuses(&box->world, &box->light, opening, receiver));
    assert_int_equal(method->prepare(&tools, &box->world, &box->light, NULL), PP_OK);
    assert_int_equal(method->evaluate(&box->world, &box->light, opening, receiver,
                                      tools, &part, NULL),
                     PP_OK);
    method->destroy_tools(tools);
    return part.value;
}

static struct pp_receiver at(double x, double y)
{
    return (struct pp_receiver){{x, y, 0.85}, {0, 0, 1}, 0, 0.0};
}

static const struct pp_method *const by_position[] = {
    &pp_method_irc_atlas, &pp_method_bre_atlas, &pp_method_split_flux_atlas};
static const struct pp_method *const all[] = {
    &pp_method_irc_atlas, &pp_method_bre_atlas, &pp_method_split_flux_atlas,
    &pp_method_average_df_atlas};
enum { BY_POSITION = 3, ALL = 4 };

static void build_room(struct box_room *box, double depth, double reflectance)
{
    box_room_build(box, 3.7, depth, 2.9, reflectance, reflectance, reflectance);
    box_room_south(box, 0.9, 0.7, 1.9, 1.3);
    box->light.ground_reflectance = 0.17;
}

/* Calculated by hand with printed values, in a room of 3.7 x 5.3 x 2.9 m:
 *
 *   A = 2 (3.7 5.3 + 9.0 2.9) = 91.42, glass 2.47;
 *   R = (19.61 (0.15 + 0.81) + (52.2 - 2.47) 0.62 + 2.47 0.1)/A = 0.545889
 *   below 1.35 m: A_l = 19.61 + 18 1.35 - 1.235 = 42.675, rho_l = 0.404025
 *   above it:     A_u = 19.61 + 18 1.55 - 1.235 = 46.275, rho_u = 0.700516
 *   V = 0.396177, C_g = 0.085, tau = 0.85, Ag = 2.47, no reveal, nothing outside
 *   irc_m = 0.85 2.47/(A (1 - R)) (V rho_l + C_g) rho_u^(1/2)
 *           (A_l/A_u)^(c (1 - R))
 *   l = 2 3.7 2.9/6.6 = 3.251515; x = 4.1, y = 0.45, 1.8 m of wall beside the window
 */
static void build_worked_room(struct box_room *box)
{
    box_room_build(box, 3.7, 5.3, 2.9, 0.15, 0.62, 0.81);
    box_room_south(box, 0.9, 0.7, 1.9, 1.3)->glass.diffuse = 0.85;
    box->light.ground_reflectance = 0.17;
}

static void worked_room_is_as_calculated_by_hand(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    double A = 91.42, R = 0.545889, A_l = 42.675, A_u = 46.275, rho_l = 0.404025;
    double mean = 0.85 * 2.47 / (A * (1 - R)) * (0.396177 * rho_l + 0.085)
                  * sqrt(0.700516) * pow(A_l / A_u, atof(PP_FITTED_PARTS) * (1 - R));
    assert_relative(value_of(&pp_method_irc_atlas, &box, 0, NULL), mean, 1e-4);

    double l = 2 * 3.7 * 2.9 / 6.6,
           q_d =
               sqrt(1 - R) * (atof(PP_FITTED_DEPTH) * 5.3 / l - atof(PP_FITTED_START)),
           q_s = atof(PP_FITTED_SIDE) * 1.8 * sqrt(1 - R) / l;
    double f_d = q_d * exp(-q_d * 4.1 / 5.3) / (1 - exp(-q_d));
    double f_s = q_s * exp(-2 * q_s * 0.45 / 3.7) / (1 - exp(-q_s));
    struct pp_receiver point = at(0.9 + 1.9 / 2 + 0.45, 4.1);
    assert_relative(value_of(&pp_method_irc_atlas, &box, 0, &point), mean * f_d * f_s,
                    1e-4);
}

/* The same room by the other two formulae. Without the window wall, below 1.35 m
 *   R_fw = (19.61 0.15 + 14.3 1.35 0.62)/(19.61 + 14.3 1.35) = 0.383157
 * and 0.15 m of the 1.3 m of the window's height are below the plane at 0.85 m.
 */
static void worked_room_is_as_calculated_by_hand_by_bre_and_split_flux(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    double A = 91.42, R = 0.545889, A_l = 42.675, A_u = 46.275, rho_l = 0.404025,
           rho_u = 0.700516, R_fw = 0.383157;
    double bre = 0.85 * 2.47 / (A * (1 - R)) * (0.396177 * R_fw + 0.085)
                 * pow(rho_u, atof(PP_FITTED_BRE_UPPER))
                 * pow(A_l / A_u, atof(PP_FITTED_BRE_PARTS) * (1 - R))
                 * pow(1 + 2.9 / 5.3, atof(PP_FITTED_BRE_SHALLOW) * (1 - R));
    assert_relative(value_of(&pp_method_bre_atlas, &box, 0, NULL), bre, 1e-4);

    double flux = 2 * 0.85 * 2.47 / (A * (1 - R * R))
                  * (rho_u * 0.085 + rho_u * rho_l * 0.396177)
                  * exp(-atof(PP_FITTED_FLUX_LOW) * (1 - R) * 0.15 / 1.3);
    assert_relative(value_of(&pp_method_split_flux_atlas, &box, 0, NULL), flux, 1e-4);
}

/* Behind an infinitely long, black skyline of 40 degrees,
 *   V = 3/14 (1 - sin 40) + 4/(7 pi) cos(40)^2 = 0.183283,
 * which is 0.462836 of 0.396177. The light from the ground is reduced by the power b/2
 * of this ratio.
 */
static void the_ground_stands_in_half_of_the_openings_shade(void **state)
{
    (void)state;
    double light[2][2];
    for (int shut = 0; shut < 2; shut++)
        for (int bright = 0; bright < 2; bright++) {
            struct box_room box;
            build_worked_room(&box);
            box.light.ground_reflectance = bright ? 0.34 : 0.17;
            if (shut) {
                box_room_skyline(&box, 40.0 * PP_RAD, 1.35, INFINITY);
                box.skyline.reflectance = 0.0;
            }
            light[shut][bright] = value_of(&pp_method_irc_atlas, &box, 0, NULL);
        }
    assert_relative((light[1][1] - light[1][0]) / (light[0][1] - light[0][0]),
                    pow(0.462836, atof(PP_FITTED_SHADE) / 2), 1e-3);
}

/* Beside a window from wall to wall there is no wall that would be darker. */
static void a_window_as_broad_as_its_wall_lights_alike_from_side_to_side(void **state)
{
    (void)state;
    for (int i = 0; i < BY_POSITION; i++) {
        struct box_room box;
        box_room_build(&box, 3.7, 5.3, 2.9, 0.3, 0.5, 0.7);
        box_room_south(&box, 0.0, 0.7, 3.7, 1.3);
        struct pp_receiver middle = at(1.85, 2.1), side = at(0.3, 2.1);
        assert_relative(value_of(by_position[i], &box, 0, &side),
                        value_of(by_position[i], &box, 0, &middle), 1e-5);
    }
}

static void a_furnace_is_lit_alike_everywhere_by_its_energy_balance(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.7, 9.3, 2.9, 1, 1, 1);
    struct pp_opening *window = box_room_south(&box, 1.84, 1.4, 0.02, 0.013);
    window->glass.diffuse = 0.85;
    double glass = 0.02 * 0.013;
    /* Only the opening absorbs light: A (1 - R) is 0.9 of its area. */
    double balance = 0.85 * glass * (0.396177 + 0.1) / (0.9 * glass);
    for (int i = 0; i < BY_POSITION; i++)
        for (double y = 0.7; y < 9.3; y += 2.1) {
            struct pp_receiver point = at(2.9, y);
            /* The difference is the remainder of 1 - R, 2.4e-6, and its square root in
             * f_d. */
            assert_relative(value_of(by_position[i], &box, 0, &point), balance, 1e-2);
        }
}

static void a_dark_room_reflects_nothing(void **state)
{
    (void)state;
    struct box_room box;
    build_room(&box, 5.3, 0.0);
    struct pp_receiver point = at(1.2, 2.3);
    assert_near(value_of(&pp_method_irc_atlas, &box, 0, &point), 0.0, 0.0);
    assert_near(value_of(&pp_method_split_flux_atlas, &box, 0, &point), 0.0, 0.0);
    double last = INFINITY;
    for (double rho = 0.1; rho > 1e-4; rho /= 3.0) {
        build_room(&box, 5.3, rho);
        double now = value_of(&pp_method_bre_atlas, &box, 0, &point);
        assert_true(now < 0.5 * last);
        last = now;
    }
    assert_true(last < 1e-5);
}

static void without_light_outside_there_is_none_inside(void **state)
{
    (void)state;
    struct box_room box;
    build_room(&box, 5.3, 0.5);
    box.light.ground_reflectance = 0.0;
    box_room_skyline(&box, 89.99 * PP_RAD, 1.35, INFINITY);
    box.skyline.reflectance = 0.0;
    struct pp_receiver point = at(1.2, 2.3);
    for (int i = 0; i < ALL; i++)
        assert_near(value_of(all[i], &box, 0, &point), 0.0, 1e-6);
}

/* In a room 1000 m deep no light is left 100 m from the window; at 2.1 m the light is
 * the same as in a room half as deep. */
static void no_light_is_left_at_the_back_of_an_infinitely_deep_room(void **state)
{
    (void)state;
    struct box_room endless, long_one;
    build_room(&endless, 1000.0, 0.5);
    build_room(&long_one, 500.0, 0.5);
    for (int i = 0; i < BY_POSITION; i++) {
        struct pp_receiver far = at(1.2, 100.0), near = at(1.2, 2.1);
        double here = value_of(by_position[i], &endless, 0, &near);
        assert_true(value_of(by_position[i], &endless, 0, &far) < 1e-9 * here);
        assert_relative(value_of(by_position[i], &long_one, 0, &near), here, 0.02);
    }
}

/* The light starts c l/k = 2.9 m behind the window. In a room of that depth it is the
 * same at all depths, for any reflectance; in a shallower room it is brighter at the
 * back. */
static void a_room_that_ends_where_the_light_starts_is_alike_at_all_depths(void **state)
{
    (void)state;
    double start = atof(PP_FITTED_START) / atof(PP_FITTED_DEPTH) * 2 * 3.7 * 2.9 / 6.6;
    for (double rho = 0.13; rho < 0.9; rho += 0.31)
        for (int side = -1; side <= 1; side++) {
            struct box_room box;
            build_room(&box, start * (1.0 + 0.3 * side), rho);
            struct pp_receiver front = at(2.3, 0.4), back = at(2.3, 0.6 * start);
            double ratio = value_of(&pp_method_irc_atlas, &box, 0, &back)
                           / value_of(&pp_method_irc_atlas, &box, 0, &front);
            assert_true(side == 0 ? fabs(ratio - 1.0) < 1e-5
                                  : side * (1.0 - ratio) > 0.02);
        }
}

static void the_back_has_less_than_the_front_and_a_white_room_less_so(void **state)
{
    (void)state;
    double last = 0.0;
    for (double rho = 0.2; rho < 0.95; rho += 0.23) {
        struct box_room box;
        build_room(&box, 7.3, rho);
        struct pp_receiver front = at(1.85, 0.6), back = at(1.85, 6.8);
        double ratio = value_of(&pp_method_irc_atlas, &box, 0, &back)
                       / value_of(&pp_method_irc_atlas, &box, 0, &front);
        assert_true(ratio > last && ratio < 1.0);
        last = ratio;
    }
}

/* The window is in the middle of its wall; midpoint rule over 40 x 40 points. */
static void the_mean_over_the_plane_is_the_average(void **state)
{
    (void)state;
    struct box_room box;
    build_room(&box, 5.3, 0.55);
    for (int i = 0; i < BY_POSITION; i++) {
        double average = value_of(by_position[i], &box, 0, NULL), sum = 0.0;
        enum { N = 40 };
        for (int k = 0; k < N * N; k++) {
            struct pp_receiver point =
                at(3.7 * (k % N + 0.5) / N, 5.3 * (k / N + 0.5) / N);
            sum += value_of(by_position[i], &box, 0, &point) / (N * N);
        }
        assert_relative(sum, average, 1e-3); /* (q/N)^2/24, and the kink at y = 0 */
    }
}

static void ground_and_obstruction_are_the_rooms(void **state)
{
    (void)state;
    for (int i = 0; i < ALL; i++) {
        struct box_room box;
        build_room(&box, 5.3, 0.5);
        double open = value_of(all[i], &box, 0, NULL);
        box.light.ground_reflectance = 0.4;
        assert_true(value_of(all[i], &box, 0, NULL) > 1.1 * open);
        box.light.ground_reflectance = 0.17;
        box_room_skyline(&box, 40.0 * PP_RAD, 1.35, INFINITY);
        double obstructed = value_of(all[i], &box, 0, NULL);
        assert_true(obstructed < 0.7 * open);
        /* An obstruction with 2.6 times the reflectance gives more. */
        box.skyline.reflectance = 0.52;
        assert_true(value_of(all[i], &box, 0, NULL) > obstructed);
    }
}

static void a_reveal_takes_light(void **state)
{
    (void)state;
    const struct pp_method *const with[] = {&pp_method_irc_atlas,
                                            &pp_method_average_df_atlas};
    for (int i = 0; i < 2; i++) {
        struct box_room box;
        build_room(&box, 5.3, 0.5);
        double flush = value_of(with[i], &box, 0, NULL);
        box_room_reveal(&box, 0, 0.37);
        assert_true(value_of(with[i], &box, 0, NULL) < 0.95 * flush);
    }
}

static void rooms_outside_the_fit_are_rejected(void **state)
{
    (void)state;
    struct box_room box;
    build_room(&box, 5.3, 0.5);
    struct pp_opening *window = box.openings;
    for (int i = 0; i < ALL; i++) {
        const struct pp_method *method = all[i];
        window->glass.diffusing = true;
        assert_non_null(method->refuses(&box.world, &box.light, window, NULL));
        window->glass.diffusing = false;
        assert_null(method->refuses(&box.world, &box.light, window, NULL));
        window->slope_rad = 1.1;
        assert_non_null(method->refuses(&box.world, &box.light, window, NULL));
        window->slope_rad = PP_PI / 2.0;
        struct pp_receiver upright = {{1, 1, 1}, {0, -1, 0}, 0, 0.0};
        assert_non_null(method->refuses_room(&box.world, &box.light, &upright));
        box.light.sky = pp_sky_uniform();
        assert_non_null(method->refuses_room(&box.world, &box.light, NULL));
        box.light.sky = pp_sky_overcast();
    }
}

static void a_point_behind_the_windows_wall_counts_as_in_it(void **state)
{
    (void)state;
    struct box_room box;
    build_room(&box, 5.3, 0.5);
    struct pp_receiver behind = at(1.2, -0.7);
    struct pp_fitted_place place =
        pp_fitted_position_of(&box.world, box.openings, &behind);
    assert_near(place.x, 0.0, 0.0);
    assert_near(place.y, 1.85 - 1.2, 1e-12);
    assert_near(place.d_r, 5.3, 1e-12);
    assert_near(place.w_r, 3.7, 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_room_is_as_calculated_by_hand),
        cmocka_unit_test(worked_room_is_as_calculated_by_hand_by_bre_and_split_flux),
        cmocka_unit_test(the_ground_stands_in_half_of_the_openings_shade),
        cmocka_unit_test(a_window_as_broad_as_its_wall_lights_alike_from_side_to_side),
        cmocka_unit_test(a_furnace_is_lit_alike_everywhere_by_its_energy_balance),
        cmocka_unit_test(a_dark_room_reflects_nothing),
        cmocka_unit_test(without_light_outside_there_is_none_inside),
        cmocka_unit_test(no_light_is_left_at_the_back_of_an_infinitely_deep_room),
        cmocka_unit_test(
            a_room_that_ends_where_the_light_starts_is_alike_at_all_depths),
        cmocka_unit_test(the_back_has_less_than_the_front_and_a_white_room_less_so),
        cmocka_unit_test(the_mean_over_the_plane_is_the_average),
        cmocka_unit_test(ground_and_obstruction_are_the_rooms),
        cmocka_unit_test(a_reveal_takes_light),
        cmocka_unit_test(rooms_outside_the_fit_are_rejected),
        cmocka_unit_test(a_point_behind_the_windows_wall_counts_as_in_it),
    };
    add_tests(tests, NULL, NULL);
}
