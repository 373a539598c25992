/* test_elevation_study.c - positions of windows and walls in elevations, and the
 * vertical sky component over walls, compared with an independent integral. */
#include "studies/site/elevation_study.h"

#include "model/room/room_light.h"
#include "tests/lib/room_of.h"

enum { ROOMS_MOST = 4 };

/* Rooms of a building, as proposed or as existing. */
struct read_site {
    struct pp_building *building;
    struct pp_study_room rooms[ROOMS_MOST];
    int count;
};

static void read_site(struct read_site *site, const char *xml, enum pp_site_state state)
{
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(
        pp_building_parse(&site->building, xml, strlen(xml), &mistakes, NULL), PP_OK);
    assert_int_equal(pp_building_set_state(site->building, state, NULL), PP_OK);
    site->count = pp_building_room_count(site->building);
    assert_true(site->count <= ROOMS_MOST);
    for (int i = 0; i < site->count; i++) {
        struct pp_world *world;
        struct pp_outside_light light;
        const struct pp_room *room = pp_building_room(site->building, i);
        assert_int_equal(pp_world_create(&world, room, &mistakes, NULL), PP_OK);
        assert_int_equal(pp_room_light(&light, room, NULL), PP_OK);
        pp_study_room_init(&site->rooms[i], "test.xml", site->building, i, room, world,
                           &light);
    }
    pp_mistakes_clear(&mistakes);
}

static void clear_site(struct read_site *site)
{
    for (int i = 0; i < site->count; i++)
        pp_study_room_clear(&site->rooms[i]);
    pp_building_destroy(site->building);
}

/* A sheet, and the sites that own its names. */
struct made_sheet {
    struct pp_elevation_sheet sheet;
    struct read_site now, then;
    bool compared;
};

static void make(struct made_sheet *made, const char *xml, bool compared)
{
    const struct pp_study_room *before[ROOMS_MOST] = {NULL};
    made->compared = compared;
    read_site(&made->now, xml, PP_STATE_PROPOSED);
    if (compared)
        read_site(&made->then, xml, PP_STATE_EXISTING);
    for (int i = 0; compared && i < made->now.count; i++)
        before[i] = &made->then.rooms[i];
    const struct pp_site_rooms rooms = {made->now.rooms, before, made->now.count, 0.0};
    struct pp_error err;
    if (pp_elevation_study_make(&made->sheet, &rooms, &err) != PP_OK)
        fail_msg("%s", err.message);
}

static void clear_made(struct made_sheet *made)
{
    pp_site_sheet_clear_elevations(&made->sheet);
    clear_site(&made->now);
    if (made->compared)
        clear_site(&made->then);
}

/* Vertical sky component in front of an infinitely long parallel edge at this altitude,
 * by a sum over the sky: (9 / 7 pi) L/Lz cos(incidence) over the directions above the
 * edge. */
static double component_above(double edge_rad)
{
    enum { N = 600 };
    double sum = 0.0;
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            double azimuth = ((i + 0.5) / N - 0.5) * PP_PI;
            double low = atan(tan(edge_rad) * cos(azimuth));
            double a = low + (0.5 * PP_PI - low) * (k + 0.5) / N;
            double luminance = (1.0 + 2.0 * sin(a)) / 3.0;
            sum += luminance * cos(a) * cos(azimuth) * cos(a) * (0.5 * PP_PI - low) / N
                   * PP_PI / N;
        }
    return sum * 9.0 / (7.0 * PP_PI);
}

/* An infinitely long house 12 m high, 14 m away: the component is 27 % at the height
 * from which the house has the altitude that leaves 27 %; below this height it is
 * lower. */
static void contours_lie_where_the_house_opposite_leaves_their_component(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made,
         "<room version='1'><plan width='6' depth='5' height='9'/>"
         "<window wall='south' left='2' sill='1' width='2' height='1'/>"
         "<block x='-2000' y='-30' width='4000' depth='16' height='12'/></room>",
         false);
    assert_int_equal(sheet->count, 1);
    assert_int_equal(sheet->elevations[0].wall_count, 1);
    const struct pp_elevation_wall *wall = &sheet->elevations[0].walls[0];
    double low = 0.0, high = 80.0 * PP_RAD;
    while (high - low > 1e-6) {
        double middle = 0.5 * (low + high);
        if (component_above(middle) > 0.27)
            low = middle;
        else
            high = middle;
    }
    double height = 12.0 - 14.0 * tan(low);
    int seen = 0;
    for (int i = 0; i < wall->lines.count; i++)
        for (int k = 0;
             wall->lines.list[i].level == 0.27 && k < wall->lines.list[i].count;
             k++, seen++)
            assert_near(wall->lines.list[i].xy[k][1], height, 0.03);
    assert_true(seen >= 2 && height > 1.0 && height < 8.0);
    for (int i = 0; i < wall->below.count; i++)
        for (int k = 0;
             wall->below.list[i].level == 0.27 && k < wall->below.list[i].count; k++)
            assert_true(wall->below.list[i].xy[k][1] < height + 0.03);
    double at = component_above(atan2(12.0 - 1.5, 14.0));
    assert_near(sheet->site.windows[0].component, at, 2e-4);
    assert_true(isnan(sheet->site.windows[0].before));
    clear_made(&made);
}

static const char street[] =
    "<building version='1' name='Street' north='90'>"
    "<block name='Shed' state='existing' x='2' y='-12' width='3' depth='3' height='4'/>"
    "<block name='Tower' state='proposed' x='0' y='-12' width='8' depth='3' "
    "height='15'/>"
    "<block name='Mill' x='30' y='-12' width='8' depth='3' height='9'/>"
    "<room name='Ground' x='1' y='2' z='0.5'><plan width='5' depth='5' height='2.7'/>"
    "<window name='A' wall='south' left='1' sill='1' width='1.5' height='1.25'/></room>"
    "<room name='Wing' x='6' y='2' z='0.5' rotate='-90'>"
    "<plan width='4' depth='5' height='2.7'/>"
    "<window name='B' wall='south' left='0.5' sill='1' width='1' height='1'/></room>"
    "<room name='Upper' x='1' y='2' z='3.5'><plan width='5' depth='5' height='2.7'/>"
    "<window name='C' wall='south' left='1.5' sill='1' width='2' height='1'/></room>"
    "</building>";

static const struct pp_site_window *window_of(const struct pp_elevation_sheet *sheet,
                                              const char *name)
{
    for (int i = 0; i < sheet->site.window_count; i++)
        if (strcmp(sheet->site.windows[i].name, name) == 0)
            return &sheet->site.windows[i];
    fail_msg("no window %s", name);
    return NULL;
}

/* Left is as seen from outside. A room rotated by -90 degrees faces west with its own
 * south wall. Storeys are counted where windows are above each other. */
static void windows_stand_where_their_rooms_do(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made, street, true);
    const struct pp_site_window *a = window_of(sheet, "A"), *b = window_of(sheet, "B"),
                                *c = window_of(sheet, "C");
    assert_near(a->from.x, 2.0, 1e-9);
    assert_near(a->to.x, 3.5, 1e-9);
    assert_near(a->from.y, 2.0, 1e-9);
    assert_near(a->from.z, 1.5, 1e-9);
    assert_near(a->height_m, 1.25, 1e-9);
    assert_near(a->out.y, -1.0, 1e-9);
    assert_near(b->out.x, -1.0, 1e-9);
    assert_near(b->from.y, 1.5, 1e-9);
    assert_near(b->to.y, 0.5, 1e-9);
    assert_int_equal(a->storey, 0);
    assert_int_equal(c->storey, 1);
    assert_true(a->component < 0.8 * a->before);
    clear_made(&made);
}

/* In the south elevation u is x. The façade extends to the ground, z = 0, and 1.2 m
 * beyond the wall on the left, and is included in the drawing. The balcony is as wide
 * as the window plus 0.4 m on each side; its slab is 2.8 m above the floor of the
 * room. */
static void facades_and_balconies_are_in_the_elevation(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made,
         "<building version='1'><room name='Flat' x='10' y='0' z='3'>"
         "<plan width='4' depth='5' height='2.6'/>"
         "<facade wall='south' left='1.2' right='0.7' up='0.5' down='3' depth='0.2'/>"
         "<window wall='south' left='1' sill='0.8' width='2' height='1.5'>"
         "<balcony depth='1.5' level='2.8' left='0.4' right='0.4'/></window></room>"
         "</building>",
         false);
    const struct pp_site_elevation *south = &sheet->elevations[0];
    assert_int_equal(south->facade_count, 1);
    assert_near(south->facades[0].low[0], 10.0 - 1.2, 1e-9);
    assert_near(south->facades[0].high[0], 14.0 + 0.7, 1e-9);
    assert_near(south->facades[0].low[1], 0.0, 1e-9);
    assert_near(south->facades[0].high[1], 3.0 + 2.6 + 0.5, 1e-9);
    assert_near(south->low[0], 10.0 - 1.2, 1e-9);
    assert_true(south->shade_count >= 1);
    double low = INFINITY;
    for (int i = 0; i < south->shade_count; i++) {
        assert_true(south->shades[i].low[0] > 10.6 - 1e-9);
        assert_true(south->shades[i].high[0] < 13.4 + 1e-9);
        low = fmin(low, south->shades[i].low[1]);
    }
    assert_near(low, 3.0 + 2.8, 1e-9);
    assert_string_equal(sheet->site.windows[0].label, "W1");
    assert_string_equal(sheet->site.windows[0].room, "Flat");
    assert_string_equal(south->walls[0].room, "Flat");
    clear_made(&made);
}

/* `left` of a door is measured from outside, as for a window. A dado is inside, and the
 * door of an inner wall is in no elevation. */
static void doors_of_outer_walls_stand_where_they_are(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made,
         "<building version='1'><room x='1.3' y='2' z='0.4'>"
         "<plan width='5' depth='5' height='2.7'/>"
         "<window wall='south' left='1' sill='1' width='1.5' height='1.25'/>"
         "<door wall='south' left='3.1' width='0.97' height='2.03'/>"
         "<door wall='north' left='1'/><dado height='1.1' reflectance='0.3'/></room>"
         "</building>",
         false);
    assert_int_equal(sheet->count, 1);
    assert_int_equal(sheet->elevations[0].wall_count, 1);
    const struct pp_elevation_wall *wall = &sheet->elevations[0].walls[0];
    assert_int_equal(wall->door_count, 1);
    assert_near(wall->doors[0].low[0], 1.3 + 3.1, 1e-9);
    assert_near(wall->doors[0].high[0], 1.3 + 3.1 + 0.97, 1e-9);
    assert_near(wall->doors[0].low[1], 0.4, 1e-9);
    assert_near(wall->doors[0].high[1], 0.4 + 2.03, 1e-9);
    clear_made(&made);
}

/* In the order of the directions that they face, clockwise from north: with +y to the
 * east, -x is north and -y west. */
static void elevations_go_round_from_north(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made, street, true);
    assert_int_equal(sheet->count, 2);
    assert_near(sheet->elevations[0].bearing_rad, 0.0, 1e-9);
    assert_near(sheet->elevations[1].bearing_rad, 270.0 * PP_RAD, 1e-9);
    assert_int_equal(sheet->elevations[0].window_count, 1);
    assert_int_equal(sheet->elevations[1].window_count, 2);
    assert_near(sheet->elevations[1].high[1], 6.2, 1e-9);
    assert_near(sheet->elevations[1].low[1], 0.0, 1e-9);
    clear_made(&made);
}

/* Two houses with a court of 8 m between them that both face south: their walls overlap
 * in elevation, so each has its own elevation. The north walls have no windows and no
 * elevation. */
static void a_house_in_front_does_not_cover_the_windows_behind_it(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made,
         "<building version='1'><room name='Front'><plan width='4' depth='4' "
         "height='3'/>"
         "<window name='F' wall='south' left='1' sill='1' width='1' height='1'/></room>"
         "<room name='Back' x='2' y='12'><plan width='4' depth='4' height='3'/>"
         "<window name='B' wall='south' left='1' sill='1' width='1' height='1'/></room>"
         "</building>",
         false);
    assert_int_equal(sheet->count, 2);
    for (int i = 0; i < 2; i++) {
        const struct pp_site_elevation *one = &sheet->elevations[i];
        assert_int_equal(one->layer, i);
        assert_int_equal(one->wall_count, 1);
        assert_int_equal(one->window_count, 1);
        assert_string_equal(one->walls[0].room, i == 0 ? "Front" : "Back");
        assert_string_equal(sheet->site.windows[one->windows[0]].label,
                            i == 0 ? "F" : "B");
    }
    clear_made(&made);
}

/* Changes of obstructions: the shed is demolished, the tower is proposed, the mill is
 * unchanged. */
static void demolished_and_proposed_blocks_are_distinguished(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    int sides[3] = {0};
    make(&made, street, true);
    for (int i = 0; i < sheet->site.shape_count; i++) {
        const struct pp_site_shape *shape = &sheet->site.shapes[i];
        const char *name = shape->name;
        if (name && strcmp(name, "Shed") == 0) {
            assert_int_equal(shape->when, PP_SITE_GONE);
            sides[0]++;
        } else if (name && strcmp(name, "Tower") == 0) {
            assert_int_equal(shape->when, PP_SITE_NEW);
            assert_near(shape->top_m, 15.0, 1e-9);
            sides[1]++;
        } else if (name && strcmp(name, "Mill") == 0) {
            assert_int_equal(shape->when, PP_SITE_ALWAYS);
            sides[2]++;
        }
    }
    for (int i = 0; i < 3; i++)
        assert_true(sides[i] >= 5);
    clear_made(&made);
}

/* In the south elevation u is x of the building. A crown is drawn if it is before the
 * wall that it covers: not one behind, far to the side, or removed. */
static void crowns_before_a_wall_are_in_its_elevation(void **state)
{
    (void)state;
    struct made_sheet made;
    const struct pp_elevation_sheet *sheet = &made.sheet;
    make(&made,
         "<building version='1'><site>"
         "<tree x='3' y='-9' height='7' crown-base='2' crown-width='3' "
         "transmittance='0.2' winter-transmittance='0.7'/>"
         "<tree x='6' y='-4' height='3.5' crown-base='1' crown-width='2.4' "
         "transmittance='0.3' state='proposed'/>"
         "<tree x='4' y='12' height='9' crown-width='3' transmittance='0.2'/>"
         "<tree x='20' y='-9' height='9' crown-width='3' transmittance='0.2'/>"
         "<tree x='4' y='-6' height='9' crown-width='3' transmittance='0.2' "
         "state='existing'/></site>"
         "<room x='2' y='1' z='0.4'><plan width='5' depth='5' height='2.7'/>"
         "<window wall='south' left='1' sill='1' width='1.5' height='1.25'/></room>"
         "</building>",
         true);
    assert_int_equal(sheet->site.tree_count, 5);
    const struct pp_site_elevation *south = &sheet->elevations[0];
    assert_int_equal(south->crown_count, 2);
    const struct pp_site_tree *foremost = &sheet->site.trees[south->crown_trees[0]];
    assert_near(foremost->foot.y, -9.0, 1e-9);
    assert_near(foremost->winter_transmittance, 0.7, 1e-12);
    assert_int_equal(foremost->when, PP_SITE_ALWAYS);
    assert_near(south->crowns[0].low[0], 1.5, 1e-9);
    assert_near(south->crowns[0].high[0], 4.5, 1e-9);
    assert_near(south->crowns[0].low[1], 2.0, 1e-9);
    assert_near(south->crowns[0].high[1], 7.0, 1e-9);
    assert_int_equal(sheet->site.trees[south->crown_trees[1]].when, PP_SITE_NEW);
    assert_near(south->crowns[1].high[0], 7.2, 1e-9);
    /* The drawing ends at most 1.5 m outside the wall. */
    assert_near(south->low[0], 1.5, 1e-9);
    assert_near(south->high[0], 7.2, 1e-9);
    assert_near(south->high[1], 0.4 + 2.7 + 1.5, 1e-9);
    int gone = 0;
    for (int i = 0; i < sheet->site.tree_count; i++)
        gone += sheet->site.trees[i].when == PP_SITE_GONE;
    assert_int_equal(gone, 1);
    clear_made(&made);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contours_lie_where_the_house_opposite_leaves_their_component),
        cmocka_unit_test(windows_stand_where_their_rooms_do),
        cmocka_unit_test(crowns_before_a_wall_are_in_its_elevation),
        cmocka_unit_test(facades_and_balconies_are_in_the_elevation),
        cmocka_unit_test(doors_of_outer_walls_stand_where_they_are),
        cmocka_unit_test(elevations_go_round_from_north),
        cmocka_unit_test(a_house_in_front_does_not_cover_the_windows_behind_it),
        cmocka_unit_test(demolished_and_proposed_blocks_are_distinguished),
    };
    add_tests(tests, NULL, NULL);
}
