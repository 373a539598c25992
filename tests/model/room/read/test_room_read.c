/* test_room_read.c - every element and attribute of a room file is stored in the right
 * field. */
#include "model/room/building.h"

#include <stdio.h>
#include <stdlib.h>

#include "model/room/room_parts.h"
#include "tests/lib/near.h"
#include "model/room/room.h"

static struct pp_building *read_good(const char *xml)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {0};
    pp_mistakes_init(&mistakes, "test");
    enum pp_status status =
        pp_building_parse(&building, xml, strlen(xml), &mistakes, &err);
    for (int i = 0; i < mistakes.count; i++)
        print_message("# %d: %s\n", mistakes.list[i].line, mistakes.list[i].text);
    assert_int_equal(status, PP_OK);
    assert_non_null(building);
    pp_mistakes_clear(&mistakes);
    return building;
}

#define DEG (3.14159265358979323846 / 180.0)

static void the_contract_s_own_room(void **state)
{
    (void)state;
    struct pp_building *b = read_good(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<room version=\"1\" name=\"Deep office\" north=\"30\">\n"
        "  <site latitude=\"51.5\" longitude=\"-0.1\" surroundings=\"urban\"\n"
        "        ground-reflectance=\"0.25\" ground-level=\"-3.1\"/>\n"
        "  <sky type=\"iso-12\" sun-altitude=\"40\" sun-bearing=\"200\"/>\n"
        "  <plan width=\"3.1\" depth=\"9.2\" height=\"2.7\"/>\n"
        "  <finishes floor=\"0.21\" walls=\"0.71\" ceiling=\"0.81\"/>\n"
        "  <finish wall=\"north\" reflectance=\"light\"/>\n"
        "  <window wall=\"south\" left=\"0.2\" sill=\"0.8\" width=\"2.6\"\n"
        "    height=\"1.5\" glazing=\"clear-double\" frame-factor=\"0.8\"\n"
        "    maintenance=\"auto\" reveal=\"0.15\"/>\n"
        "  <window wall=\"east\" left=\"-0.2\" sill=\"0\" width=\"1\" height=\"2\"\n"
        "    transmittance=\"0.6\" diffusing=\"yes\" maintenance=\"0.7\"/>\n"
        "  <rooflight x=\"1\" y=\"2\" width=\"0.9\" depth=\"1.2\" glazing=\"none\"/>\n"
        "  <opening transmittance=\"0.77\">\n"
        "    <vertex x=\"0.3\" y=\"0\" z=\"1\"/><vertex x=\"1\" y=\"0\" z=\"1.1\"/>\n"
        "    <vertex x=\"1\" y=\"0\" z=\"2\"/></opening>\n"
        "  <skyline wall=\"south\" angle=\"20\" distance=\"14\" reflectance=\"0.3\"/>\n"
        "  <skyline wall=\"east\" angle=\"10\"/>\n"
        "  <block x=\"-4\" y=\"-14\" width=\"10\" depth=\"6\" base=\"0.4\"\n"
        "    height=\"8\" rotate=\"15\" reflectance=\"brick\"/>\n"
        "  <block x=\"-4\" y=\"-34\" width=\"10\" depth=\"6\" height=\"8\"/>\n"
        "  <surface reflectance=\"0.4\" exitance=\"0.1\">\n"
        "    <vertex x=\"0\" y=\"-1\" z=\"2\"/><vertex x=\"1\" y=\"-1\" z=\"2\"/>\n"
        "    <vertex x=\"1\" y=\"-2\" z=\"2.5\"/></surface>\n"
        "  <working-plane height=\"0.7\"/>\n"
        "  <point x=\"1.5\" y=\"2.5\"/>\n"
        "  <point x=\"1.5\" y=\"2.5\" z=\"1.2\" nx=\"0\" ny=\"-1\" nz=\"0.5\"/>\n"
        "  <line from=\"1.5 0.5\" to=\"1.6 8.5\" points=\"17\"/>\n"
        "  <grid spacing=\"0.25\" margin=\"0\"/>\n"
        "  <grid/>\n"
        "</room>\n");
    assert_null(pp_building_name(b));
    assert_int_equal(pp_building_room_count(b), 1);
    const struct pp_room *room = pp_building_room(b, 0);
    assert_string_equal(room->name, "Deep office");
    assert_int_equal(room->line, 2);
    assert_near(room->north_rad, 30 * DEG, 1e-15);

    assert_near(room->site.latitude_rad, 51.5 * DEG, 1e-15);
    assert_near(room->site.longitude_rad, -0.1 * DEG, 1e-15);
    assert_int_equal(room->site.surroundings, PP_URBAN);
    assert_true(room->site.ground_reflectance == 0.25);
    assert_true(room->site.ground_level_m == -3.1);
    assert_int_equal(room->site.line, 3);

    assert_int_equal(room->sky.kind, PP_SKY_ISO);
    assert_int_equal(room->sky.iso, 12);
    assert_near(room->sky.sun_altitude_rad, 40 * DEG, 1e-15);
    assert_near(room->sky.sun_bearing_rad, 200 * DEG, 1e-15);
    assert_int_equal(room->sky.line, 5);

    assert_false(room->plan.envelope);
    assert_true(room->plan.rectangle);
    assert_true(room->plan.width_m == 3.1);
    assert_true(room->plan.depth_m == 9.2);
    assert_true(room->plan.height_m == 2.7);
    assert_int_equal(room->plan.line, 6);

    assert_true(room->floor == 0.21);
    assert_true(room->walls == 0.71);
    assert_true(room->ceiling == 0.81);
    assert_int_equal(room->finish_count, 1);
    assert_string_equal(room->finishes[0].wall, "north");
    assert_true(room->finishes[0].reflectance == 0.7);
    assert_int_equal(room->finishes[0].line, 8);

    assert_int_equal(room->opening_count, 4);
    const struct pp_opening_part *o = room->openings;
    assert_int_equal(o[0].kind, PP_WINDOW);
    assert_string_equal(o[0].wall, "south");
    assert_true(o[0].left_m == 0.2 && o[0].sill_m == 0.8);
    assert_true(o[0].width_m == 2.6 && o[0].height_m == 1.5);
    assert_int_equal(o[0].glazing.glass.panes, 2);
    assert_true(o[0].glazing.frame_factor == 0.8);
    assert_true(isnan(o[0].glazing.maintenance));
    assert_true(o[0].glazing.reveal_m == 0.15);
    assert_int_equal(o[0].line, 9);
    assert_true(o[1].left_m == -0.2);
    assert_true(o[1].glazing.glass.diffusing);
    assert_true(o[1].glazing.glass.diffuse == 0.6);
    assert_true(o[1].glazing.maintenance == 0.7);
    assert_true(o[1].glazing.frame_factor == 1.0);
    assert_int_equal(o[2].kind, PP_ROOFLIGHT);
    assert_null(o[2].wall);
    assert_true(o[2].x == 1 && o[2].y == 2 && o[2].width_m == 0.9
                && o[2].depth_m == 1.2);
    assert_int_equal(o[2].glazing.glass.panes, 0);
    assert_int_equal(o[3].kind, PP_OPENING);
    assert_int_equal(o[3].vertices.count, 3);
    assert_true(o[3].vertices.list[0].x == 0.3 && o[3].vertices.list[1].z == 1.1);
    assert_int_equal(o[3].vertices.lines[2], 17);
    assert_true(o[3].glazing.glass.normal == 0.77);
    assert_true(o[3].glazing.maintenance == 1.0);

    assert_int_equal(room->skyline_count, 2);
    assert_string_equal(room->skylines[0].wall, "south");
    assert_near(room->skylines[0].angle_rad, 20 * DEG, 1e-15);
    assert_true(room->skylines[0].distance_m == 14);
    assert_true(room->skylines[0].reflectance == 0.3);
    assert_true(isinf(room->skylines[1].distance_m));
    assert_true(room->skylines[1].reflectance == 0.2);

    assert_int_equal(room->block_count, 2);
    assert_true(room->blocks[0].corner.x == -4 && room->blocks[0].corner.y == -14);
    assert_true(room->blocks[0].corner.z == 0.4);
    assert_true(room->blocks[0].width_m == 10 && room->blocks[0].depth_m == 6);
    assert_true(room->blocks[0].height_m == 8);
    assert_near(room->blocks[0].rotate_rad, 15 * DEG, 1e-15);
    assert_true(room->blocks[0].reflectance == 0.3);
    assert_true(room->blocks[1].corner.z == -3.1); /* on the ground */
    assert_true(room->blocks[1].rotate_rad == 0.0);

    assert_int_equal(room->surface_count, 1);
    assert_int_equal(room->surfaces[0].vertices.count, 3);
    assert_true(room->surfaces[0].reflectance == 0.4);
    assert_true(room->surfaces[0].exitance == 0.1);

    assert_true(room->working_plane_m == 0.7);
    assert_int_equal(room->receiver_count, 5);
    const struct pp_receiver_part *p = room->receivers;
    assert_int_equal(p[0].kind, PP_POINT);
    assert_true(p[0].x == 1.5 && p[0].y == 2.5 && isnan(p[0].z));
    assert_true(p[0].normal.x == 0 && p[0].normal.y == 0 && p[0].normal.z == 1);
    assert_true(p[1].z == 1.2 && p[1].normal.y == -1 && p[1].normal.z == 0.5);
    assert_int_equal(p[2].kind, PP_LINE);
    assert_true(p[2].from[0] == 1.5 && p[2].from[1] == 0.5);
    assert_true(p[2].to[0] == 1.6 && p[2].to[1] == 8.5);
    assert_int_equal(p[2].points, 17);
    assert_int_equal(p[3].kind, PP_GRID);
    assert_true(p[3].spacing_m == 0.25 && p[3].margin_m == 0);
    assert_true(p[4].spacing_m == 0.5 && p[4].margin_m == 0.5);
    pp_building_destroy(b);
}

/* The five entities of XML and numeric character references are replaced. */
static void names_may_be_escaped(void **state)
{
    (void)state;
    struct pp_building *b =
        read_good("<room version='1' name='Bed &amp; bath, &lt;2&gt; "
                  "&quot;&apos;&#38;&#xe9;&amp;#38;'>"
                  "<plan width='3' depth='4' height='2.5'/></room>");
    assert_string_equal(pp_building_room(b, 0)->name,
                        "Bed & bath, <2> \"'&\xc3\xa9&#38;");
    pp_building_destroy(b);
}

/* Defaults are those documented in the manual. */
static void the_smallest_room(void **state)
{
    (void)state;
    struct pp_building *b =
        read_good("<room version='1'><plan width='3' depth='4' height='2.5'/></room>");
    const struct pp_room *room = pp_building_room(b, 0);
    assert_null(room->name);
    assert_true(room->north_rad == 0.0);
    assert_true(isnan(room->site.latitude_rad) && isnan(room->site.longitude_rad));
    assert_int_equal(room->site.surroundings, PP_RURAL);
    assert_true(room->site.ground_reflectance == 0.2);
    assert_true(room->site.ground_level_m == 0.0);
    assert_int_equal(room->sky.kind, PP_SKY_OVERCAST);
    assert_true(isnan(room->sky.sun_altitude_rad));
    assert_true(room->floor == 0.2 && room->walls == 0.5 && room->ceiling == 0.7);
    assert_true(room->working_plane_m == 0.85);
    assert_int_equal(room->opening_count, 0);
    assert_int_equal(room->receiver_count, 0);
    pp_building_destroy(b);
}

static void plans_by_vertices_and_envelopes(void **state)
{
    (void)state;
    struct pp_building *b = read_good(
        "<building version='1' name='Two'>\n"
        "<room name='L'><plan height='3.1'>\n"
        "<vertex x='0' y='0'/><vertex x='3.3' y='0'/>\n<vertex x='0' y='2.2'/>\n"
        "</plan></room>\n"
        "<room><envelope>\n"
        "<face role='floor' name='f'><vertex x='0' y='0' z='0'/>"
        "<vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/></face>\n"
        "<face role='wall' name='Südwand' reflectance='white-paint'>"
        "<vertex x='0' y='0' z='0'/><vertex x='0' y='0' z='1.5'/>"
        "<vertex x='1' y='0' z='0'/></face>\n"
        "<face role='wall' name='w'><vertex x='0' y='0' z='0'/>"
        "<vertex x='0' y='1' z='0'/><vertex x='0' y='0' z='1.5'/></face>\n"
        "<face role='ceiling' name='c'><vertex x='1' y='0' z='0'/>"
        "<vertex x='0' y='0' z='1.5'/><vertex x='0' y='1' z='0'/></face>\n"
        "</envelope></room></building>");
    assert_string_equal(pp_building_name(b), "Two");
    assert_int_equal(pp_building_room_count(b), 2);
    const struct pp_plan_part *plan = &pp_building_room(b, 0)->plan;
    assert_false(plan->rectangle);
    assert_false(plan->envelope);
    assert_true(plan->height_m == 3.1);
    assert_int_equal(plan->vertices.count, 3);
    assert_true(plan->vertices.list[1].x == 3.3 && plan->vertices.list[2].y == 2.2);
    assert_true(plan->vertices.list[2].z == 0.0);
    assert_int_equal(plan->vertices.lines[2], 4);

    plan = &pp_building_room(b, 1)->plan;
    assert_true(plan->envelope);
    assert_int_equal(plan->face_count, 4);
    assert_int_equal(plan->faces[0].role, PP_FLOOR);
    assert_true(isnan(plan->faces[0].reflectance));
    assert_int_equal(plan->faces[1].role, PP_WALL);
    assert_string_equal(plan->faces[1].name, "Südwand");
    assert_true(plan->faces[1].reflectance == 0.85);
    assert_true(plan->faces[1].vertices.list[1].z == 1.5);
    assert_int_equal(plan->faces[3].role, PP_CEILING);
    assert_int_equal(plan->faces[3].line, 10);
    pp_building_destroy(b);
}

/* The position of the elements in the building does not matter. */
static void a_building_s_site_and_sky_are_its_rooms_defaults(void **state)
{
    (void)state;
    struct pp_building *b = read_good(
        "<building version='1'>"
        "<room><plan width='3' depth='4' height='2.5'/>"
        "<block x='9' y='9' width='1' depth='1' height='1'/></room>"
        "<room><site ground-level='-1.5'/><sky type='overcast'/>"
        "<plan width='3' depth='4' height='2.5'/>"
        "<block x='9' y='9' width='1' depth='1' height='1'/></room>"
        "<site surroundings='industrial' ground-level='-6.5'/><sky type='uniform'/>"
        "</building>");
    const struct pp_room *first = pp_building_room(b, 0);
    const struct pp_room *second = pp_building_room(b, 1);
    assert_int_equal(first->site.surroundings, PP_INDUSTRIAL);
    assert_int_equal(first->sky.kind, PP_SKY_UNIFORM);
    assert_true(first->blocks[0].corner.z == -6.5);
    assert_int_equal(second->site.surroundings, PP_RURAL);
    assert_int_equal(second->sky.kind, PP_SKY_OVERCAST);
    assert_true(second->blocks[0].corner.z == -1.5);
    pp_building_destroy(b);
}

static void another_sky_can_be_put_in(void **state)
{
    (void)state;
    struct pp_building *b =
        read_good("<room version='1'><plan width='3' depth='4' height='2.5'/></room>");
    struct pp_room *room = pp_building_room(b, 0);
    struct pp_error err = {0};
    assert_int_equal(pp_room_set_sky(room, "uniform", &err), PP_OK);
    assert_int_equal(room->sky.kind, PP_SKY_UNIFORM);
    assert_int_equal(pp_room_set_sky(room, "iso-5", &err), PP_OK);
    assert_int_equal(room->sky.iso, 5);
    assert_int_equal(pp_room_set_sky(room, "iso-12", &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "the position of the sun"));
    assert_int_equal(room->sky.iso, 5);
    assert_int_equal(pp_room_set_sky(room, "iso-12,30.5,180", &err), PP_OK);
    assert_near(room->sky.sun_altitude_rad, 30.5 * DEG, 1e-15);
    assert_near(room->sky.sun_bearing_rad, 180 * DEG, 1e-15);
    assert_int_equal(pp_room_set_sky(room, "iso-13", &err), PP_OK); /* the same sun */
    static const char *const wrong[] = {"",          "Overcast",        "iso-16",
                                        "iso-",      "iso-1x",          "iso-12,95,0",
                                        "iso-12,30", "iso-12,30,180,1", "iso-12,nan,0",
                                        "overcast ", "a very long name"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(pp_room_set_sky(room, wrong[i], &err), PP_BAD_INPUT);
    assert_int_equal(room->sky.iso, 13);
    pp_building_destroy(b);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_contract_s_own_room),
        cmocka_unit_test(names_may_be_escaped),
        cmocka_unit_test(the_smallest_room),
        cmocka_unit_test(plans_by_vertices_and_envelopes),
        cmocka_unit_test(a_building_s_site_and_sky_are_its_rooms_defaults),
        cmocka_unit_test(another_sky_can_be_put_in),
    };
    add_tests(tests, NULL, NULL);
}
