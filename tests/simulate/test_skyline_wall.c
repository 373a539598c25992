/* test_skyline_wall.c - a skyline with a distance compared with a long block in its
 * place: by path tracing, photons and radiosity, through windows of its own wall and of
 * another. */
#include <stdio.h>

#include "tests/lib/photons_of.h"
#include "tests/lib/radiosity_of.h"
#include "tests/lib/room_of.h"

/* A street 8.3 m wide; its own side is 10.7 m high. */
#define STREET                                                                         \
    "<window wall='south' left='0.8' sill='0.9' width='2' height='1.5'/>"              \
    "<facade wall='south' left='60' right='60' up='8' reflectance='0.35'/>"

/* An obstruction in the south is seen obliquely from the east. */
#define ASIDE "<window wall='east' left='1.1' sill='0.9' width='2' height='1.5'/>"

static const double distance = 8.3, angle_deg = 50.0, reflectance = 0.4;

/* The middle of a window in the south wall, and of that wall. */
static const double window_m = 1.65, wall_m = 1.35;

static struct pp_world *room_with(struct pp_outside_light *light, const char *windows,
                                  const char *outside)
{
    char xml[2000];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='3.6' depth='5.1' height='2.7'/>"
             "<finishes floor='0.25' walls='0.6' ceiling='0.8'/>%s%s</room>",
             windows, outside);
    return pp_test_lit_world(light, xml);
}

static struct pp_world *room_with_skyline(struct pp_outside_light *light,
                                          const char *windows)
{
    char outside[200];
    snprintf(outside, sizeof outside,
             "<skyline wall='south' angle='%g' distance='%g' reflectance='%g'/>",
             angle_deg, distance, reflectance);
    return room_with(light, windows, outside);
}

static struct pp_world *room_with_block(struct pp_outside_light *light,
                                        const char *windows, double middle_m)
{
    char outside[200];
    snprintf(outside, sizeof outside,
             "<block x='-9000' y='%.17g' width='18000' depth='11' height='%.17g' "
             "reflectance='%g'/>",
             -distance - 11.0, middle_m + distance * tan(angle_deg * PP_RAD),
             reflectance);
    return room_with(light, windows, outside);
}

enum { POINTS = 2 };
static const struct pp_receiver receivers[POINTS] = {
    {{1.9, 1.4, 0.85}, {0.0, 0.0, 1.0}, 0, 0.0},
    {{1.6, 4.1, 0.85}, {0.0, 0.0, 1.0}, 0, 0.0}};

/* An engine's readings of both points; the caller frees them. */
typedef struct pp_reading (*readings_by(const struct pp_world *world,
                                        const struct pp_outside_light *light))[4];

static struct pp_reading (*by_paths(const struct pp_world *world,
                                    const struct pp_outside_light *light))[4]
{
    const struct pp_tracer_options options = pp_test_paths(1024);
    return pp_test_trace(world, light, receivers, POINTS, &options, NULL);
}

static struct pp_reading (*by_photons(const struct pp_world *world,
                                      const struct pp_outside_light *light))[4]
{
    const struct pp_photons_options options = {
        .samples = 1024, .seed = 20, .threads = 1};
    return pp_test_photons(world, light, receivers, POINTS, &options, NULL);
}

static struct pp_reading (*by_elements(const struct pp_world *world,
                                       const struct pp_outside_light *light))[4]
{
    const struct pp_radiosity_options options = {.threads = 1};
    return pp_test_elements(world, light, receivers, POINTS, &options, NULL);
}

/* At most four standard errors of the difference and at most 2 % of the daylight
 * factor; the errors of radiosity are limits. */
static void assert_same_light(readings_by *by, const char *windows, double middle_m)
{
    struct pp_outside_light light;
    struct pp_world *skyline = room_with_skyline(&light, windows);
    struct pp_world *block = room_with_block(&light, windows, middle_m);
    struct pp_reading(*a)[4] = by(skyline, &light), (*b)[4] = by(block, &light);
    for (int i = 0; i < POINTS; i++)
        for (int c = PP_SC; c <= PP_DF; c++) {
            double error = hypot(a[i][c].std_error, b[i][c].std_error);
            assert_near(a[i][c].value, b[i][c].value,
                        fmin(4.0 * error, 0.02 * b[i][PP_DF].value) + 1e-12);
            assert_true(c != PP_DF || error < 0.02 * b[i][c].value);
        }
    free(a);
    free(b);
    pp_world_destroy(skyline);
    pp_world_destroy(block);
}

static void a_skyline_with_a_distance_is_the_block_in_its_place(void **state)
{
    (void)state;
    assert_same_light(by_paths, STREET, window_m);
    assert_same_light(by_photons, STREET, window_m);
}

static void light_through_windows_of_another_wall_is_the_same(void **state)
{
    (void)state;
    assert_same_light(by_paths, ASIDE, wall_m);
}

static void radiosity_has_the_skyline_as_the_block(void **state)
{
    (void)state;
    assert_same_light(by_elements, STREET, window_m);
    assert_same_light(by_elements, ASIDE, wall_m);
}

/* In a narrow street the skyline receives less light than under the open sky: the light
 * of a ground and a face lit by the whole sky would be more than a third higher. */
static void a_street_is_darker_than_the_open_sky_makes_it(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = room_with_skyline(&light, STREET);
    struct pp_reading(*found)[4] = by_paths(world, &light);
    /* Seen from the back, the wall fills the window except for its upper edge. */
    struct pp_world *dark =
        room_with(&light, STREET, "<skyline wall='south' angle='70'/>");
    struct pp_reading(*open)[4] = by_paths(dark, &light);
    double glow = open[1][PP_ERC].value * reflectance / 0.2;
    assert_true(found[1][PP_ERC].value < 0.75 * glow);
    free(found);
    free(open);
    pp_world_destroy(world);
    pp_world_destroy(dark);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_skyline_with_a_distance_is_the_block_in_its_place),
        cmocka_unit_test(light_through_windows_of_another_wall_is_the_same),
        cmocka_unit_test(a_street_is_darker_than_the_open_sky_makes_it),
    };
    add_tests(tests, NULL, NULL);
    const struct CMUnitTest long_tests[] = {
        cmocka_unit_test(radiosity_has_the_skyline_as_the_block),
    };
    add_long_tests(long_tests, NULL, NULL);
}
