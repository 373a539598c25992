/* test_beam_average.c - the mean over the working plane as an integral over directions,
 * compared with the mean over points by closed form and quadrature. */
#include "methods/fast/beam_average.h"

#include "methods/method.h"
#include "methods/average/plane_average.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"

struct pointwise {
    const struct pp_world *world;
    const struct pp_outside_light *light;
    const struct pp_opening *opening;
};

static bool at_point(void *data, int centre, const struct pp_receiver *receiver,
                     double values[PP_PLANE_VALUES])
{
    (void)centre;
    const struct pointwise *task = data;
    struct pp_part part = {0};
    if (pp_method_exact.evaluate(task->world, task->light, task->opening, receiver,
                                 NULL, &part, NULL)
        != PP_OK)
        return false;
    values[0] = part.sky;
    values[1] = part.external;
    return true;
}

/* Compares both means for every opening of a room. The error of the mean over points is
 * about `share` of the mean. */
static void assert_same_mean(const char *body, int points, double share)
{
    char xml[2000];
    snprintf(xml, sizeof xml, "<room version='1'>%s</room>", body);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_thread_pool *pool;
    struct pp_beams *beams;
    assert_true(world->opening_count > 0);
    assert_int_equal(pp_beams_create(&beams, world, false, NULL), PP_OK);
    assert_int_equal(pp_thread_pool_create(&pool, 1, NULL), PP_OK);
    for (int i = 0; i < world->opening_count; i++) {
        struct pointwise task = {world, &light, &world->openings[i]};
        struct pp_part part = {0};
        double mean[PP_PLANE_VALUES];
        bool stopped, known;
        const struct pp_plane_centre centre = pp_plane_centre_of(task.opening);
        assert_int_equal(pp_plane_average(mean, &stopped, world, &centre, 1, at_point,
                                          &task, 1e-5, points / 6, pool, NULL),
                         PP_OK);
        assert_false(stopped);
        assert_int_equal(pp_method_exact.average(beams, &light, task.opening, NULL,
                                                 &part, &known, NULL),
                         PP_OK);
        assert_true(known);
        double sum = mean[0] + mean[1];
        assert_true(sum > 1e-4);
        assert_near(part.sky, mean[0], share * sum);
        assert_near(part.external, mean[1], share * sum);
    }
    pp_thread_pool_destroy(pool);
    pp_beams_destroy(beams);
    pp_world_destroy(world);
}

/* Numbers of points, and the relative error of their mean. */
#define FINE PP_SIZED(5000, 1500, 1500), PP_SIZED(8e-4, 2e-3, 2e-3)
#define FINE_L PP_SIZED(5000, 1500, 1500), PP_SIZED(2e-3, 4e-3, 4e-3)
#define COARSE 1500, 2e-3

#define BOX "<plan width='4.2' depth='6' height='2.6'/>"
#define WINDOW "<window wall='south' left='0.6' sill='0.7' width='2.9' height='1.6' "

static void an_unobstructed_window_and_its_reveal(void **state)
{
    (void)state;
    assert_same_mean(BOX WINDOW "glazing='none'/>", FINE);
    assert_same_mean(BOX WINDOW "reveal='0.31'/>", FINE);
}

/* The parapet hides the lower part of the sky, the slab the upper part, and the block
 * the part between them. */
static void a_balcony_with_a_parapet_and_a_neighbour(void **state)
{
    (void)state;
    assert_same_mean(
        "<site ground-level='-9'/>" BOX WINDOW "/>"
        "<block x='0' y='-1.7' base='2.6' width='4.2' depth='1.5' height='0.25' "
        "reflectance='0.3'/>"
        "<surface reflectance='0.5'><vertex x='0' y='-1.7' z='0'/><vertex x='4.2' "
        "y='-1.7' z='0'/><vertex x='4.2' y='-1.7' z='1.1'/><vertex x='0' y='-1.7' "
        "z='1.1'/></surface>"
        "<block x='-3' y='-21' width='13' depth='6' height='19' reflectance='0.35'/>",
        COARSE);
}

static void skylines_near_and_far(void **state)
{
    (void)state;
    assert_same_mean(BOX WINDOW "/><skyline wall='south' angle='31'/>", FINE);
    assert_same_mean(BOX WINDOW "/><skyline wall='south' angle='31' distance='7.3'/>",
                     FINE);
}

/* The inner corner of an L hides each window from a part of the plane. */
static void an_l_shaped_room(void **state)
{
    (void)state;
    assert_same_mean(
        "<plan height='2.8'><vertex x='0' y='0'/><vertex x='5' y='0'/><vertex x='5' "
        "y='2'/><vertex x='2' y='2'/><vertex x='2' y='4'/><vertex x='0' y='4'/></plan>"
        "<window wall='1' left='3' sill='0.9' width='1.6' height='1.4'/>"
        "<window wall='5' left='0.4' sill='0.5' width='1.2' height='1.9'/>",
        FINE_L);
}

static void a_rooflight_under_a_block_and_a_diffusing_one(void **state)
{
    (void)state;
    assert_same_mean(BOX "<rooflight x='1.1' y='1.7' width='1.3' depth='0.9'/>"
                         "<block x='-4' y='-4' width='3' depth='9' height='8'/>",
                     COARSE);
    assert_same_mean(BOX "<rooflight x='1.1' y='1.7' width='1.3' depth='0.9' "
                         "transmittance='0.5' diffusing='yes'/>",
                     FINE);
}

/* ---- a sky that is dark but for a spot ---- */

struct spot {
    struct pp_vec3 to;
    double width_rad;
};

static double spot_luminance(const void *context, struct pp_vec3 u)
{
    const struct spot *spot = context;
    double angle = acos(fmin(1.0, pp_vec_dot(spot->to, u))) / spot->width_rad;
    return exp(-angle * angle);
}

/* All light that enters the window falls on the plane: the mean is the flux through the
 * window over the area of the plane. The spot of width s has the illuminance pi s2. The
 * first estimate for the first spot is almost 0. */
static void a_small_spot_gives_the_plane_its_flux_through_the_window(void **state)
{
    (void)state;
    const struct pp_vec3 outward = {0.0, -1.0, 0.0};
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'>" BOX "<window wall='south' left='1.1' sill='1.1' "
                "width='1.7' height='1.3'/></room>");
    static const double places[][2] = {{181.5, 42.688}, {166.0, 38.0}, {150.0, 36.0}};
    for (int i = 0; i < 3; i++) {
        double bearing = places[i][0] * PP_RAD, altitude = places[i][1] * PP_RAD;
        struct spot spot = {pp_vec(cos(altitude) * sin(bearing),
                                   cos(altitude) * cos(bearing), sin(altitude)),
                            1.0 * PP_RAD};
        const struct pp_plane_light of = {.sky = spot_luminance, .context = &spot};
        struct pp_beams *beams;
        double mean[2], s = spot.width_rad;
        assert_int_equal(pp_beams_create(&beams, world, false, NULL), PP_OK);
        assert_int_equal(pp_beam_average(mean, beams, &world->openings[0], &of,
                                         PP_BEAM_AVERAGE_ERROR, NULL),
                         PP_OK);
        assert_relative(mean[0],
                        PP_PI * s * s * pp_vec_dot(spot.to, outward) * 1.7 * 1.3
                            / (4.2 * 6.0),
                        0.01);
        pp_beams_destroy(beams);
    }
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_unobstructed_window_and_its_reveal),
        cmocka_unit_test(a_balcony_with_a_parapet_and_a_neighbour),
        cmocka_unit_test(skylines_near_and_far),
        cmocka_unit_test(an_l_shaped_room),
        cmocka_unit_test(a_rooflight_under_a_block_and_a_diffusing_one),
        cmocka_unit_test(a_small_spot_gives_the_plane_its_flux_through_the_window),
    };
    add_tests(tests, NULL, NULL);
}
