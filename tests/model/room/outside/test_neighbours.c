/* test_neighbours.c - exterior parts of a building's rooms obstruct the other rooms in
 * the same way as equal polygons in the file of a single room. */
#include <math.h>
#include <stdio.h>

#include "methods/exact/exterior.h"
#include "model/room/building.h"
#include "tests/lib/room_of.h"

/* World of a room of the building, whose element has these attributes. line: adds the
 * mirror image at this boundary; NULL: as proposed. */
static struct pp_world *world_by(const char *attributes, const char *inside, int index,
                                 const struct pp_mirror_line *line)
{
    char xml[8192];
    snprintf(xml, sizeof xml, "<building version=\"1\" %s>%s</building>", attributes,
             inside);
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    if (pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL) != PP_OK
        || (line && pp_building_mirror(building, line, NULL) != PP_OK)
        || pp_world_create(&world, pp_building_room(building, index), &mistakes, NULL)
               != PP_OK)
        fail_msg("%s: %s", xml, mistakes.count ? mistakes.list[0].text : "no room");
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return world;
}

static struct pp_world *world_in(const char *attributes, const char *inside, int index)
{
    return world_by(attributes, inside, index, NULL);
}

/* Vertical sky component at the first opening. */
static double component_of(const struct pp_world *world)
{
    const struct pp_sky overcast = pp_sky_overcast();
    const struct pp_opening *opening = &world->openings[0];
    double share;
    assert_int_equal(pp_exterior_sky_on_plane(&share, world, opening,
                                              pp_vec_scale(opening->inner.normal, -1.0),
                                              &overcast, NULL),
                     PP_OK);
    return share;
}

static double component_in(const char *inside, int index)
{
    struct pp_world *world = world_in("", inside, index);
    double share = component_of(world);
    pp_world_destroy(world);
    return share;
}

static double component_alone(const char *inside)
{
    char room[6144];
    snprintf(room, sizeof room, "<room>%s</room>", inside);
    return component_in(room, 0);
}

#define V(x, y, z) "<vertex x='" #x "' y='" #y "' z='" #z "'/>"
#define QUAD(a, b, c, d) "<surface>" a b c d "</surface>"
#define PLAN "<plan width='4.2' depth='5.3' height='2.7'/>"
#define WINDOW "<window wall='south' left='0.9' sill='0.8' width='2.4' height='1.5'"
#define ROOM PLAN WINDOW "/>"

/* A balcony 1.4 m deep in front of the room above, 3.1 m up; it begins in the plane of
 * the glass below it. */
static void a_balcony_above_is_four_plates(void **state)
{
    (void)state;
    double below = component_in(
        "<room x='7' y='-2' z='0.4'>" ROOM "</room>"
        "<room x='7' y='-2' z='3.5'>" PLAN "<window wall='south' left='0.9' sill='0' "
        "width='2.4' height='2.1'><balcony depth='1.4' left='0.5' right='0.7' "
        "parapet='1.2'/></window></room>",
        0);
    double plates = component_alone(
        ROOM QUAD(V(0.4, 0, 3.1), V(4, 0, 3.1), V(4, -1.4, 3.1), V(0.4, -1.4, 3.1))
            QUAD(V(0.4, 0, 3.1), V(0.4, -1.4, 3.1), V(0.4, -1.4, 4.3), V(0.4, 0, 4.3))
                QUAD(V(0.4, -1.4, 3.1), V(4, -1.4, 3.1), V(4, -1.4, 4.3),
                     V(0.4, -1.4, 4.3))
                    QUAD(V(4, -1.4, 3.1), V(4, 0, 3.1), V(4, 0, 4.3), V(4, -1.4, 4.3)));
    assert_near(below, plates, 1e-9);
    assert_true(below < component_alone(ROOM) - 0.05);
}

/* A room rotated by 180 degrees, 9 m away: its façade is a rectangle, 2.3 m longer to
 * its right (our left), up to 7.9 m, 0.35 m in front of its wall. */
static void a_facade_opposite_hides_its_rectangle(void **state)
{
    (void)state;
    double before = component_in(
        "<room x='0' y='0'>" ROOM
        "</room><room x='4.2' y='-9' rotate='180'>" PLAN WINDOW
        " reveal='0.2'/><facade wall='south' left='1.1' right='2.3' up='5.2' "
        "depth='0.35'/></room>",
        0);
    double rectangle = component_alone(
        ROOM "<block x='0' y='-14.3' width='4.2' depth='5.3' height='2.7'/>" QUAD(
            V(-2.3, -8.65, 0), V(5.3, -8.65, 0), V(5.3, -8.65, 7.9),
            V(-2.3, -8.65, 7.9)));
    assert_near(before, rectangle, 1e-9);
    assert_true(before < component_alone(ROOM "<block x='0' y='-14.3' width='4.2' "
                                              "depth='5.3' height='2.7'/>")
                             - 0.05);
}

/* The overhang of a rotated room, and a screen of its own, calculated independently in
 * the axes of the other room. */
static void what_a_turned_room_carries_is_turned_with_it(void **state)
{
    (void)state;
    double before = component_in(
        "<room x='0' y='0'>" ROOM "</room><room x='1' y='-4' z='0.5' rotate='150'>" PLAN
        "<window wall='south' left='0.6' sill='0.7' width='3' height='1.6'><overhang "
        "depth='1.9' above='0.1'/></window><surface><vertex x='-1' y='-2' z='0'/>"
        "<vertex x='0' y='-2' z='0'/><vertex x='0' y='-2' z='5.1'/></surface></room>",
        0);
    char alone[4096], *end = alone;
    const double points[][3] = {{0.6, 0, 2.4},    {3.6, 0, 2.4}, {3.6, -1.9, 2.4},
                                {0.6, -1.9, 2.4}, {-1, -2, 0},   {0, -2, 0},
                                {0, -2, 5.1}};
    const double c = cos(150.0 * M_PI / 180.0), s = sin(150.0 * M_PI / 180.0);
    end += sprintf(end, ROOM);
    for (int i = 0; i < 7; i++) {
        const double *p = points[i];
        if (i == 0 || i == 4)
            end += sprintf(end, "%s<surface>", i ? "</surface>" : "");
        end +=
            sprintf(end, "<vertex x='%.17g' y='%.17g' z='%.17g'/>",
                    1.0 + c * p[0] - s * p[1], -4.0 + s * p[0] + c * p[1], 0.5 + p[2]);
    }
    end += sprintf(end, "</surface>");
    const double box[2] = {1.0, -4.0};
    double bare = component_alone(alone);
    sprintf(end,
            "<block x='%.17g' y='%.17g' base='0.5' width='4.2' depth='5.3' "
            "height='2.7' rotate='150'/>",
            box[0], box[1]);
    assert_near(before, component_alone(alone), 1e-9);
    assert_true(before < bare);
}

/* A façade that extends 30 m past the storeys above and below, flush or 0.3 m out,
 * hides no sky from the windows in it: their sky is that of the room alone. */
static void a_front_hides_nothing_of_the_windows_in_it(void **state)
{
    (void)state;
    double flush = component_in("<room z='3' x='0'>" ROOM
                                "<facade wall='south' left='30' right='30' up='30' "
                                "down='30'/></room><room z='6' x='0'>" ROOM "</room>",
                                1);
    assert_near(flush, component_alone(ROOM), 1e-12);
    const char *deep =
        "<room z='3' x='0'>" PLAN WINDOW
        " reveal='0.3'/><facade wall='south' left='30' right='30' up='30' "
        "down='30'/></room><room z='6' x='0'>" PLAN WINDOW
        " reveal='0.3'/></room><room z='9' x='0'>" PLAN WINDOW
        " reveal='0.1'/><facade wall='south' depth='0.3'/></room>";
    assert_near(component_in(deep, 1), component_alone(PLAN WINDOW " reveal='0.3'/>"),
                1e-9);
    /* Seen from 0.2 m behind the façade; the room's own façade extends no further in
     * any direction. */
    assert_near(component_in(deep, 2),
                component_alone(PLAN WINDOW " reveal='0.1'/><facade wall='south' "
                                            "depth='0.3'/>"),
                1e-9);
}

/* Two storeys half a metre apart, and a façade that closes the gap: from opposite it is
 * one wall, 6.1 m high. */
static void a_front_leaves_no_gap_between_storeys(void **state)
{
    (void)state;
    double opposite = component_in("<room x='0' y='0' z='0'>" ROOM
                                   "</room><room x='9' y='-8' z='0' rotate='180'>"
                                   "<plan width='13.7' depth='4' height='2.7'/>" WINDOW
                                   "/></room><room x='9' y='-8' z='3.4' rotate='180'>"
                                   "<plan width='13.7' depth='4' height='2.7'/>" WINDOW
                                   "/><facade wall='south' down='3.4'/></room>",
                                   0);
    double one = component_alone(
        ROOM "<block x='-4.7' y='-12' width='13.7' depth='4' height='6.1'/>");
    assert_near(opposite, one, 1e-9);
    double gaping = component_in(
        "<room x='0' y='0' z='0'>" ROOM "</room><room x='9' y='-8' z='0' rotate='180'>"
        "<plan width='13.7' depth='4' height='2.7'/></room><room x='9' y='-8' z='3.4' "
        "rotate='180'><plan width='13.7' depth='4' height='2.7'/></room>",
        0);
    assert_true(gaping > one + 1e-4);
}

/* A bay extends 1.2 m out of the façade of its neighbour, which ends there. */
static void a_front_ends_at_a_bay_that_comes_through_it(void **state)
{
    (void)state;
    double bay =
        component_in("<room x='0' y='0'>" ROOM "<facade wall='south' right='9' "
                     "depth='0.2'/></room><room x='4.2' y='-1.2'>" ROOM "</room>",
                     1);
    assert_near(bay, component_alone(ROOM), 1e-9);
    /* The west wall of the room faces along the façade, which begins 1 m behind its
     * window. */
    double aside = component_in(
        "<room x='0' y='0'>" ROOM "<facade wall='south' right='9' depth='0.2'/></room>"
        "<room x='4.2' y='-3'>" PLAN "<window wall='west' left='3.4' sill='0.8' "
        "width='1.1' height='1.5'/></room>",
        1);
    double plate = component_alone(
        PLAN "<window wall='west' left='3.4' sill='0.8' width='1.1' height='1.5'/>"
             "<block x='-4.2' y='3' width='4.2' depth='5.3' height='2.7'/>" QUAD(
                 V(-4.2, 2.8, 0), V(0, 2.8, 0), V(0, 2.8, 2.7), V(-4.2, 2.8, 2.7)));
    assert_near(aside, plate, 1e-9);
}

/* A block that two rooms repeat exists once. A room's block also obstructs the other
 * rooms, but only in its own state: the file is read as proposed. */
static void a_rooms_own_block_shades_the_others_in_its_state(void **state)
{
    (void)state;
#define BLOCK(x, more)                                                                 \
    "<block x='" #x "' y='-9' width='4' depth='3' height='8' " more "/>"
    double by_other =
        component_in("<room x='0'>" ROOM
                     "</room><room x='6'>" ROOM BLOCK(-5, "state='proposed'") "</room>",
                     0);
    assert_near(by_other, component_alone(ROOM BLOCK(1, "")), 1e-12);
    assert_near(
        component_in("<room x='0'>" ROOM BLOCK(1, "") "</room><room x='6'>" ROOM BLOCK(
                         -5, "") "</room>",
                     0),
        component_alone(ROOM BLOCK(1, "")), 1e-12);
    assert_near(component_in("<room x='0'>" ROOM "</room><room x='6'>" ROOM BLOCK(
                                 -5, "state='existing'") "</room>",
                             0),
                component_alone(ROOM), 1e-12);
}

/* A room 4.2 by 5.3 by 2.7 m has 44.52 m2 of floor and roof and 51.3 m2 of walls,
 * including a window of 3.6 m2. Panes have a reflectance of 0.15; walls have 0.2, or
 * 0.35 where a façade in the plane of the south wall (11.34 m2) sets it. */
static void panes_are_areas_of_their_own_reflectance(void **state)
{
    (void)state;
    const double whole_m2 = 44.52 + 51.3, pane_m2 = 2.4 * 1.5;
    static const char *const facades[] = {"",
                                          "<facade wall='south' reflectance='0.35'/>"};
    const double wanted[] = {0.2 * (whole_m2 - pane_m2) + 0.15 * pane_m2,
                             0.2 * (whole_m2 - 11.34) + 0.35 * (11.34 - pane_m2)
                                 + 0.15 * pane_m2};
    for (int i = 0; i < 2; i++) {
        char inside[1024];
        double area_m2 = 0.0, reflecting_m2 = 0.0, glass_m2 = 0.0;
        snprintf(inside, sizeof inside,
                 "<room x='0' y='0'>" ROOM "</room><room x='1' y='-4' z='0.5' "
                 "rotate='150'>" ROOM "%s</room>",
                 facades[i]);
        struct pp_world *world = world_in("glass-reflectance='0.15'", inside, 0);
        for (int k = world->face_count; k < world->surface_count; k++) {
            const struct pp_surface *surface = &world->surfaces[k];
            area_m2 += surface->outline.area_m2;
            reflecting_m2 += surface->front * surface->outline.area_m2;
            if (surface->front == 0.15)
                glass_m2 += surface->outline.area_m2;
        }
        assert_near(area_m2, whole_m2, 1e-9);
        assert_near(glass_m2, pane_m2, 1e-9);
        assert_near(reflecting_m2, wanted[i], 1e-9);
        double by_pieces = component_of(world);
        pp_world_destroy(world);
        assert_near(by_pieces, component_in(inside, 0), 1e-12);
    }
}

/* A house 5.3 m deep whose façade is 4 m behind a boundary at 30 degrees, seen from its
 * window. The mirror image is the box rotated by 60 degrees about the mirrored corner,
 * calculated independently, with a façade up to 6 m. Proposed blocks and blocks to be
 * demolished are not included. */
static void the_mirror_image_is_the_house_beyond_the_boundary(void **state)
{
    (void)state;
    const double turn = 30.0 * M_PI / 180.0, c = cos(2.0 * turn), s = sin(2.0 * turn);
    const struct pp_mirror_line line = {{0.0, -4.0},
                                        {7.0 * cos(turn), -4.0 + 7.0 * sin(turn)}};
    static const char inside[] =
        "<block state='proposed' x='0' y='-20' width='9' depth='5' height='40'/>"
        "<block state='existing' x='0' y='-20' width='9' depth='5' height='40'/>"
        "<room x='-6' y='1' z='0.3'>" ROOM "<facade wall='south' up='3.3'/></room>";
    struct pp_world *world = world_by("", inside, 0, &line);
    double mirrored = component_of(world);
    pp_world_destroy(world);
    /* A corner of the building and its mirror image, in the axes of the room. */
    char alone[4096], *end = alone;
    const double corners[4][2] = {{-6, 1}, {-1.8, 1}, {-1.8, 6.3}, {-6, 6.3}};
    double image[4][2];
    for (int i = 0; i < 4; i++) {
        double x = corners[i][0], y = corners[i][1] + 4.0;
        image[i][0] = c * x + s * y + 6.0;
        image[i][1] = s * x - c * y - 4.0 - 1.0;
    }
    end += sprintf(end,
                   ROOM "<facade wall='south' up='3.3'/><block x='%.17g' y='%.17g' "
                        "base='0' width='4.2' depth='5.3' height='2.7' rotate='%.17g'/>"
                        "<surface>",
                   image[3][0], image[3][1],
                   atan2(image[2][1] - image[3][1], image[2][0] - image[3][0]) * 180.0
                       / M_PI);
    for (int i = 0; i < 4; i++) /* over its front */
        end += sprintf(end, "<vertex x='%.17g' y='%.17g' z='%g'/>",
                       image[i == 1 || i == 2][0], image[i == 1 || i == 2][1],
                       i < 2 ? 2.7 : 6.0);
    sprintf(end, "</surface>");
    assert_near(mirrored, component_alone(alone), 1e-9);
    assert_true(mirrored < 0.39);
}

static void a_boundary_through_the_building_has_no_mirror_image(void **state)
{
    (void)state;
    static const struct {
        struct pp_mirror_line line;
        const char *why;
    } lines[] = {{{{-9.0, 1.0}, {9.0, 1.1}}, "crosses the room \"A\""},
                 {{{5.0, 0.0}, {5.0, 3.0}}, "are on opposite sides"}};
    static const char xml[] =
        "<building version='1'><room name='A' x='0'>" ROOM
        "</room><room name='B' x='7' y='4'>" ROOM "</room></building>";
    for (int i = 0; i < 2; i++) {
        struct pp_building *building = NULL;
        struct pp_mistakes mistakes;
        struct pp_error err = {0};
        pp_mistakes_init(&mistakes, "test");
        assert_int_equal(
            pp_building_parse(&building, xml, strlen(xml), &mistakes, &err), PP_OK);
        assert_int_equal(pp_building_mirror(building, &lines[i].line, &err),
                         PP_BAD_INPUT);
        assert_non_null(strstr(err.message, lines[i].why));
        assert_int_equal(pp_building_room_count(building), 0);
        pp_building_destroy(building);
        pp_mistakes_clear(&mistakes);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_balcony_above_is_four_plates),
        cmocka_unit_test(a_facade_opposite_hides_its_rectangle),
        cmocka_unit_test(what_a_turned_room_carries_is_turned_with_it),
        cmocka_unit_test(a_front_hides_nothing_of_the_windows_in_it),
        cmocka_unit_test(a_front_leaves_no_gap_between_storeys),
        cmocka_unit_test(a_front_ends_at_a_bay_that_comes_through_it),
        cmocka_unit_test(the_mirror_image_is_the_house_beyond_the_boundary),
        cmocka_unit_test(a_boundary_through_the_building_has_no_mirror_image),
        cmocka_unit_test(panes_are_areas_of_their_own_reflectance),
        cmocka_unit_test(a_rooms_own_block_shades_the_others_in_its_state),
    };
    add_tests(tests, NULL, NULL);
}
