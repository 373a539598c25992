/* test_pepper_pot_sky.c - dots for any sky, any slope and any receiver. */
#include "methods/pepper_pot/pepper_pot_cloud.h"
#include "methods/pepper_pot/pepper_pot_dots.h"
#include "methods/method.h"

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

/* Axes of an opening with a slope (0: horizontal) and a bearing. */
static struct pp_window_axes axes_at(double slope_rad, double bearing_rad)
{
    struct pp_vec3 level = pp_vec(sin(bearing_rad), cos(bearing_rad), 0.0);
    struct pp_vec3 zenith = pp_vec(0.0, 0.0, 1.0);
    struct pp_vec3 out =
        pp_vec_along(pp_vec_scale(zenith, cos(slope_rad)), sin(slope_rad), level);
    struct pp_vec3 along = pp_vec_cross(level, zenith);
    return (struct pp_window_axes){along, pp_vec_cross(along, out), out};
}

static struct pp_sky clear_sky(void)
{
    struct pp_sky sky;
    assert_int_equal(pp_sky_iso(&sky, 12, pp_vec_unit(pp_vec(0.28, -0.77, 0.57)), NULL),
                     PP_OK);
    return sky;
}

/* Light of a rectangle of the drawing, by the midpoints of a grid. */
static double by_grid(const struct pp_sky *sky, const struct pp_glass *glass,
                      const struct pp_window_axes *axes, struct pp_vec3 normal,
                      const double at[4])
{
    enum { STEPS = 40 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++)
        for (int j = 0; j < STEPS; j++) {
            double a = at[0] + (at[1] - at[0]) * (i + 0.5) / STEPS;
            double b = at[2] + (at[3] - at[2]) * (j + 0.5) / STEPS;
            double r = sqrt(1.0 + a * a + b * b);
            struct pp_vec3 u = pp_vec_scale(
                pp_vec_along(pp_vec_along(axes->out, a, axes->along), b, axes->up),
                1.0 / r);
            double facing = pp_vec_dot(u, normal);
            if (facing > 0.0 && u.z > 0.0)
                sum += pp_sky_luminance(sky, u) * pp_glass_transmittance(glass, 1.0 / r)
                       * facing / (r * r * r);
        }
    return sum * (at[1] - at[0]) * (at[3] - at[2]) / (STEPS * STEPS);
}

static const struct {
    bool clear;
    double slope_deg, bearing_deg;
    struct pp_vec3 normal;
} kinds[] = {{false, 0.0, 0.0, {0, 0, 1}},      {false, 37.0, 20.0, {0, 0, 1}},
             {true, 0.0, 0.0, {0, 0, 1}},       {true, 62.0, 140.0, {0, 0, 1}},
             {true, 90.0, 170.0, {0, 0, 1}},    {false, 30.0, 0.0, {0, 1, 0}},
             {true, 90.0, 100.0, {0.6, 0, 0.8}}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Counts for 800 rectangles on each diagram: no bias beyond three standard errors, and
 * a spread below 1.7 dots. */
static void counts_are_unbiased_and_close(void **state)
{
    (void)state;
    enum { WINDOWS = 800 };
    struct pp_glass glass = pp_glass_clear_single();
    for (int kind = 0; kind < KINDS; kind++) {
        struct dice dice = {(uint64_t)(71 + kind)};
        struct pp_sky sky = kinds[kind].clear ? clear_sky() : pp_sky_overcast();
        struct pp_window_axes axes =
            axes_at(kinds[kind].slope_deg * PP_RAD, kinds[kind].bearing_deg * PP_RAD);
        struct pp_pepper_pot_cloud cloud;
        assert_int_equal(pp_pepper_pot_cloud_init(&cloud, &sky, &glass, &axes,
                                                  kinds[kind].normal,
                                                  PP_PEPPER_POT_WORTH, NULL),
                         PP_OK);
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < WINDOWS; i++) {
            double a = between(&dice, -1.5, 1.0), b = between(&dice, -1.2, 0.8);
            const double at[4] = {a, a + between(&dice, 0.2, 1.2), b,
                                  b + between(&dice, 0.2, 1.2)};
            double xy[4][2] = {
                {at[0], at[2]}, {at[1], at[2]}, {at[1], at[3]}, {at[0], at[3]}};
            struct pp_ring ring = {4, xy};
            struct pp_region region = {1, &ring};
            double off = pp_pepper_pot_cloud_count(&cloud, &region)
                         - by_grid(&sky, &glass, &axes, kinds[kind].normal, at)
                               / PP_PEPPER_POT_WORTH;
            sum += off;
            squares += off * off;
        }
        double mean = sum / WINDOWS, spread = sqrt(squares / WINDOWS);
        assert_near(mean, 0.0, 3.0 * spread / sqrt(WINDOWS) + 0.02);
        assert_true(spread < 1.7);
        pp_pepper_pot_cloud_clear(&cloud);
    }
}

/* Without glass an infinite horizontal opening shows 100 % of any sky, a vertical one
 * 50 % of the uniform sky. With glass the published diagram has 316 dots, and that for
 * horizontal glass 849. */
static void boundless_openings_hold_all_dots(void **state)
{
    (void)state;
    struct pp_glass none = pp_glass_none(), glass = pp_glass_clear_single();
    struct pp_sky clear = clear_sky(), overcast = pp_sky_overcast(),
                  uniform = pp_sky_uniform();
    const struct pp_vec3 up = {0, 0, 1};
    const struct {
        const struct pp_sky *sky;
        const struct pp_glass *glass;
        double slope_deg, whole;
    } cases[] = {{&clear, &none, 0.0, 1.0},
                 {&overcast, &none, 0.0, 1.0},
                 {&uniform, &none, 90.0, 0.5},
                 {&overcast, &glass, 90.0, 0.31628},
                 {&overcast, &glass, 0.0, 0.8486}};
    for (int i = 0; i < 5; i++) {
        struct pp_window_axes axes = axes_at(cases[i].slope_deg * PP_RAD, 0.0);
        struct pp_pepper_pot_cloud cloud;
        assert_int_equal(pp_pepper_pot_cloud_init(&cloud, cases[i].sky, cases[i].glass,
                                                  &axes, up, PP_PEPPER_POT_WORTH, NULL),
                         PP_OK);
        assert_near(cloud.whole, cases[i].whole, 6e-4);
        assert_near(cloud.count, 1000.0 * cases[i].whole, 1.0);
        pp_pepper_pot_cloud_clear(&cloud);
    }
}

/* A room with a window and a roof window under a clear sky, receivers facing up and
 * tilted: counts differ from `exact` by a few dots. */
static void rooms_under_a_clear_sky_are_near_to_exact(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><sky type='iso-12' sun-altitude='35' "
                "sun-bearing='160'/><plan width='5.3' depth='7.1' height='3.4'/>"
                "<window wall='south' left='0.7' sill='0.9' width='3.7' height='2.1'/>"
                "<rooflight x='2.1' y='4.7' width='1.6' depth='1.1'/></room>");
    const struct pp_vec3 normals[] = {{0, 0, 1}, {0, -0.6, 0.8}};
    for (int k = 0; k < 2; k++) {
        const struct pp_method *methods[2] = {&pp_method_pepper_pot_sky,
                                              &pp_method_exact};
        const struct pp_receiver receiver = {{2.4, 3.9, 0.85}, normals[k], 0, 0.0};
        double sky[2] = {0};
        for (int m = 0; m < 2; m++) {
            void *tools = NULL;
            if (methods[m]->prepare)
                assert_int_equal(methods[m]->prepare(&tools, world, &light, NULL),
                                 PP_OK);
            for (int i = 0; i < 2; i++) {
                struct pp_part part = {0};
                assert_int_equal(methods[m]->evaluate(world, &light,
                                                      &world->openings[i], &receiver,
                                                      tools, &part, NULL),
                                 PP_OK);
                sky[m] += part.sky;
            }
            methods[m]->destroy_tools(tools);
        }
        assert_true(sky[1] > 0.02);
        assert_near(sky[0], sky[1], 3.5 * PP_PEPPER_POT_WORTH);
    }
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(counts_are_unbiased_and_close),
        cmocka_unit_test(boundless_openings_hold_all_dots),
        cmocka_unit_test(rooms_under_a_clear_sky_are_near_to_exact),
    };
    add_tests(tests, NULL, NULL);
}
