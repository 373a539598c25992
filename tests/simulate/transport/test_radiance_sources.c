/* test_radiance_sources.c - light of skies, suns and lamps of every shape compared with
 * its closed form, sampled directly and found by random paths. */
#include "tests/lib/light_scenes.h"
#include "tests/lib/sampled_light.h"

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

/* ---- skies ---- */

/* A dome of a pattern, or of radiance 1 without one. */
static struct pp_light_scene *under_sky(const struct pp_pattern *pattern)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_material glow = pp_material_glow(pp_rgb_grey(1.0));
    if (pattern)
        assert_int_equal(
            pp_scene_description_add_pattern(&scene, pattern, &glow.pattern, NULL),
            PP_OK);
    pp_test_dome(&scene, pp_test_material(&scene, glow), up, PP_PI / 2.0);
    return pp_test_built(&scene);
}

static struct pp_test_mean under(const struct pp_pattern *pattern,
                                 struct pp_vec3 normal)
{
    struct pp_light_scene *scene = under_sky(pattern);
    struct pp_test_mean mean =
        pp_test_irradiance(scene, NULL, NULL, pp_radiance_state_defaults(),
                           pp_vec(1.3, 2.7, 0.4), normal, 1024);
    pp_light_scene_destroy(scene);
    return mean;
}

/* Closed forms: pi, and 7 pi/9. The tolerance is the target error, 0.05 %, with 32768
 * rays. */
static void unit_skies_light_a_horizontal_plane_by_pi_and_seven_ninths_of_it(
    void **state)
{
    (void)state;
    assert_relative(under(NULL, up).value.g, 3.141593, 5e-4);
    /* Lz / Eh of the overcast sky is 9/(7 pi): with this factor Lz is 1. */
    struct pp_pattern overcast = {
        .kind = PP_PATTERN_SKY, .factor = 7.0 * PP_PI / 9.0, .sky = pp_sky_overcast()};
    assert_relative(under(&overcast, up).value.g, 2.443461, 5e-4);
    /* A vertical plane receives half of a uniform sky, and 0.396177 of the overcast
     * sky. */
    struct pp_vec3 aside = {0.6, -0.8, 0.0};
    assert_lit(under(NULL, aside), PP_PI / 2.0, 2e-3);
    assert_lit(under(&overcast, aside), 0.396177 * 7.0 * PP_PI / 9.0, 2e-3);
}

static void the_smaller_of_two_domes_is_visible(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    int dim = pp_test_material(&scene, pp_material_glow(pp_rgb_grey(1.0)));
    int bright = pp_test_material(&scene, pp_material_glow(pp_rgb_grey(5.0)));
    double half = 20.0 * PP_RAD;
    pp_test_dome(&scene, bright, up, half);
    pp_test_dome(&scene, dim, up, PP_PI / 2.0);
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_test_mean mean =
        pp_test_irradiance(made, NULL, NULL, pp_radiance_state_defaults(),
                           pp_vec(0.0, 0.0, 0.0), up, 2048);
    assert_lit(mean, PP_PI * (1.0 + 4.0 * sin(half) * sin(half)), 2e-3);
    pp_light_scene_destroy(made);
}

/* ---- square lamps ---- */

/* E = pi L F, sampled directly or found by random paths. Direct sampling with a
 * hundredth of the rays has a smaller error. */
static void a_square_lamp_gives_its_form_factor_as_light_and_as_glow(void **state)
{
    (void)state;
    double a = 0.35, h = 2.3, radiance = 120.0;
    double expected = PP_PI * radiance * pp_test_square_factor(a, h);
    struct pp_rgb colour = pp_rgb(1.5 * radiance, radiance, 0.5 * radiance);
    struct pp_light_scene *light =
        pp_test_under_square(pp_material_light(colour), a, h);
    struct pp_light_scene *glow = pp_test_under_square(pp_material_glow(colour), a, h);
    struct pp_vec3 point = {0.0, 0.0, 0.0};
    struct pp_radiance_options one = pp_radiance_state_defaults();
    one.source_size = 0.0;
    struct pp_test_mean sampled =
        pp_test_irradiance(light, NULL, NULL, one, point, up, 16);
    struct pp_test_mean found =
        pp_test_irradiance(glow, NULL, NULL, one, point, up, 4096);
    assert_near(sampled.value.g, expected, 4.0 * sampled.error);
    assert_near(found.value.g, expected, 4.0 * found.error);
    assert_relative(sampled.value.r, 1.5 * sampled.value.g, 1e-12);
    assert_true(sampled.error < found.error);
    assert_true(sampled.rays * 100 < found.rays);
    /* With direct sampling switched off, a light is treated like a glow: the same
     * paths, the same numbers. */
    one.sources = false;
    struct pp_test_mean off =
        pp_test_irradiance(light, NULL, NULL, one, point, up, 4096);
    assert_near(off.value.g, found.value.g, 1e-9 * expected);
    pp_light_scene_destroy(light);
    pp_light_scene_destroy(glow);
}

static void the_back_of_a_lamp_is_dark(void **state)
{
    (void)state;
    struct pp_light_scene *scene =
        pp_test_under_square(pp_material_light(pp_rgb_grey(7.0)), 0.4, -1.1);
    struct pp_test_mean mean =
        pp_test_irradiance(scene, NULL, NULL, pp_radiance_state_defaults(),
                           pp_vec(0.0, 0.0, 0.0), pp_vec(0.0, 0.0, -1.0), 16);
    assert_near(mean.value.g, 0.0, 0.0);
    assert_near(pp_test_radiance(scene, NULL, pp_radiance_state_defaults(),
                                 pp_vec(0.0, 0.0, 0.0), pp_vec(0.0, 0.0, -1.0), 1)
                    .value.g,
                0.0, 0.0);
    assert_near(pp_test_radiance(scene, NULL, pp_radiance_state_defaults(),
                                 pp_vec(0.0, 0.0, -2.0), up, 1)
                    .value.g,
                7.0, 0.0);
    pp_light_scene_destroy(scene);
}

/* A sheet with a lamp in front and a black back, below a glossy surface that faces the
 * back: nothing is sampled directly, and the list of emitters is not read beyond its
 * end (which sanitizers would detect). */
static void a_lamp_that_is_black_behind_is_one_emitter(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_material gloss = pp_material_plastic(pp_rgb_grey(0.0), 0.9, 0.2, 0.2);
    pp_test_rectangle(&scene, pp_test_material(&scene, gloss), pp_vec(-3.0, -3.0, 2.0),
                      pp_vec(0.0, 6.0, 0.0), pp_vec(6.0, 0.0, 0.0));
    pp_test_rectangle(
        &scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(1.0))),
        pp_vec(-1.0, -1.0, -1.0), pp_vec(0.0, 2.0, 0.0), pp_vec(2.0, 0.0, 0.0));
    scene.shapes[1].back_material =
        pp_test_material(&scene, pp_material_light(pp_rgb_grey(0.0)));
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_vec3 o = {0.0, 0.0, 0.0};
    assert_near(
        pp_test_irradiance(made, NULL, NULL, pp_radiance_state_defaults(), o, up, 64)
            .value.g,
        0.0, 0.0);
    /* Form factor of the front, from 1 m. */
    assert_lit(pp_test_irradiance(made, NULL, NULL, pp_radiance_state_defaults(),
                                  pp_vec(0.0, 0.0, -2.0), up, 64),
               PP_PI * pp_test_square_factor(1.0, 1.0), 0.01);
    pp_light_scene_destroy(made);
}

/* Radiance's illum: it lights other surfaces but is invisible. */
static void an_unseen_lamp_lights_but_does_not_show(void **state)
{
    (void)state;
    struct pp_material air = pp_material_air();
    air.emits = PP_EMITS_CONCENTRATED;
    air.radiance = pp_rgb_grey(3.0);
    air.unseen = true;
    double a = 0.4, h = 1.3;
    struct pp_light_scene *scene = pp_test_under_square(air, a, h);
    struct pp_vec3 o = {0.0, 0.0, 0.0};
    double expected = 3.0 * PP_PI * pp_test_square_factor(a, h);
    assert_lit(
        pp_test_irradiance(scene, NULL, NULL, pp_radiance_state_defaults(), o, up, 64),
        expected, 0.01);
    assert_near(
        pp_test_radiance(scene, NULL, pp_radiance_state_defaults(), o, up, 1).value.g,
        0.0, 0.0);
    pp_light_scene_destroy(scene);
}

/* Beyond the first surface one of a hundred lamps is chosen at random: the sum is that
 * of one lamp of their total size. */
static void many_lamps_give_as_much_as_one_of_their_size(void **state)
{
    (void)state;
    double seen[2];
    for (int many = 0; many < 2; many++) {
        struct pp_scene_description scene;
        pp_scene_description_init(&scene);
        pp_test_box(&scene,
                    pp_test_material(&scene, pp_material_diffuse(pp_rgb_grey(0.6))),
                    2.0, 3.0, 2.5);
        int lamp = pp_test_material(&scene, pp_material_light(pp_rgb_grey(1.0)));
        int side = many ? 10 : 1;
        for (int i = 0; i < side * side; i++)
            pp_test_rectangle(&scene, lamp,
                              pp_vec(0.5 + (i % side) / (double)side,
                                     1.0 + (i / side) / (double)side, 2.4),
                              pp_vec(0.0, 1.0 / side, 0.0),
                              pp_vec(1.0 / side, 0.0, 0.0));
        struct pp_light_scene *made = pp_test_built(&scene);
        struct pp_test_mean mean =
            pp_test_irradiance(made, NULL, NULL, pp_radiance_state_defaults(),
                               pp_vec(0.9, 1.1, 0.8), pp_vec(0.0, 0.0, 1.0), 256);
        assert_true(mean.error < 0.003 * mean.value.g);
        seen[many] = mean.value.g;
        pp_light_scene_destroy(made);
    }
    /* Four standard errors, each of at most 0.3 %. */
    assert_relative(seen[1], seen[0], 0.017);
}

/* ---- other lamps ---- */

static struct pp_light_scene *under_lamp(struct pp_shape lamp,
                                         struct pp_material material)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    lamp.material = pp_test_material(&scene, material);
    lamp.back_material = -1;
    assert_int_equal(pp_scene_description_add_shape(&scene, &lamp, NULL, NULL), PP_OK);
    return pp_test_built(&scene);
}

static struct pp_test_mean lit_by(struct pp_shape lamp, struct pp_vec3 normal,
                                  bool direct, uint32_t paths)
{
    struct pp_light_scene *scene =
        under_lamp(lamp, pp_material_light(pp_rgb_grey(1.0)));
    struct pp_radiance_options options = pp_radiance_state_defaults();
    options.sources = direct;
    struct pp_test_mean mean = pp_test_irradiance(
        scene, NULL, NULL, options, pp_vec(0.0, 0.0, 0.0), pp_vec_unit(normal), paths);
    pp_light_scene_destroy(scene);
    return mean;
}

/* A ball entirely above the horizon: pi (r/d)^2 cos, as if all light came from its
 * centre. */
static void a_ball_shines_as_from_its_middle(void **state)
{
    (void)state;
    struct pp_shape ball = {.kind = PP_SHAPE_SPHERE,
                            .is.sphere = {pp_vec(0.4, 0.3, 1.2), 0.5}};
    struct pp_vec3 normal = pp_vec_unit(pp_vec(0.3, 0.0, 1.0));
    double expected =
        PP_PI * 0.25 / 1.69
        * pp_vec_dot(normal, pp_vec_scale(ball.is.sphere.centre, 1.0 / 1.3));
    assert_lit(lit_by(ball, normal, true, 64), expected, 1e-3);
    assert_lit(lit_by(ball, normal, false, 2048), expected, 5e-3);
    /* A small distant ball is sampled without loss of digits. */
    ball.is.sphere.centre = pp_vec(0.0, 0.0, 1e6);
    assert_relative(lit_by(ball, up, true, 4).value.g, PP_PI * 0.25e-12, 1e-6);
    /* Inside an inward-facing sphere all directions are lit. */
    ball = (struct pp_shape){.kind = PP_SHAPE_SPHERE,
                             .inward = true,
                             .is.sphere = {pp_vec(0.4, 0.3, 1.2), 2.0}};
    assert_lit(lit_by(ball, normal, true, 256), PP_PI, 5e-3);
}

/* Above the middle of a disc: pi r^2/(r^2 + h^2); a ring is one disc less another. */
static void a_ring_shines_as_one_disc_less_another(void **state)
{
    (void)state;
    double h = 1.7, inner = 0.6, outer = 1.1;
    struct pp_shape ring = {
        .kind = PP_SHAPE_RING,
        .is.ring = {pp_vec(0.0, 0.0, h), pp_vec(0.0, 0.0, -1.0), {inner, outer}}};
    double expected = PP_PI
                      * (outer * outer / (outer * outer + h * h)
                         - inner * inner / (inner * inner + h * h));
    assert_lit(lit_by(ring, up, true, 64), expected, 1e-3);
    assert_lit(lit_by(ring, up, false, 1024), expected, 5e-3);
}

/* No closed form: direct sampling and random paths must agree. */
static void a_cone_shines_the_same_aimed_at_and_found(void **state)
{
    (void)state;
    struct pp_shape cone = {
        .kind = PP_SHAPE_CONE,
        .is.cone = {{pp_vec(0.3, -0.8, 1.0), pp_vec(0.5, 0.9, 1.6)}, {0.2, 0.45}}};
    struct pp_test_mean sampled = lit_by(cone, up, true, 256);
    struct pp_test_mean found = lit_by(cone, up, false, 8192);
    assert_near(sampled.value.g, found.value.g,
                4.0 * hypot(sampled.error, found.error));
    assert_true(found.error < 2e-3 && sampled.value.g > 0.3);
}

/* A cone of directions about w gives pi L sin^2(half) cos(w, n). */
static void the_sun_gives_its_solid_angle(void **state)
{
    (void)state;
    double half = 0.2665 * PP_RAD;
    struct pp_vec3 sun = pp_vec_unit(pp_vec(0.5, -0.4, 0.6));
    struct pp_shape shape = {.kind = PP_SHAPE_DISTANT, .is.distant = {sun, half}};
    double expected = PP_PI * sin(half) * sin(half) * sun.z;
    /* Over its disc the cosine varies by its angle, 0.005: 1e-4 with 128 directions. */
    assert_relative(lit_by(shape, up, true, 4).value.g, expected, 1e-4);
    shape.is.distant.half_angle_rad = 25.0 * PP_RAD;
    expected = PP_PI * sin(25.0 * PP_RAD) * sin(25.0 * PP_RAD) * sun.z;
    assert_lit(lit_by(shape, up, true, 64), expected, 1e-3);
    assert_lit(lit_by(shape, up, false, 2048), expected, 5e-3);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            unit_skies_light_a_horizontal_plane_by_pi_and_seven_ninths_of_it),
        cmocka_unit_test(the_smaller_of_two_domes_is_visible),
        cmocka_unit_test(a_square_lamp_gives_its_form_factor_as_light_and_as_glow),
        cmocka_unit_test(the_back_of_a_lamp_is_dark),
        cmocka_unit_test(a_lamp_that_is_black_behind_is_one_emitter),
        cmocka_unit_test(an_unseen_lamp_lights_but_does_not_show),
        cmocka_unit_test(many_lamps_give_as_much_as_one_of_their_size),
        cmocka_unit_test(a_ball_shines_as_from_its_middle),
        cmocka_unit_test(a_ring_shines_as_one_disc_less_another),
        cmocka_unit_test(a_cone_shines_the_same_aimed_at_and_found),
        cmocka_unit_test(the_sun_gives_its_solid_angle),
    };
    add_tests(tests, NULL, NULL);
}
