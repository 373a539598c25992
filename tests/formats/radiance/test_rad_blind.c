/* test_rad_blind.c - the slats of a blind are exported as polygons of the scene. */
#include "tests/lib/room_of.h"

#include "formats/radiance/write/rad_room.h"

#define ROOM                                                                           \
    "<room version='1'><plan width='4' depth='5' height='2.8'/>"                       \
    "<window wall='south' left='0.7' sill='0.8' width='1.3' height='1.2' "             \
    "glazing='clear-double'>%s</window></room>"

static enum pp_status scene_with(struct pp_rad_room *room, const char *blind)
{
    char xml[1000];
    struct pp_outside_light light;
    snprintf(xml, sizeof xml, ROOM, blind);
    struct pp_world *world = pp_test_lit_world(&light, xml);
    enum pp_status status = pp_rad_room_init(room, world, &light, 1.0, false, NULL);
    pp_world_destroy(world);
    return status;
}

/* Number of polygons with the material of the slats; *least, *most: their limits in
 * y. */
static int slat_count(const struct pp_rad_room *room, double *least, double *most)
{
    const struct pp_scene_description *scene = &room->scene;
    int count = 0;
    *least = INFINITY, *most = -INFINITY;
    for (int i = 0; i < scene->shape_count; i++) {
        const struct pp_shape *shape = &scene->shapes[i];
        if (strncmp(scene->materials[shape->material].name, "slats", 5) != 0)
            continue;
        count++;
        for (int k = 0; k < shape->is.polygon.count; k++) {
            double y = scene->vertices[shape->is.polygon.first + k].y;
            *least = fmin(*least, y);
            *most = fmax(*most, y);
        }
    }
    return count;
}

/* The window is 1.2 m high: 24 slats 50 mm apart. The room is at positive y. */
static void slats_are_polygons_beside_the_glass(void **state)
{
    (void)state;
    struct pp_rad_room room;
    double least, most;
    assert_int_equal(scene_with(&room,
                                "<blind slat-width='0.06' spacing='0.05' angle='-30' "
                                "reflectance='0.7' reflectance-below='0.2'/>"),
                     PP_OK);
    assert_int_equal(slat_count(&room, &least, &most), 24);
    assert_near(least, 0.001, 1e-9);
    assert_near(most, 0.001 + 0.06 * cos(30.0 * PP_RAD), 1e-9);
    pp_rad_room_clear(&room);
    assert_int_equal(scene_with(&room, "<blind slat-width='0.06' spacing='0.05' "
                                       "curvature='0.004' position='outside'/>"),
                     PP_OK);
    assert_int_equal(slat_count(&room, &least, &most), 24 * 6);
    assert_true(most < 0.0);
    pp_rad_room_clear(&room);
}

static void slats_between_panes_are_refused(void **state)
{
    (void)state;
    struct pp_rad_room room;
    assert_int_equal(scene_with(&room, "<blind position='between'/>"), PP_BAD_INPUT);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(slats_are_polygons_beside_the_glass),
        cmocka_unit_test(slats_between_panes_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
