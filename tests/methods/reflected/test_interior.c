/* test_interior.c - areas and mean reflectances of the inside surfaces of a room. */
#include "methods/reflected/interior.h"

#include "tests/lib/near.h"

#include "tests/lib/box_room.h"
#include "tests/lib/room_of.h"

/* Rounding of a sum of a dozen areas of some ten square metres. */
#define ROUNDING 1e-13

/* The worked room: 6 x 4 x 3 m, window 3.6 x 1.5 m with its sill at 0.9 m in a 4 m
 * wall; ceiling 0.7, walls 0.5, floor 0.2. */
static void build_worked_room(struct box_room *box)
{
    box_room_build(box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    box_room_south(box, 0.2, 0.9, 3.6, 1.5);
}

static void worked_room_as_calculated_by_hand(void **state)
{
    (void)state;
    struct box_room box;
    build_worked_room(&box);
    /* Tolerances: half a unit of the last printed digit. */
    struct pp_interior all = pp_interior_all(&box.world);
    assert_near(all.area_m2, 108.0, ROUNDING * 108.0);
    assert_near(all.reflectance, 0.45778, 5e-6);
    struct pp_interior_parts bre =
        pp_interior_split_without(&box.world, 1.65, BOX_SOUTH);
    assert_near(bre.lower.reflectance, 0.35714, 5e-6);
    assert_near(bre.upper.reflectance, 0.60526, 5e-6);
    struct pp_interior_parts split = pp_interior_split(&box.world, 1.65);
    assert_near(split.lower.area_m2, 54.3, ROUNDING * 54.3);
    assert_near(split.upper.area_m2, 48.3, ROUNDING * 48.3);
    assert_near(split.lower.reflectance, 0.36740, 5e-6);
    assert_near(split.upper.reflectance, 0.59938, 5e-6);
}

/* A cupboard on the floor, 1.6 x 0.8 x 1.5 m: four sides and the top count, its inside
 * does not. */
static void a_cupboard_counts_with_its_outer_faces(void **state)
{
    (void)state;
    struct pp_world *bare = pp_test_world(
        "<room version='1'><plan width='4' depth='6' height='3'/></room>");
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='6' height='3'/>"
        "<furniture x='1' y='2' width='1.6' depth='0.8' height='1.5'/></room>");
    assert_near(pp_interior_all(world).area_m2 - pp_interior_all(bare).area_m2,
                2.0 * (1.6 + 0.8) * 1.5 + 1.6 * 0.8, 1e-9);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

static void parts_and_openings_make_up_the_whole(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.7, 5.3, 2.9, 0.15, 0.62, 0.81);
    box_room_south(&box, 0.4, 0.7, 1.9, 1.3);
    box_room_open(&box, BOX_CEILING, pp_vec(0.9, 1.7, 2.9), 0.8, 0.6);
    struct pp_interior all = pp_interior_all(&box.world);
    double glass_m2 = 1.9 * 1.3 + 0.8 * 0.6;
    for (double z = 0.0; z <= 2.9; z += 0.1) {
        struct pp_interior_parts parts = pp_interior_split(&box.world, z);
        assert_near(parts.lower.area_m2 + parts.upper.area_m2 + glass_m2, all.area_m2,
                    ROUNDING * all.area_m2);
        double reflecting_m2 = parts.lower.area_m2 * parts.lower.reflectance
                               + parts.upper.area_m2 * parts.upper.reflectance
                               + glass_m2 * PP_OPENING_REFLECTANCE;
        assert_near(reflecting_m2, all.area_m2 * all.reflectance,
                    ROUNDING * all.area_m2);
    }
}

/* The middle of a rooflight is at the height of the ceiling, so all walls are below
 * it. */
static void a_ceiling_is_above_its_own_rooflight(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.7, 5.3, 2.9, 0.15, 0.62, 0.81);
    struct pp_opening *rooflight =
        box_room_open(&box, BOX_CEILING, pp_vec(0.9, 2.3, 2.9), 0.8, 0.6);
    struct pp_interior_parts parts =
        pp_interior_split(&box.world, rooflight->middle_z_m);
    assert_near(parts.upper.area_m2, 3.7 * 5.3 - 0.48, ROUNDING * 20.0);
    assert_near(parts.upper.reflectance, 0.81, ROUNDING);
    assert_near(parts.lower.area_m2, 3.7 * 5.3 + 18.0 * 2.9, ROUNDING * 72.0);
}

static void other_walls_openings_count_with_a_tenth_in_the_bre_means(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 4.0, 6.0, 3.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 0.2, 0.9, 3.6, 1.5);
    box_room_open(&box, BOX_NORTH, pp_vec(1.0, 6.0, 0.3), 2.0, 1.2);
    struct pp_interior_parts parts =
        pp_interior_split_without(&box.world, 1.65, BOX_SOUTH);
    double walls_m2 = (6.0 + 6.0 + 4.0) * 1.65, glass_m2 = 2.0 * 1.2;
    double area_m2 = 24.0 + walls_m2;
    assert_near(parts.lower.area_m2, area_m2, ROUNDING * area_m2);
    assert_near(parts.lower.reflectance,
                (24.0 * 0.2 + (walls_m2 - glass_m2) * 0.5 + glass_m2 * 0.1) / area_m2,
                ROUNDING);
}

static void a_room_of_one_colour_is_that_colour_in_every_part(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.1, 4.7, 2.3, 0.43, 0.43, 0.43);
    box_room_south(&box, 0.3, 0.6, 1.1, 1.2);
    for (double z = 0.1; z < 2.3; z += 0.37) {
        struct pp_interior_parts split = pp_interior_split(&box.world, z);
        struct pp_interior_parts without =
            pp_interior_split_without(&box.world, z, BOX_SOUTH);
        assert_near(split.lower.reflectance, 0.43, ROUNDING);
        assert_near(split.upper.reflectance, 0.43, ROUNDING);
        assert_near(without.lower.reflectance, 0.43, ROUNDING);
        assert_near(without.upper.reflectance, 0.43, ROUNDING);
    }
}

/* A comb-shaped surface with three teeth above a bar: a horizontal cut leaves three
 * pieces above it. The surface is tilted about the x axis by an angle with the sine
 * 0.6. */
static void area_below_a_cut_through_a_comb(void **state)
{
    (void)state;
    const double flat[12][2] = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                                {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
    struct pp_vec3 corners[12];
    for (int i = 0; i < 12; i++)
        corners[i] = pp_vec(flat[i][0], 0.8 * flat[i][1], 0.6 * flat[i][1]);
    struct pp_polygon comb = {12, corners, pp_vec(0, -0.6, 0.8), 5.0 + 2.0 + 1.0 + 2.0};
    assert_near(pp_interior_area_below(&comb, 0.6 * 0.5), 2.5, ROUNDING);
    assert_near(pp_interior_area_below(&comb, 0.6 * 1.5), 5.0 + 1.5, 10 * ROUNDING);
    assert_near(pp_interior_area_below(&comb, 0.6 * 2.5), 8.0 + 1.0, 10 * ROUNDING);
    assert_near(pp_interior_area_below(&comb, -0.1), 0.0, 0.0);
    assert_near(pp_interior_area_below(&comb, 7.0), 10.0, 0.0);
}

/* A glass ceiling and glass walls above 1.4 m leave only a strip above the cut. */
static void a_room_is_split_if_both_parts_have_surfaces(void **state)
{
    (void)state;
    struct pp_world *box = pp_test_world(
        "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"
        "<window wall='south' left='0.4' sill='0.9' width='2' height='1.2'/></room>");
    assert_true(pp_interior_is_split(box, 1.5));
    assert_false(pp_interior_is_split(box, -0.2));
    assert_false(pp_interior_is_split(box, 2.7));
    pp_world_destroy(box);
    struct pp_world *glass = pp_test_world(
        "<room version='1'><plan width='3' depth='4' height='2.6'/>"
        "<rooflight x='0' y='0' width='3' depth='4'/>"
        "<window wall='south' left='0' sill='1.4' width='3' height='1.2'/>"
        "<window wall='north' left='0' sill='1.4' width='3' height='1.2'/>"
        "<window wall='east' left='0' sill='1.4' width='4' height='1.2'/>"
        "<window wall='west' left='0' sill='1.4' width='4' height='1.2'/></room>");
    assert_true(pp_interior_is_split(glass, 1.3));
    struct pp_interior_parts parts = pp_interior_split(glass, 1.3);
    assert_near(parts.upper.area_m2, 14.0 * 0.1, ROUNDING);
    pp_world_destroy(glass);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worked_room_as_calculated_by_hand),
        cmocka_unit_test(a_cupboard_counts_with_its_outer_faces),
        cmocka_unit_test(parts_and_openings_make_up_the_whole),
        cmocka_unit_test(a_ceiling_is_above_its_own_rooflight),
        cmocka_unit_test(other_walls_openings_count_with_a_tenth_in_the_bre_means),
        cmocka_unit_test(a_room_of_one_colour_is_that_colour_in_every_part),
        cmocka_unit_test(area_below_a_cut_through_a_comb),
        cmocka_unit_test(a_room_is_split_if_both_parts_have_surfaces),
    };
    add_tests(tests, NULL, NULL);
}
