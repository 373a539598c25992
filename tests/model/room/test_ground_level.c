/* test_ground_level.c - the level of the ground. */
#include "model/room/ground.h"

#include "tests/lib/room_of.h"

static double level_of(const char *parts)
{
    char xml[2048];
    snprintf(xml, sizeof xml,
             "<room version=\"1\"><plan width=\"4.3\" depth=\"6.1\" height=\"2.9\"/>"
             "%s</room>",
             parts);
    struct pp_world *world = pp_test_world(xml);
    double level = pp_ground_level(world);
    pp_world_destroy(world);
    return level;
}

#define WINDOW "<window wall=\"south\" left=\"0.7\" width=\"1.3\" height=\"1.1\" "
#define SITE(level) "<site ground-level=\"" level "\"/>"

static void the_ground_is_where_the_site_has_it(void **state)
{
    (void)state;
    assert_near(level_of(WINDOW "sill=\"0.83\"/>"), 0.0, 0.0);
    assert_near(level_of(SITE("-7.3") WINDOW "sill=\"0.83\"/>"), -7.3, 0.0);
    assert_near(level_of(SITE("0.61") WINDOW "sill=\"0.83\"/>"), 0.61, 0.0);
    assert_near(level_of(SITE("0.61")), 0.61, 0.0); /* no window below the ground */
}

/* Windows of a cellar, the higher of them above the ground: the ground is lowered to
 * the sill of the lowest window. */
static void the_ground_is_dug_away_before_the_lowest_window(void **state)
{
    (void)state;
    assert_near(level_of(SITE("1.7") WINDOW "sill=\"0.83\"/>"), 0.83, 1e-15);
    assert_near(level_of(SITE("1.7") WINDOW "sill=\"0.83\"/>"
                                            "<window wall=\"east\" left=\"0.4\" "
                                            "sill=\"1.75\" width=\"1\" height=\"1\"/>"
                                            "<window wall=\"north\" left=\"0.4\" "
                                            "sill=\"0.37\" width=\"1\" height=\"1\"/>"),
                0.37, 1e-15);
    /* A rooflight is above the ground. */
    assert_near(level_of(SITE("1.7") "<rooflight x=\"1\" y=\"2\" width=\"1.1\" "
                                     "depth=\"0.9\"/>"),
                1.7, 0.0);
}

/* Without a room, the ground is below the points. */
static void the_ground_lies_below_points_without_a_room(void **state)
{
    (void)state;
    struct pp_receiver points[2] = {{.position = {1.7, 2.3, 0.85}},
                                    {.position = {0.3, 5.1, -0.47}}};
    struct pp_world world = {
        .ground_level_m = 0.2, .receivers = points, .receiver_count = 2};
    assert_near(pp_ground_level(&world), -0.47, 0.0);
    points[1].position.z = 0.31;
    assert_near(pp_ground_level(&world), 0.2, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ground_is_where_the_site_has_it),
        cmocka_unit_test(the_ground_is_dug_away_before_the_lowest_window),
        cmocka_unit_test(the_ground_lies_below_points_without_a_room),
    };
    add_tests(tests, NULL, NULL);
}
