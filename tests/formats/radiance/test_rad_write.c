/* test_rad_write.c - rooms written as Radiance scene files and read back. */
#include "tests/lib/room_of.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>

#include "formats/radiance/rad_functions.h"
#include "formats/radiance/read/rad_read.h"
#include "formats/radiance/write/rad_room.h"
#include "formats/radiance/write/rad_write.h"
#include "model/room/building.h"
#include "model/room/keyhole.h"
#include "model/room/room_light.h"
#include "tests/lib/near.h"
#include "formats/radiance/write/rad_numbers.h"
#include "formats/radiance/write/rad_write_materials.h"

static char *text_of(const struct pp_scene_description *scene, size_t *length)
{
    char *text = NULL;
    struct pp_error err = {0};
    struct pp_rad_writer *writer;
    if (pp_rad_write_create(&writer, scene, &err) != PP_OK)
        fail_msg("%s", err.message);
    FILE *out = open_memstream(&text, length);
    assert_non_null(out);
    pp_rad_write_materials(writer, out);
    pp_rad_write_shapes(writer, "shape", 0, scene->shape_count, out);
    fclose(out);
    pp_rad_write_destroy(writer);
    return text;
}

static struct pp_scene_description read_back(const char *text, size_t length)
{
    struct pp_scene_description scene;
    struct pp_rad_summary summary;
    struct pp_error err = {0};
    if (pp_rad_read_bytes(&scene, &summary, text, length, "back.rad", &err) != PP_OK)
        fail_msg("%s", err.message);
    return scene;
}

static void assert_same_vec(struct pp_vec3 a, struct pp_vec3 b)
{
    assert_true(a.x == b.x && a.y == b.y && a.z == b.z);
}

/* Rounding of a product and a quotient of numbers up to 1: a few times 1e-16. */
static void assert_same_rgb(struct pp_rgb a, struct pp_rgb b)
{
    assert_near(a.r, b.r, 1e-14 * (1.0 + a.r));
    assert_near(a.g, b.g, 1e-14 * (1.0 + a.g));
    assert_near(a.b, b.b, 1e-14 * (1.0 + a.b));
}

static void assert_same_material(const struct pp_material *a,
                                 const struct pp_material *b)
{
    assert_int_equal(a->kind, b->kind);
    assert_int_equal(a->emits, b->emits);
    assert_int_equal(a->pattern >= 0, b->pattern >= 0);
    assert_same_rgb(a->diffuse, b->diffuse);
    assert_same_rgb(a->gloss, b->gloss);
    assert_same_rgb(a->through_diffuse, b->through_diffuse);
    assert_same_rgb(a->through_gloss, b->through_gloss);
    assert_same_rgb(a->radiance, b->radiance);
    assert_true(a->roughness[0] == b->roughness[0]);
    assert_true(a->roughness[1] == b->roughness[1]);
    assert_same_vec(a->grain, b->grain);
    if (a->kind != PP_MATERIAL_GLASS)
        return;
    assert_true(a->clear_share == b->clear_share && a->dirt == b->dirt);
    for (int i = 0; i < 3; i++)
        for (double cosine = 0.05; cosine < 1.0; cosine += 0.13) {
            assert_near(pp_glass_transmittance(&a->glass[i], cosine),
                        pp_glass_transmittance(&b->glass[i], cosine), 1e-13);
            assert_near(pp_glass_reflectance(&a->glass[i], cosine),
                        pp_glass_reflectance(&b->glass[i], cosine), 1e-13);
        }
}

static void assert_same_shape(const struct pp_scene_description *a,
                              const struct pp_scene_description *b, int which)
{
    const struct pp_shape *s = &a->shapes[which], *t = &b->shapes[which];
    assert_int_equal(s->kind, t->kind);
    assert_same_material(&a->materials[s->material], &b->materials[t->material]);
    assert_int_equal(s->back_material >= 0, t->back_material >= 0);
    if (s->back_material >= 0)
        assert_same_material(&a->materials[s->back_material],
                             &b->materials[t->back_material]);
    if (s->kind == PP_SHAPE_DISTANT) {
        assert_same_vec(s->is.distant.direction, t->is.distant.direction);
        assert_near(s->is.distant.half_angle_rad, t->is.distant.half_angle_rad, 1e-15);
        return;
    }
    if (s->kind != PP_SHAPE_POLYGON)
        return;
    assert_int_equal(s->is.polygon.count, t->is.polygon.count);
    for (int i = 0; i < s->is.polygon.count; i++)
        assert_same_vec(a->vertices[s->is.polygon.first + i],
                        b->vertices[t->is.polygon.first + i]);
}

static void assert_same_patterns(const struct pp_scene_description *a,
                                 const struct pp_scene_description *b)
{
    assert_int_equal(a->pattern_count, b->pattern_count);
    for (int i = 0; i < a->pattern_count; i++)
        for (int k = 0; k < 500; k++) {
            double z = (k % 25 + 0.5) / 25.0, turn = 0.37 * k;
            double r = sqrt(1.0 - z * z);
            struct pp_vec3 u = pp_vec(r * cos(turn), r * sin(turn), z);
            double value = pp_scene_description_pattern_value(&a->patterns[i], u);
            assert_near(pp_scene_description_pattern_value(&b->patterns[i], u), value,
                        1e-13 * value);
        }
}

static void assert_same_scene(const struct pp_scene_description *scene)
{
    size_t length;
    char *text = text_of(scene, &length);
    struct pp_scene_description back = read_back(text, length);
    assert_int_equal(scene->shape_count, back.shape_count);
    for (int i = 0; i < scene->shape_count; i++)
        assert_same_shape(scene, &back, i);
    assert_same_patterns(scene, &back);
    pp_scene_description_clear(&back);
    free(text);
}

/* Asserts that the outlines of a face have its area without its openings. */
static void assert_cut(const struct pp_world *world)
{
    for (int face = 0; face < world->face_count; face++) {
        struct pp_keyhole_outlines cut;
        struct pp_error err = {0};
        assert_int_equal(pp_keyhole_outlines_init(&cut, world, face, &err), PP_OK);
        double left = world->surfaces[face].outline.area_m2;
        for (int i = 0; i < world->opening_count; i++)
            if (world->openings[i].face == face)
                left -= world->openings[i].inner.area_m2;
        struct pp_vec3 sum = {0.0, 0.0, 0.0};
        for (int i = 0; i < cut.count; i++)
            for (int k = 2; k < cut.outlines[i].count; k++) {
                const struct pp_vec3 *v = cut.outlines[i].corners;
                sum = pp_vec_along(
                    sum, 0.5,
                    pp_vec_cross(pp_vec_sub(v[k - 1], v[0]), pp_vec_sub(v[k], v[0])));
            }
        assert_near(pp_vec_dot(sum, world->surfaces[face].outline.normal), left,
                    1e-9 * world->surfaces[face].outline.area_m2);
        pp_keyhole_outlines_clear(&cut);
    }
}

/* Compares rooms with matt surfaces, and with all gloss. */
static void assert_room_comes_back(const struct pp_world *world,
                                   const struct pp_outside_light *light)
{
    assert_cut(world);
    for (int gloss = 0; gloss < 2; gloss++) {
        struct pp_rad_room room;
        struct pp_error err = {0};
        if (pp_rad_room_init(&room, world, light, 55.9, gloss, &err) != PP_OK)
            fail_msg("%s", err.message);
        assert_same_scene(&room.scene);
        pp_rad_room_clear(&room);
    }
}

static void every_example_comes_back_as_it_was(void **state)
{
    (void)state;
    static const char *const names[] = {
        "building", "classroom", "deep-office", "deep-office-obstructed",
        "l-shaped", "office",    "studio",      "workshop"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/examples/%s.xml", getenv("srcdir"), names[i]);
        struct pp_mistakes mistakes;
        struct pp_building *building;
        pp_mistakes_init(&mistakes, path);
        assert_int_equal(pp_building_read(&building, path, &mistakes, NULL), PP_OK);
        for (int k = 0; k < pp_building_room_count(building); k++) {
            struct pp_world *world;
            struct pp_outside_light light;
            assert_int_equal(
                pp_world_create(&world, pp_building_room(building, k), &mistakes, NULL),
                PP_OK);
            assert_int_equal(pp_room_light(&light, pp_building_room(building, k), NULL),
                             PP_OK);
            assert_room_comes_back(world, &light);
            pp_world_destroy(world);
        }
        pp_building_destroy(building);
        pp_mistakes_clear(&mistakes);
    }
}

static void assert_comes_back(const char *xml)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    assert_room_comes_back(world, &light);
    pp_world_destroy(world);
}

static void every_glazing_and_sky_comes_back(void **state)
{
    (void)state;
    static const char *const glazings[] = {
        "glazing='none'",
        "glazing='none' frame-factor='0.8'",
        "glazing='clear-single'",
        "glazing='clear-triple' maintenance='0.7'",
        "glazing='opal-glass'",
        "glazing='opal-glass' frame-factor='0.8'",
        "transmittance='0.37'",
        "glazing='solar-control-dark' frame-factor='0.71' reveal='0.2'"};
    for (int sky = 0; sky < 17; sky++) {
        char type[16] = "overcast", xml[2000];
        if (sky > 0)
            snprintf(type, sizeof type, sky == 16 ? "uniform" : "iso-%d", sky);
        snprintf(xml, sizeof xml,
                 "<room version='1' north='20'><sky type='%s' sun-altitude='37' "
                 "sun-bearing='140'/>"
                 "<plan width='4.3' depth='5.1' height='2.9'/>"
                 "<finish wall='north' reflectance='brass'/>"
                 "<finish wall='east' reflectance='brushed-aluminium'/>"
                 "<finish wall='west' reflectance='mirror'/>"
                 "<finish wall='south' reflectance='red-brick'/>"
                 "<window wall='south' left='0.3' sill='0.7' width='1.7' height='1.1' "
                 "%s/></room>",
                 type, glazings[sky % 8]);
        if (strstr(type, "overcast") || strstr(type, "uniform") || sky < 7) {
            char *sun = strstr(xml, " sun-altitude='37' sun-bearing='140'");
            if (sun && (sky == 0 || sky == 16 || sky == 1 || sky == 3 || sky == 5))
                memset(sun, ' ', strlen(" sun-altitude='37' sun-bearing='140'"));
        }
        assert_comes_back(xml);
    }
}

static void many_holes_in_one_wall_become_one_outline(void **state)
{
    (void)state;
    char xml[20000] = "<room version='1'><plan width='20.3' depth='5.1' height='9.7'/>";
    for (int row = 0; row < 4; row++)
        for (int i = 0; i < 9; i++)
            snprintf(xml + strlen(xml), 200,
                     "<window wall='south' left='%g' sill='%g' width='1.3' "
                     "height='1.1' glazing='clear-single'/>",
                     0.4 + 2.2 * i + 0.05 * row, row == 0 ? 0.0 : 0.4 + 2.3 * row);
    strcat(xml, "<rooflight x='3' y='1' width='2' depth='1.2' glazing='clear-single'/>"
                "</room>");
    struct pp_world *world = pp_test_world(xml);
    for (int face = 0; face < world->face_count; face++) {
        struct pp_keyhole_outlines cut;
        assert_int_equal(pp_keyhole_outlines_init(&cut, world, face, NULL), PP_OK);
        assert_int_equal(cut.count, 1);
        pp_keyhole_outlines_clear(&cut);
    }
    pp_world_destroy(world);
    assert_comes_back(xml);
}

/* Two windows from floor to ceiling divide the wall into three parts; a third window is a
 * hole in one of them. */
static void openings_that_part_a_wall_leave_several_outlines(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='6' depth='4' height='3'/>"
        "<window wall='south' left='1' sill='0' width='1' height='3' glazing='none'/>"
        "<window wall='south' left='3' sill='0' width='1' height='3' glazing='none'/>"
        "<window wall='south' left='4.5' sill='1' width='1' height='1' glazing='none'/>"
        "</room>";
    struct pp_world *world = pp_test_world(xml);
    struct pp_keyhole_outlines cut;
    int south = world->openings[0].face;
    assert_int_equal(pp_keyhole_outlines_init(&cut, world, south, NULL), PP_OK);
    assert_int_equal(cut.count, 3);
    pp_keyhole_outlines_clear(&cut);
    pp_world_destroy(world);
    assert_comes_back(xml);
}

/* Towards the skyline the sky has its luminance by the conventions of the tracer, above
 * it that of the room's sky by sky.h. */
static void a_far_skyline_is_part_of_the_sky(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><site ground-reflectance='0.3'/>"
                "<plan width='4' depth='5' height='3'/>"
                "<window wall='south' left='1' sill='1' width='2' height='1.3'/>"
                "<window wall='east' left='1' sill='1' width='2' height='1.3'/>"
                "<skyline wall='south' angle='25' reflectance='0.4'/>"
                "<skyline wall='east' angle='11' reflectance='0.2'/></room>");
    struct pp_rad_room room;
    assert_int_equal(pp_rad_room_init(&room, world, &light, 70.0, true, NULL), PP_OK);
    const struct pp_pattern *pattern = &room.scene.patterns[0];
    assert_int_equal(pattern->skyline_count, 2);
    /* 0.4 (0.396177 + 0.3/2) 70 / pi: with the known maximum of the vertical sky
     * component */
    struct pp_vec3 low = pp_vec_unit(pp_vec(0.01, -1.0, 0.3));
    assert_near(pp_scene_description_pattern_value(pattern, low),
                0.4 * (0.396177 + 0.15) * 70.0 / PP_PI, 1e-5);
    struct pp_vec3 above = pp_vec_unit(pp_vec(0.01, -1.0, 0.48));
    assert_near(pp_scene_description_pattern_value(pattern, above),
                70.0 * pp_sky_luminance(&light.sky, above), 1e-12);
    assert_same_scene(&room.scene);
    pp_rad_room_clear(&room);
    pp_world_destroy(world);
}

static void assert_refused(const char *inside, const char *why)
{
    char xml[2000];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='4' depth='5' height='3'/>\n%s\n</room>",
             inside);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_rad_room room;
    struct pp_error err = {0};
    assert_int_equal(pp_rad_room_init(&room, world, &light, 50.0, true, &err),
                     PP_BAD_INPUT);
    if (!strstr(err.message, why) || !strstr(err.message, "line 2"))
        fail_msg("\"%s\" says nothing of %s", err.message, why);
    pp_world_destroy(world);
}

static void what_radiance_has_no_words_for_is_refused(void **state)
{
    (void)state;
    assert_refused("<surface reflectance='0.3' exitance='0.1'><vertex x='1' y='1' "
                   "z='1'/><vertex x='2' y='1' z='1'/><vertex x='2' y='2' z='1'/>"
                   "</surface>",
                   "emits and reflects light");
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    struct pp_material lit = pp_material_diffuse(pp_rgb_grey(0.4));
    lit.emits = PP_EMITS_EXTENDED;
    lit.radiance = pp_rgb_grey(2.0);
    assert_int_equal(pp_scene_description_add_material(&scene, &lit, NULL, NULL),
                     PP_OK);
    struct pp_rad_writer *writer;
    assert_int_equal(pp_rad_write_create(&writer, &scene, NULL), PP_BAD_INPUT);
    pp_scene_description_clear(&scene);
}

/* Round shapes and every material, written as text and read back. */
static void any_scene_is_read_back_unchanged(void **state)
{
    (void)state;
    static const char text[] =
        "void plastic a 0 0 5 .5 .4 .3 .1 .05\nvoid metal b 0 0 5 .5 .4 .3 .8 .1\n"
        "void trans c 0 0 7 .8 .7 .6 .1 .02 .5 .25\nvoid mirror d 0 0 3 .9 .8 .7\n"
        "void plastic2 e 4 .3 .4 .5 . 0 6 .5 .5 .5 .1 .05 .2\n"
        "void metal2 f 4 .3 .4 .5 . 0 6 .5 .4 .5 .1 .05 .2\n"
        "void trans2 g 4 .3 .4 .5 . 0 8 .5 .5 .4 .1 .05 .2 .3 .4\n"
        "void glass h 0 0 4 .9 .8 .7 1.4\nvoid light i 0 0 3 7 8 9\n"
        "void glow j 0 0 4 7 8 9 0\nvoid illum k 0 0 3 7 8 9\n"
        "void mixfunc l 4 a b if(Rdot,1,0) . 0 0\n"
        "a sphere s 0 0 4 1 2 3 .5\nb bubble s 0 0 4 1 2 3 .5\n"
        "c cone s 0 0 8 0 0 0 0 0 2 .5 .25\nd cup s 0 0 8 0 0 0 0 0 2 .5 0\n"
        "e cylinder s 0 0 7 0 0 0 0 0 2 .5\nf tube s 0 0 7 0 0 0 0 0 2 .5\n"
        "g ring s 0 0 8 1 1 1 0 0 1 .7 .2\nh polygon s 0 0 9 0 0 0 1 0 0 0 1 .3\n"
        "i source s 0 0 4 0 0 1 .5\nj source s 0 0 4 0 0 -1 180\n"
        "k polygon s 0 0 9 0 0 0 1 0 0 0 1 .3\nl polygon s 0 0 9 0 0 0 1 0 0 0 1 .3\n";
    struct pp_scene_description scene = read_back(text, strlen(text));
    assert_same_scene(&scene);
    size_t length, again;
    char *first = text_of(&scene, &length);
    struct pp_scene_description back = read_back(first, length);
    char *second = text_of(&back, &again);
    assert_string_equal(
        first, second); /* names too, after the first conversion to valid names */
    free(first);
    free(second);
    pp_scene_description_clear(&back);
    pp_scene_description_clear(&scene);
}

static void names_are_fit_and_unlike_each_other(void **state)
{
    (void)state;
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    static const char *const names[] = {"void",
                                        "north wall",
                                        "north_wall",
                                        "!x #y",
                                        "",
                                        ("k\xc3\xbc"
                                         "che")};
    for (int i = 0; i < 6; i++) {
        struct pp_material grey = pp_material_diffuse(pp_rgb_grey(0.1 * i));
        strcpy(grey.name, names[i]);
        int index;
        assert_int_equal(pp_scene_description_add_material(&scene, &grey, &index, NULL),
                         PP_OK);
        const struct pp_vec3 corners[] = {{0, 0, i}, {1, 0, i}, {0, 1, i}};
        assert_int_equal(
            pp_scene_description_add_polygon(&scene, corners, 3, index, NULL, NULL),
            PP_OK);
    }
    assert_same_scene(&scene);
    pp_scene_description_clear(&scene);
}

/* Each shape has a material of its own, and most have another one behind. Nearly all
 * materials have the same name: a linear search for each would take minutes. */
static void twenty_thousand_materials_of_one_name_get_unique_names(void **state)
{
    (void)state;
    enum { COUNT = 20000 };
    struct pp_scene_description scene;
    pp_scene_description_init(&scene);
    for (int i = 0; i < COUNT; i++) {
        struct pp_material grey = pp_material_diffuse(pp_rgb_grey(0.9 * i / COUNT));
        strcpy(grey.name, i == 7 ? "void" : i == 9 ? "wall_5" : "wall");
        assert_int_equal(pp_scene_description_add_material(&scene, &grey, NULL, NULL),
                         PP_OK);
        const struct pp_vec3 corners[] = {{0, 0, i}, {1, 0, i}, {0, 1, i}};
        assert_int_equal(
            pp_scene_description_add_polygon(&scene, corners, 3, i, NULL, NULL), PP_OK);
        if (i % 3 > 0)
            scene.shapes[i].back_material = COUNT - 1 - i;
    }
    assert_same_scene(&scene);
    pp_scene_description_clear(&scene);
}

static void numbers_come_back_to_the_bit(void **state)
{
    (void)state;
    static const double numbers[] = {
        0.1, 1.0 / 3.0, 1e22, -2.5e-7, 123456789.123456789, 5e-324, 1.7999999999999998};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[32];
        pp_rad_numbers_text(numbers[i], text);
        assert_true(strtod(text, NULL) == numbers[i]);
    }
    char text[32];
    pp_rad_numbers_text(0.1, text);
    assert_string_equal(text, "0.1");
}

static void invalid_or_foreign_functions_are_rejected(void **state)
{
    (void)state;
    static const char *const wrong[] = {
        "void mixfunc m 4 void void if(Rdot,1,0) . 0 0",
        "void mixfunc m 4 a a if(Rdot,0,1) . 0 0",
        "void mixfunc m 4 a b if(Rdot,1,0) . 0 0",
        "void BRTDfunc m 10 r r r t t t 0 0 0 x.cal 0 9 0 0 0 0 0 0 0 0 0",
        "void BRTDfunc m 10 pp_mirrored pp_mirrored pp_mirrored pp_through pp_through "
        "pp_through 0 0 0 pepperpot.cal 0 15 0 0 0 0 0 0 0 0 0 1.5 1.52 0 1 1 1",
        "void BRTDfunc m 10 pp_mirrored pp_mirrored pp_mirrored pp_through pp_through "
        "pp_through 0 0 0 pepperpot.cal 0 15 .9 0 0 0 0 0 0 0 0 1 1.52 0 1 .5 1",
        "void brightfunc m 2 pp_sky pepperpot.cal 0 3 1 0 1",
        "void brightfunc m 2 pp_sky pepperpot.cal 0 11 1 17 .3 0 0 0 0 0 0 0 1",
        "void brightfunc m 2 pp_sky pepperpot.cal 0 11 1 16 .3 0 0 0 0 0 0 0 1",
        "void brightfunc m 2 pp_sky pepperpot.cal 0 15 1 0 .3183098861837907 0 0 0 0 0 "
        "0 "
        "0 1 1 1 1 1"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char text[600];
        snprintf(text, sizeof text, "void plastic a 0 0 5 .5 .5 .5 0 0\n%s\n",
                 wrong[i]);
        struct pp_scene_description scene;
        struct pp_rad_summary summary;
        struct pp_error err = {0};
        if (pp_rad_read_bytes(&scene, &summary, text, strlen(text), "x.rad", &err)
            != PP_BAD_INPUT)
            fail_msg("taken: %s", wrong[i]);
        assert_non_null(strstr(err.message, "x.rad:2: "));
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_example_comes_back_as_it_was),
        cmocka_unit_test(every_glazing_and_sky_comes_back),
        cmocka_unit_test(many_holes_in_one_wall_become_one_outline),
        cmocka_unit_test(openings_that_part_a_wall_leave_several_outlines),
        cmocka_unit_test(a_far_skyline_is_part_of_the_sky),
        cmocka_unit_test(what_radiance_has_no_words_for_is_refused),
        cmocka_unit_test(any_scene_is_read_back_unchanged),
        cmocka_unit_test(names_are_fit_and_unlike_each_other),
        cmocka_unit_test(twenty_thousand_materials_of_one_name_get_unique_names),
        cmocka_unit_test(numbers_come_back_to_the_bit),
        cmocka_unit_test(invalid_or_foreign_functions_are_rejected),
    };
    add_tests(tests, NULL, NULL);
}
