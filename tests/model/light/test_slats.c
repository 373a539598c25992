/* test_slats.c - light through blinds compared with independent ray tracing, crossed
 * strings and limits. */
#include "model/light/slats/slats.h"

#include "model/light/slats/slat_cell.h"
#include "tests/lib/near.h"

static struct pp_slat_parts light_at(const struct pp_slats *slats, double low,
                                     double high)
{
    struct pp_slat_cell *cell = NULL;
    struct pp_slat_light light;
    assert_int_equal(pp_slat_cell_create(&cell, slats, NULL), PP_OK);
    if (low == high)
        pp_slat_cell_light(cell, low * PP_RAD, &light);
    else
        pp_slat_cell_diffuse(cell, low * PP_RAD, high * PP_RAD, &light);
    pp_slat_cell_destroy(cell);
    return pp_slat_cell_parts(&light);
}

static double sum_of(struct pp_slat_parts p)
{
    return p.straight + p.room_down + p.room_up + p.back_up + p.back_down;
}

/* Independent ray tracing with three million rays for each device, standard errors up
 * to 5e-4: tilt in degrees; incidence from `low` to `high`; direct, to the room
 * downwards and upwards, back upwards and downwards. */
static void parts_are_those_of_traced_rays(void **state)
{
    (void)state;
    static const struct {
        struct pp_slats slats;
        double low, high, parts[5];
    } rows[] = {
        {{1.0, 1, 0, 0, 0.5, 0.5},
         45,
         45,
         {0.00000, 0.03162, 0.15287, 0.15315, 0.03159}},
        {{1.2, 1, 45, 0, 0.7, 0.5},
         0,
         0,
         {0.15147, 0.04910, 0.03795, 0.07587, 0.18323}},
        {{1.2, 1, 45, 0, 0.7, 0.5},
         -90,
         90,
         {0.24824, 0.04272, 0.04401, 0.06548, 0.17272}},
        {{1.25, 1, -30, 0, 0.1, 0.6}, -30, -30, {1, 0, 0, 0, 0}},
        {{1.3, 1, -60, 0, 0.85, 0.4},
         -90,
         0,
         {0.28482, 0.02552, 0.04445, 0.22343, 0.14939}},
        {{1.15, 1, 15, 0, 0.3, 0.8},
         30,
         30,
         {0.65631, 0.00962, 0.03746, 0.02158, 0.01255}},
        {{1.2, 1, 0, 0, 1, 1}, 60, 60, {0.00000, 0.14738, 0.24132, 0.44151, 0.16967}},
        {{1.25, 1, 0, 0.1, 0.7, 0.7},
         0,
         0,
         {0.90000, 0.00585, 0.00703, 0.03630, 0.00724}},
        {{1.25, 1, 0, 0.1, 0.7, 0.7},
         0,
         90,
         {0.34013, 0.04321, 0.07863, 0.19449, 0.04842}},
        {{1.25, 1, -45, 0.1, 0.8, 0.4},
         -60,
         -60,
         {0.34678, 0.13918, 0.03794, 0.01843, 0.02807}},
        {{1.2, 1, 10, 0.2, 0.9, 0.1},
         45,
         45,
         {0.02586, 0.01850, 0.15337, 0.29761, 0.02249}},
        {{1.1, 1, -45, 0, 0.7, 0.3},
         -90,
         90,
         {0.27443, 0.02320, 0.03950, 0.23278, 0.07480}},
        {{1.2, 1, -60, 0, 0.85, 0.2},
         -75,
         -75,
         {0.00000, 0.07477, 0.05372, 0.01584, 0.02240}},
        {{1.1, 1, 0, 0, 0.6, 0.6},
         30,
         30,
         {0.36491, 0.03028, 0.11431, 0.11419, 0.03016}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct pp_slats slats = rows[i].slats;
        slats.tilt_rad *= PP_RAD;
        struct pp_slat_parts p = light_at(&slats, rows[i].low, rows[i].high);
        assert_near(p.straight, rows[i].parts[0], 1e-3);
        assert_near(p.room_down, rows[i].parts[1], 1.5e-3);
        assert_near(p.room_up, rows[i].parts[2], 1.5e-3);
        assert_near(p.back_up, rows[i].parts[3], 1.5e-3);
        assert_near(p.back_down, rows[i].parts[4], 1.5e-3);
    }
}

/* The same rays: w/s 1, horizontal, reflectance 0.5, light from 60 degrees below the
 * horizon. Most scattered light leaves between 0 and 60 degrees downwards. */
static void scattered_light_leaves_by_direction_as_traced(void **state)
{
    (void)state;
    static const double traced[18] = {0.00060, 0.00196, 0.00352, 0.00523, 0.00639,
                                      0.00543, 0.00406, 0.00248, 0.00083, 0.00401,
                                      0.01181, 0.01914, 0.02619, 0.02984, 0.01821,
                                      0.00443, 0.00047, 0.00015};
    const struct pp_slats slats = {1.0, 1.0, 0.0, 0.0, 0.5, 0.5};
    struct pp_slat_cell *cell = NULL;
    struct pp_slat_light light;
    assert_int_equal(pp_slat_cell_create(&cell, &slats, NULL), PP_OK);
    pp_slat_cell_light(cell, -60.0 * PP_RAD, &light);
    for (int i = 0; i < 18; i++)
        assert_near(pp_slat_cell_sum(&light, 18 + 2 * i, 20 + 2 * i), traced[i], 6e-4);
    pp_slat_cell_destroy(cell);
}

/* Uniform light through flat slats: the crossed strings minus the uncrossed ones, (d1 +
 * d2 - 2 w) / (2 s), with the diagonals d of a gap (Hottel). */
static void diffuse_light_through_gaps_is_that_of_crossed_strings(void **state)
{
    (void)state;
    static const double widths[] = {0.4, 1.0, 1.37},
                        tilts[] = {-71.0, -20.0, 0.0, 53.0};
    for (int i = 0; i < 12; i++) {
        double w = widths[i / 4], sine = sin(tilts[i % 4] * PP_RAD);
        const struct pp_slats slats = {w, 1.0, tilts[i % 4] * PP_RAD, 0.0, 0.3, 0.6};
        double strings = sqrt(w * w + 1.0 + 2.0 * w * sine)
                         + sqrt(w * w + 1.0 - 2.0 * w * sine) - 2.0 * w;
        /* midpoints of 180 steps */
        assert_near(light_at(&slats, -90.0, 90.0).straight, 0.5 * strings, 2e-4);
    }
}

static void horizontal_light_passes_horizontal_flat_slats(void **state)
{
    (void)state;
    const struct pp_slats flat = {1.3, 0.9, 0.0, 0.0, 0.4, 0.7};
    const struct pp_slats arc = {1.25, 1.0, 0.0, 0.1, 0.4, 0.7};
    assert_true(pp_slats_straight(&flat, 0.0) == 1.0);
    assert_near(pp_slats_straight(&arc, 0.0), 0.9, 1e-12); /* 1 - rise/s */
}

/* Closed flat slats wider than their spacing act as a wall. */
static void closed_slats_reflect_as_a_wall_and_pass_nothing(void **state)
{
    (void)state;
    const struct pp_slats slats = {1.2, 1.0, -0.5 * PP_PI, 0.0, 0.62, 0.31};
    struct pp_slat_parts p = light_at(&slats, 33.0, 33.0);
    assert_true(p.straight == 0.0);
    assert_near(p.room_up + p.room_down, 0.0, 1e-4);
    assert_near(p.back_up + p.back_down, 0.62, 2e-3); /* gaps of 0.01 degrees */
}

static void white_slats_lose_nothing_and_black_ones_scatter_nothing(void **state)
{
    (void)state;
    static const double tilts[] = {-75.0, -30.0, 0.0, 42.0},
                        angles[] = {-80.0, 7.0, 55.0};
    for (int i = 0; i < 24; i++) {
        struct pp_slats slats = {1.2, 1, tilts[i % 4] * PP_RAD, i < 12 ? 0 : 0.13,
                                 1,   1};
        double p = angles[i / 4 % 3];
        assert_near(sum_of(light_at(&slats, p, p)), 1.0, 1e-10);
        slats.upper = slats.lower = 0.0;
        assert_near(sum_of(light_at(&slats, p, p)),
                    pp_slats_straight(&slats, p * PP_RAD), 1e-15);
    }
}

/* Reciprocity: uniform light from outside and from the room is transmitted equally. */
static void uniform_light_passes_alike_both_ways(void **state)
{
    (void)state;
    const struct pp_slats slats = {1.25, 1.0, -37.0 * PP_RAD, 0.17, 0.8, 0.4};
    struct pp_slat_parts in = light_at(&slats, -90.0, 90.0);
    struct pp_slat_parts out = light_at(&slats, 90.0, 270.0);
    assert_near(in.straight, out.straight, 1e-4);
    assert_near(in.straight + in.room_down + in.room_up,
                out.straight + out.back_down + out.back_up, 2e-4);
}

/* A blind upside down, with light from the opposite altitude. */
static void a_blind_upside_down_does_the_same_upside_down(void **state)
{
    (void)state;
    const struct pp_slats one = {1.1, 1.0, 24.0 * PP_RAD, 0.12, 0.7, 0.2};
    const struct pp_slats other = {1.1, 1.0, -24.0 * PP_RAD, -0.12, 0.2, 0.7};
    struct pp_slat_parts p = light_at(&one, 31.0, 31.0),
                         q = light_at(&other, -31.0, -31.0);
    assert_near(p.straight, q.straight, 1e-12);
    assert_near(p.room_down, q.room_up, 1e-9);
    assert_near(p.back_up, q.back_down, 1e-9);
}

/* Slats perpendicular to the ray hide most light, w / (s cos p): with a spacing of 1.2
 * widths they can block light from 33.6 degrees upwards. For w = s the cut-off is at t
 * = 2 p - 90. */
static void slats_turn_no_further_than_the_sun_requires(void **state)
{
    (void)state;
    const struct pp_slats wide = {1.0, 1.2, 0.0, 0.0, 0.5, 0.5};
    const struct pp_slats even = {0.8, 0.8, 0.0, 0.0, 0.5, 0.5};
    struct pp_slats turned = wide;
    turned.tilt_rad = pp_slats_cut_off(&wide, 20.0 * PP_RAD);
    assert_near(turned.tilt_rad, -70.0 * PP_RAD, 1e-3); /* steps of 0.05 degrees */
    assert_near(pp_slats_straight(&turned, 20.0 * PP_RAD),
                1.0 - 1.0 / 1.2 / cos(20.0 * PP_RAD), 1e-6);
    turned.tilt_rad = pp_slats_cut_off(&wide, 34.0 * PP_RAD);
    assert_true(pp_slats_straight(&turned, 34.0 * PP_RAD) == 0.0);
    assert_near(pp_slats_cut_off(&even, 31.0 * PP_RAD), -28.0 * PP_RAD, 1e-9);
    assert_true(pp_slats_cut_off(&even, 60.0 * PP_RAD) == 0.0);
}

/* A beam can be blocked at some tilt if and only if cos p <= w/s; otherwise slats
 * perpendicular to the ray transmit 1 - (w/s)/cos p. Another program left such slats at
 * 0 degrees (EnergyPlus, issue 2842). */
static void slats_narrower_than_their_spacing_block_a_high_sun_only(void **state)
{
    (void)state;
    static const struct {
        double spacing, limit_deg;
    } cases[] = {{1.1, 24.6}, {1.2, 33.6}, {1.4, 44.4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int p = 1; p < 90; p++) {
            struct pp_slats slats = {1.0, cases[i].spacing, 0.0, 0.0, 0.5, 0.5};
            double profile = p * PP_RAD;
            slats.tilt_rad = pp_slats_cut_off(&slats, profile);
            double straight = pp_slats_straight(&slats, profile);
            assert_true((straight == 0.0) == (p > cases[i].limit_deg));
            assert_near(straight, fmax(0.0, 1.0 - 1.0 / slats.spacing / cos(profile)),
                        1e-6);
        }
}

static void slats_that_touch_are_refused(void **state)
{
    (void)state;
    const struct pp_slats slats = {1.3, 1.0, 85.0 * PP_RAD, 0.2, 0.5, 0.5};
    struct pp_slat_cell *cell = NULL;
    struct pp_error err;
    assert_int_equal(pp_slat_cell_create(&cell, &slats, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "touch"));
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_those_of_traced_rays),
        cmocka_unit_test(scattered_light_leaves_by_direction_as_traced),
        cmocka_unit_test(diffuse_light_through_gaps_is_that_of_crossed_strings),
        cmocka_unit_test(horizontal_light_passes_horizontal_flat_slats),
        cmocka_unit_test(closed_slats_reflect_as_a_wall_and_pass_nothing),
        cmocka_unit_test(white_slats_lose_nothing_and_black_ones_scatter_nothing),
        cmocka_unit_test(uniform_light_passes_alike_both_ways),
        cmocka_unit_test(a_blind_upside_down_does_the_same_upside_down),
        cmocka_unit_test(slats_turn_no_further_than_the_sun_requires),
        cmocka_unit_test(slats_narrower_than_their_spacing_block_a_high_sun_only),
        cmocka_unit_test(slats_that_touch_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
