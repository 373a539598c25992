/* test_average_df.c - the average daylight factor formula. */
#include "methods/reflected/interior.h"
#include "methods/reflected/well.h"
#include "methods/method.h"

#include "tests/methods/box_method.h"

static double average_df_of(struct box_room *box, int index)
{
    return box_method_value(&pp_method_average_df, box, index);
}

static void build_worked_room(struct box_room *box)
{
    box_room_build(box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    struct pp_opening *window = box_room_south(box, 0.2, 0.9, 3.6, 1.5);
    window->glass = pp_glass_diffusing(0.68); /* T is its diffuse transmittance */
    window->maintenance = 0.9;
}

static void worked_room_has_2_5163_per_cent(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    box_room_skyline(&box, 25.0 * PP_RAD, 1.65, INFINITY);     /* theta 65 degrees */
    assert_near(100.0 * average_df_of(&box, 0), 2.5163, 5e-5); /* as printed */
}

static void proportional_to_glass_frame_dirt_and_angle(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    double base = average_df_of(&box, 0);
    box.openings[0].frame_factor = 0.71;
    assert_relative(average_df_of(&box, 0), 0.71 * base, 1e-14);
    box.openings[0].maintenance = 0.45;
    assert_relative(average_df_of(&box, 0), 0.71 * 0.5 * base, 1e-14);
    box.openings[0].glass = pp_glass_none();
    assert_relative(average_df_of(&box, 0), 0.71 * 0.5 / 0.68 * base, 1e-14);
    box_room_skyline(&box, 27.0 * PP_RAD, 1.65, INFINITY);
    assert_relative(average_df_of(&box, 0), 0.7 * 0.71 * 0.5 / 0.68 * base, 1e-14);
}

/* From the middle of a window 1.5 m high, 0.75 m below the head: a reveal of the same
 * depth leaves 45 degrees. */
static void reveal_cuts_the_angle_from_above(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    double base = average_df_of(&box, 0);
    box_room_reveal(&box, 0, 0.75);
    assert_relative(average_df_of(&box, 0), base / 2.0, 1e-14);
    box_room_skyline(&box, 46.0 * PP_RAD, 1.65, INFINITY);
    assert_near(average_df_of(&box, 0), 0.0, 0.0);
}

/* (1 + R)/2 times the newer form, without the factor for dirt. By hand for the worked
 * room: R 0.45778, 2.5163 / 0.9 / 2 * 1.45778 = 2.0379. */
static void older_form_is_over_all_surfaces(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    box_room_skyline(&box, 25.0 * PP_RAD, 1.65, INFINITY);
    assert_near(100.0 * box_method_value(&pp_method_average_df_lynes, &box, 0), 2.0379,
                2e-4);
    double R = pp_interior_all(&box.world).reflectance, M = 0.9;
    assert_near(R, 0.45778, 5e-6); /* as printed */
    assert_relative(box_method_value(&pp_method_average_df_lynes, &box, 0),
                    (1 + R) / 2 / M * average_df_of(&box, 0), 1e-14);
    assert_true(pp_method_average_df_lynes.of_all_surfaces);
    assert_int_equal(pp_method_average_df_lynes.allowances & PP_ALLOWS_DIRT, 0);
}

/* Room 4 x 6 x 3 m, window 3.6 x 1.5 m, its sill 0.4 m below the working plane at 0.85
 * m: 1.1 m of its height count fully, 0.4 m with the floor's 0.2, together 1.1 + 0.08
 * of 1.5. With a black floor the low part does not count. */
static void glass_below_the_working_plane_counts_by_way_of_the_floor(void **state)
{
    (void)state;
    for (double floor = 0.0; floor < 1.0; floor += 0.2) {
        struct box_room box;
        box_room_build(&box, 4.0, 6.0, 3.0, floor, 0.5, 0.7);
        box.world.working_plane_m = 0.45;
        box_room_south(&box, 0.2, 0.45, 3.6, 1.5)->frame_factor = 0.71;
        double above = average_df_of(&box, 0);
        double older = box_method_value(&pp_method_average_df_lynes, &box, 0);
        box.world.working_plane_m = 0.85;
        assert_relative(average_df_of(&box, 0), (1.1 + 0.4 * floor) / 1.5 * above,
                        1e-13);
        assert_relative(box_method_value(&pp_method_average_df_lynes, &box, 0), older,
                        1e-14);
    }
}

/* 1.1 of the 1.5 m of the same window count, for any floor. With a black floor, or if
 * all glass is above the plane, both rules agree. A window entirely below the plane
 * counts as zero. */
static void glass_below_the_working_plane_can_be_left_out(void **state)
{
    (void)state;
    const struct pp_method *above_only = &pp_method_average_df_above;
    for (double floor = 0.0; floor < 1.0; floor += 0.3) {
        struct box_room box;
        box_room_build(&box, 4.0, 6.0, 3.0, floor, 0.5, 0.7);
        box.world.working_plane_m = 0.45;
        box_room_south(&box, 0.2, 0.45, 3.6, 1.5)->frame_factor = 0.71;
        double whole = average_df_of(&box, 0);
        assert_relative(box_method_value(above_only, &box, 0), whole, 1e-14);
        box.world.working_plane_m = 0.85;
        double left = box_method_value(above_only, &box, 0);
        assert_relative(left, 1.1 / 1.5 * whole, 1e-13);
        assert_relative(average_df_of(&box, 0) - left, 0.4 * floor / 1.5 * whole,
                        1e-12);
        box.world.working_plane_m = 1.96;
        assert_near(box_method_value(above_only, &box, 0), 0.0, 1e-16);
    }
}

/* Calculated by hand, 4 x 6 x 3 m, a horizontal pane of 1.1 x 0.7 m, T 0.68: R = (24 *
 * 0.2 + 60 * 0.5 + 23.23 * 0.7 + 0.077) / 108 = 0.473500, DF = 0.68 * 0.77 * 180 / (108
 * (1 - R^2)) = 1.12486 %. */
static void level_glass_sees_180_degrees_of_sky(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    struct pp_opening *pane =
        box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 3.0), 1.1, 0.7);
    pane->glass = pp_glass_diffusing(0.68);
    double R = (24.0 * 0.2 + 60.0 * 0.5 + 23.23 * 0.7 + 0.77 * 0.1) / 108.0;
    double whole = 0.68 * 0.77 * 1.8 / (108.0 * (1.0 - R * R));
    assert_relative(average_df_of(&box, 0), whole, 1e-13);
    /* In a well as deep as half its width, multiplied by its efficiency. */
    box_room_reveal(&box, 0, pane->height_m / 2.0);
    struct pp_well_shape well = {1.1, 0.7, 0.35, 0.7};
    struct pp_well_efficiency N = pp_well_efficiency(&well, 0.0, &pane->glass);
    assert_relative(average_df_of(&box, 0), N.whole * whole, 1e-12);
    assert_true(N.whole > 0.6 && N.whole < 0.75);
}

/* For a single pane only the angle changes with the slope: 180 degrees less the
 * slope. */
static void sloping_glass_sees_180_degrees_less_its_slope(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    struct pp_opening *pane =
        box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 3.0), 1.1, 0.7);
    double level = average_df_of(&box, 0);
    for (double deg = 13.0; deg < 170.0; deg += 31.0) {
        double beta = deg * PP_RAD;
        pane->inner.normal = pane->outer.normal = pp_vec(0, -sin(beta), -cos(beta));
        pane->slope_rad = beta;
        assert_relative(average_df_of(&box, 0), (180.0 - deg) / 180.0 * level, 1e-12);
    }
}

static void other_skies_are_refused_and_by_the_older_form_slopes(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    box.light.sky = pp_sky_uniform();
    assert_non_null(pp_method_average_df.refuses_room(&box.world, &box.light, NULL));
    struct pp_opening *rooflight =
        box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 3.0), 1.1, 0.7);
    assert_non_null(
        pp_method_average_df_lynes.refuses(&box.world, &box.light, rooflight, NULL));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_room_has_2_5163_per_cent),
        cmocka_unit_test(proportional_to_glass_frame_dirt_and_angle),
        cmocka_unit_test(reveal_cuts_the_angle_from_above),
        cmocka_unit_test(older_form_is_over_all_surfaces),
        cmocka_unit_test(glass_below_the_working_plane_counts_by_way_of_the_floor),
        cmocka_unit_test(glass_below_the_working_plane_can_be_left_out),
        cmocka_unit_test(level_glass_sees_180_degrees_of_sky),
        cmocka_unit_test(sloping_glass_sees_180_degrees_less_its_slope),
        cmocka_unit_test(other_skies_are_refused_and_by_the_older_form_slopes),
    };
    add_tests(tests, NULL, NULL);
}
