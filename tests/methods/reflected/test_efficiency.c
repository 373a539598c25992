/* test_efficiency.c - the efficiency method: light on the window, and its shares that
 * reach the plane directly and by reflection. */
#include "methods/reflected/point_factor.h"
#include "methods/reflected/room_zones.h"
#include "methods/average/plane_light.h"
#include "methods/exact/direct.h"
#include "model/light/graded_sky.h"

#include "tests/lib/room_of.h"
#include "tests/methods/box_method.h"

static double figure(const struct pp_worksheet *sheet, const char *symbol)
{
    for (int i = sheet->count - 1; i >= 0; i--)
        if (strcmp(sheet->list[i].symbol, symbol) == 0)
            return sheet->list[i].printed;
    fail_msg("no %s on the sheet", symbol);
    return NAN;
}

static struct pp_part worked(struct box_room *box)
{
    struct pp_part part = {0};
    assert_int_equal(pp_method_efficiency.evaluate(&box->world, &box->light,
                                                   box->openings, NULL, NULL, &part,
                                                   NULL),
                     PP_OK);
    return part;
}

/* The published form, quoted from memory, compared with its derivation: the sky above
 * an infinitely long skyline, VSC, and 0.15 of the hidden sky. Its constants have four
 * digits. */
static void light_on_the_window_is_vsc_and_15_per_cent_of_what_is_hidden(void **state)
{
    (void)state;
    for (double alpha = 0.0; alpha < 90.0; alpha += 7.3) {
        struct box_room box;
        box_room_build(&box, 4.1, 6.3, 3.2, 0.2, 0.5, 0.7);
        box_room_south(&box, 0.3, 1.0, 3.1, 1.5);
        box_room_skyline(&box, alpha * PP_RAD, 1.75, INFINITY);
        struct pp_part part = worked(&box);
        double s = sin(alpha * PP_RAD), c = cos(alpha * PP_RAD);
        double sky = 3.0 / 14.0 * (1.0 - s) + 4.0 / (7.0 * PP_PI) * c * c;
        double open = 3.0 / 14.0 + 4.0 / (7.0 * PP_PI);
        assert_near(figure(&part.sheet, "E_o"), 100.0 * (sky + 0.15 * (open - sky)),
                    0.02);
    }
}

/* The skylight that passes a point and reaches the plane equals the sky component, at
 * that point, of the plane mirrored above the point; by quadrature over the plane. */
static void direct_share_is_the_light_followed_to_the_plane(void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_overcast();
    double corners[4][2] = {{-1.1, 0.2}, {2.7, 0.2}, {2.7, 4.4}, {-1.1, 4.4}};
    struct pp_ring ring = {4, corners};
    struct pp_region plane = {1, &ring};
    for (double slope = 0.0; slope < 91.0; slope += 22.5) {
        struct pp_vec3 from = pp_vec(0.4, 0.1, 1.9);
        struct pp_vec3 normal = /* facing north and down */
            pp_vec(0.0, sin(slope * PP_RAD), -cos(slope * PP_RAD));
        enum { N = 900 };
        double sum = 0.0, even = 0.0;
        for (int i = 0; i < N * N; i++) {
            double x = -1.1 + 3.8 * (i % N + 0.5) / N,
                   y = 0.2 + 4.2 * ((double)(i / N) + 0.5) / N;
            struct pp_vec3 v = pp_vec_sub(pp_vec(x, y, 0.3), from);
            double r = pp_vec_length(v), cosine = pp_vec_dot(v, normal) / r;
            if (!(cosine > 0.0))
                continue;
            double seen = cosine * (1.6 / r) / (r * r) * 3.8 * 4.2 / N / N;
            sum += seen * pp_sky_luminance(&sky, pp_vec_scale(v, -1.0 / r));
            even += seen / PP_PI;
        }
        assert_near(pp_point_factor_sky(from, normal, &plane, 0.3, &sky), sum, 2e-5);
        assert_near(pp_point_factor(from, normal, &plane, 0.3), even, 2e-5);
    }
}

/* All light that leaves a deep well falls on the plane below it, and none on a plane to
 * one side. */
static void light_through_a_well_falls_where_the_foot_lets_it(void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_overcast();
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='3' height='2.6'/>"
        "<rooflight x='1.2' y='0.4' width='0.6' depth='0.8' reveal='3.5'/></room>");
    const struct pp_polygon *foot = &world->openings[0].inner;
    struct pp_vec3 glass = pp_polygon_middle(&world->openings[0].outer);
    double z = world->working_plane_m;
    assert_near(pp_point_factor_through(glass, foot, &world->plane, z, &sky), 1.0,
                1e-9);
    double aside[4][2] = {{2.5, 0}, {4, 0}, {4, 3}, {2.5, 3}};
    struct pp_ring ring = {4, aside};
    struct pp_region east = {1, &ring};
    assert_near(pp_point_factor_through(glass, foot, &east, z, &sky), 0.0, 1e-12);
    /* by symmetry, half of the plane directly below receives half */
    double half[4][2] = {{1.5, 0}, {4, 0}, {4, 3}, {1.5, 3}};
    ring.xy = half;
    assert_near(pp_point_factor_through(glass, foot, &east, z, &sky), 0.5, 1e-9);
    pp_world_destroy(world);
}

/* Light followed from zone to zone for 3,000 reflections in a box of 4.1 x 6.3 x 3.2 m,
 * compared with the formulae; in the end all light is absorbed. */
static void efficiency_is_the_light_followed_from_zone_to_zone(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.1, 6.3, 3.2, 0.25, 0.55, 0.75);
    box_room_south(&box, 0.3, 1.0, 3.1, 1.5);
    struct pp_part part = worked(&box);
    double S = 4.1 * 6.3, F = figure(&part.sheet, "F"), m = figure(&part.sheet, "m");
    double wall_m2 = 2 * (4.1 + 6.3) * (3.2 - 0.85);
    assert_relative(m, S * (1 - F) / wall_m2, 1e-12);
    double low_m2 = S + 2 * (4.1 + 6.3) * 0.85;
    double low = (S * 0.25 + (low_m2 - S) * 0.55) / low_m2;
    double rho[3] = {low * S / (low_m2 * (1 - low) + low * S), 0.75,
                     (0.55 * (wall_m2 - 4.65) + 0.1 * 4.65) / wall_m2};
    const double to[3][3] = {
        {0, F, 1 - F}, {F, 0, 1 - F}, {m, m, 1 - 2 * m}}; /* plane, ceiling, walls */
    double d = figure(&part.sheet, "d"), g = figure(&part.sheet, "g");
    const double start[2][3] = {{d, 0, 1 - d}, {0, g, 1 - g}};
    double eta[2];
    for (int source = 0; source < 2; source++) {
        double light[3], lost = 0.0;
        eta[source] = start[source][0];
        memcpy(light, start[source], sizeof light);
        for (int k = 0; k < 3000; k++) {
            double next[3] = {0};
            for (int i = 0; i < 3; i++) {
                lost += (1 - rho[i]) * light[i];
                for (int j = 0; j < 3; j++)
                    next[j] += rho[i] * light[i] * to[i][j];
            }
            memcpy(light, next, sizeof light);
            eta[source] += next[0];
        }
        assert_relative(lost, 1.0, 1e-12);
    }
    assert_relative(figure(&part.sheet, "eta"), eta[0], 1e-12);
    assert_relative(figure(&part.sheet, "eta_g"), eta[1], 1e-12);
    struct pp_glass glass = box.openings[0].glass;
    assert_relative(part.value,
                    glass.diffuse * 4.65 / S * 0.01
                        * (figure(&part.sheet, "E_o") * eta[0]
                           + figure(&part.sheet, "C_g") * eta[1]),
                    1e-12);
}

/* Without reflection the average is the skylight that falls directly on the plane: an
 * unglazed slit of 0.2 x 0.2 m compared with the integral of `exact` over the plane.
 * The error of using the centre of the slit is (0.1/1.5)^2. */
static void black_room_has_the_direct_light_alone(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><site ground-reflectance='0'/>"
        "<plan width='4.1' depth='6.3' height='3.2'/>"
        "<finishes floor='0' walls='0' ceiling='0'/><window wall='south' "
        "left='1.3' sill='2.3' width='0.2' height='0.2' glazing='none'/></room>");
    struct pp_part part = {0};
    double mean[2] = {0.0};
    const struct pp_opening *slit = &world->openings[0];
    assert_int_equal(
        pp_method_efficiency.evaluate(world, &light, slit, NULL, NULL, &part, NULL),
        PP_OK);
    struct pp_beams *beams;
    assert_int_equal(pp_beams_create(&beams, world, false, NULL), PP_OK);
    assert_int_equal(
        pp_plane_light_direct(mean, beams, &light, slit, &slit->glass, NULL), PP_OK);
    pp_beams_destroy(beams);
    /* The opening reflects 0.1, but it is less than 0.1 % of the walls. */
    assert_relative(part.value, mean[0], 0.006);
    pp_world_destroy(world);
}

/* If walls and ceiling are white, all light above the plane reaches it: all shares are
 * 1. */
static void white_room_loses_nothing_above_the_plane(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.1, 6.3, 3.2, 0.25, 1.0, 1.0);
    box.world.opening_count = 0;
    struct pp_worksheet sheet = {0};
    pp_room_zones_put(&sheet, &box.world);
    assert_relative(figure(&sheet, "u_w"), 1.0, 1e-12);
    assert_relative(figure(&sheet, "u_c"), 1.0, 1e-12);
    assert_relative(figure(&sheet, "u_p"), 1.0, 1e-12);
}

/* A window that extends below the plane gives the light of its upper part, the same as
 * a window that begins at the plane, except for the wall below it. */
static void glass_below_the_plane_is_left_out(void **state)
{
    (void)state;
    double value[2];
    for (int i = 0; i < 2; i++) {
        struct box_room box;
        box_room_build(&box, 4.1, 6.3, 3.2, 0.25, 0.1, 0.75);
        box_room_south(&box, 0.3, i ? 0.25 : 0.85, 3.1, i ? 2.1 : 1.5);
        value[i] = worked(&box).value;
    }
    assert_relative(value[1], value[0], 1e-9);
}

static void diffusing_panes_are_covered_where_level(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.1, 6.3, 3.2, 0.25, 0.5, 0.75);
    box_room_south(&box, 0.3, 1.0, 3.1, 1.5)->glass = pp_glass_diffusing(0.6);
    assert_non_null(
        pp_method_efficiency.refuses(&box.world, &box.light, box.openings, NULL));
    box.openings[0].slope_rad = 0.0;
    assert_null(
        pp_method_efficiency.refuses(&box.world, &box.light, box.openings, NULL));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_on_the_window_is_vsc_and_15_per_cent_of_what_is_hidden),
        cmocka_unit_test(direct_share_is_the_light_followed_to_the_plane),
        cmocka_unit_test(light_through_a_well_falls_where_the_foot_lets_it),
        cmocka_unit_test(efficiency_is_the_light_followed_from_zone_to_zone),
        cmocka_unit_test(black_room_has_the_direct_light_alone),
        cmocka_unit_test(white_room_loses_nothing_above_the_plane),
        cmocka_unit_test(glass_below_the_plane_is_left_out),
        cmocka_unit_test(diffusing_panes_are_covered_where_level),
    };
    add_tests(tests, NULL, NULL);
}
