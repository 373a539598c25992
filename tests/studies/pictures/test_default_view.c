/* test_default_view.c - the default view of a room. */
#include "model/pictures/camera.h"
#include "studies/pictures/default_view.h"
#include "simulate/scene/light_scene_of_world.h"
#include "tests/lib/room_of.h"

#define DEEP                                                                           \
    "<room version='1'><sky type='uniform'/><plan width='3' depth='6' height='2.7'/>"  \
    "<finishes floor='0.2' walls='0.7' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/></room>"

#define L_SHAPED                                                                       \
    "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"                       \
    "<vertex x='5.4' y='0'/><vertex x='5.4' y='3.6'/><vertex x='3' y='3.6'/>"          \
    "<vertex x='3' y='6.6'/><vertex x='0' y='6.6'/></plan>"                            \
    "<window wall='1' left='1.8' sill='0.5' width='2.8' height='1.7'/></room>"

struct scene {
    struct pp_world *world;
    struct pp_light_scene *light;
};

static struct scene scene_of(const char *xml)
{
    struct scene scene = {pp_test_world(xml), NULL};
    assert_int_equal(pp_light_scene_of_world(&scene.light, scene.world, NULL), PP_OK);
    return scene;
}

static void clear(struct scene *scene)
{
    pp_light_scene_destroy(scene->light);
    pp_world_destroy(scene->world);
}

static void the_default_view_stands_back_and_sees_the_window(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_view_place place;
    pp_default_view(&place, scene.light, scene.world, PP_ROOM_VIEW_PERSPECTIVE);
    assert_near(place.eye.z, 1.6, 1e-12);
    assert_near(place.eye.x, 1.5, 0.15); /* half a step of the positions tested */
    assert_true(place.eye.y > 5.2
                && place.eye.y < 5.65); /* with a distance from the wall at 6 */
    assert_near(place.toward.z, 0.0, 0.0);
    assert_true(place.toward.y < -4.0);

    pp_default_view(&place, scene.light, scene.world, PP_ROOM_VIEW_SECTION);
    assert_near(place.across_m, 6.0, 1e-9);
    assert_near(place.down_m, 2.7, 1e-9);
    struct pp_camera camera;
    assert_int_equal(pp_camera_set(&camera, PP_VIEW_PARALLEL, place.eye, place.toward,
                                   place.up, place.across_m, place.down_m, NULL),
                     PP_OK);
    double x, y, distance_m;
    assert_true(pp_camera_project(&camera, pp_vec(1.4, 0.0, 0.0), &x, &y, &distance_m));
    assert_near(x, 0.0, 1e-9); /* the window wall is on the left, the floor below */
    assert_near(y, 1.0, 1e-9);

    pp_default_view(&place, scene.light, scene.world, PP_ROOM_VIEW_FISHEYE);
    assert_near(place.eye.z, scene.world->working_plane_m, 1e-12);
    clear(&scene);
}

/* With a cupboard along the back and a column in the middle, the eye is in front of the
 * cupboard and not behind the column. */
static void the_default_view_is_clear_of_what_stands_in_the_room(void **state)
{
    (void)state;
    struct scene scene = scene_of(
        "<room version='1'><plan width='4' depth='6' height='2.7'/>"
        "<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"
        "<surface><vertex x='0' y='4.5' z='0'/><vertex x='4' y='4.5' z='0'/>"
        "<vertex x='4' y='4.5' z='2.2'/><vertex x='0' y='4.5' z='2.2'/></surface>"
        "<surface><vertex x='1.7' y='2' z='0'/><vertex x='2.3' y='2' z='0'/>"
        "<vertex x='2.3' y='2' z='2.7'/><vertex x='1.7' y='2' z='2.7'/></surface>"
        "</room>");
    struct pp_view_place place;
    pp_default_view(&place, scene.light, scene.world, PP_ROOM_VIEW_PERSPECTIVE);
    assert_true(place.eye.y < 4.2);
    struct pp_vec3 way = pp_vec_sub(pp_vec(2.0, 0.0, place.eye.z), place.eye);
    struct pp_light_ray ray = {
        .from = place.eye, .to = pp_vec_unit(way), .space = PP_INDOORS};
    struct pp_light_hit hit;
    assert_true(pp_light_scene_first(scene.light, &ray, &hit));
    assert_true(hit.distance_m > 0.95 * pp_vec_length(way));
    clear(&scene);
}

/* Horizontal distance to the nearest object in this direction. */
static double free_m(const struct scene *scene, struct pp_vec3 eye, double angle_rad)
{
    struct pp_light_ray ray = {.from = eye,
                               .to = pp_vec(cos(angle_rad), sin(angle_rad), 0.0),
                               .space = PP_INDOORS};
    struct pp_light_hit hit;
    return pp_light_scene_first(scene->light, &ray, &hit) ? hit.distance_m : INFINITY;
}

/* From behind the corner of the L-shaped room, a wall 3 m away would fill a third of
 * the picture. */
static void the_default_view_does_not_look_round_a_corner(void **state)
{
    (void)state;
    struct scene scene = scene_of(L_SHAPED);
    struct pp_view_place place;
    pp_default_view(&place, scene.light, scene.world, PP_ROOM_VIEW_PERSPECTIVE);
    double middle = atan2(place.toward.y, place.toward.x);
    int near = 0;
    for (int i = -37; i <= 37; i++)
        near += free_m(&scene, place.eye, middle + i * PP_RAD) < 4.0;
    assert_in_range(near, 0, 8); /* of 75 degrees */
    assert_true(place.eye.y > 3.6);
    clear(&scene);
}

/* From 0.1 m in front of a wall this wall would fill half of the picture. */
static void the_default_view_keeps_clear_of_walls(void **state)
{
    (void)state;
    static const char *const rooms[] = {
        DEEP, L_SHAPED,
        "<room version='1'><plan width='1.6' depth='60' height='2.4'/>"
        "<window wall='south' left='0.3' sill='0.5' width='1' height='1.6'/></room>",
        /* The rearmost positions tested are 0.25 m in front of the wall. */
        "<room version='1'><plan width='3.2' depth='12' height='2.4'/>"
        "<window wall='south' left='0.6' sill='0.5' width='2' height='1.6'/></room>",
        "<room version='1'><plan width='8' depth='5' height='4'/>"
        "<rooflight x='1.5' y='1.5' width='2' depth='2' reveal='0.5'/></room>",
        "<room version='1'><plan width='3' depth='5' height='2.5'/></room>"};
    for (size_t i = 0; i < sizeof rooms / sizeof rooms[0]; i++) {
        struct scene scene = scene_of(rooms[i]);
        struct pp_view_place place;
        pp_default_view(&place, scene.light, scene.world, PP_ROOM_VIEW_PERSPECTIVE);
        for (int deg = 0; deg < 360; deg += 3)
            assert_true(free_m(&scene, place.eye, deg * PP_RAD) > 0.3);
        clear(&scene);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_default_view_stands_back_and_sees_the_window),
        cmocka_unit_test(the_default_view_is_clear_of_what_stands_in_the_room),
        cmocka_unit_test(the_default_view_does_not_look_round_a_corner),
        cmocka_unit_test(the_default_view_keeps_clear_of_walls),
    };
    add_tests(tests, NULL, NULL);
}
