/* test_room_features.c - features of a room compared with values calculated by hand. */
#include "studies/research/atlas/room_features.h"

#include "tests/lib/near.h"
#include "tests/lib/box_room.h"

/* 3.1 m wide, 5.7 m deep and 2.9 m high, with one window of 1.9 x 1.3 m in the south wall,
 * 0.6 m from its left and 1.1 m above the floor, behind a skyline of 23 degrees. */
static void build(struct box_room *box)
{
    box_room_build(box, 3.1, 5.7, 2.9, 0.25, 0.45, 0.75);
    box_room_south(box, 0.6, 1.1, 1.9, 1.3);
    box_room_skyline(box, 23.0 * PP_RAD, 1.75, INFINITY);
    box->light.ground_reflectance = 0.15;
}

static void a_side_lit_room_has_the_features_of_its_drawing(void **state)
{
    (void)state;
    struct box_room box;
    double f[PP_ROOM_FEATURES];
    build(&box);
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    double glass = 1.9 * 1.3, floor = 3.1 * 5.7, walls = 2 * (3.1 + 5.7) * 2.9;
    double inside = 2 * floor + walls;
    double reflected =
        0.25 * floor + 0.45 * (walls - glass) + 0.75 * floor + 0.1 * glass;
    assert_relative(f[PP_ROOM_GLASS_FLOOR], glass / floor, 1e-12);
    assert_relative(f[PP_ROOM_GLASS_INSIDE], glass / inside, 1e-12);
    assert_relative(f[PP_ROOM_REFLECTANCE], reflected / inside, 1e-12);
    assert_near(f[PP_ROOM_FLOOR], 0.25, 1e-12);
    assert_near(f[PP_ROOM_CEILING], 0.75, 1e-12);
    assert_relative(f[PP_ROOM_DEPTH_HEAD], 5.7 / (1.1 + 1.3 - 0.85), 1e-12);
    assert_relative(f[PP_ROOM_DEPTH_WIDTH], 5.7 / 3.1, 1e-12);
    assert_near(f[PP_ROOM_BELOW], 0.0, 1e-12);
    assert_near(f[PP_ROOM_UPRIGHT], 1.0, 1e-12);
    assert_near(f[PP_ROOM_WALLS], 1.0, 0.0);
    assert_near(f[PP_ROOM_SPREAD], 1.0, 1e-12);
    assert_near(f[PP_ROOM_OBSTRUCTION], 23.0, 1e-9);
    assert_near(f[PP_ROOM_THINGS], 0.0, 0.0);
    assert_near(f[PP_ROOM_GROUND], 0.15, 0.0);
    /* Overcast sky on a vertical plane (3/14 + 4/(7 pi)), in both directions. */
    assert_near(f[PP_ROOM_FACING], 3.0 / 14.0 + 4.0 / (7.0 * PP_PI), 1e-12);
    assert_near(f[PP_ROOM_OPPOSITE], f[PP_ROOM_FACING], 1e-12);
    assert_true(isnan(f[PP_ROOM_DEPTH]) && isnan(f[PP_ROOM_VIEW]));
}

/* A room with walls of 0.45, a floor of 0.25 and a ceiling of 0.75 is ordinary; one
 * with a ceiling of 0.5, or with snow on the ground, is not. */
static void a_room_is_ordinary_in_usual_ranges_alone(void **state)
{
    (void)state;
    struct box_room box;
    double f[PP_ROOM_FEATURES];
    build(&box);
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    assert_near(f[PP_ROOM_ORDINARY], 1.0, 0.0);
    box.light.ground_reflectance = 0.8;
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    assert_near(f[PP_ROOM_ORDINARY], 0.0, 0.0);
    box_room_build(&box, 3.1, 5.7, 2.9, 0.25, 0.6, 0.5);
    box_room_south(&box, 0.6, 1.1, 1.9, 1.3);
    box.light.ground_reflectance = 0.15;
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    assert_near(f[PP_ROOM_ORDINARY], 0.0, 0.0);
}

/* Clear sky with the sun in front of the window: the window receives more light than
 * the obstruction that faces it. With the sun behind the room it receives less. */
static void a_sun_before_the_window_is_behind_what_faces_it(void **state)
{
    (void)state;
    struct box_room box;
    double before[PP_ROOM_FEATURES], behind[PP_ROOM_FEATURES];
    const double c = cos(30.0 * PP_RAD), s = sin(30.0 * PP_RAD);
    build(&box);
    assert_int_equal(pp_sky_iso(&box.light.sky, 12, pp_vec(0.0, -c, s), NULL), PP_OK);
    assert_int_equal(pp_room_features(before, &box.world, &box.light, NULL), PP_OK);
    assert_int_equal(pp_sky_iso(&box.light.sky, 12, pp_vec(0.0, c, s), NULL), PP_OK);
    assert_int_equal(pp_room_features(behind, &box.world, &box.light, NULL), PP_OK);
    assert_true(before[PP_ROOM_FACING] > 2.0 * before[PP_ROOM_OPPOSITE]);
    assert_relative(behind[PP_ROOM_OPPOSITE], before[PP_ROOM_FACING], 1e-6);
    assert_relative(behind[PP_ROOM_FACING], before[PP_ROOM_OPPOSITE], 1e-6);
}

/* Configuration factor of a vertical rectangle, w wide and h high, for a horizontal
 * point in front of its lower corner at the distance d: (atan(w/d) - d/s atan(w/s)) / 2
 * pi with s = sqrt(d^2 + h^2). */
static double corner(double w, double h, double d)
{
    double s = hypot(d, h);
    return (atan2(w, d) - d / s * atan2(w, s)) / (2.0 * PP_PI);
}

static void a_point_has_its_depth_and_its_view_of_the_window(void **state)
{
    (void)state;
    struct box_room box;
    double f[PP_ROOM_FEATURES];
    build(&box);
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    pp_room_features_at(f, &box.world, pp_vec(1.2, 3.3, 0.85));
    assert_relative(f[PP_ROOM_DEPTH], 3.3 / (2.4 - 0.85), 1e-12);
    assert_relative(f[PP_ROOM_SIDE], 1.2 / 2.9, 1e-12);
    /* The window extends from x = 0.6 to 2.5 and z = 1.1 to 2.4. */
    double low = 1.1 - 0.85, high = 2.4 - 0.85;
    double view = corner(1.2 - 0.6, high, 3.3) - corner(1.2 - 0.6, low, 3.3)
                  + corner(2.5 - 1.2, high, 3.3) - corner(2.5 - 1.2, low, 3.3);
    assert_relative(f[PP_ROOM_VIEW], view, 1e-9);
}

/* For a point beside the window the distance to its nearest edge counts. */
static void depth_is_to_the_nearest_part_of_the_window(void **state)
{
    (void)state;
    struct box_room box;
    double f[PP_ROOM_FEATURES];
    build(&box);
    pp_room_features_at(f, &box.world, pp_vec(2.9, 0.3, 0.85));
    assert_relative(f[PP_ROOM_DEPTH], 0.5 / (2.4 - 0.85), 1e-12);
}

/* With a sill at 0.5 m and the plane at 0.85 m, 0.35 of 1.3 m are hidden. */
static void glass_below_the_plane_counts_by_its_area(void **state)
{
    (void)state;
    struct box_room box;
    double f[PP_ROOM_FEATURES];
    box_room_build(&box, 3.1, 5.7, 2.9, 0.25, 0.45, 0.75);
    box_room_south(&box, 0.6, 0.5, 1.9, 1.3);
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    assert_relative(f[PP_ROOM_BELOW], 0.35 / 1.3, 1e-12);
}

static void a_room_without_openings_has_no_features(void **state)
{
    (void)state;
    struct box_room box;
    double f[PP_ROOM_FEATURES];
    box_room_build(&box, 3.1, 5.7, 2.9, 0.25, 0.45, 0.75);
    assert_int_equal(pp_room_features(f, &box.world, &box.light, NULL), PP_OK);
    for (int i = 0; i < PP_ROOM_FEATURES; i++)
        assert_true(isnan(f[i]));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_room_is_ordinary_in_usual_ranges_alone),
        cmocka_unit_test(a_side_lit_room_has_the_features_of_its_drawing),
        cmocka_unit_test(a_sun_before_the_window_is_behind_what_faces_it),
        cmocka_unit_test(a_point_has_its_depth_and_its_view_of_the_window),
        cmocka_unit_test(depth_is_to_the_nearest_part_of_the_window),
        cmocka_unit_test(glass_below_the_plane_counts_by_its_area),
        cmocka_unit_test(a_room_without_openings_has_no_features),
    };
    add_tests(tests, NULL, NULL);
}
