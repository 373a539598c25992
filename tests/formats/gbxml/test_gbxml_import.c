/* test_gbxml_import.c - gbXML files become rooms with the light of the rooms that they
 * describe. */
#include <stdarg.h>
#include <stdlib.h>

#include "formats/gbxml/gbxml_import.h"
#include "methods/evaluate.h"
#include "tests/lib/near.h"
#include "tests/lib/made_gbxml.h"
#include "tests/lib/room_of.h"

/* Sky component by exact at a point of a room, by the number of the room. */
static double sky_at(const char *xml, int room, struct pp_vec3 at)
{
    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_world *world;
    struct pp_outside_light light;
    pp_mistakes_init(&mistakes, "made");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    assert_true(room < pp_building_room_count(building));
    const struct pp_room *of = pp_building_room(building, room);
    assert_int_equal(pp_world_create(&world, of, &mistakes, NULL), PP_OK);
    assert_int_equal(mistakes.count, 0);
    assert_int_equal(pp_room_light(&light, of, NULL), PP_OK);
    const struct pp_receiver receiver = {.position = at, .normal = {0.0, 0.0, 1.0}};
    struct pp_report report = {
        .world = world, .light = light, .receivers = &receiver, .receiver_count = 1};
    assert_int_equal(pp_methods_evaluate(&report, "exact", NULL), PP_OK);
    double value = pp_report_find(&report, PP_SC, "exact")->points[0].value;
    pp_report_clear(&report);
    pp_world_destroy(world);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return value;
}

static const char by_hand[] =
    "<room version='1'><plan width='4' depth='6' height='3'/><window wall='south' "
    "left='1' sill='0.9' width='1.6' height='1.2' transmittance='0.8'/></room>";

static void box(struct made_gbxml *file, const char *unit, double metre)
{
    made_gbxml_begin(file, unit, metre, "");
    made_gbxml_space(file, "a", "OfficeEnclosed");
    fputs("</Building>\n", file->out);
    made_gbxml_box(file, "a", 0.0, 4.0, 6.0, 3.0, 0);
    made_gbxml_end(file, "");
}

static void box_has_the_light_of_the_same_room_by_hand(void **state)
{
    (void)state;
    static const struct {
        const char *unit;
        double metre;
    } units[] = {
        {"Meters", 1.0}, {"Feet", 0.3048}, {"Inches", 0.0254}, {"Millimeters", 1e-3}};
    const struct pp_vec3 at = {1.3, 2.2, 0.85};
    double truth = sky_at(by_hand, 0, at);
    assert_true(truth > 0.005);
    for (int i = 0; i < 4; i++) {
        struct made_gbxml file;
        box(&file, units[i].unit, units[i].metre);
        char *xml = made_gbxml_import(&file, NULL, 0);
        assert_near(sky_at(xml, 0, at), truth, 1e-9);
        assert_non_null(strstr(xml, "<plan width=\"4\" depth=\"6\" height=\"3\"/>"));
        assert_non_null(strstr(xml, "<finishes floor=\"0.55\" walls=\"0.55\" "
                                    "ceiling=\"0.55\"/>"));
        assert_non_null(strstr(xml, "use=\"office\""));
        free(xml);
    }
}

/* Zero bytes between letters, after a byte order mark. */
static void utf_16_is_read_as_utf_8_is(void **state)
{
    (void)state;
    struct made_gbxml file;
    box(&file, "Meters", 1.0);
    char *wide = calloc(2 * file.length + 2, 1), *plain = strdup(file.text);
    size_t count = file.length;
    memcpy(wide, "\xff\xfe", 2);
    for (size_t i = 0; i < count; i++)
        wide[2 + 2 * i] = file.text[i];
    char *expected = made_gbxml_import(&file, NULL, 0);
    file.text = wide;
    file.length = 2 * count + 2;
    assert_true(pp_gbxml_import_is_xml(wide, file.length));
    assert_true(pp_gbxml_import_is_xml(plain, count));
    assert_false(pp_gbxml_import_is_xml("# a scene\nvoid plastic", 22));
    char *xml = made_gbxml_import(&file, NULL, 0);
    assert_string_equal(xml, expected);
    free(plain);
    free(xml);
    free(expected);
}

/* A room rotated by 30 degrees is imported as a rotated box, with the same light. */
static void turned_box_stays_a_box(void **state)
{
    (void)state;
    struct made_gbxml file;
    made_gbxml_begin(&file, "Meters", 1.0, "<CADModelAzimuth>15</CADModelAzimuth>");
    const double c = cos(PP_PI / 6.0), s = sin(PP_PI / 6.0);
    const double plan[4][2] = {{0, 0}, {4, 0}, {4, 6}, {0, 6}};
    double turned[4][2], flat[2][12];
    char notes[2000];
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    for (int i = 0; i < 4; i++) {
        turned[i][0] = c * plan[i][0] - s * plan[i][1];
        turned[i][1] = s * plan[i][0] + c * plan[i][1];
        for (int k = 0; k < 2; k++) {
            flat[k][3 * i] = turned[i][0];
            flat[k][3 * i + 1] = turned[i][1];
            flat[k][3 * i + 2] = 3.0 * k;
        }
    }
    made_gbxml_surface(&file, "SlabOnGrade", "a", NULL, 4, flat[0]);
    made_gbxml_end_surface(&file);
    made_gbxml_surface(&file, "Roof", "a", NULL, 4, flat[1]);
    made_gbxml_end_surface(&file);
    for (int i = 0; i < 4; i++) {
        const double *a = turned[i], *b = turned[(i + 1) % 4];
        made_gbxml_surface(
            &file, "ExteriorWall", "a", NULL,
            CORNERS(a[0], a[1], 0, b[0], b[1], 0, b[0], b[1], 3, a[0], a[1], 3));
        if (i == 0)
            made_gbxml_opening(&file, "FixedWindow",
                               CORNERS(c, s, 0.9, 2.6 * c, 2.6 * s, 0.9, 2.6 * c,
                                       2.6 * s, 2.1, c, s, 2.1));
        made_gbxml_end_surface(&file);
    }
    made_gbxml_end(&file, "");
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_non_null(strstr(xml, "rotate=\"30\""));
    assert_non_null(strstr(xml, "north=\"15\""));
    assert_non_null(strstr(notes, "CADModelAzimuth 15"));
    const struct pp_vec3 at = {1.3, 2.2, 0.85};
    assert_near(sky_at(xml, 0, at), sky_at(by_hand, 0, at), 1e-9);
    free(xml);
}

/* Two rooms with a common wall, which the file contains once: both rooms are closed,
 * and it is an inner wall of both. */
static void rooms_share_a_wall(void **state)
{
    (void)state;
    struct made_gbxml file;
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "Classroom");
    made_gbxml_space(&file, "b", "ConferenceMeetingMultipurpose");
    fputs("</Building>\n", file.out);
    made_gbxml_box(&file, "a", 0.0, 4.0, 6.0, 3.0, NO_EAST);
    made_gbxml_box(&file, "b", 4.0, 4.0, 6.0, 3.0, NO_WEST);
    made_gbxml_surface(&file, "InteriorWall", "a", "b",
                       CORNERS(4, 0, 0, 4, 6, 0, 4, 6, 3, 4, 0, 3));
    made_gbxml_opening(&file, "NonSlidingDoor",
                       CORNERS(4, 1, 0, 4, 2, 0, 4, 2, 2, 4, 1, 2));
    made_gbxml_end_surface(&file);
    made_gbxml_end(&file, "");
    char notes[2000], *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_non_null(strstr(notes, "1 openings between spaces are treated as walls"));
    assert_non_null(strstr(xml, "<wall name=\"east\" kind=\"inner\"/>"));
    assert_non_null(strstr(xml, "<wall name=\"west\" kind=\"inner\"/>"));
    assert_non_null(strstr(xml, "use=\"classroom\""));
    assert_non_null(strstr(xml, "use=\"meeting-room\""));
    const struct pp_vec3 at = {1.3, 2.2, 0.85};
    for (int room = 0; room < 2; room++)
        assert_near(sky_at(xml, room, at), sky_at(by_hand, 0, at), 1e-9);
    free(xml);
}

/* A gable roof whose walls are in two pieces, with a skylight: imported as an envelope,
 * with the light of the same room as a plan with a roof. */
static void attic_is_an_envelope(void **state)
{
    (void)state;
    struct made_gbxml file;
    made_gbxml_begin(&file, "Feet", 0.3048, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    const double t = 3.0 * tan(40.0 * PP_RAD), e = 2.2, r = e + t;
    made_gbxml_surface(&file, "SlabOnGrade", "a", NULL,
                       CORNERS(0, 0, 0, 6, 0, 0, 6, 8, 0, 0, 8, 0));
    made_gbxml_end_surface(&file);
    for (int i = 0; i < 2; i++) {
        double y = 8.0 * i;
        made_gbxml_surface(&file, "ExteriorWall", "a", NULL,
                           CORNERS(0, y, 0, 6, y, 0, 6, y, e, 0, y, e));
        made_gbxml_end_surface(&file);
        made_gbxml_surface(&file, "ExteriorWall", "a", NULL,
                           CORNERS(0, y, e, 6, y, e, 3, y, r));
        made_gbxml_end_surface(&file);
        double x = 6.0 * i;
        made_gbxml_surface(&file, "ExteriorWall", "a", NULL,
                           CORNERS(x, 0, 0, x, 8, 0, x, 8, e, x, 0, e));
        made_gbxml_end_surface(&file);
        made_gbxml_surface(&file, "Roof", "a", NULL,
                           CORNERS(x, 0, e, x, 8, e, 3, 8, r, 3, 0, r));
        if (i == 1) { /* from the left end seen from outside, along the slope */
            double c = cos(40.0 * PP_RAD), s = sin(40.0 * PP_RAD);
            made_gbxml_opening(&file, "FixedSkylight",
                               CORNERS(6 - 0.9 * c, 1, e + 0.9 * s, 6 - 0.9 * c, 2.2,
                                       e + 0.9 * s, 6 - 2.3 * c, 2.2, e + 2.3 * s,
                                       6 - 2.3 * c, 1, e + 2.3 * s));
        }
        made_gbxml_end_surface(&file);
    }
    made_gbxml_end(&file, "");
    char *xml = made_gbxml_import(&file, NULL, 0);
    static const char roofed[] =
        "<room version='1'><plan width='6' depth='8' height='2.2' roof='gable' "
        "ridge='depth' pitch='40'/><window wall='roof-east' left='1' sill='0.9' "
        "width='1.2' height='1.4' transmittance='0.8'/></room>";
    assert_non_null(strstr(xml, "<envelope>"));
    for (int i = 0; i < 3; i++) {
        struct pp_vec3 at = {1.0 + 1.9 * i, 2.0 + i, 0.85};
        assert_near(sky_at(xml, 0, at), sky_at(roofed, 0, at), 2e-6);
    }
    free(xml);
}

/* A box without its roof is closed by one plane face; without another side too, by the
 * prism over its floor. The light is the same, and the repair is reported. */
static void what_lacks_is_closed_and_said(void **state)
{
    (void)state;
    const struct pp_vec3 at = {1.3, 2.2, 0.85};
    char notes[2000];
    struct made_gbxml file;
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    made_gbxml_box(&file, "a", 0.0, 4.0, 6.0, 3.0, NO_ROOF);
    made_gbxml_end(&file, "");
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_non_null(strstr(notes, "closed by adding 1 plane face"));
    assert_near(sky_at(xml, 0, at), sky_at(by_hand, 0, at), 1e-9);
    free(xml);

    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    made_gbxml_box(&file, "a", 0.0, 4.0, 6.0, 3.0, NO_ROOF | NO_EAST);
    made_gbxml_end(&file, "");
    xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_non_null(strstr(notes, "a vertical prism over its floor"));
    assert_near(sky_at(xml, 0, at), sky_at(by_hand, 0, at), 1e-9);
    free(xml);
}

/* A shade in front of the window reduces light. Objects in the room and a door are
 * omitted and reported. A window type without a transmittance is reported with the
 * default used. */
static void defaults_and_omissions_are_reported(void **state)
{
    (void)state;
    const struct pp_vec3 at = {1.3, 2.2, 0.85};
    char notes[3000];
    struct made_gbxml file;
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    made_gbxml_box(&file, "a", 0.0, 4.0, 6.0, 3.0, NO_WEST);
    made_gbxml_surface(&file, "ExteriorWall", "a", NULL,
                       CORNERS(0, 6, 0, 0, 0, 0, 0, 0, 3, 0, 6, 3));
    fputs("<Opening id=\"q\" openingType=\"FixedWindow\" windowTypeIdRef=\"bare\">",
          file.out);
    made_gbxml_geometry(&file, CORNERS(0, 3, 1, 0, 2, 1, 0, 2, 2, 0, 3, 2));
    fputs("</Opening>", file.out);
    fputs("<Opening id=\"d\" openingType=\"NonSlidingDoor\">", file.out);
    made_gbxml_geometry(&file, CORNERS(0, 1.5, 0, 0, 0.5, 0, 0, 0.5, 2, 0, 1.5, 2));
    fputs("</Opening>", file.out);
    made_gbxml_end_surface(&file);
    made_gbxml_surface(&file, "Shade", NULL, NULL,
                       CORNERS(0, -1, 2.5, 4, -1, 2.5, 4, 0, 2.5, 0, 0, 2.5));
    made_gbxml_end_surface(&file);
    made_gbxml_surface(&file, "Shade", NULL, NULL,
                       CORNERS(1, 1, 1, 2, 1, 1, 2, 2, 1, 1, 2, 1));
    made_gbxml_end_surface(&file);
    made_gbxml_end(&file, "<WindowType id=\"bare\"/>");
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_non_null(strstr(notes, "WindowType \"bare\" has no visible transmittance"));
    assert_non_null(strstr(notes, "of type \"NonSlidingDoor\" is not a window"));
    assert_non_null(strstr(notes, "surface \"Shade\" is ignored"));
    assert_non_null(strstr(notes, "frame-factor 1"));
    assert_non_null(strstr(xml, "glazing=\"clear-double\" name=\"q\""));
    static const char shaded[] =
        "<room version='1'><plan width='4' depth='6' height='3'/><window wall='south' "
        "left='1' sill='0.9' width='1.6' height='1.2' transmittance='0.8'/><window "
        "wall='west' left='3' sill='1' width='1' height='1' glazing='clear-double'/>"
        "<surface><vertex x='0' y='-1' z='2.5'/><vertex x='4' y='-1' z='2.5'/>"
        "<vertex x='4' y='0' z='2.5'/><vertex x='0' y='0' z='2.5'/></surface></room>";
    assert_near(sky_at(xml, 0, at), sky_at(shaded, 0, at), 1e-9);
    free(xml);
}

static void others_are_refused_with_a_reason(void **state)
{
    (void)state;
    static const struct {
        const char *text, *why;
    } cases[] = {
        {"", "the file is empty; expected a <gbXML>"},
        {"<gbXML", "the file ends inside the tag"},
        {"<gbXML lengthUnit='Meters'><Campus></gbXML>",
         "there is </gbXML>; expected </Campus> to close the element on line 1"},
        {"<room version='1'/>", "expected <gbXML>"},
        {"<!DOCTYPE gbXML [<!ENTITY a 'aaaa'>]><gbXML lengthUnit='Meters'/>",
         "DOCTYPE"},
        {"<gbXML/>", "lengthUnit is \"\""},
        {"<gbXML lengthUnit='Cubits'/>", "lengthUnit is \"Cubits\""},
        {"<gbXML lengthUnit='Meters'/>", "no Campus"},
        {"<gbXML lengthUnit='Meters'><Campus/></gbXML>", "no Space"},
        {"<gbXML lengthUnit='Meters'><Campus><Building><Space id='a'/></Building>"
         "<Surface surfaceType='Roof'><AdjacentSpaceId spaceIdRef='a'/><PlanarGeometry>"
         "<PolyLoop><CartesianPoint><Coordinate>nan</Coordinate><Coordinate>1e308"
         "</Coordinate><Coordinate>0</Coordinate></CartesianPoint></PolyLoop>"
         "</PlanarGeometry></Surface></Campus></gbXML>",
         "no space could be converted to a room with an opening"},
    };
    for (int i = 0; i < (int)(sizeof cases / sizeof *cases); i++) {
        struct pp_mistakes notes;
        struct pp_error err = {0};
        char *xml;
        size_t length;
        pp_mistakes_init(&notes, "test.xml");
        assert_int_equal(pp_gbxml_import(&xml, &length, cases[i].text,
                                         strlen(cases[i].text), "test.xml", &notes,
                                         &err),
                         PP_BAD_INPUT);
        assert_null(xml);
        if (!strstr(err.message, cases[i].why))
            fail_msg("%s: %s", cases[i].text, err.message);
        pp_mistakes_clear(&notes);
    }
}

/* A file that is truncated, or has one wrong byte, is rejected or gives a room with
 * fewer parts; the program never crashes. Every 37th position is tested. */
static void broken_files_do_no_harm(void **state)
{
    (void)state;
    struct made_gbxml file;
    box(&file, "Meters", 1.0);
    for (size_t cut = 0; cut < file.length; cut += 37)
        for (int way = 0; way < 2; way++) {
            struct pp_mistakes notes;
            size_t length;
            char *xml, *bytes = strdup(file.text);
            pp_mistakes_init(&notes, "test.xml");
            if (way)
                bytes[cut] = "9-<x"[cut % 4];
            pp_gbxml_import(&xml, &length, bytes, way ? file.length : cut, "test.xml",
                            &notes, NULL);
            pp_mistakes_clear(&notes);
            free(xml);
            free(bytes);
        }
    free(file.text);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_has_the_light_of_the_same_room_by_hand),
        cmocka_unit_test(utf_16_is_read_as_utf_8_is),
        cmocka_unit_test(turned_box_stays_a_box),
        cmocka_unit_test(rooms_share_a_wall),
        cmocka_unit_test(attic_is_an_envelope),
        cmocka_unit_test(what_lacks_is_closed_and_said),
        cmocka_unit_test(defaults_and_omissions_are_reported),
        cmocka_unit_test(others_are_refused_with_a_reason),
        cmocka_unit_test(broken_files_do_no_harm),
    };
    add_tests(tests, NULL, NULL);
}
