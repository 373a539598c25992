/* test_pane_light.c - light through windows from tables, compared with quadrature over
 * the window, a simple sum over its area, closed forms and limits. */
#include "tests/lib/dice.h"
#include "tests/lib/near.h"

#include <stdlib.h>

#include "methods/fast/pane_light.h"
#include "methods/exact/quadrature.h"
#include "methods/exact/solid_angle.h"

static const struct pp_vec3 zenith = {0.0, 0.0, 1.0};

/* A rectangle seen from a point through a pane, as input for the tables. */
struct window {
    struct pp_visible visible;
    struct pp_visible_patch patch;
    struct pp_ring ring;
    double corners[4][2];
};

/* Axes of a pane with a slope, 0 up and pi/2 vertical, and a bearing. */
static struct pp_projection axes_of(double slope, double bearing)
{
    struct pp_vec3 out = {sin(slope) * cos(bearing), sin(slope) * sin(bearing),
                          cos(slope)};
    struct pp_vec3 along = {sin(bearing), -cos(bearing), 0.0};
    struct pp_projection axes = {
        .along = along, .up = pp_vec_cross(out, along), .toward = out};
    axes.up = pp_vec_scale(axes.up, -1.0);
    if (axes.up.z < 0.0) {
        axes.up = pp_vec_scale(axes.up, -1.0);
        axes.along = pp_vec_scale(along, -1.0);
    }
    return axes;
}

/* `window` must not move afterwards. */
static void set_window(struct window *window, struct pp_projection axes, double left,
                       double right, double low, double high, double distance)
{
    const double corners[4][2] = {
        {left, low}, {right, low}, {right, high}, {left, high}};
    memcpy(window->corners, corners, sizeof corners);
    window->ring = (struct pp_ring){4, window->corners};
    window->patch = (struct pp_visible_patch){.region = {1, &window->ring}};
    axes.distance_m = distance;
    window->visible.view = axes;
}

/* A sky, a pane and the receiver's normal, with the tables for them. */
struct lighting {
    struct pp_sky sky;
    struct pp_glass glass;
    struct pp_vec3 toward, normal;
    struct pp_axial_table glass_table, gradation_table;
    struct pp_sky_table *sky_table;
    struct pp_pane_light light;
    struct pp_vec3 limits[2];
};

static double transmittance_at(const void *glass, double c)
{
    return pp_glass_transmittance(glass, c);
}

static double gradation_at(const void *sky, double z)
{
    return pp_sky_table_gradation(sky, z);
}

/* The caller frees the result, with its sky table. */
static struct lighting *lighting_of(struct pp_sky sky, struct pp_glass glass,
                                    const struct pp_projection *axes,
                                    struct pp_vec3 normal)
{
    struct lighting *made = calloc(1, sizeof *made);
    assert_non_null(made);
    made->sky = sky;
    made->glass = glass;
    made->toward = axes->toward;
    made->normal = normal;
    made->limits[0] = normal;
    made->limits[1] = zenith;
    bool iso = sky.kind == PP_SKY_ISO, glazed = glass.panes > 0;
    if (glazed) {
        pp_axial_table_init(&made->glass_table, transmittance_at, &made->glass);
        made->light.glass = &made->glass_table;
    }
    if (iso && !glazed && !pp_sky_has_azimuth(&sky)) {
        pp_axial_table_init(&made->gradation_table, gradation_at, &made->sky);
        made->light.gradation = &made->gradation_table;
    } else if (iso) {
        assert_int_equal(pp_sky_table_create(&made->sky_table, &made->sky, &made->glass,
                                             axes, normal, NULL),
                         PP_OK);
        made->light.sky = made->sky_table;
    }
    return made;
}

static void destroy_lighting(struct lighting *lighting)
{
    pp_sky_table_destroy(lighting->sky_table);
    free(lighting);
}

static struct pp_pane_part part_of(const struct lighting *lighting,
                                   const struct window *window, bool rough)
{
    return (struct pp_pane_part){.visible = &window->visible,
                                 .patch = &window->patch,
                                 .normal = lighting->normal,
                                 .half_spaces = lighting->limits,
                                 .half_space_count = 2,
                                 .glazed = lighting->glass.panes > 0,
                                 .rough = rough};
}

static double by_tables(const struct lighting *lighting, const struct window *window,
                        bool rough)
{
    struct pp_pane_part part = part_of(lighting, window, rough);
    assert_true(pp_pane_light_has_sky(&lighting->light, &lighting->sky, &part));
    double value;
    assert_int_equal(
        pp_pane_light_sky(&value, &lighting->light, &lighting->sky, &part, NULL),
        PP_OK);
    return value;
}

/* Luminance times transmittance. */
static double luminance_at(const void *context, struct pp_vec3 u)
{
    const struct lighting *lighting = context;
    return pp_sky_luminance(&lighting->sky, u)
           * pp_glass_transmittance(&lighting->glass, pp_vec_dot(lighting->toward, u));
}

static double by_quadrature(const struct lighting *lighting,
                            const struct window *window, double relative_error)
{
    struct pp_integrand integrand = {
        luminance_at, lighting,
        pp_sky_has_azimuth(&lighting->sky) ? &lighting->sky.sun : NULL, 0.0};
    struct pp_quadrature result;
    assert_int_equal(pp_quadrature_over(&result, &window->visible.view,
                                        &window->patch.region, lighting->limits, 2,
                                        lighting->normal, &integrand, relative_error,
                                        NULL),
                     PP_OK);
    return result.value;
}

/* Sum over `steps` squared parts of the window: the luminance at the centre of each
 * part times the solid angle of the part. */
static double by_plain_sum(const struct lighting *lighting, const struct window *window,
                           int steps)
{
    const struct pp_projection *view = &window->visible.view;
    double low[2] = {window->corners[0][0], window->corners[0][1]};
    double wide = (window->corners[2][0] - low[0]) / steps;
    double high = (window->corners[2][1] - low[1]) / steps;
    double sum = 0.0, d = view->distance_m;
    for (int i = 0; i < steps; i++)
        for (int k = 0; k < steps; k++) {
            struct pp_vec3 own =
                pp_vec(low[0] + (i + 0.5) * wide, low[1] + (k + 0.5) * high, d);
            double length = pp_vec_length(own);
            struct pp_vec3 u =
                pp_projection_to_room(view, pp_vec_scale(own, 1.0 / length));
            sum += luminance_at(lighting, u)
                   * fmax(0.0, pp_vec_dot(lighting->normal, u)) * d * wide * high
                   / (length * length * length);
        }
    return sum;
}

/* ---- random windows ---- */

static struct pp_vec3 any_direction(struct dice *dice)
{
    double z = between(dice, -1.0, 1.0), azimuth = between(dice, 0.0, 2.0 * PP_PI);
    double across = sqrt(1.0 - z * z);
    return pp_vec(across * cos(azimuth), across * sin(azimuth), z);
}

static struct pp_sky iso_sky(int type, struct pp_vec3 sun)
{
    struct pp_sky sky;
    sun.z = fabs(sun.z);
    assert_int_equal(pp_sky_iso(&sky, type, sun, NULL), PP_OK);
    return sky;
}

static struct pp_glass any_glass(struct dice *dice)
{
    switch ((int)between(dice, 0.0, 4.0)) {
    case 0:
        return pp_glass_clear_single();
    case 1:
        return pp_glass_panes(2, 1.52, 0.03);
    case 2:
        return pp_glass_panes(1, 1.52, 0.0005);
    default:
        return pp_glass_of_normal(3, 1.6, 0.05, 0.5);
    }
}

static struct pp_vec3 any_normal(struct dice *dice)
{
    struct pp_vec3 tilted = any_direction(dice);
    return one_in(dice, 2) ? zenith : tilted;
}

static void deal_window(struct window *window, struct pp_projection axes,
                        struct dice *dice)
{
    double left = between(dice, -3.0, 2.0), low = between(dice, -2.0, 1.5);
    double right = left + between(dice, 0.3, 3.0);
    double high = low + between(dice, 0.3, 2.5);
    double distance = exp(between(dice, log(0.02), log(8.0)));
    set_window(window, axes, left, right, low, high, distance);
}

static struct pp_projection any_axes(struct dice *dice)
{
    double slope = one_in(dice, 2) ? PP_PI / 2.0 : between(dice, 0.0, 2.5);
    return axes_of(slope, between(dice, 0.0, 2.0 * PP_PI));
}

/* The target of the quadrature is a relative error of 1e-11. */
static void edges_give_the_light_through_glass_to_1e9_of_the_open_sky(void **state)
{
    (void)state;
    struct dice dice = {2026};
    double worst = 0.0, worst_rough = 0.0;
    for (int i = 0; i < 2000; i++) {
        struct pp_projection axes = any_axes(&dice);
        struct lighting *lighting =
            lighting_of(one_in(&dice, 3) ? pp_sky_uniform() : pp_sky_overcast(),
                        any_glass(&dice), &axes, any_normal(&dice));
        struct window window;
        deal_window(&window, axes, &dice);
        double expected = by_quadrature(lighting, &window, 1e-11);
        worst = fmax(worst, fabs(by_tables(lighting, &window, false) - expected));
        worst_rough =
            fmax(worst_rough, fabs(by_tables(lighting, &window, true) - expected));
        destroy_lighting(lighting);
    }
    print_message("# worst %.2g, rough %.2g\n", worst, worst_rough);
    assert_true(worst <= 1e-9);
    assert_true(worst_rough <= 1e-6);
}

/* A gradation about the zenith; the target of the quadrature is 1e-11, as above. */
static void edges_give_a_sky_without_sun_to_1e9_of_the_open_sky(void **state)
{
    (void)state;
    static const int types[3] = {1, 3, 5};
    struct dice dice = {1969};
    double worst = 0.0;
    for (int i = 0; i < 300; i++) {
        struct pp_projection axes = any_axes(&dice);
        struct lighting *lighting = lighting_of(
            iso_sky(types[i % 3], zenith), pp_glass_none(), &axes, any_normal(&dice));
        struct window window;
        deal_window(&window, axes, &dice);
        worst = fmax(worst, fabs(by_tables(lighting, &window, false)
                                 - by_quadrature(lighting, &window, 1e-11)));
        destroy_lighting(lighting);
    }
    print_message("# worst %.2g\n", worst);
    assert_true(worst <= 1e-9);
}

/* Largest and root mean square error of 1,020 windows under 30 skies of all types, with
 * any position of the sun; a third of the windows are unglazed. The quadrature is a
 * hundred times more accurate than its target of 1e-5. */
static void errors_of_tables(double *worst, double *rms, bool facing_up, uint64_t seed)
{
    struct dice dice = {seed};
    double squares = 0.0;
    *worst = 0.0;
    for (int i = 0; i < 30; i++) {
        struct pp_projection axes = any_axes(&dice);
        struct pp_sky sky = iso_sky(1 + i % 15, any_direction(&dice));
        struct pp_glass glass = any_glass(&dice);
        struct pp_vec3 normal = any_direction(&dice);
        if (one_in(&dice, 3) && pp_sky_has_azimuth(&sky))
            glass = pp_glass_none();
        struct lighting *lighting =
            lighting_of(sky, glass, &axes, facing_up ? zenith : normal);
        for (int k = 0; k < 34; k++) {
            struct window window;
            deal_window(&window, axes, &dice);
            double error = fabs(by_tables(lighting, &window, true)
                                - by_quadrature(lighting, &window, 1e-5));
            *worst = fmax(*worst, error);
            squares += error * error;
        }
        destroy_lighting(lighting);
    }
    *rms = sqrt(squares / (30.0 * 34.0));
    print_message("# %s worst %.2g, rms %.2g\n", facing_up ? "up" : "tilted", *worst,
                  *rms);
}

static void a_sky_table_is_within_1e6_of_the_open_sky_on_a_plane(void **state)
{
    (void)state;
    double worst, rms;
    errors_of_tables(&worst, &rms, true, 171);
    assert_true(worst <= 1e-6);
    assert_true(rms <= 1e-7);
}

/* On planes that face a low sun, and may receive more light than under an unobstructed
 * horizontal sky, the errors are up to 1e-5 for iso-14 and iso-15, the skies with the
 * steepest gradient at the horizon. */
static void a_sky_table_is_within_1e5_on_tilted_planes(void **state)
{
    (void)state;
    double worst, rms;
    errors_of_tables(&worst, &rms, false, 172);
    assert_true(worst <= 1e-5);
    assert_true(rms <= 3e-7);
}

/* ---- compared with a simple sum, which does not use edges ---- */

/* The error of 400 x 400 steps, proportional to the squared step and the second
 * derivatives, is below 3e-6 for these cases. */
static void check_by_plain_sum(const char *what, struct pp_sky sky,
                               struct pp_glass glass, struct pp_projection axes,
                               struct pp_vec3 normal, const double window[4],
                               double distance)
{
    struct window seen;
    struct lighting *lighting = lighting_of(sky, glass, &axes, normal);
    set_window(&seen, axes, window[0], window[1], window[2], window[3], distance);
    double value = by_tables(lighting, &seen, true);
    double sum = by_plain_sum(lighting, &seen, 400);
    destroy_lighting(lighting);
    if (!(fabs(value - sum) <= 3e-6 && sum > 1e-3))
        fail_msg("%s: %.9f by edges, %.9f by a plain sum", what, value, sum);
}

static struct pp_vec3 direction_of(double altitude, double azimuth)
{
    return pp_vec(cos(altitude) * cos(azimuth), cos(altitude) * sin(azimuth),
                  sin(altitude));
}

static void a_plain_sum_over_the_window_gives_the_same(void **state)
{
    (void)state;
    const struct pp_glass single = pp_glass_clear_single(), none = pp_glass_none();
    const struct pp_glass two = pp_glass_panes(2, 1.52, 0.03);
    const struct pp_projection wall = axes_of(PP_PI / 2.0, 0.7);
    const struct pp_projection roof = axes_of(0.35, 2.1), flat = axes_of(0.0, 0.4);
    const struct pp_vec3 tilted = pp_vec_unit(pp_vec(0.5, 0.8, 0.6));
    const double above[4] = {-0.7, 1.9, 0.3, 2.2}, to_horizon[4] = {-0.8, 1.1, 0, 1.7};
    const double overhead[4] = {-0.9, 1.3, -1.2, 0.8}, aside[4] = {1.7, 3.9, 0.1, 1.6};
    /* The sun is visible through the window: its azimuth is near that of the wall's
     * normal, its altitude low. */
    const struct pp_sky facing = iso_sky(12, direction_of(0.6, 0.6));
    const struct pp_sky high = iso_sky(15, direction_of(1.4, 2.0));
    const struct pp_sky at_horizon = iso_sky(13, direction_of(0.0, 0.75));
    const struct pp_sky behind = iso_sky(14, direction_of(0.8, 0.7 + PP_PI));
    check_by_plain_sum("overcast", pp_sky_overcast(), single, wall, zenith, above, 1.3);
    check_by_plain_sum("zenith inside", pp_sky_overcast(), two, flat, zenith, overhead,
                       0.9);
    check_by_plain_sum("sun inside", facing, single, wall, zenith, above, 1.3);
    check_by_plain_sum("sun inside, unglazed", facing, none, wall, zenith, above, 1.3);
    check_by_plain_sum("sun and zenith inside", high, two, roof, zenith, overhead, 0.8);
    check_by_plain_sum("rooflight", high, none, flat, zenith, overhead, 1.1);
    check_by_plain_sum("sun on the sill and the horizon", at_horizon, single, wall,
                       zenith, to_horizon, 1.2);
    check_by_plain_sum("sun behind", behind, two, wall, zenith, to_horizon, 1.2);
    check_by_plain_sum("tilted receiver", facing, single, wall, tilted, above, 1.3);
    check_by_plain_sum("aside", iso_sky(9, direction_of(0.3, 1.9)), single, wall,
                       tilted, aside, 1.4);
    check_by_plain_sum("without sun", iso_sky(3, zenith), single, roof, zenith,
                       overhead, 0.8);
}

/* ---- limits ---- */

/* An opening 2e4 times as wide as its distance misses a strip of 1e-4 at grazing
 * incidence, which is 1e-8 of the light. No other window is farther from the centre of
 * the table in all directions. With the steepest horizons, iso-14 and iso-15, in front
 * of a slope the error is 1.7e-6. */
static void an_endless_opening_shows_all_that_a_plane_gets(void **state)
{
    (void)state;
    for (int type = 2; type <= 15; type += 2) {
        struct pp_sky sky = iso_sky(type, direction_of(0.5, 0.9));
        const struct pp_projection axes[3] = {
            axes_of(0.0, 0.3), axes_of(PP_PI / 2.0, 0.7), axes_of(0.9, 4.0)};
        for (int i = 0; i < 3; i++) {
            struct lighting *lighting =
                lighting_of(sky, pp_glass_none(), &axes[i], axes[i].toward);
            struct window window;
            set_window(&window, axes[i], -1.1e4, 0.9e4, -0.8e4, 1.2e4, 0.97);
            assert_near(by_tables(lighting, &window, true),
                        pp_sky_on_plane(&sky, axes[i].toward), type < 14 ? 1e-6 : 2e-6);
            destroy_lighting(lighting);
        }
    }
}

static double all_through(const void *context, double c)
{
    (void)context, (void)c;
    return 1.0;
}

/* With a pane that transmits all light the result equals the closed form for an open
 * window, except for rounding and the error of the polynomials. */
static void a_perfect_pane_leaves_the_closed_form(void **state)
{
    (void)state;
    struct dice dice = {77};
    struct pp_sky sky = pp_sky_overcast();
    struct pp_axial_table *table = malloc(sizeof *table);
    assert_non_null(table);
    pp_axial_table_init(table, all_through, NULL);
    const struct pp_pane_light light = {.glass = table};
    for (int i = 0; i < 500; i++) {
        struct pp_projection axes = any_axes(&dice);
        struct window window;
        deal_window(&window, axes, &dice);
        struct pp_vec3 limits[2] = {any_normal(&dice), zenith}, corners[4];
        const struct pp_pane_part part = {
            &window.visible, &window.patch, limits[0], limits, 2, true, false};
        double value;
        assert_int_equal(pp_pane_light_sky(&value, &light, &sky, &part, NULL), PP_OK);
        for (int k = 0; k < 4; k++)
            corners[k] = pp_projection_to_room(
                &window.visible.view, pp_vec(window.corners[k][0], window.corners[k][1],
                                             window.visible.view.distance_m));
        struct pp_moments moments = {0};
        pp_solid_angle_add_moments(&moments, corners, 4, limits[0], limits, 2);
        assert_near(value, pp_solid_angle_sky_component(&moments, &sky), 1e-9);
    }
    free(table);
}

/* A hole is an outline in the opposite sense and subtracts its light. Two windows side
 * by side equal one window; an outline in the opposite sense gives the negative
 * value. */
static void windows_side_by_side_add_up(void **state)
{
    (void)state;
    const struct pp_projection wall = axes_of(PP_PI / 2.0, 0.7);
    struct lighting *lighting = lighting_of(iso_sky(12, direction_of(0.6, 0.6)),
                                            pp_glass_clear_single(), &wall, zenith);
    struct window whole, left, right;
    set_window(&whole, wall, -1.1, 1.7, 0.2, 1.9, 1.3);
    set_window(&left, wall, -1.1, 0.37, 0.2, 1.9, 1.3);
    set_window(&right, wall, 1.7, 0.37, 0.2, 1.9, 1.3);
    double all = by_tables(lighting, &whole, true);
    assert_near(by_tables(lighting, &left, true) - by_tables(lighting, &right, true),
                all, 1e-7 * all);
    destroy_lighting(lighting);
}

/* A sky table is valid for one plane; look-ups for other planes report that there is no
 * table. */
static void a_sky_table_is_for_its_own_plane(void **state)
{
    (void)state;
    const struct pp_projection wall = axes_of(PP_PI / 2.0, 0.7);
    struct lighting *lighting = lighting_of(iso_sky(12, direction_of(0.6, 0.6)),
                                            pp_glass_clear_single(), &wall, zenith);
    struct window window;
    set_window(&window, wall, -1.1, 1.7, 0.2, 1.9, 1.3);
    struct pp_pane_part part = part_of(lighting, &window, true);
    assert_true(pp_pane_light_has_sky(&lighting->light, &lighting->sky, &part));
    part.rough = false;
    assert_false(pp_pane_light_has_sky(&lighting->light, &lighting->sky, &part));
    part.rough = true;
    part.normal = pp_vec(0.6, 0.0, 0.8);
    assert_false(pp_pane_light_has_sky(&lighting->light, &lighting->sky, &part));
    destroy_lighting(lighting);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_give_the_light_through_glass_to_1e9_of_the_open_sky),
        cmocka_unit_test(edges_give_a_sky_without_sun_to_1e9_of_the_open_sky),
        cmocka_unit_test(a_sky_table_is_within_1e6_of_the_open_sky_on_a_plane),
        cmocka_unit_test(a_sky_table_is_within_1e5_on_tilted_planes),
        cmocka_unit_test(a_plain_sum_over_the_window_gives_the_same),
        cmocka_unit_test(an_endless_opening_shows_all_that_a_plane_gets),
        cmocka_unit_test(a_perfect_pane_leaves_the_closed_form),
        cmocka_unit_test(windows_side_by_side_add_up),
        cmocka_unit_test(a_sky_table_is_for_its_own_plane),
    };
    add_tests(tests, NULL, NULL);
}
