/* test_radiance_rough.c - physically rough surfaces in simulated scenes: paths find the
 * same light as quadrature, with any kind of sampling. */
#include "tests/lib/light_scenes.h"
#include "tests/lib/sampled_light.h"
#include "tests/lib/sized.h"
#include "tests/model/light/towards.h"

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

static struct pp_rough_optics copper(double s0, double t)
{
    return (struct pp_rough_optics){
        {0.21, 1.04, 1.18}, {3.67, 2.59, 2.40}, {0.65, 0.55, 0.45}, s0, t,
        {0.0, 0.0, 0.0}};
}

/* A large sheet of the surface, under a light. */
struct rough_scene {
    struct pp_rough_surface surface;
    struct pp_light_scene *scene;
};

static struct rough_scene *sheet(struct pp_rough_optics optics, struct pp_material sky,
                                 struct pp_vec3 to, double half_angle_rad)
{
    static struct rough_scene made;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    assert_int_equal(pp_rough_surface_init(&made.surface, &optics, NULL), PP_OK);
    pp_test_rectangle(
        &scene, pp_test_material(&scene, pp_material_rough(&made.surface)),
        pp_vec(-90.0, -90.0, 0.0), pp_vec(180.0, 0.0, 0.0), pp_vec(0.0, 180.0, 0.0));
    pp_test_dome(&scene, pp_test_material(&scene, sky), to, half_angle_rad);
    made.scene = pp_test_built(&scene);
    return &made;
}

/* Radiance of the middle of the sheet, seen from this direction. */
static struct pp_test_mean seen(const struct rough_scene *made, double tilt_deg,
                                bool sources, uint32_t paths)
{
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_vec3 eye = pp_vec_scale(pp_test_towards(tilt_deg, 21.0), 2.0);
    options.sources = sources;
    return pp_test_radiance(made->scene, NULL, options, eye, pp_vec_scale(eye, -1.0),
                            paths);
}

/* Under a uniform sky the sheet has its albedo in each channel: with spike and lobe,
 * with the spike alone, with the lobe alone; to the 0.6 % of the tables. */
static void under_a_uniform_sky_a_sheet_has_its_albedo(void **state)
{
    (void)state;
    const double surfaces[][2] = {{0.05, 3.0}, {0.002, 3.0}, {0.28, 1.77}, {3.0, 15.0}};
    const double tilts[] = {8.0, 51.0, 79.0};
    for (int i = 0; i < 4; i++) {
        struct rough_scene *made = sheet(copper(surfaces[i][0], surfaces[i][1]),
                                         pp_material_glow(pp_rgb_grey(1.0)), up, PP_PI);
        for (int k = 0; k < 3; k++) {
            double cosine = cos(tilts[k] * PP_RAD);
            struct pp_rgb albedo =
                pp_rgb_add(pp_rough_surface_spike(&made->surface, cosine),
                           pp_rough_surface_lobe(&made->surface, cosine));
            struct pp_test_mean mean = seen(made, tilts[k], true, 32);
            assert_near(mean.value.r, albedo.r, 0.01 * albedo.r);
            assert_near(mean.value.g, albedo.g, 0.01 * albedo.g);
            assert_near(mean.value.b, albedo.b, 0.01 * albedo.b);
        }
        pp_light_scene_destroy(made->scene);
    }
}

/* Light of a round source by quadrature over its cone, including the spike if the
 * mirror direction is in the cone. */
static double cone_light(const struct rough_scene *made, double tilt_deg,
                         double sun_tilt_deg, double half_angle_rad)
{
    enum { RINGS = 100, SPOKES = 100 };
    struct pp_vec3 eye = pp_test_towards(tilt_deg, 21.0),
                   sun = pp_test_towards(sun_tilt_deg, 201.0);
    struct pp_vec3 a = pp_test_towards(sun_tilt_deg + 90.0, 201.0),
                   b = pp_vec_cross(sun, a);
    double sum = 0.0, step = half_angle_rad / RINGS;
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < SPOKES; k++) {
            double t = (i + 0.5) * step, p = 2.0 * PP_PI * (k + 0.5) / SPOKES;
            struct pp_vec3 to = pp_vec_along(
                pp_vec_along(pp_vec_scale(sun, cos(t)), sin(t) * cos(p), a),
                sin(t) * sin(p), b);
            sum += pp_rough_surface_value(&made->surface, eye, to).g * fmax(to.z, 0.0)
                   * sin(t) * step * 2.0 * PP_PI / SPOKES;
        }
    if (fabs(tilt_deg - sun_tilt_deg) * PP_RAD < half_angle_rad)
        sum += pp_rough_surface_spike(&made->surface, eye.z).g;
    return sum;
}

/* A source with a half angle of 5 degrees, in and beside the mirror direction: sampled
 * as a source and by the lobe, or by the lobe and the spike alone. */
static void a_sheet_shows_a_source_as_quadrature_does(void **state)
{
    (void)state;
    const double half = 5.0 * PP_RAD;
    const uint32_t paths = PP_SIZED(256, 64, 64);
    for (int i = 0; i < 4; i++) {
        double s0 = i < 2 ? 0.05 : 0.28, sun = i % 2 ? 41.0 : 58.0;
        struct rough_scene *made =
            sheet(copper(s0, 3.0), pp_material_light(pp_rgb_grey(1.0)),
                  pp_test_towards(sun, 201.0), half);
        double expected = cone_light(made, 43.0, sun, half);
        struct pp_test_mean sampled = seen(made, 43.0, true, paths);
        struct pp_test_mean found = seen(made, 43.0, false, 4 * paths);
        assert_near(sampled.value.g, expected, 0.004 * expected + 4.0 * sampled.error);
        assert_near(found.value.g, expected, 0.004 * expected + 4.0 * found.error);
        assert_true(sampled.error < 0.02 * expected);
        pp_light_scene_destroy(made->scene);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(under_a_uniform_sky_a_sheet_has_its_albedo),
        cmocka_unit_test(a_sheet_shows_a_source_as_quadrature_does),
    };
    add_tests(tests, NULL, NULL);
}
