/* test_shades.c - overhangs, fins, balconies and shelves of windows. */
#include "model/room/outside/shades.h"

#include <math.h>

#include "model/room/room.h"
#include "tests/lib/room_of.h"

#define ROOM(inside)                                                                   \
    "<room version='1'><plan width='4.2' depth='5.3' height='2.7'/>" inside "</room>"
#define WINDOW(reveal, inside)                                                         \
    "<window wall='south' left='0.9' sill='0.8' width='2.4' height='1.5' "             \
    "reveal='" reveal "'>" inside "</window>"

/* Asserts the extents of a surface. */
static void extends(const struct pp_surface *surface, struct pp_vec3 low,
                    struct pp_vec3 high)
{
    struct pp_vec3 least = surface->outline.vertices[0], most = least;
    for (int i = 1; i < surface->outline.count; i++) {
        struct pp_vec3 v = surface->outline.vertices[i];
        least = pp_vec(fmin(least.x, v.x), fmin(least.y, v.y), fmin(least.z, v.z));
        most = pp_vec(fmax(most.x, v.x), fmax(most.y, v.y), fmax(most.z, v.z));
    }
    assert_near(pp_vec_length(pp_vec_sub(least, low)), 0.0, 1e-12);
    assert_near(pp_vec_length(pp_vec_sub(most, high)), 0.0, 1e-12);
}

static const struct pp_surface *shade(const struct pp_world *world, int index)
{
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_FREE_SURFACE && index-- == 0)
            return &world->surfaces[i];
    fail_msg("there are not so many");
    return NULL;
}

/* South is -y: left, as seen from outside, is low x. */
static void an_overhang_begins_at_the_glass(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM(WINDOW("0.3", "<overhang depth='0.7' above='0.1' left='0.4' right='0.05' "
                           "reflectance='0.45'/>")));
    extends(shade(world, 0), pp_vec(0.5, -1.0, 2.4), pp_vec(3.35, -0.3, 2.4));
    assert_near(shade(world, 0)->front, 0.45, 0.0);
    assert_false(shade(world, 0)->inside);
    pp_world_destroy(world);
}

static void and_before_a_facade_at_its_plane(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM("<facade wall='south' left='2' right='2' depth='0.4'/>" WINDOW(
            "0.1", "<overhang depth='0.7'/>")));
    extends(shade(world, 0), pp_vec(0.9, -1.1, 2.3), pp_vec(3.3, -0.4, 2.3));
    pp_world_destroy(world);
}

static void fins_stand_beside_the_jambs(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world(ROOM(WINDOW("0", "<fin depth='0.6' gap='0.1' above='0.2'/>"
                                       "<fin depth='0.5' side='left' below='0.3'/>")));
    extends(shade(world, 0), pp_vec(0.8, -0.6, 0.8), pp_vec(0.8, 0.0, 2.5));
    extends(shade(world, 1), pp_vec(3.4, -0.6, 0.8), pp_vec(3.4, 0.0, 2.5));
    extends(shade(world, 2), pp_vec(0.9, -0.5, 0.5), pp_vec(0.9, 0.0, 2.3));
    pp_world_destroy(world);
}

static void a_balcony_has_a_floor_and_three_parapets(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM(WINDOW("0", "<balcony depth='1.4' left='0.5' level='-0.1'/>")));
    extends(shade(world, 0), pp_vec(0.4, -1.4, -0.1), pp_vec(3.3, 0.0, -0.1));
    extends(shade(world, 1), pp_vec(0.4, -1.4, -0.1), pp_vec(0.4, 0.0, 1.0));
    extends(shade(world, 2), pp_vec(0.4, -1.4, -0.1), pp_vec(3.3, -1.4, 1.0));
    extends(shade(world, 3), pp_vec(3.3, -1.4, -0.1), pp_vec(3.3, 0.0, 1.0));
    pp_world_destroy(world);
}

static void a_shelf_goes_on_in_the_room(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM(WINDOW("0.2", "<shelf height='1.1' depth='0.4' inside='0.6'/>")));
    extends(shade(world, 0), pp_vec(0.9, -0.6, 1.9), pp_vec(3.3, -0.2, 1.9));
    extends(shade(world, 1), pp_vec(0.9, 0.0, 1.9), pp_vec(3.3, 0.6, 1.9));
    assert_false(shade(world, 0)->inside);
    assert_true(shade(world, 1)->inside);
    assert_near(shade(world, 1)->front, 0.7, 0.0);
    pp_world_destroy(world);
}

/* On the east wall right is +y, seen from outside (facing west). */
static void an_overhang_moves_with_its_window(void **state)
{
    (void)state;
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    const char *xml = ROOM(WINDOW("0", "<overhang depth='0.7' right='0.3'/>"));
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    struct pp_room *room;
    assert_int_equal(pp_room_copy(&room, pp_building_room(building, 0), NULL), PP_OK);
    pp_room_set_place(
        room, 0,
        (struct pp_opening_place){
            .left_m = 1.2, .width_m = 1.5, .sill_m = 0.7, .height_m = 1.3});
    assert_int_equal(pp_room_set_wall(room, 0, "east", NULL), PP_OK);
    struct pp_world *world;
    assert_int_equal(pp_world_create(&world, room, &mistakes, NULL), PP_OK);
    extends(shade(world, 0), pp_vec(4.2, 1.2, 2.0), pp_vec(4.9, 3.0, 2.0));
    pp_world_destroy(world);
    pp_room_destroy(room);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_overhang_begins_at_the_glass),
        cmocka_unit_test(and_before_a_facade_at_its_plane),
        cmocka_unit_test(fins_stand_beside_the_jambs),
        cmocka_unit_test(a_balcony_has_a_floor_and_three_parapets),
        cmocka_unit_test(a_shelf_goes_on_in_the_room),
        cmocka_unit_test(an_overhang_moves_with_its_window),
    };
    add_tests(tests, NULL, NULL);
}
