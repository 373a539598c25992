/* test_facades.c - the façade of a wall: its surface, its holes and their edges. */
#include "model/room/room.h"
#include "model/room/world.h"
#include "tests/lib/room_of.h"

#define ROOM(parts)                                                                    \
    "<room version='1'><site ground-level='-0.4'/>"                                    \
    "<plan width='4.3' depth='6.1' height='2.9'/>" parts "</room>"

#define WINDOW                                                                         \
    "<window wall='east' left='0.6' sill='0.7' width='1.9' height='1.3' "              \
    "reveal='0.28'/>"

/* An opening with a pointed head, 1.4 m2. */
#define POINTED                                                                        \
    "<opening reveal='0.11'><vertex x='4.3' y='4.3' z='0.8'/>"                         \
    "<vertex x='4.3' y='3.3' z='0.8'/><vertex x='4.3' y='3.3' z='2.0'/>"               \
    "<vertex x='4.3' y='3.8' z='2.4'/><vertex x='4.3' y='4.3' z='2.0'/></opening>"

/* Areas of a façade's pieces: the normal of the main surface is `out`; the edges of
 * holes are perpendicular to it. */
struct measure {
    double sheet_m2, rim_m2;
    int pieces;
};

static struct measure measure_of(const struct pp_world *world, struct pp_vec3 out)
{
    struct measure sum = {0.0, 0.0, 0};
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *piece = &world->surfaces[i];
        if (piece->role != PP_FACADE)
            continue;
        double along = pp_vec_dot(piece->outline.normal, out);
        assert_false(piece->inside);
        assert_true(along > 1.0 - 1e-9 || fabs(along) < 1e-9);
        *(along > 0.5 ? &sum.sheet_m2 : &sum.rim_m2) += piece->outline.area_m2;
        sum.pieces++;
    }
    return sum;
}

/* 2.3 m to the left, 3.1 to the right, 1.7 up, and down to the ground. Seen from
 * outside, left of an east wall is south. */
static void a_sheet_is_its_rectangle_less_the_openings(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM(WINDOW POINTED "<facade wall='east' left='2.3' right='3.1' up='1.7' "
                            "down='0.9' reflectance='0.37'/>"));
    assert_int_equal(world->facade_count, 1);
    const struct pp_facade *facade = &world->facades[0];
    static const double places[4][2] = {
        {-2.3, -0.4}, {6.1 + 3.1, -0.4}, {6.1 + 3.1, 4.6}, {-2.3, 4.6}};
    for (int k = 0; k < 4; k++) {
        assert_near(facade->corners[k].x, 4.3 + 0.28, 1e-12);
        assert_near(facade->corners[k].y, places[k][0], 1e-12);
        assert_near(facade->corners[k].z, places[k][1], 1e-12);
    }
    assert_near(facade->down_m, 0.4, 1e-12);

    struct measure sum = measure_of(world, pp_vec(1.0, 0.0, 0.0));
    assert_near(sum.sheet_m2, 11.5 * 5.0 - 1.9 * 1.3 - 1.4, 1e-7);
    /* The glass of the first opening is in the plane of the façade; that of the other
     * is 0.17 m behind it. */
    assert_near(world->openings[0].recess_m, 0.0, 0.0);
    assert_near(world->openings[1].recess_m, 0.17, 1e-12);
    double round_m = 1.0 + 2.0 * 1.2 + 2.0 * hypot(0.5, 0.4);
    assert_near(sum.rim_m2, 0.17 * round_m, 1e-12);
    for (int i = world->face_count; i < world->surface_count; i++)
        if (world->surfaces[i].role == PP_FACADE)
            assert_near(world->surfaces[i].front, 0.37, 0.0);
    pp_world_destroy(world);
}

static bool same(struct pp_vec3 a, struct pp_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* True if the outline contains the edge from b to a. */
static bool runs_back(const struct pp_polygon *outline, struct pp_vec3 a,
                      struct pp_vec3 b)
{
    for (int i = 0; i < outline->count; i++)
        if (same(outline->vertices[i], b)
            && same(outline->vertices[(i + 1) % outline->count], a))
            return true;
    return false;
}

/* True if both ends are on one side of the rectangle. */
static bool is_border(const struct pp_facade *facade, struct pp_vec3 a,
                      struct pp_vec3 b)
{
    for (int k = 0; k < 4; k++) {
        struct pp_vec3 p = facade->corners[k];
        struct pp_vec3 side = pp_vec_unit(pp_vec_sub(facade->corners[(k + 1) % 4], p));
        if (pp_vec_length(pp_vec_cross(side, pp_vec_sub(a, p))) < 1e-8
            && pp_vec_length(pp_vec_cross(side, pp_vec_sub(b, p))) < 1e-8)
            return true;
    }
    return false;
}

/* Each edge of a piece is exactly an edge of another piece in the opposite direction,
 * an edge of the glass, or the border of the façade, so no ray can pass between
 * pieces. */
static void no_light_gets_between_the_pieces(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM(WINDOW POINTED
             "<window wall='east' left='4.9' sill='0' width='1.2' height='2.1'/>"
             "<facade wall='east' left='2.3' right='3.1' up='1.7' depth='0.43'/>"));
    int edges = 0, borders = 0, glass = 0;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_polygon *piece = &world->surfaces[i].outline;
        for (int k = 0; k < piece->count && world->surfaces[i].role == PP_FACADE; k++) {
            struct pp_vec3 a = piece->vertices[k];
            struct pp_vec3 b = piece->vertices[(k + 1) % piece->count];
            int found = 0;
            for (int other = 0; other < world->surface_count; other++)
                found += world->surfaces[other].role == PP_FACADE
                         && runs_back(&world->surfaces[other].outline, a, b);
            for (int o = 0; o < world->opening_count && !found; o++) {
                found = runs_back(&world->openings[o].outer, b, a);
                glass += found;
            }
            if (!found && is_border(&world->facades[0], a, b))
                found = ++borders > 0;
            assert_int_equal(found, 1);
            edges++;
        }
    }
    assert_int_equal(glass, 4 + 5 + 4);
    assert_true(borders >= 4);
    assert_true(edges > 3 * (glass + borders));
    pp_world_destroy(world);
}

/* A façade in the plane of the wall omits the part in front of the wall, whose back is
 * the façade. */
static void in_the_wall_s_own_plane_the_wall_is_the_facade(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM("<window wall='north' left='0.9' sill='1' width='1.7' height='1'/>"
             "<facade wall='north' left='3.3' up='2.1' reflectance='0.61'/>"));
    struct measure sum = measure_of(world, pp_vec(0.0, 1.0, 0.0));
    assert_near(sum.sheet_m2, (4.3 + 3.3) * (2.9 + 2.1) - 4.3 * 2.9, 1e-7);
    assert_near(sum.rim_m2, 0.0, 0.0);
    const struct pp_surface *wall = &world->surfaces[world->openings[0].face];
    assert_near(wall->back, 0.61, 0.0);
    for (int i = 0; i < world->face_count; i++)
        if (&world->surfaces[i] != wall)
            assert_near(world->surfaces[i].back, 0.2, 0.0);
    pp_world_destroy(world);

    world = pp_test_world(ROOM("<facade wall='north' reflectance='0.61'/>"));
    assert_int_equal(measure_of(world, pp_vec(0.0, 1.0, 0.0)).pieces, 0);
    pp_world_destroy(world);
}

/* The façade of one leg of a U extends across the other leg: it has a hole for the
 * window of that leg, as deep as the distance of the window. */
static void the_other_wing_s_window_has_its_hole_too(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan height='2.7'><vertex x='0' y='0'/>"
        "<vertex x='2' y='0'/><vertex x='2' y='2.3'/><vertex x='4' y='2.3'/>"
        "<vertex x='4' y='0'/><vertex x='6.3' y='0'/><vertex x='6.3' y='5.3'/>"
        "<vertex x='0' y='5.3'/></plan>"
        "<window wall='5' left='0.4' sill='0.9' width='1.1' height='1.3' reveal='0.1'/>"
        "<facade wall='1' right='5' depth='0.3'/></room>");
    struct measure sum = measure_of(world, pp_vec(0.0, -1.0, 0.0));
    assert_near(sum.sheet_m2, 7.0 * 2.7 - 1.1 * 1.3, 1e-7);
    assert_near(sum.rim_m2, 2.0 * (1.1 + 1.3) * 0.2, 1e-12);
    assert_int_equal(world->openings[0].facade, 0);
    pp_world_destroy(world);
}

/* A neighbouring house may touch the façade or extend into it. */
static void a_block_may_extend_into_a_facade(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM(WINDOW "<facade wall='east' left='9' right='9' up='6'/>"
                    "<block x='4.3' y='-8' width='5' depth='6' height='9'/>"));
    assert_int_equal(world->block_count, 1);
    assert_near(measure_of(world, pp_vec(1.0, 0.0, 0.0)).sheet_m2,
                (6.1 + 18.0) * 8.9 - 1.9 * 1.3, 1e-7);
    pp_world_destroy(world);
}

/* "Without surroundings" removes the neighbours but not the room's own façade. */
static void a_room_without_surroundings_keeps_its_facade(void **state)
{
    (void)state;
    static const char xml[] =
        ROOM(WINDOW "<facade wall='east' left='9'/>"
                    "<block x='14' y='0' width='5' depth='6' height='9'/>");
    struct pp_mistakes mistakes;
    struct pp_building *building = NULL;
    struct pp_room *room = NULL;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    struct pp_world *world = pp_test_world(xml), *cleared = NULL;
    assert_int_equal(pp_room_copy(&room, pp_building_room(building, 0), NULL), PP_OK);
    pp_building_destroy(building);
    pp_room_clear_surroundings(room, world);
    assert_int_equal(pp_world_create(&cleared, room, &mistakes, NULL), PP_OK);
    assert_int_equal(cleared->block_count, 0);
    assert_int_equal(cleared->facade_count, 1);
    struct pp_vec3 east = {1.0, 0.0, 0.0};
    assert_near(measure_of(cleared, east).sheet_m2, measure_of(world, east).sheet_m2,
                0.0);
    pp_mistakes_clear(&mistakes);
    pp_room_destroy(room);
    pp_world_destroy(world);
    pp_world_destroy(cleared);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_is_its_rectangle_less_the_openings),
        cmocka_unit_test(no_light_gets_between_the_pieces),
        cmocka_unit_test(in_the_wall_s_own_plane_the_wall_is_the_facade),
        cmocka_unit_test(the_other_wing_s_window_has_its_hole_too),
        cmocka_unit_test(a_block_may_extend_into_a_facade),
        cmocka_unit_test(a_room_without_surroundings_keeps_its_facade),
    };
    add_tests(tests, NULL, NULL);
}
