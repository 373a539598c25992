/* test_gbxml_repairs.c - models with small and large errors are repaired: floor area,
 * volume and glass area, compared with calculations by hand. */
#include <stdarg.h>
#include <stdlib.h>

#include "model/room/building.h"
#include "tests/lib/made_gbxml.h"
#include "tests/lib/room_of.h"

/* Dimensions of a room of the imported file. */
struct sizes {
    int rooms, points;
    double floor_m2, volume_m3, glass_m2, height_m, plane_m;
};

/* Volume by the divergence theorem over the faces, openings included. */
static struct sizes sizes_of(const char *xml, int room)
{
    struct sizes sizes = {0};
    struct pp_building *building;
    struct pp_mistakes mistakes;
    struct pp_world *world;
    pp_mistakes_init(&mistakes, "made");
    assert_int_equal(pp_building_parse(&building, xml, strlen(xml), &mistakes, NULL),
                     PP_OK);
    sizes.rooms = pp_building_room_count(building);
    assert_true(room < sizes.rooms);
    assert_int_equal(
        pp_world_create(&world, pp_building_room(building, room), &mistakes, NULL),
        PP_OK);
    assert_int_equal(mistakes.count, 0);
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *face = &world->surfaces[i].outline;
        sizes.volume_m3 -=
            pp_vec_dot(face->vertices[0], face->normal) * face->area_m2 / 3.0;
        if (world->surfaces[i].role == PP_FLOOR)
            sizes.floor_m2 += face->area_m2;
    }
    for (int i = 0; i < world->opening_count; i++)
        sizes.glass_m2 += world->openings[i].inner.area_m2;
    sizes.height_m = world->height_m;
    sizes.plane_m = world->working_plane_m;
    sizes.points = world->receiver_count;
    pp_world_destroy(world);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return sizes;
}

/* A wall, floor or roof of the space "a". */
#define PUT(file, type, ...)                                                           \
    (made_gbxml_surface((file), (type), "a", NULL, CORNERS(__VA_ARGS__)),              \
     made_gbxml_end_surface(file))

/* Begins a file of one space with this area and volume; 0: not given. */
static void begin_space(struct made_gbxml *file, double area_m2, double volume_m3)
{
    made_gbxml_begin(file, "Meters", 1.0, "");
    fputs("<Space id=\"a\">", file->out);
    if (area_m2 > 0.0)
        fprintf(file->out, "<Area>%g</Area>", area_m2);
    if (volume_m3 > 0.0)
        fprintf(file->out, "<Volume>%g</Volume>", volume_m3);
    fputs("</Space></Building>\n", file->out);
}

/* Ends the file, with units of area and volume in the root element. */
static void end_space(struct made_gbxml *file)
{
    static const char units[] = "areaUnit='SquareMeters' volumeUnit='CubicMeters' ";
    made_gbxml_end(file, "");
    char *at = strstr(file->text, "lengthUnit");
    char *made = calloc(file->length + sizeof units, 1);
    memcpy(made, file->text, (size_t)(at - file->text));
    strcat(made, units);
    strcat(made, at);
    free(file->text);
    file->text = made;
    file->length = strlen(made);
}

/* A box of 6 x 4 x `h` m; its south wall, 6 m long, has the openings written by
 * `inside`. up: height of one corner of the roof above the others; out: distance of the
 * south wall from the box. */
static void put_room(struct made_gbxml *file, double h, double up, double out,
                     void (*inside)(struct made_gbxml *file))
{
    PUT(file, "SlabOnGrade", 0, 0, 0, 0, 4, 0, 6, 4, 0, 6, 0, 0);
    PUT(file, "Roof", 0, 0, h, 6, 0, h, 6, 4, h + up, 0, 4, h);
    made_gbxml_surface(file, "ExteriorWall", "a", NULL,
                       CORNERS(0, -out, 0, 6, -out, 0, 6, -out, h, 0, -out, h));
    inside(file);
    made_gbxml_end_surface(file);
    PUT(file, "ExteriorWall", 6, 4, 0, 0, 4, 0, 0, 4, h, 6, 4, h + up);
    PUT(file, "ExteriorWall", 6, 0, 0, 6, 4, 0, 6, 4, h + up, 6, 0, h);
    PUT(file, "ExteriorWall", 0, 4, 0, 0, 0, 0, 0, 0, h, 0, 4, h);
}

/* Writes a window in the south wall. */
static void put_window(struct made_gbxml *f, double left, double sill, double right,
                       double top)
{
    made_gbxml_opening(
        f, "FixedWindow",
        CORNERS(left, 0, sill, right, 0, sill, right, 0, top, left, 0, top));
}

static void plain_window(struct made_gbxml *f)
{
    put_window(f, 1, 1, 3, 2.5);
}

static struct sizes room_with(double h, double up, double out,
                              void (*inside)(struct made_gbxml *file), char *notes)
{
    struct made_gbxml file;
    begin_space(&file, 24.0, 24.0 * h);
    put_room(&file, h, up, out, inside);
    end_space(&file);
    char *xml = made_gbxml_import(&file, notes, 2000);
    struct sizes sizes = sizes_of(xml, 0);
    free(xml);
    return sizes;
}

/* ---- openings ---- */

static void over_top(struct made_gbxml *f)
{
    put_window(f, 1, 1, 3, 3.005);
}

static void under_foot(struct made_gbxml *f)
{
    put_window(f, 1, -0.02, 3, 1);
}

static void beyond_ends(struct made_gbxml *f)
{
    put_window(f, -0.009, 1, 6.001, 2);
}

static void overlapping(struct made_gbxml *f)
{
    put_window(f, 1, 1, 3, 2.5);
    put_window(f, 2, 1, 4, 2.5);
}

static void nested(struct made_gbxml *f)
{
    put_window(f, 2, 1.5, 3, 2);
    put_window(f, 1, 1, 4, 2.5);
}

static void cut_at_all_sides_and_at_each_other(void **state)
{
    (void)state;
    const struct {
        void (*inside)(struct made_gbxml *file);
        double glass_m2;
        const char *noted; /* NULL: nothing */
    } cases[] = {{plain_window, 2 * 1.5, NULL},
                 {over_top, 2 * 2, "0.01 of its 4.01 m2 are cut off"},
                 {under_foot, 2 * 1, "0.04 of its 2.04 m2 are cut off"},
                 {beyond_ends, 6 * 1, "0.01 of its 6.01 m2 are cut off"},
                 {overlapping, 3 * 1.5, "1.5 of its 3 m2 are cut off"},
                 {nested, 3 * 1.5,
                  "or it overlaps other openings; it is treated as part of the wall"}};
    for (int i = 0; i < (int)(sizeof cases / sizeof *cases); i++) {
        char notes[2000];
        struct sizes sizes = room_with(3.0, 0.0, 0.0, cases[i].inside, notes);
        assert_near(sizes.glass_m2, cases[i].glass_m2, 1e-4);
        assert_near(sizes.floor_m2, 24.0, 1e-6);
        assert_true(cases[i].noted ? strstr(notes, cases[i].noted) != NULL
                                   : strstr(notes, "cut off") == NULL);
    }
}

static void glazed_door(struct made_gbxml *f)
{
    made_gbxml_opening(f, "NonSlidingDoor",
                       CORNERS(1, 0, 0, 3, 0, 0, 3, 0, 2.2, 1, 0, 2.2));
}

static void air_opening(struct made_gbxml *f)
{
    made_gbxml_opening(f, "Air", CORNERS(1, 0, 0, 3, 0, 0, 3, 0, 2, 1, 0, 2));
}

/* A door whose type has a visible transmittance is glazed; an air opening has no
 * pane. */
static void doors_of_glass_and_air_are_openings(void **state)
{
    (void)state;
    const struct {
        void (*inside)(struct made_gbxml *file);
        const char *words;
    } cases[] = {{glazed_door, "height=\"2.2\" transmittance=\"0.8\""},
                 {air_opening, "height=\"2\" glazing=\"none\""}};
    for (int i = 0; i < 2; i++) {
        struct made_gbxml file;
        begin_space(&file, 0.0, 0.0);
        put_room(&file, 3.0, 0.0, 0.0, cases[i].inside);
        end_space(&file);
        char *xml = made_gbxml_import(&file, NULL, 0);
        assert_non_null(strstr(xml, cases[i].words));
        free(xml);
    }
}

/* ---- envelopes ---- */

/* A roof with one corner 5 mm higher is divided into two triangles: 24 x 3 and a third
 * of the prism. */
static void faces_that_are_not_plane_are_divided(void **state)
{
    (void)state;
    char notes[2000];
    struct sizes sizes = room_with(3.0, 0.005, 0.0, plain_window, notes);
    assert_near(sizes.volume_m3, 72.0 + 12.0 * 0.005 / 3.0, 0.03);
    assert_near(sizes.glass_m2, 3.0, 1e-6);
    assert_non_null(strstr(notes, "1 faces are not planar"));
}

/* A south wall 50 mm outside leaves the surfaces open. The room is the prism over both
 * slabs, 6 x 4 and 3 x 4 m, with the window in front of the second. */
static void all_slabs_are_floor(void **state)
{
    (void)state;
    const double out = -0.05;
    struct made_gbxml file;
    char notes[2000];
    begin_space(&file, 36.0, 108.0);
    PUT(&file, "SlabOnGrade", 0, 0, 0, 0, 4, 0, 6, 4, 0, 6, 0, 0);
    PUT(&file, "SlabOnGrade", 6, 0, 0, 6, 4, 0, 9, 4, 0, 9, 0, 0);
    PUT(&file, "Roof", 0, 0, 3, 9, 0, 3, 9, 4, 3, 0, 4, 3);
    made_gbxml_surface(&file, "ExteriorWall", "a", NULL,
                       CORNERS(0, out, 0, 9, out, 0, 9, out, 3, 0, out, 3));
    made_gbxml_opening(&file, "FixedWindow",
                       CORNERS(6.5, out, 1, 8.5, out, 1, 8.5, out, 2.5, 6.5, out, 2.5));
    made_gbxml_end_surface(&file);
    PUT(&file, "ExteriorWall", 9, 4, 0, 0, 4, 0, 0, 4, 3, 9, 4, 3);
    PUT(&file, "ExteriorWall", 9, 0, 0, 9, 4, 0, 9, 4, 3, 9, 0, 3);
    PUT(&file, "ExteriorWall", 0, 4, 0, 0, 0, 0, 0, 0, 3, 0, 4, 3);
    end_space(&file);
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    struct sizes sizes = sizes_of(xml, 0);
    assert_near(sizes.floor_m2, 36.0, 1e-6);
    assert_near(sizes.volume_m3, 108.0, 1e-6);
    assert_near(sizes.glass_m2, 3.0, 1e-6);
    assert_non_null(strstr(xml, "left=\"6.5\""));
    assert_non_null(strstr(notes, "a vertical prism over its floor is used instead"));
    assert_null(strstr(notes, "its Area"));
    free(xml);
}

/* An attic of 6 x 4 m, eaves 2 m, ridge 4 m, one corner of a slope too high by `off`:
 * 24 m2 times (2 + 4)/2. Beyond the tolerance for merging, the surfaces are not
 * closed. */
static struct sizes attic(double off, char *notes)
{
    struct made_gbxml file;
    begin_space(&file, 24.0, 72.0);
    PUT(&file, "SlabOnGrade", 0, 0, 0, 0, 4, 0, 6, 4, 0, 6, 0, 0);
    PUT(&file, "Roof", 0, 0, 2, 6, 0, 2, 6, 2, 4, 0, 2, 4);
    PUT(&file, "Roof", 6, 4, 2, 0, 4, 2, 0, 2, 4 + off, 6, 2, 4);
    made_gbxml_surface(&file, "ExteriorWall", "a", NULL,
                       CORNERS(0, 0, 0, 6, 0, 0, 6, 0, 2, 0, 0, 2));
    put_window(&file, 1, 0.8, 3, 1.8);
    made_gbxml_end_surface(&file);
    PUT(&file, "ExteriorWall", 6, 4, 0, 0, 4, 0, 0, 4, 2, 6, 4, 2);
    PUT(&file, "ExteriorWall", 6, 0, 0, 6, 4, 0, 6, 4, 2, 6, 2, 4, 6, 0, 2);
    PUT(&file, "ExteriorWall", 0, 4, 0, 0, 0, 0, 0, 0, 2, 0, 2, 4, 0, 4, 2);
    end_space(&file);
    char *xml = made_gbxml_import(&file, notes, 2000);
    struct sizes sizes = sizes_of(xml, 0);
    free(xml);
    return sizes;
}

static void corners_are_welded_within_20_mm(void **state)
{
    (void)state;
    char notes[2000];
    struct sizes sizes = attic(0.01, notes);
    assert_near(sizes.volume_m3, 72.0, 0.2);
    assert_near(sizes.height_m, 4.0, 0.011);
    assert_non_null(strstr(notes, "corners up to 10 mm apart were merged"));
    sizes = attic(0.001, notes);
    assert_near(sizes.volume_m3, 72.0, 0.02);
    assert_null(strstr(notes, "made one"));
    /* If it is farther apart, the prism with the volume in the file is used. */
    sizes = attic(0.5, notes);
    assert_near(sizes.volume_m3, 72.0, 1e-3);
    assert_near(sizes.height_m, 3.0, 1e-4);
    assert_non_null(strstr(notes, "a vertical prism"));
}

/* If the area or volume in the file differs, the surfaces are used, and this is
 * reported. */
static void other_sizes_are_noted(void **state)
{
    (void)state;
    struct made_gbxml file;
    char notes[2000];
    begin_space(&file, 30.0, 24.0 * 3.0);
    put_room(&file, 3.0, 0.0, 0.0, plain_window);
    end_space(&file);
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_near(sizes_of(xml, 0).floor_m2, 24.0, 1e-6);
    assert_non_null(strstr(notes, "the floor measures 24 m2, but its Area is 30 m2"));
    assert_null(strstr(notes, "its Volume"));
    free(xml);
}

/* A storey of 4 m with a ceiling at 2.8 m, which follows from the volume. */
static void ceiling_is_where_the_volume_has_it(void **state)
{
    (void)state;
    struct made_gbxml file;
    char notes[2000];
    begin_space(&file, 24.0, 24.0 * 2.8);
    put_room(&file, 4.0, 0.0, 0.0, plain_window);
    end_space(&file);
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    struct sizes sizes = sizes_of(xml, 0);
    assert_near(sizes.height_m, 2.8, 1e-6);
    assert_near(sizes.glass_m2, 3.0, 1e-6);
    assert_non_null(strstr(notes, "its surfaces do not match its Area and Volume"));
    free(xml);
}

/* ---- neighbouring rooms ---- */

/* Two rooms of 4 x 6 x 3 m, which overlap by `by`. */
static char *two_rooms(double by, char *notes)
{
    struct made_gbxml file;
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    made_gbxml_space(&file, "b", "");
    fputs("</Building>\n", file.out);
    made_gbxml_box(&file, "a", 0.0, 4.0, 6.0, 3.0, 0);
    made_gbxml_box(&file, "b", 4.0 - by, 4.0, 6.0, 3.0, 0);
    made_gbxml_end(&file, "");
    return made_gbxml_import(&file, notes, 3000);
}

static void overlaps_up_to_20_mm_are_trimmed(void **state)
{
    (void)state;
    const struct {
        double by;
        int rooms;
        const char *noted; /* NULL: nothing */
    } cases[] = {{0.0, 2, NULL},
                 {0.002, 2, NULL},
                 {0.018, 2, "extends 18 mm into the space \"a\""},
                 {0.3, 1, "with its openings (1): it overlaps the space \"a\""}};
    for (int i = 0; i < 4; i++) {
        char notes[3000], *xml = two_rooms(cases[i].by, notes);
        struct sizes sizes = sizes_of(xml, cases[i].rooms - 1);
        assert_int_equal(sizes.rooms, cases[i].rooms);
        assert_near(sizes.floor_m2, 24.0 - (i < 3 ? 6.0 * cases[i].by : 0.0), 1e-4);
        assert_true(cases[i].noted ? strstr(notes, cases[i].noted) != NULL
                                   : strstr(notes, "extends") == NULL);
        free(xml);
    }
}

/* ---- planes and positions ---- */

/* In a hall the grid is within the limit on points; in a low room the plane is within
 * the room. */
static void grid_and_working_plane_fit(void **state)
{
    (void)state;
    struct made_gbxml file;
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    made_gbxml_box(&file, "a", 0.0, 200.0, 160.0, 8.0, 0);
    made_gbxml_end(&file, "");
    char notes[2000], *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_int_equal(sizes_of(xml, 0).points, 199 * 159);
    assert_non_null(
        strstr(notes, "200 m by 160 m and gets a grid with a spacing of 1 m"));
    free(xml);
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    put_room(&file, 0.7, 0.0, 0.0, glazed_door);
    made_gbxml_end(&file, "");
    xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_near(sizes_of(xml, 0).plane_m, 0.35, 1e-9);
    assert_non_null(strstr(notes, "its working plane is at half its height"));
    free(xml);
}

/* Coordinates of a national grid give the same room as small ones. */
static void far_models_are_moved(void **state)
{
    (void)state;
    struct made_gbxml file;
    char notes[2000];
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    file.east = 506000.0, file.north = 4021000.0;
    put_room(&file, 3.0, 0.0, 0.0, plain_window);
    made_gbxml_end(&file, "");
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_non_null(strstr(xml, "x=\"0\" y=\"0\" z=\"0\""));
    assert_near(sizes_of(xml, 0).floor_m2, 24.0, 1e-4);
    assert_near(sizes_of(xml, 0).glass_m2, 3.0, 1e-4);
    assert_non_null(
        strstr(notes, "its origin was moved to the point (506000, 4021000, 0) m"));
    free(xml);
}

static int count_words(const char *text, const char *word)
{
    int count = 0;
    while ((text = strstr(text, word)) != NULL) {
        text += strlen(word);
        count++;
    }
    return count;
}

/* Two triangles in one loop become a shade with their common outline. */
static void self_touching_outlines_are_replaced_by_their_rim(void **state)
{
    (void)state;
    struct made_gbxml file;
    char notes[2000];
    made_gbxml_begin(&file, "Meters", 1.0, "");
    made_gbxml_space(&file, "a", "");
    fputs("</Building>\n", file.out);
    put_room(&file, 3.0, 0.0, 0.0, plain_window);
    made_gbxml_surface(
        &file, "Shade", NULL, NULL,
        CORNERS(0, -1, 3, 6, -1, 3, 6, 0, 3, 0, -1, 3, 6, 0, 3, 0, 0, 3));
    made_gbxml_end_surface(&file);
    made_gbxml_end(&file, "");
    char *xml = made_gbxml_import(&file, notes, sizeof notes);
    assert_null(strstr(notes, "left out"));
    char *end = strstr(xml, "</surface>");
    assert_non_null(end);
    *end = '\0';
    int corners = count_words(xml, "<vertex");
    assert_int_equal(corners, 4);
    free(xml);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_at_all_sides_and_at_each_other),
        cmocka_unit_test(doors_of_glass_and_air_are_openings),
        cmocka_unit_test(faces_that_are_not_plane_are_divided),
        cmocka_unit_test(all_slabs_are_floor),
        cmocka_unit_test(corners_are_welded_within_20_mm),
        cmocka_unit_test(other_sizes_are_noted),
        cmocka_unit_test(ceiling_is_where_the_volume_has_it),
        cmocka_unit_test(overlaps_up_to_20_mm_are_trimmed),
        cmocka_unit_test(grid_and_working_plane_fit),
        cmocka_unit_test(far_models_are_moved),
        cmocka_unit_test(self_touching_outlines_are_replaced_by_their_rim),
    };
    add_tests(tests, NULL, NULL);
}
