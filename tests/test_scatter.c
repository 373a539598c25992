/* test_scatter.c - where light goes from a surface: energy, reciprocity, and directions
 * drawn as their densities say. */
#include "simulate/scatter.h"

#include "simulate/hash.h"
#include "tests/near.h"

static const struct pp_vec3 up = {0.0, 0.0, 1.0};

static struct pp_lobes lobes_of(const struct pp_material *material, struct pp_vec3 eye)
{
    struct pp_lobes lobes;
    pp_lobes_init(&lobes, material, up, eye);
    return lobes;
}

static struct pp_vec3 towards(double tilt_deg, double azimuth_deg)
{
    double t = tilt_deg * PP_RAD, a = azimuth_deg * PP_RAD;
    return pp_vec(sin(t) * cos(a), sin(t) * sin(a), cos(t));
}

static double random_of(uint64_t seed, uint64_t part)
{
    return ((double)(pp_hash(seed, part) >> 11) + 0.5) * 0x1p-53;
}

static const double roughnesses[][2] = {
    {0.02, 0.02}, {0.1, 0.1}, {0.3, 0.3}, {0.07, 0.25}, {0.6, 0.9}};
enum { ROUGHNESSES = sizeof roughnesses / sizeof *roughnesses };

static struct pp_material gloss_of(int i)
{
    struct pp_material metal =
        pp_material_metal(pp_rgb_grey(1.0), 1.0, roughnesses[i][0], roughnesses[i][1]);
    metal.grain = pp_vec(1.0, 0.3, 0.0);
    return metal;
}

/* The albedo, by directions drawn on a grid of side x side. */
static double albedo(const struct pp_lobes *lobes, int side)
{
    double sum = 0.0;
    for (int i = 0; i < side; i++)
        for (int k = 0; k < side; k++) {
            struct pp_vec3 o;
            double factor, u = (i + 0.5) / side, v = (k + 0.5) / side;
            if (pp_lobes_sample(lobes, PP_LOBE_GLOSS, u, v, &o, &factor))
                sum += factor / (side * side);
        }
    return sum;
}

/* [GMD10]: the albedo is bounded, up to grazing incidence, where Ward's own form grows
 * without limit. 40,000 directions give it to 0.002. */
static void a_gloss_never_gives_back_more_than_it_gets(void **state)
{
    (void)state;
    const double tilts[] = {0.0, 30.0, 60.0, 80.0, 85.0, 88.0, 89.5, 89.99};
    for (int i = 0; i < ROUGHNESSES; i++)
        for (size_t k = 0; k < sizeof tilts / sizeof *tilts; k++) {
            struct pp_material metal = gloss_of(i);
            struct pp_lobes lobes = lobes_of(&metal, towards(tilts[k], 37.0));
            assert_true(albedo(&lobes, 200) <= 1.002);
        }
    /* Hardly rough, it gives back nearly all. */
    struct pp_material metal = gloss_of(0);
    struct pp_lobes lobes = lobes_of(&metal, towards(40.0, 11.0));
    assert_near(albedo(&lobes, 200), 1.0, 0.002);
}

/* Light may run either way. To rounding. */
static void light_may_run_either_way(void **state)
{
    (void)state;
    for (int i = 0; i < ROUGHNESSES; i++)
        for (int k = 0; k < 40; k++) {
            double r[4];
            for (int j = 0; j < 4; j++)
                r[j] = random_of(7, (uint64_t)(4 * k + j));
            struct pp_vec3 a = towards(89.0 * r[0], 360.0 * r[1]);
            struct pp_vec3 b = towards(89.0 * r[2], 360.0 * r[3]);
            struct pp_material metal = gloss_of(i);
            struct pp_lobes there = lobes_of(&metal, a), back = lobes_of(&metal, b);
            double f = pp_lobes_gloss(&there, b).g;
            assert_relative(f, pp_lobes_gloss(&back, a).g, 1e-9);
        }
}

/* Two routes to the albedo: by drawn directions, and by integrating f over the
 * hemisphere on a fine grid (midpoints, 1 degree by 1.25; to 0.5 %). */
static void directions_are_drawn_as_the_lobe_is_shaped(void **state)
{
    (void)state;
    for (int i = 2; i < ROUGHNESSES; i++) {
        struct pp_material metal = gloss_of(i);
        struct pp_lobes lobes = lobes_of(&metal, towards(50.0, 20.0));
        double sum = 0.0, step = PP_PI / 720.0;
        for (int t = 0; t < 360; t++)
            for (int a = 0; a < 720; a++) {
                double tilt = (t + 0.5) * step, azimuth = (a + 0.5) * 2.0 * step;
                struct pp_vec3 o = towards(tilt / PP_RAD, azimuth / PP_RAD);
                sum +=
                    pp_lobes_gloss(&lobes, o).g * o.z * sin(tilt) * 2.0 * step * step;
            }
        assert_near(albedo(&lobes, 400), sum, 0.005);
    }
}

/* Along the grain the brush leaves the surface smooth: slopes there are as the first
 * roughness, across it as the second. RMS of a_x r cos is a_x / sqrt 2. */
static void a_brushed_metal_spreads_light_across_its_grain(void **state)
{
    (void)state;
    struct pp_material metal = pp_material_metal(pp_rgb_grey(0.8), 1.0, 0.02, 0.2);
    metal.grain = pp_vec(0.0, 2.0, 1.0);
    struct pp_lobes lobes = lobes_of(&metal, up);
    double along = 0.0, across = 0.0;
    enum { COUNT = 20000 };
    for (int i = 0; i < COUNT; i++) {
        struct pp_vec3 o;
        double factor, u = random_of(13, (uint64_t)i), v = random_of(17, (uint64_t)i);
        if (!pp_lobes_sample(&lobes, PP_LOBE_GLOSS, u, v, &o, &factor))
            continue;
        struct pp_vec3 h = pp_add(o, up);
        along += h.y * h.y / (h.z * h.z) / COUNT;
        across += h.x * h.x / (h.z * h.z) / COUNT;
    }
    assert_relative(sqrt(along), 0.02 / sqrt(2.0), 0.02);
    assert_relative(sqrt(across), 0.2 / sqrt(2.0), 0.02);
}

static void a_smooth_gloss_is_a_mirror(void **state)
{
    (void)state;
    struct pp_material mirror = pp_material_mirror(pp_rgb(0.9, 0.8, 0.7));
    struct pp_lobes lobes = lobes_of(&mirror, towards(33.0, 60.0));
    struct pp_vec3 o;
    double factor;
    assert_true(pp_lobes_sample(&lobes, PP_LOBE_MIRROR, 0.1, 0.2, &o, &factor));
    struct pp_vec3 expected = towards(33.0, 240.0);
    assert_near(pp_length(pp_sub(o, expected)), 0.0, 1e-12);
    assert_near(lobes.share[PP_LOBE_MIRROR].b, 0.7, 0.0);
    assert_true(pp_rgb_is_black(lobes.share[PP_LOBE_GLOSS]));
}

/* Clear glass: what is not reflected or let through is absorbed; of a lossless pane
 * nothing is. A frame and dirt take their shares. */
static void glass_shares_light_out_as_its_law_says(void **state)
{
    (void)state;
    struct pp_material pane = pp_material_pane(pp_rgb(1.0, 0.9, 0.5), 1.52);
    for (double tilt = 0.0; tilt < 90.0; tilt += 8.9) {
        struct pp_lobes lobes = lobes_of(&pane, towards(tilt, 5.0));
        struct pp_rgb sum =
            pp_rgb_add(lobes.share[PP_LOBE_MIRROR], lobes.share[PP_LOBE_STRAIGHT]);
        assert_near(sum.r, 1.0, 1e-12);
        assert_true(sum.g < 0.95 && sum.b < sum.g);
    }
    /* At normal incidence rho = (0.52/2.52)^2, tau = (1 - rho)^2 t / (1 - rho^2 t^2).
     */
    double rho = 0.52 / 2.52 * (0.52 / 2.52);
    struct pp_lobes lobes = lobes_of(&pane, up);
    assert_near(lobes.share[PP_LOBE_STRAIGHT].g,
                (1.0 - rho) * (1.0 - rho) * 0.9 / (1.0 - rho * rho * 0.81), 1e-12);

    struct pp_glass clear = pp_glass_clear_single();
    struct pp_material framed = pp_material_glazing(&clear, 0.7, 0.8, 0.5);
    lobes = lobes_of(&framed, up);
    assert_near(lobes.share[PP_LOBE_STRAIGHT].g, clear.normal * 0.7 * 0.8, 1e-12);
    assert_near(lobes.share[PP_LOBE_DIFFUSE].g, 0.3 * 0.5, 1e-12);
}

static void translucent_panels_share_light_out_as_radiance_does(void **state)
{
    (void)state;
    /* By hand: 0.9 colour, 0.05 specular, 0.6 through, 0.25 of that straight. */
    struct pp_material trans =
        pp_material_trans(pp_rgb_grey(0.9), 0.05, 0.0, 0.6, 0.25);
    assert_near(trans.diffuse.g, 0.9 * 0.95 * 0.4, 1e-12);
    assert_near(trans.through_diffuse.g, 0.9 * 0.95 * 0.6 * 0.75, 1e-12);
    assert_near(trans.through_gloss.g, 0.9 * 0.95 * 0.6 * 0.25, 1e-12);
    struct pp_lobes lobes = lobes_of(&trans, towards(20.0, 0.0));
    assert_near(lobes.share[PP_LOBE_STRAIGHT].g, trans.through_gloss.g, 0.0);
    struct pp_vec3 o;
    double factor;
    assert_true(
        pp_lobes_sample(&lobes, PP_LOBE_THROUGH_DIFFUSE, 0.4, 0.7, &o, &factor));
    assert_true(o.z < 0.0);
    /* Rough, what goes through spreads as the gloss does, on the other side. */
    trans = pp_material_trans(pp_rgb_grey(0.9), 0.05, 0.2, 0.6, 0.25);
    lobes = lobes_of(&trans, towards(20.0, 0.0));
    struct pp_vec3 above = towards(25.0, 170.0), below = above;
    below.z = -below.z;
    assert_relative(pp_lobes_gloss(&lobes, below).g / trans.through_gloss.g,
                    pp_lobes_gloss(&lobes, above).g / trans.gloss.g, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gloss_never_gives_back_more_than_it_gets),
        cmocka_unit_test(light_may_run_either_way),
        cmocka_unit_test(directions_are_drawn_as_the_lobe_is_shaped),
        cmocka_unit_test(a_brushed_metal_spreads_light_across_its_grain),
        cmocka_unit_test(a_smooth_gloss_is_a_mirror),
        cmocka_unit_test(glass_shares_light_out_as_its_law_says),
        cmocka_unit_test(translucent_panels_share_light_out_as_radiance_does),
    };
    return cmocka_run_group_tests_name("scatter", tests, NULL, NULL);
}
