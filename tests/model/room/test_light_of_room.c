/* test_light_of_room.c - the light from outside that a room file describes. */
#include "model/room/room.h"
#include "model/room/room_parts.h"
#include "tests/lib/room_of.h"

#define PLAN "<plan width=\"4.3\" depth=\"6.1\" height=\"2.9\"/>"

static void without_a_word_it_is_overcast_over_a_ground_of_a_fifth(void **state)
{
    (void)state;
    struct pp_outside_light light =
        pp_test_light("<room version=\"1\">" PLAN "</room>");
    assert_int_equal(light.sky.kind, PP_SKY_OVERCAST);
    assert_near(light.ground_reflectance, 0.2, 0.0);
    light = pp_test_light("<room version=\"1\"><sky type=\"uniform\"/>"
                          "<site ground-reflectance=\"0.37\"/>" PLAN "</room>");
    assert_int_equal(light.sky.kind, PP_SKY_UNIFORM);
    assert_near(light.ground_reflectance, 0.37, 0.0);
}

/* A sun in the true south is at -y if +y is north, and at -x if +y is west (bearing
 * 270): if the room rotates, the sun rotates around it in the opposite direction. */
static void the_sun_s_bearing_is_from_true_north(void **state)
{
    (void)state;
    static const struct {
        const char *north;
        double x, y;
    } cases[] = {{"0", 0.0, -1.0}, {"270", -1.0, 0.0}, {"90", 1.0, 0.0}};
    for (int i = 0; i < 3; i++) {
        char xml[512];
        snprintf(xml, sizeof xml,
                 "<room version=\"1\" north=\"%s\"><sky type=\"iso-12\" "
                 "sun-altitude=\"25\" sun-bearing=\"180\"/>" PLAN "</room>",
                 cases[i].north);
        struct pp_outside_light light = pp_test_light(xml);
        double c = cos(25.0 * PP_RAD);
        assert_near(light.sky.sun.x, c * cases[i].x, 1e-15);
        assert_near(light.sky.sun.y, c * cases[i].y, 1e-15);
        assert_near(light.sky.sun.z, sin(25.0 * PP_RAD), 1e-15);
    }
}

/* Snow and a clear sky do not change the geometry: the two worlds have identical
 * surfaces. */
static void rooms_that_differ_in_light_have_one_world(void **state)
{
    (void)state;
#define WINDOW                                                                         \
    "<window wall=\"south\" left=\"0.7\" sill=\"0.9\" width=\"2.3\" height=\"1.4\"/>"
    struct pp_outside_light dull, snow;
    struct pp_world *a =
        pp_test_lit_world(&dull, "<room version=\"1\">" PLAN WINDOW "</room>");
    struct pp_world *b = pp_test_lit_world(
        &snow, "<room version=\"1\"><sky type=\"iso-12\" sun-altitude=\"25\" "
               "sun-bearing=\"180\"/><site ground-reflectance=\"0.8\"/>" PLAN WINDOW
               "</room>");
    assert_true(dull.ground_reflectance < snow.ground_reflectance);
    assert_int_equal(snow.sky.kind, PP_SKY_ISO);
    assert_int_equal(a->surface_count, b->surface_count);
    for (int i = 0; i < a->surface_count; i++) {
        const struct pp_polygon *p = &a->surfaces[i].outline;
        assert_int_equal(p->count, b->surfaces[i].outline.count);
        assert_memory_equal(p->vertices, b->surfaces[i].outline.vertices,
                            (size_t)p->count * sizeof *p->vertices);
        assert_near(a->surfaces[i].front, b->surfaces[i].front, 0.0);
        assert_near(a->surfaces[i].back, b->surfaces[i].back, 0.0);
    }
    assert_int_equal(a->receiver_count, b->receiver_count);
    assert_near(a->openings[0].maintenance, b->openings[0].maintenance, 0.0);
    pp_world_destroy(a);
    pp_world_destroy(b);
}

/* A sky whose sun has no position or is below the horizon is rejected, and the previous
 * light is kept. Room files cannot describe such a sky, so the test sets its parts. */
static void a_sky_that_cannot_be_is_refused(void **state)
{
    (void)state;
    struct pp_room room = {.site = {.ground_reflectance = 0.5},
                           .sky = pp_sky_words_default()};
    struct pp_outside_light light;
    struct pp_error err = {0};
    assert_int_equal(pp_room_light(&light, &room, &err), PP_OK);
    room.sky.kind = PP_SKY_ISO;
    room.sky.iso = 12;
    room.site.ground_reflectance = 0.1;
    assert_int_equal(pp_room_light(&light, &room, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "sun-altitude"));
    room.sky.sun_altitude_rad = -3.0 * PP_RAD;
    room.sky.sun_bearing_rad = 1.0;
    assert_int_equal(pp_room_light(&light, &room, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "below the horizon"));
    assert_int_equal(light.sky.kind, PP_SKY_OVERCAST);
    assert_near(light.ground_reflectance, 0.5, 0.0);
    room.sky = pp_sky_words_default();
    assert_int_equal(pp_room_set_sky(&room, "iso-12", &err), PP_BAD_INPUT);
    assert_int_equal(pp_room_set_sky(&room, "iso-12,-3,57", &err), PP_BAD_INPUT);
    assert_int_equal(pp_room_light(&light, &room, &err), PP_OK);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_word_it_is_overcast_over_a_ground_of_a_fifth),
        cmocka_unit_test(the_sun_s_bearing_is_from_true_north),
        cmocka_unit_test(rooms_that_differ_in_light_have_one_world),
        cmocka_unit_test(a_sky_that_cannot_be_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
