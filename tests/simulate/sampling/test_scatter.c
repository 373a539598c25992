/* test_scatter.c - scattering at a surface: the shares of its lobes and their
 * directions. */
#include "simulate/sampling/scatter.h"

#include "tests/lib/near.h"
#include "tests/model/light/towards.h"

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

static struct pp_lobes lobes_of(const struct pp_material *material, struct pp_vec3 eye)
{
    static struct pp_gloss gloss;
    const double *roughness = material->roughness;
    bool rough = !pp_gloss_is_mirror(roughness[0], roughness[1]);
    if (rough)
        assert_int_equal(pp_gloss_init(&gloss, roughness[0], roughness[1], NULL),
                         PP_OK);
    struct pp_lobes lobes;
    pp_scatter_init(&lobes, material, rough ? &gloss : NULL, up, eye);
    return lobes;
}

/* A brushed gloss in world coordinates does not depend on the axes used for its
 * table. */
static void a_gloss_follows_its_grain(void **state)
{
    (void)state;
    struct pp_material metal = pp_material_metal(pp_rgb(0.8, 0.7, 0.5), 1.0, 0.05, 0.2);
    metal.grain = pp_vec(0.0, 2.0, 1.0);
    struct pp_vec3 eye = pp_test_towards(52.0, 100.0);
    struct pp_lobes lobes = lobes_of(&metal, eye);
    assert_near(lobes.frame.x.y, 1.0, 1e-12);
    assert_near(lobes.frame.y.x, -1.0, 1e-12);
    assert_true(pp_rgb_is_black(lobes.share[PP_LOBE_DIFFUSE]));

    struct pp_vec3 o = pp_test_towards(47.0, 275.0);
    double value = pp_gloss_value(lobes.gloss, pp_vec(eye.y, -eye.x, eye.z),
                                  pp_vec(o.y, -o.x, o.z));
    assert_relative(pp_scatter_gloss_brdf(&lobes, o).r, 0.8 * value, 1e-12);
    assert_relative(pp_scatter_gloss_brdf(&lobes, o).b, 0.5 * value, 1e-12);

    struct pp_rgb factor;
    struct pp_vec3 drawn, in_frame;
    assert_true(pp_scatter_sample(&lobes, PP_LOBE_GLOSS, 0.3, 0.6, &drawn, &factor));
    assert_relative(
        factor.g,
        pp_gloss_sample(lobes.gloss, pp_vec(eye.y, -eye.x, eye.z), 0.3, 0.6, &in_frame),
        1e-12);
    assert_near(
        pp_vec_length(pp_vec_sub(drawn, pp_vec(-in_frame.y, in_frame.x, in_frame.z))),
        0.0, 1e-12);
}

static void a_smooth_gloss_is_a_mirror(void **state)
{
    (void)state;
    struct pp_material mirror = pp_material_mirror(pp_rgb(0.9, 0.8, 0.7));
    struct pp_lobes lobes = lobes_of(&mirror, pp_test_towards(33.0, 60.0));
    struct pp_vec3 o;
    struct pp_rgb factor;
    assert_true(pp_scatter_sample(&lobes, PP_LOBE_MIRROR, 0.1, 0.2, &o, &factor));
    struct pp_vec3 expected = pp_test_towards(33.0, 240.0);
    assert_near(pp_vec_length(pp_vec_sub(o, expected)), 0.0, 1e-12);
    assert_near(lobes.share[PP_LOBE_MIRROR].b, 0.7, 0.0);
    assert_true(pp_rgb_is_black(lobes.share[PP_LOBE_GLOSS]));
}

/* Clear glass absorbs the light that it neither reflects nor transmits; a lossless pane
 * absorbs nothing. A frame and dirt absorb their shares. */
static void glass_divides_light_by_its_law(void **state)
{
    (void)state;
    struct pp_material pane = pp_material_pane(pp_rgb(1.0, 0.9, 0.5), 1.52);
    for (double tilt = 0.0; tilt < 90.0; tilt += 8.9) {
        struct pp_lobes lobes = lobes_of(&pane, pp_test_towards(tilt, 5.0));
        struct pp_rgb sum =
            pp_rgb_add(lobes.share[PP_LOBE_MIRROR], lobes.share[PP_LOBE_STRAIGHT]);
        assert_near(sum.r, 1.0, 1e-12);
        assert_true(sum.g < 0.95 && sum.b < sum.g);
    }
    /* At normal incidence rho = (0.52/2.52)^2, tau = (1 - rho)^2 t / (1 - rho^2
     * t^2). */
    double rho = 0.52 / 2.52 * (0.52 / 2.52);
    struct pp_lobes lobes = lobes_of(&pane, up);
    assert_near(lobes.share[PP_LOBE_STRAIGHT].g,
                (1.0 - rho) * (1.0 - rho) * 0.9 / (1.0 - rho * rho * 0.81), 1e-12);

    struct pp_glass clear = pp_glass_clear_single();
    struct pp_material framed = pp_material_glazing(&clear, 0.7, 0.8, 0.5);
    lobes = lobes_of(&framed, up);
    assert_near(lobes.share[PP_LOBE_STRAIGHT].g, clear.normal * 0.7 * 0.8, 1e-12);
    assert_near(lobes.share[PP_LOBE_DIFFUSE].g, 0.3 * 0.5, 1e-12);

    /* The frame is not a mirror: a lossless pane reflects 2 rho/(1 + rho) of the light
     * on its glass. Dirt, which is outside, does not change this. */
    struct pp_glass lossless = pp_glass_panes(1, 1.52, 0.0);
    framed = pp_material_glazing(&lossless, 0.7, 0.8, 0.5);
    lobes = lobes_of(&framed, up);
    assert_near(lobes.share[PP_LOBE_MIRROR].g, 0.7 * 2.0 * rho / (1.0 + rho), 1e-12);
}

static void translucent_panels_share_light_out_as_radiance_does(void **state)
{
    (void)state;
    /* By hand: colour 0.9, specular 0.05, transmitted 0.6, of which 0.25 is direct. */
    struct pp_material trans =
        pp_material_trans(pp_rgb_grey(0.9), 0.05, 0.0, 0.6, 0.25);
    assert_near(trans.diffuse.g, 0.9 * 0.95 * 0.4, 1e-12);
    assert_near(trans.through_diffuse.g, 0.9 * 0.95 * 0.6 * 0.75, 1e-12);
    assert_near(trans.through_gloss.g, 0.9 * 0.95 * 0.6 * 0.25, 1e-12);
    struct pp_lobes lobes = lobes_of(&trans, pp_test_towards(20.0, 0.0));
    assert_near(lobes.share[PP_LOBE_STRAIGHT].g, trans.through_gloss.g, 0.0);
    struct pp_vec3 o;
    struct pp_rgb factor;
    assert_true(
        pp_scatter_sample(&lobes, PP_LOBE_THROUGH_DIFFUSE, 0.4, 0.7, &o, &factor));
    assert_true(o.z < 0.0);
    /* With roughness, transmitted light spreads like the gloss, on the other side. */
    trans = pp_material_trans(pp_rgb_grey(0.9), 0.05, 0.2, 0.6, 0.25);
    lobes = lobes_of(&trans, pp_test_towards(20.0, 0.0));
    struct pp_vec3 above = pp_test_towards(25.0, 170.0), below = above;
    below.z = -below.z;
    assert_relative(pp_scatter_gloss_brdf(&lobes, below).g / trans.through_gloss.g,
                    pp_scatter_gloss_brdf(&lobes, above).g / trans.gloss.g, 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gloss_follows_its_grain),
        cmocka_unit_test(a_smooth_gloss_is_a_mirror),
        cmocka_unit_test(glass_divides_light_by_its_law),
        cmocka_unit_test(translucent_panels_share_light_out_as_radiance_does),
    };
    add_tests(tests, NULL, NULL);
}
