/* test_glazing_file.c - windows whose glass is described by a file of measured data. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "model/room/building.h"
#include "model/room/room_light.h"
#include "model/room/world.h"
#include "tests/lib/made_bsdf.h"
#include "tests/lib/near.h"

static char folder[] = "/tmp/pepperpot-pane-XXXXXX";

static char *path_of(const char *file)
{
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, file);
    return path;
}

static void write_to(const char *file, const char *text, size_t length)
{
    FILE *out = fopen(path_of(file), "w");
    assert_non_null(out);
    assert_int_equal(fwrite(text, 1, length, out), length);
    assert_int_equal(fclose(out), 0);
}

static int make_folder(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    struct made_bsdf prism = made_bsdf_front("LBNL/Klems Quarter", made_bsdf_prism);
    struct made_bsdf opal = made_bsdf_front("LBNL/Klems Quarter", made_bsdf_lambertian);
    write_to("prism.xml", prism.text, prism.length);
    write_to("opal.xml", opal.text, opal.length);
    write_to("not.xml", "<room/>", 7);
    free(prism.text);
    free(opal.text);
    return 0;
}

static int remove_folder(void **state)
{
    (void)state;
    static const char *const files[] = {"prism.xml", "opal.xml", "not.xml", "room.xml"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        unlink(path_of(files[i]));
    return rmdir(folder);
}

/* Reads a room with these windows from a file; NULL if there are mistakes. */
static struct pp_world *room_of_file(const char *windows, struct pp_mistakes *mistakes)
{
    char text[1024];
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    int length = snprintf(text, sizeof text,
                          "<room version='1'><plan width='4' depth='5' height='3'/>"
                          "%s</room>",
                          windows);
    write_to("room.xml", text, (size_t)length);
    pp_mistakes_init(mistakes, "room.xml");
    if (pp_building_read(&building, path_of("room.xml"), mistakes, NULL) == PP_OK)
        pp_world_create(&world, pp_building_room(building, 0), mistakes, NULL);
    pp_building_destroy(building);
    return world;
}

#define WINDOW(left, glass)                                                            \
    "<window wall='south' left='" left "' sill='1' width='1' height='1' " glass "/>"

static void windows_of_one_file_share_its_pane(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    struct pp_world *world =
        room_of_file(WINDOW("0.1", "glazing-file='prism.xml'")
                         WINDOW("1.2", "glazing-file='prism.xml'")
                             WINDOW("2.3", "glazing-file='opal.xml'"),
                     &mistakes);
    assert_non_null(world);
    const struct pp_opening *openings = world->openings;
    assert_ptr_equal(openings[0].measured, openings[1].measured);
    assert_ptr_not_equal(openings[0].measured, openings[2].measured);
    assert_ptr_equal(openings[0].scatter, &openings[0].measured->scatter);
    assert_near(openings[0].glass.normal, 0.5, 1e-8);
    assert_near(openings[0].glass.diffuse, openings[0].measured->diffuse, 1e-12);
    assert_true(openings[2].glass.diffusing);
    assert_near(openings[2].glass.diffuse, 0.4, 1e-8);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
}

static void the_peak_is_a_ray_unless_the_file_says_patch(void **state)
{
    (void)state;
    struct pp_mistakes mistakes;
    struct pp_world *world =
        room_of_file(WINDOW("0.1", "glazing-file='prism.xml'")
                         WINDOW("1.2", "glazing-file='prism.xml' glazing-peak='patch'"),
                     &mistakes);
    assert_non_null(world);
    assert_true(world->openings[0].measured->straight_diffuse > 0.2);
    assert_near(world->openings[1].measured->straight_diffuse, 0.0, 0.0);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
}

static void wrong_uses_are_refused(void **state)
{
    (void)state;
    static const struct {
        const char *window, *message;
    } wrong[] = {
        {WINDOW("1", "glazing-file='none.xml'"), "none.xml"},
        {WINDOW("1", "glazing-file='not.xml'"), "outermost element is <room>"},
        {WINDOW("1", "glazing-file='prism.xml' glazing='clear-single'"),
         "glazing and glazing-file are both given"},
        {WINDOW("1", "glazing-file='prism.xml' transmittance='0.5'"),
         "transmittance and glazing-file are both given"},
        {WINDOW("1", "glazing-file='prism.xml' diffusing='yes'"),
         "diffusing and glazing-file are both given"},
        {WINDOW("1", "glazing-peak='ray'"), "without glazing-file"},
        {WINDOW("1", "glazing-file='prism.xml' glazing-peak='disc'"), "\"ray\" or"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct pp_mistakes mistakes;
        assert_null(room_of_file(wrong[i].window, &mistakes));
        assert_int_equal(mistakes.count, 1);
        if (!strstr(mistakes.list[0].text, wrong[i].message))
            fail_msg("%s", mistakes.list[0].text);
        pp_mistakes_clear(&mistakes);
    }
}

static void a_room_without_a_folder_has_no_files(void **state)
{
    (void)state;
    static const char text[] =
        "<room version='1'><plan width='4' depth='5' height='3'/>" WINDOW(
            "1", "glazing-file='prism.xml'") "</room>";
    struct pp_mistakes mistakes;
    struct pp_building *building = NULL;
    pp_mistakes_init(&mistakes, "room.xml");
    assert_int_equal(
        pp_building_parse(&building, text, sizeof text - 1, &mistakes, NULL),
        PP_BAD_INPUT);
    assert_non_null(strstr(mistakes.list[0].text, "not read from a file"));
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_of_one_file_share_its_pane),
        cmocka_unit_test(the_peak_is_a_ray_unless_the_file_says_patch),
        cmocka_unit_test(wrong_uses_are_refused),
        cmocka_unit_test(a_room_without_a_folder_has_no_files),
    };
    add_tests(tests, make_folder, remove_folder);
}
