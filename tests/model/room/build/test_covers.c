/* test_covers.c - doors and dados as surfaces in front of their walls, and in mean
 * reflectances. */
#include "methods/reflected/interior.h"
#include "model/geometry/polygon.h"
#include "tests/lib/room_of.h"

#define PLAN                                                                           \
    "<room version='1'><plan width='6' depth='5' height='2.8'/>"                       \
    "<finishes floor='0.2' walls='0.45' ceiling='0.7'/>"
#define ROOM PLAN "<window wall='south' left='1' sill='0.9' width='3' height='1.5'/>"

/* Total area of the covers, all of which must be 0.1 mm in front of their walls. */
static double area_of(const struct pp_world *world, int *count)
{
    double sum = 0.0;
    *count = 0;
    for (int i = world->face_count; i < world->surface_count; i++) {
        const struct pp_surface *cover = &world->surfaces[i];
        if (cover->role != PP_COVER)
            continue;
        const struct pp_polygon *wall = &world->surfaces[cover->owner].outline;
        assert_true(cover->inside);
        for (int k = 0; k < cover->outline.count; k++)
            assert_near(pp_polygon_height(wall, cover->outline.vertices[k]), 1e-4,
                        1e-9);
        assert_near(pp_vec_dot(wall->normal, cover->outline.normal), 1.0, 1e-12);
        sum += cover->outline.area_m2;
        ++*count;
    }
    return sum;
}

/* On the floor, 0.4 m from the left end of the north wall seen from outside, which is
 * its east end. */
static void a_door_is_placed_like_a_window(void **state)
{
    (void)state;
    int count;
    struct pp_world *world = pp_test_world(
        ROOM "<door wall='north' left='0.4' width='0.8' height='2.05'/></room>");
    assert_near(area_of(world, &count), 0.8 * 2.05, 1e-9);
    assert_int_equal(count, 1);
    struct pp_vec3 middle =
        pp_polygon_middle(&world->surfaces[world->surface_count - 1].outline);
    assert_near(middle.x, 6.0 - 0.4 - 0.4, 1e-9);
    assert_near(middle.y, 5.0 - 1e-4, 1e-9);
    assert_near(middle.z, 0.5 * 2.05, 1e-9);
    pp_world_destroy(world);
}

/* By hand: floor 30 x 0.2, walls 61.6 x 0.45, ceiling 30 x 0.7 m2; the window, 4.5 m2
 * of 0.1, and the door, 0.8 x 2.05 m2 of 0.15, replace parts of the wall. Total area
 * 121.6 m2. 1.65 m of the door are below the middle of the window (1.65 m). */
static void a_mean_reflectance_has_the_door_in_its_walls_place(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world(ROOM "<door wall='north' left='0.4' width='0.8' height='2.05' "
                           "reflectance='0.15'/></room>");
    struct pp_interior all = pp_interior_all(world);
    double bare = 30 * 0.2 + 61.6 * 0.45 + 30 * 0.7 - 4.5 * (0.45 - 0.1);
    assert_near(all.area_m2, 121.6, 1e-9);
    assert_near(all.reflectance, (bare - 0.8 * 2.05 * 0.3) / 121.6, 1e-12);

    struct pp_interior_parts parts = pp_interior_split(world, 1.65);
    double low_m2 = 30 + 22 * 1.65 - 2.25, high_m2 = 30 + 22 * 1.15 - 2.25;
    assert_near(parts.lower.reflectance,
                (30 * 0.2 + (22 * 1.65 - 2.25) * 0.45 - 0.8 * 1.65 * 0.3) / low_m2,
                1e-12);
    assert_near(parts.upper.reflectance,
                (30 * 0.7 + (22 * 1.15 - 2.25) * 0.45 - 0.8 * 0.4 * 0.3) / high_m2,
                1e-12);
    /* Without a wall, its door is left out too. */
    int north = world->surfaces[world->surface_count - 1].owner;
    struct pp_interior_parts without = pp_interior_split_without(world, 1.65, north);
    assert_near(without.lower.reflectance,
                (30 * 0.2 + (16 * 1.65 - 2.25) * 0.45 + 2.25 * 0.1) / (30 + 16 * 1.65),
                1e-12);
    pp_world_destroy(world);
}

/* 1.2 m high along 22 m of wall, without 0.3 m of the window's 3 m width and 1.2 m of
 * the door's 0.8 m width. The window makes a notch, the door divides the dado. */
static void a_dado_leaves_out_windows_and_doors(void **state)
{
    (void)state;
    int count;
    struct pp_world *world =
        pp_test_world(ROOM "<door wall='north' left='0.4' width='0.8' height='2.05'/>"
                           "<dado height='1.2' reflectance='0.25'/></room>");
    double door_m2 = 0.8 * 2.05;
    assert_near(area_of(world, &count), door_m2 + 22 * 1.2 - 3 * 0.3 - 0.8 * 1.2, 1e-9);
    assert_int_equal(count, 1 + 5);
    pp_world_destroy(world);
}

/* Two windows whose sills and heads are within the height of the dado: it is cut into
 * three pieces without holes, whose area is that of the wall without the windows. */
static void a_dado_round_windows_is_cut_into_pieces_without_holes(void **state)
{
    (void)state;
    int count;
    struct pp_world *world = pp_test_world(
        PLAN "<window wall='south' left='1' sill='0.3' width='1.3' height='0.5'/>"
             "<window wall='south' left='3.1' sill='0.4' width='1.1' height='0.7'/>"
             "<dado wall='south' height='1.4' reflectance='0.25'/></room>");
    assert_near(area_of(world, &count), 6 * 1.4 - 1.3 * 0.5 - 1.1 * 0.7, 1e-9);
    assert_int_equal(count, 3);
    pp_world_destroy(world);
}

/* Two doors divide a wall's dado into three pieces. With any number of reveals before
 * them in the list of surfaces, each piece belongs to its wall. */
static void every_piece_belongs_to_its_wall_however_many_surfaces_there_are(
    void **state)
{
    (void)state;
    for (int windows = 0; windows < 9; windows++) {
        char text[2048] = PLAN;
        int count;
        for (int i = 0; i < windows; i++) {
            char window[160];
            snprintf(window, sizeof window,
                     "<window wall='south' left='%g' sill='1.3' width='0.4' "
                     "height='0.9' reveal='0.1'/>",
                     0.1 + 0.6 * i);
            strcat(text, window);
        }
        strcat(text, "<door wall='north' left='1' width='0.8' height='2'/>"
                     "<door wall='north' left='3' width='0.8' height='2'/>"
                     "<dado wall='north' height='1.1' reflectance='0.3'/></room>");
        struct pp_world *world = pp_test_world(text);
        assert_near(area_of(world, &count), 2 * 0.8 * 2.0 + (6.0 - 2 * 0.8) * 1.1,
                    1e-9);
        assert_int_equal(count, 5);
        for (int i = world->face_count; i < world->surface_count; i++)
            if (world->surfaces[i].role == PP_COVER)
                assert_string_equal(world->surfaces[world->surfaces[i].owner].name,
                                    "north");
        pp_world_destroy(world);
    }
}

/* A dado of full height equals the finish of the wall: the same means, except for
 * rounding. A wall's own dado has priority over that of all walls. */
static void a_dado_of_full_height_is_the_walls_finish(void **state)
{
    (void)state;
    struct pp_world *dado =
        pp_test_world(ROOM "<dado height='2.8' reflectance='0.6'/>"
                           "<dado wall='east' height='2.8' reflectance='0.2'/></room>");
    struct pp_world *finish = pp_test_world(
        "<room version='1'><plan width='6' depth='5' height='2.8'/>"
        "<finishes floor='0.2' walls='0.6' ceiling='0.7'/>"
        "<finish wall='east' reflectance='0.2'/>"
        "<window wall='south' left='1' sill='0.9' width='3' height='1.5'/></room>");
    assert_near(pp_interior_all(dado).reflectance, pp_interior_all(finish).reflectance,
                1e-12);
    assert_near(pp_interior_role(dado, PP_WALL).reflectance,
                pp_interior_role(finish, PP_WALL).reflectance, 1e-12);
    assert_near(pp_interior_role_above(dado, PP_WALL, 0.85).reflectance,
                pp_interior_role_above(finish, PP_WALL, 0.85).reflectance, 1e-12);
    struct pp_interior_parts a = pp_interior_split_without(dado, 1.65, 1),
                             b = pp_interior_split_without(finish, 1.65, 1);
    assert_near(a.lower.reflectance, b.lower.reflectance, 1e-12);
    assert_near(a.upper.reflectance, b.upper.reflectance, 1e-12);
    pp_world_destroy(dado);
    pp_world_destroy(finish);
}

/* A point on the wall behind a dado would receive no light. */
static void no_point_lies_behind_a_dado(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    struct pp_world *world = pp_test_resolve(
        ROOM "<dado reflectance='0.3'/>"
             "<point x='3' y='5' z='0.5' nx='0' ny='-1' nz='0'/></room>",
        &mistakes);
    assert_null(world);
    assert_int_equal(mistakes.count, 1);
    assert_non_null(strstr(mistakes.list[0].text, "lies on a door or a dado"));
    pp_mistakes_clear(&mistakes);
    world = pp_test_world(ROOM "<dado reflectance='0.3'/>"
                               "<point x='3' y='5' z='1.5' nx='0' ny='-1' nz='0'/>"
                               "</room>");
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_door_is_placed_like_a_window),
        cmocka_unit_test(a_mean_reflectance_has_the_door_in_its_walls_place),
        cmocka_unit_test(a_dado_leaves_out_windows_and_doors),
        cmocka_unit_test(a_dado_round_windows_is_cut_into_pieces_without_holes),
        cmocka_unit_test(
            every_piece_belongs_to_its_wall_however_many_surfaces_there_are),
        cmocka_unit_test(a_dado_of_full_height_is_the_walls_finish),
        cmocka_unit_test(no_point_lies_behind_a_dado),
    };
    add_tests(tests, NULL, NULL);
}
