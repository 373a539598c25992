/* test_radiance_surfaces.c - reflection and transmission by surfaces: energy is
 * conserved, also with a limited number of reflections. */
#include "tests/lib/light_scenes.h"
#include "tests/lib/sampled_light.h"
#include "tests/lib/sized.h"

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

/* ---- furnaces ---- */

/* Inside a closed box that emits 1 - rho and reflects rho, with any lobes, the radiance
 * is 1 everywhere. */
static struct pp_test_mean furnace(struct pp_material material, double reflectance,
                                   struct pp_vec3 to)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    material.emits = PP_EMITS_EXTENDED;
    material.radiance = pp_rgb_grey(1.0 - reflectance);
    pp_test_box(&scene, pp_test_material(&scene, material), 1.7, 2.3, 1.1);
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_test_mean mean =
        pp_test_radiance(made, NULL, pp_radiance_state_defaults(),
                         pp_vec(0.6, 0.9, 0.4), to, PP_SIZED(64, 32, 16));
    pp_light_scene_destroy(made);
    return mean;
}

static void a_closed_white_box_neither_gains_nor_loses_light(void **state)
{
    (void)state;
    const double noise = PP_SIZED(1.0, 1.5, 3.0); /* as with 16 paths, of 64 */
    struct pp_vec3 to = {0.3, 0.5, -0.4};
    assert_lit(furnace(pp_material_diffuse(pp_rgb_grey(0.7)), 0.7, to), 1.0,
               noise * 5e-3);
    assert_lit(furnace(pp_material_mirror(pp_rgb_grey(0.8)), 0.8, to), 1.0,
               noise * 5e-3);
}

/* With roughnesses of 0.05 to 1, facing the floor, obliquely and grazing. An albedo of
 * rho (1 + e) gives 1 + e rho/(1 - rho): for rho of 0.8 the 0.3 % of gloss.h count four
 * times, less if part of the light is diffuse. With a roughness above 0.5 weights vary,
 * and paths with many reflections are noisy: 0.5. */
static void a_closed_glossy_box_neither_gains_nor_loses_light(void **state)
{
    (void)state;
    const double noise = PP_SIZED(1.0, 1.5, 3.0);
    const double roughnesses[][2] = {{0.05, 0.05}, {0.1, 0.1}, {0.2, 0.2},  {0.3, 0.3},
                                     {0.5, 0.5},   {1.0, 1.0}, {0.05, 0.2}, {0.3, 0.9}};
    const struct pp_vec3 to[] = {{0.1, 0.2, -1.0}, {0.3, 0.5, -0.4}, {1.0, 1.2, -0.5}};
    for (size_t i = 0; i < sizeof roughnesses / sizeof *roughnesses; i++)
        for (int k = 0; k < 3; k++) {
            double along = roughnesses[i][0], across = roughnesses[i][1];
            double rho = fmax(along, across) > 0.5 ? 0.5 : 0.8;
            struct pp_material metal =
                pp_material_metal(pp_rgb_grey(rho), 1.0, along, across);
            metal.grain = pp_vec(1.0, 0.3, 0.5);
            assert_lit(furnace(metal, rho, to[k]), 1.0, noise * 0.015);
            assert_lit(
                furnace(pp_material_plastic(pp_rgb_grey(0.8), 0.05, along, across),
                        0.81, to[k]),
                1.0, noise * 0.01);
        }
}

/* ---- gloss ---- */

/* A brushed sheet below a square lamp, seen obliquely. The light of a small and of a
 * large lamp is the same if the lamp is sampled directly or found by directions of the
 * gloss. */
static void a_gloss_shows_the_same_lamp_aimed_at_and_found(void **state)
{
    (void)state;
    const uint32_t paths = PP_SIZED(256, 128, 64);
    const double sizes[] = {0.05, 0.9};
    for (int i = 0; i < 2; i++) {
        struct pp_scene_description scene;
        pp_scene_description_init(&scene);
        struct pp_material metal = pp_material_metal(pp_rgb_grey(0.8), 0.7, 0.15, 0.3);
        metal.grain = pp_vec(1.0, 0.4, 0.0);
        double a = sizes[i];
        pp_test_rectangle(&scene, pp_test_material(&scene, metal),
                          pp_vec(-9.0, -9.0, 0.0), pp_vec(18.0, 0.0, 0.0),
                          pp_vec(0.0, 18.0, 0.0));
        pp_test_rectangle(
            &scene,
            pp_test_material(&scene, pp_material_light(pp_rgb_grey(1.0 / a / a))),
            pp_vec(0.7 - a, -a, 1.1), pp_vec(0.0, 2.0 * a, 0.0),
            pp_vec(2.0 * a, 0.0, 0.0));
        struct pp_light_scene *made = pp_test_built(&scene);
        struct pp_radiance_options options = pp_radiance_state_defaults();
        struct pp_vec3 eye = {-0.9, 0.1, 1.3}, at = {0.9, -0.1, -1.3};
        struct pp_test_mean sampled =
            pp_test_radiance(made, NULL, options, eye, at, paths);
        options.sources = false;
        struct pp_test_mean found =
            pp_test_radiance(made, NULL, options, eye, at, 32 * paths);
        assert_near(sampled.value.g, found.value.g,
                    4.0 * hypot(sampled.error, found.error));
        assert_true(found.error < PP_SIZED(0.03, 0.045, 0.07) * found.value.g);
        assert_true(i == 1 || sampled.error < found.error);
        pp_light_scene_destroy(made);
    }
}

/* A matt ceiling above polished metal, under a sun with a half angle of 8 degrees, or a
 * lamp. Light reflected by the metal is sampled by its gloss or found by rays of the
 * ceiling: the light is the same, sampled with less than half the error for the same
 * number of paths. */
static void metal_throws_the_same_light_sampled_and_found(void **state)
{
    (void)state;
    const uint32_t paths = PP_SIZED(512, 512, 128);
    for (int sun = 0; sun < 2; sun++) {
        struct pp_scene_description scene;
        pp_scene_description_init(&scene);
        struct pp_material metal = pp_material_metal(pp_rgb_grey(0.8), 0.9, 0.08, 0.15);
        metal.grain = pp_vec(1.0, 0.4, 0.0);
        pp_test_rectangle(&scene, pp_test_material(&scene, metal),
                          pp_vec(-1.0, -0.8, 0.0), pp_vec(1.9, 0.0, 0.0),
                          pp_vec(0.0, 1.7, 0.0));
        int light = pp_test_material(
            &scene, pp_material_light(pp_rgb(1.0, 0.8, sun ? 0.3 : 0.5)));
        if (sun)
            pp_test_dome(&scene, light, pp_vec_unit(pp_vec(0.5, 0.2, 0.8)),
                         8.0 * PP_RAD);
        else
            pp_test_rectangle(&scene, light, pp_vec(0.7, 0.2, 1.5),
                              pp_vec(0.0, 0.3, 0.0), pp_vec(0.3, 0.0, 0.0));
        struct pp_light_scene *made = pp_test_built(&scene);
        struct pp_radiance_options options = pp_radiance_state_defaults();
        struct pp_vec3 ceiling = {-0.7, -0.1, 1.3}, down = {0.0, 0.0, -1.0};
        struct pp_test_mean sampled =
            pp_test_irradiance(made, NULL, NULL, options, ceiling, down, paths);
        options.sources = false;
        struct pp_test_mean found =
            pp_test_irradiance(made, NULL, NULL, options, ceiling, down, 32 * paths);
        assert_near(sampled.value.g, found.value.g,
                    4.0 * hypot(sampled.error, found.error));
        assert_near(sampled.value.b / sampled.value.g, sun ? 0.375 : 0.625, 1e-9);
        assert_true(sampled.error < PP_SIZED(0.02, 0.02, 0.05) * sampled.value.g);
        /* 32 times the paths: the error would be six times smaller if all paths were
         * equal. */
        assert_true(sampled.error < 0.5 * sqrt(32.0) * found.error);
        pp_light_scene_destroy(made);
    }
}

/* ---- what light passes ---- */

/* Seen through a pane, and lit through it: both are multiplied by the transmittance of
 * the glass. */
static void a_lamp_shines_through_glass(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_material pane = pp_material_pane(pp_rgb(0.9, 0.8, 0.4), 1.52);
    pp_test_rectangle(&scene, pp_test_material(&scene, pane), pp_vec(-9.0, -9.0, 1.0),
                      pp_vec(18.0, 0.0, 0.0), pp_vec(0.0, 18.0, 0.0));
    double a = 0.01, h = 2.0;
    pp_test_rectangle(
        &scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(1.0))),
        pp_vec(-a, -a, h), pp_vec(0.0, 2.0 * a, 0.0), pp_vec(2.0 * a, 0.0, 0.0));
    struct pp_light_scene *made = pp_test_built(&scene);
    /* The lamp is 0.01 wide, so incidence is normal to 1e-4 of the cosine. */
    struct pp_test_mean mean = pp_test_irradiance(
        made, NULL, NULL, pp_radiance_state_defaults(), pp_vec(0.0, 0.0, 0.0), up, 16);
    double expected = 4.0 * a * a / (h * h);
    assert_relative(mean.value.r, expected * pane.glass[0].normal, 1e-3);
    assert_relative(mean.value.b, expected * pane.glass[2].normal, 1e-3);
    struct pp_test_mean seen = pp_test_radiance(
        made, NULL, pp_radiance_state_defaults(), pp_vec(0.0, 0.0, 0.0), up, 4096);
    assert_lit(seen,
               pp_rgb_luminance(pp_rgb(pane.glass[0].normal, pane.glass[1].normal,
                                       pane.glass[2].normal)),
               5e-3);
    pp_light_scene_destroy(made);
}

/* A box of translucent sheets in a white dome. The sheets emit the share that they
 * neither reflect nor transmit: in equilibrium the radiance is 1, inside and
 * outside. */
static void assert_in_equilibrium(struct pp_material trans)
{
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    trans.emits = PP_EMITS_EXTENDED;
    trans.emits_both_sides = true;
    trans.radiance = pp_rgb_grey(1.0 - (0.9 * 0.95 + 0.05));
    pp_test_box(&scene, pp_test_material(&scene, trans), 1.7, 2.3, 1.1);
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_glow(pp_rgb_grey(1.0))),
                 up, PP_PI);
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    const struct pp_vec3 from[] = {{0.6, 0.9, 0.4}, {0.6, 0.9, 4.4}, {-3.0, 0.2, 1.3}};
    const struct pp_vec3 to[] = {
        {0.3, 0.5, -0.4}, {0.03, 0.05, -1.0}, {4.0, 0.6, -0.2}};
    for (int i = 0; i < 3; i++)
        assert_lit(pp_test_radiance(made, NULL, options, from[i], to[i], 256), 1.0,
                   0.01);
    pp_light_scene_destroy(made);
}

static void translucent_sheets_neither_gain_nor_lose_light(void **state)
{
    (void)state;
    assert_in_equilibrium(pp_material_trans(pp_rgb_grey(0.9), 0.05, 0.0, 0.5, 0.3));
    assert_in_equilibrium(pp_material_trans(pp_rgb_grey(0.9), 0.05, 0.25, 0.7, 0.8));
}

/* Panes that absorb nothing cannot be distinguished from a white dome at any angle:
 * they reflect the light that they do not transmit. */
static void a_box_of_lossless_glass_is_not_to_be_seen(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    pp_test_box(&scene,
                pp_test_material(&scene, pp_material_pane(pp_rgb_grey(1.0), 1.52)), 1.7,
                2.3, 1.1);
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_glow(pp_rgb_grey(1.0))),
                 up, PP_PI);
    struct pp_light_scene *made = pp_test_built(&scene);
    const double tilts[] = {1.0, 45.0, 80.0, 87.0, 89.0, 89.9, 89.999};
    for (int i = 0; i < 7; i++) {
        double t = tilts[i] * PP_RAD;
        assert_lit(pp_test_radiance(made, NULL, pp_radiance_state_defaults(),
                                    pp_vec(-0.9, 1.1, 1.1 + 2.0 / tan(t)),
                                    pp_vec(sin(t), 0.02 * sin(t), -cos(t)), 64),
                   1.0, 1e-3);
    }
    pp_light_scene_destroy(made);
}

/* ---- bounces, and light from other estimates ---- */

/* After n reflections of 1 - rho: (1 - rho)(1 + rho + ... + rho^n) = 1 - rho^(n +
 * 1). */
static void bounces_can_be_limited(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_material grey = pp_material_diffuse(pp_rgb_grey(0.6));
    grey.emits = PP_EMITS_EXTENDED;
    grey.radiance = pp_rgb_grey(0.4);
    pp_test_box(&scene, pp_test_material(&scene, grey), 1.7, 2.3, 1.1);
    struct pp_light_scene *made = pp_test_built(&scene);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_vec3 from = {0.6, 0.9, 0.4};
    for (options.bounces = 0; options.bounces < 5; options.bounces++) {
        assert_lit(
            pp_test_radiance(made, NULL, options, from, pp_vec(0.3, 0.5, -0.4), 256),
            1.0 - pow(0.6, options.bounces + 1), 0.01);
        /* The first bounce is that of the receiver's own hemisphere. */
        assert_lit(pp_test_irradiance(made, NULL, NULL, options, from, up, 256),
                   PP_PI * (1.0 - pow(0.6, options.bounces)), 0.02);
    }
    pp_light_scene_destroy(made);
}

struct asked {
    int count, deepest;
};

static bool two(void *store, const struct pp_light_hit *hit, struct pp_vec3 normal,
                int depth, struct pp_rgb *value)
{
    struct asked *asked = store;
    assert_near(pp_vec_dot(normal, hit->normal), 1.0, 1e-12);
    assert_near(hit->point.z, 0.0, 1e-12);
    asked->count++;
    asked->deepest = depth > asked->deepest ? depth : asked->deepest;
    *value = pp_rgb_grey(2.0);
    return true;
}

/* A plane below a lamp: directly sampled light is added to the interreflected light
 * supplied by the caller. */
static void inter_reflection_may_be_had_from_elsewhere(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    pp_test_rectangle(
        &scene, pp_test_material(&scene, pp_material_diffuse(pp_rgb_grey(0.5))),
        pp_vec(-9.0, -9.0, 0.0), pp_vec(18.0, 0.0, 0.0), pp_vec(0.0, 18.0, 0.0));
    pp_test_dome(&scene, pp_test_material(&scene, pp_material_light(pp_rgb_grey(1e4))),
                 up, 1e-2);
    struct pp_light_scene *made = pp_test_built(&scene);
    struct asked asked = {0, 0};
    struct pp_ambient ambient = {two, &asked};
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    pp_sobol_init(sobol);
    struct pp_radiance_state path_state = {
        .scene = made, .options = pp_radiance_state_defaults(), .ambient = &ambient};
    pp_sobol_sequence_init(&path_state.sequence, sobol, 1);
    struct pp_light_ray down = {.from = pp_vec(0.3, 0.2, 2.0),
                                .to = pp_vec(0.0, 0.0, -1.0)};
    struct pp_light_hit hit;
    struct pp_rgb seen = pp_radiance_along(&path_state, &down, &hit);
    double direct = 1e4 * PP_PI * sin(1e-2) * sin(1e-2);
    assert_relative(seen.g, 0.5 / PP_PI * (direct + 2.0), 1e-3);
    assert_int_equal(asked.count, 1);
    assert_int_equal(asked.deepest, 0);
    assert_near(hit.distance_m, 2.0, 1e-6);
    /* Seen from a receiver's hemisphere, the estimate is used at the next surface:
     * depth 1. */
    pp_radiance_irradiance(&path_state, pp_vec(0.3, 0.2, 2.0), pp_vec(0.0, 0.0, -1.0),
                           PP_ANYWHERE);
    assert_int_equal(asked.deepest, 1);
    free(sobol);
    pp_light_scene_destroy(made);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_white_box_neither_gains_nor_loses_light),
        cmocka_unit_test(a_closed_glossy_box_neither_gains_nor_loses_light),
        cmocka_unit_test(a_gloss_shows_the_same_lamp_aimed_at_and_found),
        cmocka_unit_test(metal_throws_the_same_light_sampled_and_found),
        cmocka_unit_test(a_lamp_shines_through_glass),
        cmocka_unit_test(translucent_sheets_neither_gain_nor_lose_light),
        cmocka_unit_test(a_box_of_lossless_glass_is_not_to_be_seen),
        cmocka_unit_test(bounces_can_be_limited),
        cmocka_unit_test(inter_reflection_may_be_had_from_elsewhere),
    };
    add_tests(tests, NULL, NULL);
}
