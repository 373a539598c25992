/* test_blind.c - a blind with its glass as a pane that scatters by direction: its
 * functions agree with each other and with the slats alone, and conserve energy. */
#include "model/light/slats/blind.h"

#include "model/light/slats/blind_scatter.h"
#include "tests/lib/near.h"

static struct pp_blind *blind_of(struct pp_slats slats, bool vertical,
                                 enum pp_device_position position,
                                 struct pp_glass glass)
{
    const struct pp_window_device device = {.kind = PP_DEVICE_BLIND,
                                            .slats = slats,
                                            .vertical = vertical,
                                            .position = position};
    struct pp_blind *blind = NULL;
    assert_int_equal(pp_blind_create(&blind, &device, &glass, true, NULL), PP_OK);
    return blind;
}

static const struct pp_slats usual = {0.025, 0.02, -35.0 * PP_RAD, 0.002, 0.7, 0.4};

/* Unit vector at an angle from z, rotated from x by `turn`. */
static struct pp_vec3 direction(double angle, double turn)
{
    return pp_vec(sin(angle) * cos(turn), sin(angle) * sin(turn), cos(angle));
}

/* Integral of the btdf times the cosine over the other direction, by midpoints. The
 * profile angle and the angle to the section of the slats are the coordinates. */
static double integral_of(const struct pp_blind *blind, struct pp_vec3 known,
                          bool over_in)
{
    enum { PROFILES = 360, ANGLES = 120 };
    double sum = 0.0, sign = known.z > 0.0 ? 1.0 : -1.0;
    for (int i = 0; i < PROFILES; i++)
        for (int k = 0; k < ANGLES; k++) {
            double p = ((i + 0.5) / PROFILES - 0.5) * PP_PI;
            double s = ((k + 0.5) / ANGLES - 0.5) * PP_PI;
            struct pp_vec3 d = pp_vec(sin(s), cos(s) * sin(p), cos(s) * cos(p));
            if (blind->device.vertical)
                d = pp_vec(d.y, d.x, d.z);
            d = pp_vec_scale(d, sign);
            double f = over_in ? blind->scatter.btdf(blind, d, known)
                               : blind->scatter.btdf(blind, known, d);
            sum += f * fabs(d.z) * cos(s);
        }
    return sum * PP_PI / PROFILES * PP_PI / ANGLES;
}

static void integrals_of_the_btdf_are_the_shares(void **state)
{
    (void)state;
    struct pp_blind *blinds[] = {
        blind_of(usual, false, PP_DEVICE_INSIDE, pp_glass_clear_single()),
        blind_of(usual, true, PP_DEVICE_OUTSIDE, pp_glass_panes(2, 1.52, 0.02)),
        blind_of(usual, false, PP_DEVICE_BETWEEN, pp_glass_panes(3, 1.52, 0.02)),
    };
    static const double angles[] = {0.2, 0.9, 1.3, 2.0, 2.8};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 5; k++) {
            struct pp_vec3 d = direction(angles[k], 0.7 + k);
            const struct pp_pane_scatter *scatter = &blinds[i]->scatter;
            /* Tolerance: means of the glass over 32 steps, and over a bin. */
            assert_relative(integral_of(blinds[i], d, false),
                            scatter->scattered(blinds[i], d), 0.01);
            assert_relative(integral_of(blinds[i], d, true),
                            scatter->arriving(blinds[i], d), 0.01);
        }
        pp_blind_release(blinds[i]);
    }
}

/* The mean weight of the samples is about 1, if the integrand is nearly constant in a
 * cell; each weight is btdf cos / (density arriving). */
static void samples_have_the_density_that_is_stated(void **state)
{
    (void)state;
    enum { SAMPLES = 4000 };
    struct pp_blind *blind =
        blind_of(usual, true, PP_DEVICE_OUTSIDE, pp_glass_clear_single());
    const struct pp_pane_scatter *scatter = &blind->scatter;
    static const double angles[] = {0.4, 1.1, 2.3, 2.9};
    for (int k = 0; k < 4; k++) {
        struct pp_vec3 out = direction(angles[k], 2.0 - k);
        double sum = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            struct pp_vec3 in;
            double u = (i + 0.5) / SAMPLES,
                   v = fmod((i + 0.5) * 0.6180339887498949, 1.0);
            double factor = scatter->sample(blind, out, u, v, &in);
            assert_near(pp_vec_length(in), 1.0, 1e-12);
            assert_relative(scatter->btdf(blind, in, out) * fabs(in.z)
                                / (scatter->density(blind, in, out)
                                   * scatter->arriving(blind, out)),
                            factor, 1e-9);
            sum += factor;
        }
        assert_relative(sum / SAMPLES, 1.0, 0.03);
    }
    pp_blind_release(blind);
}

/* Without glass, the result is that of the slats alone. */
static void without_glass_the_slats_remain(void **state)
{
    (void)state;
    struct pp_blind *blind = blind_of(usual, false, PP_DEVICE_INSIDE, pp_glass_none());
    struct pp_slat_cell *cell = NULL;
    struct pp_slat_light light;
    assert_int_equal(pp_slat_cell_create(&cell, &usual, NULL), PP_OK);
    pp_slat_cell_light(cell, 40.0 * PP_RAD, &light); /* the border of a cell */
    struct pp_slat_parts parts = pp_slat_cell_parts(&light);
    /* profile angle 40 degrees: tan p = -y/z */
    struct pp_vec3 in = pp_vec_unit(pp_vec(0.6, -tan(40.0 * PP_RAD), 1.0));
    assert_relative(blind->scatter.scattered(blind, in),
                    parts.room_down + parts.room_up, 1e-3); /* means over 32 steps */
    in = pp_vec_unit(pp_vec(0.6, tan(25.0 * PP_RAD), 1.0));
    assert_near(blind->scatter.straight(blind, in),
                pp_slats_straight(&usual, -25.0 * PP_RAD), 1e-12);
    pp_slat_cell_destroy(cell);
    pp_blind_release(blind);
}

/* Between panes, light reflected from pane to pane passes the slats on its way. In the
 * tables this is scattered light, so direct light is that of two panes without this
 * reflection: a factor of 1 - r for each pane, which absorbs nothing, where r is the
 * reflectance of its two surfaces together. */
static void straight_light_between_panes_passes_each_pane_once(void **state)
{
    (void)state;
    const struct pp_slats flat = {0.025, 0.02, 0.0, 0.0, 0.0, 0.0};
    struct pp_blind *blind =
        blind_of(flat, false, PP_DEVICE_BETWEEN, pp_glass_panes(2, 1.52, 0.0));
    double surface = 0.52 / 2.52 * 0.52 / 2.52;
    double passes = (1.0 - surface) / (1.0 + surface); /* 0.918 */
    assert_near(blind->scatter.straight(blind, pp_vec(0.0, 0.0, 1.0)), passes * passes,
                1e-9);
    pp_blind_release(blind);
}

/* White slats and glass without absorption: uniform light from the room is reflected or
 * transmitted completely. The small part that passes gaps twice after reflection by the
 * glass is calculated with mean angles. */
static void white_slats_and_clear_glass_lose_nothing(void **state)
{
    (void)state;
    const struct pp_slats white = {0.025, 0.02, -35.0 * PP_RAD, 0.0, 1.0, 1.0};
    for (int position = PP_DEVICE_INSIDE; position <= PP_DEVICE_OUTSIDE; position++) {
        struct pp_blind *blind =
            blind_of(white, false, (enum pp_device_position)position,
                     pp_glass_panes(2, 1.52, 0.0));
        double passes = 0.0;
        enum { STEPS = 60 };
        for (int i = 0; i < STEPS; i++)
            for (int k = 0; k < STEPS; k++) {
                double p = asin(2.0 * (i + 0.5) / STEPS - 1.0);
                double s = ((k + 0.5) / STEPS - 0.5) * PP_PI;
                struct pp_vec3 in = pp_vec(sin(s), cos(s) * sin(p), -cos(s) * cos(p));
                passes += 2.0 * cos(s) * cos(s)
                          * (blind->scatter.straight(blind, in)
                             + blind->scatter.scattered(blind, in));
            }
        assert_near(passes / (STEPS * STEPS) + blind->scatter.reflect_room, 1.0, 0.02);
        pp_blind_release(blind);
    }
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrals_of_the_btdf_are_the_shares),
        cmocka_unit_test(samples_have_the_density_that_is_stated),
        cmocka_unit_test(without_glass_the_slats_remain),
        cmocka_unit_test(straight_light_between_panes_passes_each_pane_once),
        cmocka_unit_test(white_slats_and_clear_glass_lose_nothing),
    };
    add_tests(tests, NULL, NULL);
}
