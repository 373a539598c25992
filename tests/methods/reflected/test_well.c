/* test_well.c - wells of rooflights: limits, light followed ray by ray, and the
 * tracer. */
#include "methods/reflected/interior.h"
#include "methods/reflected/well.h"

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"
#include "tests/methods/box_method.h"

static const struct pp_well_shape awkward = {1.3, 0.7, 1.1, 0.5};

/* Without glass and under a uniform sky a black well transmits its form factor from end
 * to end, 0.199825 for a cube [HSM16]. The sum over directions is accurate to 1e-3. */
static void black_cube_lets_its_form_factor_through(void **state)
{
    (void)state;
    struct pp_glass none = pp_glass_none();
    struct pp_well_shape cube = {2.3, 2.3, 2.3, 0.0};
    struct pp_well_efficiency N = pp_well_efficiency(&cube, 0.0, &none);
    assert_near(N.whole, 0.199825, 1e-3);
    assert_near(N.direct, N.whole, 0.0);
    assert_near(pp_well_index(&cube), 1.0, 1e-12);
}

/* A deep black shaft transmits light only within the solid angle of its top. The zenith
 * of the overcast sky is 9/7 of its mean; glass raises the efficiency by at most 0.900
 * over 0.827, its normal over its diffuse transmittance. */
static void deep_black_shaft_shows_the_zenith(void **state)
{
    (void)state;
    struct pp_glass glass = pp_glass_clear_single(), none = pp_glass_none();
    struct pp_well_shape deep = {1.0, 1.0, 6.0, 0.0};
    double even = pp_well_efficiency(&deep, 0.0, &none).whole;
    assert_relative(even, 1.0 / (PP_PI * 36.0), 0.04);
    assert_relative(pp_well_efficiency(&deep, 2.0, &none).whole / even, 9.0 / 7.0,
                    0.02);
    double overcast = pp_well_efficiency(&deep, 2.0, &glass).whole
                      / pp_well_efficiency(&deep, 2.0, &none).whole;
    assert_true(1.0 < overcast);
    assert_true(overcast < 0.900 / 0.827);
}

/* Direction with a density proportional to the cosine to n. Rays start at random points
 * of the top and are followed from side to side; each side reflects diffusely. */
static struct pp_vec3 cosine_about(struct dice *dice, struct pp_vec3 n)
{
    double s = sqrt(between(dice, 0.0, 1.0)), phi = between(dice, 0.0, 2 * PP_PI);
    struct pp_vec3 t = fabs(n.z) > 0.5 ? pp_vec(1, 0, 0) : pp_vec(0, 0, 1);
    struct pp_vec3 u = pp_vec_cross(n, t);
    struct pp_vec3 d = pp_vec_scale(n, sqrt(1.0 - s * s));
    d = pp_vec_along(d, s * cos(phi), t);
    return pp_vec_along(d, s * sin(phi), u);
}

/* Moves p along u to the point where it leaves the box, and returns the inward normal
 * of that side. */
static struct pp_vec3 go(struct pp_vec3 *p, struct pp_vec3 u,
                         const struct pp_well_shape *box)
{
    double to[3] = {u.x > 0   ? (box->width_m - p->x) / u.x
                    : u.x < 0 ? -p->x / u.x
                              : INFINITY,
                    u.y > 0   ? (box->length_m - p->y) / u.y
                    : u.y < 0 ? -p->y / u.y
                              : INFINITY,
                    u.z > 0   ? (box->depth_m - p->z) / u.z
                    : u.z < 0 ? -p->z / u.z
                              : INFINITY};
    int axis = to[0] < to[1] ? (to[0] < to[2] ? 0 : 2) : (to[1] < to[2] ? 1 : 2);
    *p = pp_vec_along(*p, to[axis], u);
    return axis == 0   ? pp_vec(u.x > 0 ? -1 : 1, 0, 0)
           : axis == 1 ? pp_vec(0, u.y > 0 ? -1 : 1, 0)
                       : pp_vec(0, 0, u.z > 0 ? -1 : 1);
}

static double followed(const struct pp_well_shape *well, int rays)
{
    struct dice dice = {31};
    double sum = 0.0;
    for (int i = 0; i < rays; i++) {
        struct pp_vec3 p = pp_vec(between(&dice, 0.0, well->width_m),
                                  between(&dice, 0.0, well->length_m), well->depth_m);
        struct pp_vec3 normal = pp_vec(0, 0, -1);
        double light = 1.0;
        for (;;) {
            normal = go(&p, cosine_about(&dice, normal), well);
            if (fabs(normal.z) > 0.5)
                break;
            light *= well->sides;
        }
        sum += normal.z > 0.0 ? light : 0.0;
    }
    return sum / rays;
}

/* 60,000 rays: a standard error of at most 0.0015; bands and directions add 0.002. */
static void efficiency_is_that_of_rays_followed(void **state)
{
    (void)state;
    struct pp_glass none = pp_glass_none();
    const struct pp_well_shape wells[] = {
        awkward, {0.9, 0.9, 0.3, 0.8}, {1.0, 2.0, 3.0, 0.9}};
    for (int i = 0; i < 3; i++)
        assert_near(pp_well_efficiency(&wells[i], 0.0, &none).whole,
                    followed(&wells[i], 60000), 4 * 0.0015 + 0.002);
}

static void lighter_and_shallower_wells_let_more_through(void **state)
{
    (void)state;
    struct pp_glass glass = pp_glass_clear_single();
    for (double depth = 0.2; depth < 4.0; depth *= 1.9) {
        double before = 0.0;
        for (double rho = 0.0; rho < 1.0; rho += 0.23) {
            struct pp_well_shape well = {1.3, 0.7, depth, rho};
            double N = pp_well_efficiency(&well, 2.0, &glass).whole;
            assert_true(before < N);
            well.depth_m *= 1.1;
            assert_true(pp_well_efficiency(&well, 2.0, &glass).whole < N);
            before = N;
        }
    }
}

/* All light that leaves the well falls on a plane just below the ceiling. In a black
 * room the light on this plane is the light of the glass times N over its area; the
 * part N_d is sky component. Light sides also reflect light up to the glass, which
 * reflects some down again; without this N would be 0.02 lower for sides of 0.9. */
static void tracer_finds_the_same_light_below_the_well(void **state)
{
    (void)state;
    static const char *const sides[] = {"0.6", "0.9"};
    for (int i = 0; i < 2; i++) {
        struct pp_outside_light light;
        char xml[600];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='1.9' depth='1.4' height='2.6'/>"
                 "<finishes floor='0' walls='0' ceiling='%s'/>"
                 "<rooflight x='0.3' y='0.35' width='1.3' depth='0.7' reveal='0.9'/>"
                 "<working-plane height='2.599'/></room>",
                 sides[i]);
        struct pp_world *world = pp_test_lit_world(&light, xml);
        struct pp_tracer_options options = pp_test_paths(1200);
        options.average = true;
        struct pp_receiver point = pp_test_receiver(0.9, 0.7, 2.599, 0, 0, 1);
        struct pp_reading(*readings)[4] =
            pp_test_trace(world, &light, &point, 1, &options, NULL);
        const struct pp_opening *opening = &world->openings[0];
        struct pp_well_efficiency N = pp_well_of(world, &light, opening);
        double per_N = 1.3 * 0.7 * opening->glass.diffuse / (1.9 * 1.4);
        /* Horizontal glass transmits slightly more light from the overcast sky than
         * diffuse light: 1.017. */
        double exact_per_N = per_N * 1.017;
        assert_near(readings[1][PP_SC].value, N.direct * exact_per_N,
                    4 * readings[1][PP_SC].std_error + 0.006 * per_N);
        assert_near(readings[1][PP_IRC].value, (N.whole - N.direct) * exact_per_N,
                    4 * readings[1][PP_IRC].std_error + 0.006 * per_N);
        free(readings);
        pp_world_destroy(world);
    }
}

/* The foot of the well replaces the opening, with a reflectance of 0.1; the sides are
 * not included in any mean of the room. */
static void sides_are_no_part_of_the_room(void **state)
{
    (void)state;
    static const char *const depths[] = {"0", "2"};
    struct pp_interior all[2];
    for (int i = 0; i < 2; i++) {
        char xml[400];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='4' depth='3' height='2.6'/>"
                 "<rooflight x='1' y='1' width='1.3' depth='0.7' reveal='%s'/></room>",
                 depths[i]);
        struct pp_world *world = pp_test_world(xml);
        all[i] = pp_interior_all(world);
        pp_world_destroy(world);
    }
    assert_relative(all[1].area_m2, all[0].area_m2, 1e-12);
    assert_relative(all[1].reflectance, all[0].reflectance, 1e-12);
}

/* A plane of 4 by 3 m at 0.85 m below a foot at 2.6 m: four rectangles with one corner
 * directly below, atan sums of the configuration factor [HSM16]. */
static void foot_sees_the_plane_by_its_configuration_factor(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='3' height='2.6'/>"
        "<rooflight x='1.2' y='0.4' width='0.6' depth='0.8' reveal='0.5'/></room>");
    double h = 2.6 - 0.85, sum = 0.0;
    const double xs[] = {1.5, 2.5}, ys[] = {0.8, 2.2};
    for (int i = 0; i < 4; i++) {
        double x = xs[i % 2] / h, y = ys[i / 2] / h;
        double p = sqrt(1 + x * x), q = sqrt(1 + y * y);
        sum += (x / p * atan(y / p) + y / q * atan(x / q)) / (2 * PP_PI);
    }
    assert_relative(pp_well_foot_to_plane(world, &world->openings[0]), sum, 1e-12);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(black_cube_lets_its_form_factor_through),
        cmocka_unit_test(deep_black_shaft_shows_the_zenith),
        cmocka_unit_test(efficiency_is_that_of_rays_followed),
        cmocka_unit_test(lighter_and_shallower_wells_let_more_through),
        cmocka_unit_test(tracer_finds_the_same_light_below_the_well),
        cmocka_unit_test(sides_are_no_part_of_the_room),
        cmocka_unit_test(foot_sees_the_plane_by_its_configuration_factor),
    };
    add_tests(tests, NULL, NULL);
}
