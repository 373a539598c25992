/* test_scene_horizontal.c - illuminance of open ground from the skies of a scene. */
#include "model/light/scene_horizontal.h"

#include "tests/lib/near.h"

static const struct pp_vec3 zenith = {0.0, 0.0, 1.0};

/* Adds a distant source about `to`, with a pattern of the scene; -1: none. */
static void add_source(struct pp_scene_description *scene, struct pp_material material,
                       int pattern, struct pp_vec3 to, double half_angle_deg)
{
    struct pp_shape shape = {
        .kind = PP_SHAPE_DISTANT,
        .back_material = -1,
        .is.distant = {.direction = to, .half_angle_rad = half_angle_deg * PP_RAD}};
    material.pattern = pattern;
    assert_int_equal(
        pp_scene_description_add_material(scene, &material, &shape.material, NULL),
        PP_OK);
    assert_int_equal(pp_scene_description_add_shape(scene, &shape, NULL, NULL), PP_OK);
}

/* A uniform sky of radiance L gives pi L on the ground; a cap with a half angle of a
 * about the zenith gives pi L sin^2 a, to the 1e-3 stated in the header. Light from
 * below and the sun do not count. */
static void even_skies_give_pi_times_their_radiance(void **state)
{
    (void)state;
    const struct pp_material glow = pp_material_glow(pp_rgb(1.7, 1.1, 2.3));
    for (double half_deg = 30.0; half_deg <= 90.0; half_deg += 20.0) {
        struct pp_scene_description scene;
        pp_scene_description_init(&scene);
        add_source(&scene, glow, -1, zenith, half_deg);
        add_source(&scene, glow, -1, pp_vec(0.0, 0.0, -1.0), 90.0);
        add_source(&scene, pp_material_light(pp_rgb_grey(1e5)), -1,
                   pp_vec(0.6, 0.0, 0.8), 0.25);
        double share = pow(sin(half_deg * PP_RAD), 2.0);
        struct pp_rgb found = pp_scene_horizontal(&scene);
        assert_near(found.r, PP_PI * 1.7 * share, 2e-3 * PP_PI * 1.7);
        assert_near(found.g, PP_PI * 1.1 * share, 2e-3 * PP_PI * 1.1);
        assert_near(found.b, PP_PI * 2.3 * share, 2e-3 * PP_PI * 2.3);
        pp_scene_description_clear(&scene);
    }
}

static void without_a_sky_it_is_dark(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    assert_true(pp_rgb_is_black(pp_scene_horizontal(&scene)));
    add_source(&scene, pp_material_light(pp_rgb_grey(1e5)), -1, zenith, 0.25);
    assert_true(pp_rgb_is_black(pp_scene_horizontal(&scene)));
    pp_scene_description_clear(&scene);
}

/* The narrower of two sources in one direction is visible: a cap of 45 degrees, which
 * has half of the weight, and is three times as bright as the sky behind it. */
static void a_bright_cap_is_in_front_of_the_sky(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    add_source(&scene, pp_material_glow(pp_rgb_grey(3.0)), -1, zenith, 45.0);
    add_source(&scene, pp_material_glow(pp_rgb_grey(1.0)), -1, zenith, 90.0);
    assert_relative(pp_scene_horizontal(&scene).g, PP_PI * (0.5 * 3.0 + 0.5), 2e-3);
    pp_scene_description_clear(&scene);
}

/* Skylines are in front of the building, not on open ground: with one of 60 degrees the
 * sky gives the same Eh as without. The same holds for a sky of two sources, of which
 * the brighter is a cap. */
static void skylines_take_nothing_of_the_open_ground(void **state)
{
    (void)state;
    static const double caps_deg[] = {0.0, 45.0};
    for (int k = 0; k < 2; k++) {
        struct pp_rgb found[2];
        for (int count = 0; count < 2; count++) {
            struct pp_scene_description scene;
            struct pp_pattern sky = {
                .kind = PP_PATTERN_SKY,
                .factor = 5.3,
                .sky = pp_sky_overcast(),
                .skyline_count = count,
                .skylines = {{pp_vec(0.0, -1.0, 0.0), tan(60.0 * PP_RAD), 0.01}}};
            int pattern;
            pp_scene_description_init(&scene);
            assert_int_equal(
                pp_scene_description_add_pattern(&scene, &sky, &pattern, NULL), PP_OK);
            add_source(&scene, pp_material_glow(pp_rgb_grey(1.3)), pattern, zenith,
                       90.0);
            if (caps_deg[k] > 0.0)
                add_source(&scene, pp_material_glow(pp_rgb_grey(2.6)), pattern, zenith,
                           caps_deg[k]);
            found[count] = pp_scene_horizontal(&scene);
            pp_scene_description_clear(&scene);
        }
        assert_near(found[1].g, found[0].g, 0.0);
        /* The part above 45 degrees gives 3/7 (1/2 + 4/3 (1 - 8^-1/2)) of the overcast
         * sky. */
        double above = 3.0 / 7.0 * (0.5 + 4.0 / 3.0 * (1.0 - pow(0.5, 1.5)));
        assert_relative(found[0].g, 1.3 * 5.3 * (k ? 1.0 + above : 1.0), 2e-3);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(even_skies_give_pi_times_their_radiance),
        cmocka_unit_test(without_a_sky_it_is_dark),
        cmocka_unit_test(a_bright_cap_is_in_front_of_the_sky),
        cmocka_unit_test(skylines_take_nothing_of_the_open_ground),
    };
    add_tests(tests, NULL, NULL);
}
