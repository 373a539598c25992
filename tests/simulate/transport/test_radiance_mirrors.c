/* test_radiance_mirrors.c - lamps and the sun in mirrors: their light, and the part
 * that only random paths find. */
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/unsampled.h"
#include "tests/lib/light_scenes.h"
#include "tests/lib/sampled_light.h"

/* Limit on the light that this number of paths may have missed. */
static struct pp_rgb bound_at(const struct pp_light_scene *scene, struct pp_vec3 point,
                              bool by_chance, double paths)
{
    double shares[8];
    assert_true(scene->emitter_count <= 8);
    for (int i = 0; i < scene->emitter_count; i++)
        shares[i] = pp_unsampled_probe(scene, &scene->emitters[i]);
    struct pp_unsampled unsampled = pp_unsampled_at(scene, point, by_chance, shares);
    return pp_unsampled_bound(&unsampled, true, paths);
}

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

/* A lamp above the corner of up to two mirrors, x = -0.7 and y = -0.9; or, for each
 * mirror, its images as separate lamps. */
static struct pp_light_scene *by_mirrors(int mirrors, bool as_lamps,
                                         struct pp_material mirror)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    double share = pp_rgb_luminance(mirror.gloss);
    for (int i = 0; i < (as_lamps ? 1 << mirrors : 1); i++) {
        double light = ((i & 1) ? share : 1.0) * ((i & 2) ? share : 1.0);
        double x = (i & 1) ? -1.4 - 0.6 : 0.6, y = (i & 2) ? -1.8 - 0.5 : 0.5;
        pp_test_rectangle(
            &scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(light))),
            pp_vec(x - 0.2, y - 0.2, 1.3), pp_vec(0.0, 0.4, 0.0),
            pp_vec(0.4, 0.0, 0.0));
    }
    int material = pp_test_material(&scene, mirror);
    if (!as_lamps && mirrors > 0)
        pp_test_rectangle(&scene, material, pp_vec(-0.7, -0.9, -1.0),
                          pp_vec(0.0, 8.0, 0.0), pp_vec(0.0, 0.0, 9.0));
    if (!as_lamps && mirrors > 1)
        pp_test_rectangle(&scene, material, pp_vec(-0.7, -0.9, -1.0),
                          pp_vec(0.0, 0.0, 9.0), pp_vec(8.0, 0.0, 0.0));
    return pp_test_built(&scene);
}

/* Each mirror doubles the number of lamps: one mirror shows a second lamp; a corner of
 * two mirrors shows a fourth, by both. The tolerance allows for the offset of rays from
 * surfaces. */
static void a_mirror_gives_as_much_as_a_lamp_behind_it(void **state)
{
    (void)state;
    struct pp_vec3 point = {0.2, 0.1, 0.0},
                   tilted = pp_vec_unit(pp_vec(-0.3, -0.2, 1.0));
    struct pp_material mirror = pp_material_mirror(pp_rgb_grey(0.8));
    for (int mirrors = 1; mirrors <= 2; mirrors++) {
        struct pp_light_scene *by = by_mirrors(mirrors, false, mirror);
        struct pp_light_scene *lamps = by_mirrors(mirrors, true, mirror);
        struct pp_test_mean mean = pp_test_irradiance(
            by, NULL, NULL, pp_radiance_state_defaults(), point, tilted, 256);
        struct pp_test_mean expected = pp_test_irradiance(
            lamps, NULL, NULL, pp_radiance_state_defaults(), point, tilted, 256);
        assert_relative(mean.value.g, expected.value.g, 1e-3);
        assert_true(mean.error < 5e-4 * mean.value.g);
        pp_light_scene_destroy(by);
        pp_light_scene_destroy(lamps);
    }
}

/* The sun, with a half angle of 0.2665 degrees, in a mirror of 0.8: only one random ray
 * in a hundred thousand would find it. */
static void the_sun_is_aimed_at_in_a_mirror(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_vec3 sun = pp_vec_unit(pp_vec(0.0, -0.8, 0.5));
    double half = 0.2665 * PP_PI / 180.0;
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(1e5))),
                 sun, half);
    pp_test_rectangle(
        &scene, pp_test_material(&scene, pp_material_mirror(pp_rgb_grey(0.8))),
        pp_vec(-5.0, 5.0, -5.0), pp_vec(10.0, 0.0, 0.0), pp_vec(0.0, 0.0, 10.0));
    struct pp_light_scene *made = pp_test_built(&scene);
    assert_lit(pp_test_irradiance(made, NULL, NULL, pp_radiance_state_defaults(),
                                  pp_vec(0.0, 0.0, 0.0), up, 64),
               1.8 * 1e5 * PP_PI * sin(half) * sin(half) * sun.z, 1e-3);
    assert_near(bound_at(made, pp_vec(0.0, 0.0, 0.0), false, 64).g, 0.0, 0.0);
    pp_light_scene_destroy(made);
}

/* Sun and sky in a mirror that is seen in another mirror: 0.9 times 0.8 of their
 * light. */
static void the_sun_shows_in_mirrors(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    int one = pp_test_material(&scene, pp_material_mirror(pp_rgb_grey(0.9)));
    int other = pp_test_material(&scene, pp_material_mirror(pp_rgb_grey(0.8)));
    /* A floor, and a wall that faces along -x. */
    pp_test_rectangle(&scene, one, pp_vec(-9.0, -9.0, 0.0), pp_vec(18.0, 0.0, 0.0),
                      pp_vec(0.0, 18.0, 0.0));
    pp_test_rectangle(&scene, other, pp_vec(5.0, -9.0, 0.0), pp_vec(0.0, 0.0, 18.0),
                      pp_vec(0.0, 18.0, 0.0));
    struct pp_vec3 sun = pp_vec_unit(pp_vec(-0.6, 0.1, 0.5));
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(1e6))),
                 sun, 0.2665 * PP_RAD);
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_glow(pp_rgb_grey(3.0))),
                 up, PP_PI / 2.0);
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_vec3 eye = {0.3, 0.2, 1.5};
    /* Mirrored in the floor and in the wall, the direction of the sun is reversed in
     * both coordinates. */
    struct pp_vec3 to = {-sun.x, sun.y, -sun.z};
    struct pp_test_mean mean =
        pp_test_radiance(made, NULL, pp_radiance_state_defaults(), eye, to, 4);
    assert_relative(mean.value.g, 0.9 * 0.8 * (1e6 + 3.0), 1e-9);
    to.y += 0.02; /* 1.4 degrees aside */
    mean = pp_test_radiance(made, NULL, pp_radiance_state_defaults(), eye, to, 4);
    assert_relative(mean.value.g, 0.9 * 0.8 * 3.0, 1e-9);
    pp_light_scene_destroy(made);
}

/* A glossy floor between a pane of glass and a shiny wall that reflects and scatters:
 * with random paths and with direct sampling, no light is counted twice or lost. */
static void mirrors_show_the_same_lamp_aimed_at_and_found(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_material pane = pp_material_pane(pp_rgb(0.9, 0.8, 0.4), 1.52);
    struct pp_material floor = pp_material_plastic(pp_rgb_grey(0.5), 0.3, 0.3, 0.3);
    struct pp_material shiny = pp_material_plastic(pp_rgb_grey(0.5), 0.4, 0.0, 0.0);
    pp_test_rectangle(&scene, pp_test_material(&scene, floor), pp_vec(-4.0, -4.0, 0.0),
                      pp_vec(8.0, 0.0, 0.0), pp_vec(0.0, 8.0, 0.0));
    pp_test_rectangle(&scene, pp_test_material(&scene, pane), pp_vec(-1.1, -4.0, 0.0),
                      pp_vec(0.0, 8.0, 0.0), pp_vec(0.0, 0.0, 3.0));
    pp_test_rectangle(&scene, pp_test_material(&scene, shiny), pp_vec(1.3, -4.0, 0.0),
                      pp_vec(0.0, 0.0, 3.0), pp_vec(0.0, 8.0, 0.0));
    pp_test_rectangle(
        &scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(1.0))),
        pp_vec(-0.4, -0.4, 1.9), pp_vec(0.0, 0.8, 0.0), pp_vec(0.8, 0.0, 0.0));
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_vec3 point = {0.2, 0.3, 0.7};
    struct pp_vec3 to = pp_vec_unit(pp_vec(0.7, 0.2, 0.1));
    struct pp_test_mean sampled =
        pp_test_irradiance(made, NULL, NULL, options, point, to, 1024);
    options.sources = false;
    struct pp_test_mean found =
        pp_test_irradiance(made, NULL, NULL, options, point, to, 8192);
    assert_near(sampled.value.g, found.value.g,
                4.0 * hypot(sampled.error, found.error));
    assert_true(sampled.error < 0.5 * found.error);
    assert_true(found.error < 0.01 * found.value.g);
    pp_light_scene_destroy(made);
}

/* Light left to random paths is reported: three reflections in two mirrors, one in a
 * ball, a small luminous surface. */
static void what_mirrors_may_hide_is_known(void **state)
{
    (void)state;
    struct pp_vec3 point = {0.2, 0.1, 0.0};
    struct pp_light_scene *corner =
        by_mirrors(2, false, pp_material_mirror(pp_rgb_grey(0.8)));
    /* A lamp of 0.16 m2 and radiance 1, seen along (0.4, 0.4, 1.3). */
    double solid = 0.16 / (0.16 + 0.16 + 1.69);
    assert_relative(bound_at(corner, point, false, 10).g, 0.8 * 0.8 * 0.8 * solid,
                    1e-9);
    assert_relative(bound_at(corner, point, false, 1000000).g, PP_PI / 1e6, 1e-9);
    /* The lamp itself, if it is not sampled directly. */
    assert_relative(bound_at(corner, point, true, 10).g, solid, 1e-9);
    pp_light_scene_destroy(corner);

    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_shape ball = {
        .kind = PP_SHAPE_SPHERE,
        .material = pp_test_material(&scene, pp_material_mirror(pp_rgb_grey(0.6))),
        .back_material = -1,
        .is.sphere = {pp_vec(1.0, 1.0, 1.0), 0.3}};
    assert_int_equal(pp_scene_description_add_shape(&scene, &ball, NULL, NULL), PP_OK);
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(7.0))),
                 up, 0.01);
    struct pp_light_scene *made = pp_test_built(&scene);
    assert_relative(bound_at(made, point, false, 1).g,
                    0.6 * 7.0 * 4.0 * PP_PI * sin(0.005) * sin(0.005), 1e-9);
    pp_light_scene_destroy(made);

    struct pp_light_scene *glow =
        pp_test_under_square(pp_material_glow(pp_rgb_grey(1e6)), 0.005, 3.0);
    assert_relative(bound_at(glow, point, false, 2048).g, PP_PI * 1e6 / 2048.0, 1e-9);
    pp_light_scene_destroy(glow);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mirror_gives_as_much_as_a_lamp_behind_it),
        cmocka_unit_test(the_sun_is_aimed_at_in_a_mirror),
        cmocka_unit_test(the_sun_shows_in_mirrors),
        cmocka_unit_test(mirrors_show_the_same_lamp_aimed_at_and_found),
        cmocka_unit_test(what_mirrors_may_hide_is_known),
    };
    add_tests(tests, NULL, NULL);
}
