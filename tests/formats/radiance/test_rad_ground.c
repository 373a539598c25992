/* test_rad_ground.c - the ground as a surface of the exported scene. */
#include "tests/lib/room_of.h"

#include "formats/radiance/write/rad_room.h"
#include "simulate/scene/light_scene_of_description.h"
#include "tests/lib/sampled_light.h"

#define PLAN "<plan width='4.3' depth='6.1' height='2.9'/>"
#define WINDOW "<window wall='south' left='0.7' sill='0.8' width='1.3' height='1.1'/>"

static struct pp_rad_room scene_of(const char *parts)
{
    char xml[4096];
    snprintf(xml, sizeof xml, "<room version='1'>%s</room>", parts);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_rad_room room;
    struct pp_error err = {0};
    if (pp_rad_room_init(&room, world, &light, 1.0, false, &err) != PP_OK)
        fail_msg("%s", err.message);
    pp_world_destroy(world);
    return room;
}

static bool is_ground(const struct pp_scene_description *scene, int shape)
{
    const struct pp_shape *it = &scene->shapes[shape];
    return it->kind != PP_SHAPE_DISTANT
           && strcmp(scene->materials[it->material].name, "ground") == 0;
}

/* The disc of the ground; NULL: none. */
static const struct pp_shape *disc_of(const struct pp_scene_description *scene)
{
    for (int i = 0; i < scene->shape_count; i++)
        if (scene->shapes[i].kind == PP_SHAPE_RING)
            return &scene->shapes[i];
    return NULL;
}

/* The far upper corner of the tower is 136 m from the middle of the room. */
static void the_ground_reaches_far_beyond_what_stands_on_it(void **state)
{
    (void)state;
    struct pp_rad_room room =
        scene_of("<site ground-level='-1.7' ground-reflectance='0.37'/>" PLAN WINDOW
                 "<block x='-41.3' y='-87.2' width='7.9' depth='11.3' height='92.4'/>");
    const struct pp_shape *disc = disc_of(&room.scene);
    assert_non_null(disc);
    assert_near(disc->is.ring.centre.z, -1.7, 3e-4);
    assert_true(disc->is.ring.centre.z < -1.7 - 1e-4);
    assert_near(disc->is.ring.axis.z, 1.0, 0.0);
    assert_near(disc->is.ring.radii_m[0], 0.0, 0.0);
    double way = sqrt(pow(2.15 + 41.3, 2) + pow(3.05 + 87.2, 2) + pow(92.4, 2));
    assert_near(disc->is.ring.radii_m[1], 100.0 * way, 0.1);
    assert_near(pp_material_reflectance(&room.scene.materials[disc->material]), 0.37,
                1e-12);
    pp_rad_room_clear(&room);
}

static void an_open_ground_is_no_surface(void **state)
{
    (void)state;
    struct pp_rad_room room = scene_of("<site ground='open'/>" PLAN WINDOW);
    assert_null(disc_of(&room.scene));
    assert_int_equal(room.first[PP_RAD_SKY], room.first[PP_RAD_OUTSIDE]);
    pp_rad_room_clear(&room);
}

static void a_near_skyline_begins_at_the_ground(void **state)
{
    (void)state;
    struct pp_rad_room room =
        scene_of("<site ground-level='1.3'/>" PLAN WINDOW
                 "<skyline wall='south' angle='31' distance='11.7'/>");
    const struct pp_shape *disc = disc_of(&room.scene), *face = NULL;
    for (int i = room.first[PP_RAD_OUTSIDE]; i < room.first[PP_RAD_SKY] && !face; i++)
        if (!is_ground(&room.scene, i))
            face = &room.scene.shapes[i];
    double foot = INFINITY;
    /* The face reflects: Radiance calculates the light on it. */
    assert_non_null(face);
    const struct pp_material *matt = &room.scene.materials[face->material];
    assert_int_equal(matt->emits, PP_EMITS_NOTHING);
    assert_near(matt->diffuse.g, 0.2, 1e-12);
    for (int k = 0; k < face->is.polygon.count; k++)
        foot = fmin(foot, room.scene.vertices[face->is.polygon.first + k].z);
    assert_non_null(disc);
    assert_near(foot, 0.8, 1e-12); /* lowered to the sill */
    assert_near(disc->is.ring.centre.z, foot, 3e-4);
    assert_near(disc->is.ring.radii_m[1], 1170.0, 1e-9);
    pp_rad_room_clear(&room);
}

/* ---- a room below ground level ---- */

static double turn(struct pp_vec3 a, struct pp_vec3 b, double x, double y)
{
    return (b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y);
}

static bool covers(const struct pp_scene_description *scene, const struct pp_shape *it,
                   double x, double y)
{
    if (it->kind == PP_SHAPE_RING) {
        double off = hypot(x - it->is.ring.centre.x, y - it->is.ring.centre.y);
        return off >= it->is.ring.radii_m[0] && off <= it->is.ring.radii_m[1];
    }
    const struct pp_vec3 *v = scene->vertices + it->is.polygon.first;
    assert_int_equal(it->is.polygon.count, 3);
    assert_true(turn(v[0], v[1], v[2].x, v[2].y) > 0.0); /* it faces up */
    return turn(v[0], v[1], x, y) > 0.0 && turn(v[1], v[2], x, y) > 0.0
           && turn(v[2], v[0], x, y) > 0.0;
}

/* An L-shaped room: the ground is everywhere outside it. */
static void ground_higher_than_the_floor_stays_out_of_the_room(void **state)
{
    (void)state;
    struct pp_rad_room room = scene_of(
        "<site ground-level='0.7'/><plan height='2.9'><vertex x='0' y='0'/>"
        "<vertex x='7.3' y='0'/><vertex x='7.3' y='2.1'/><vertex x='3.1' y='2.1'/>"
        "<vertex x='3.1' y='6.7'/><vertex x='0' y='6.7'/></plan>");
    int inside = 0, outside = 0;
    for (double x = -20.03; x < 30.0; x += 0.61)
        for (double y = -20.07; y < 30.0; y += 0.59) {
            bool covered = false,
                 in = x > 0.0 && y > 0.0
                      && ((x < 7.3 && y < 2.1) || (x < 3.1 && y < 6.7));
            for (int i = 0; i < room.scene.shape_count; i++)
                covered |= is_ground(&room.scene, i)
                           && covers(&room.scene, &room.scene.shapes[i], x, y);
            assert_true(covered == !in);
            inside += in;
            outside += !in;
        }
    assert_true(inside > 50 && outside > 5000);
    pp_rad_room_clear(&room);
}

/* ---- light from the ground ---- */

/* Illuminance from below at a sensor a centimetre above the ground, 50 m in front of
 * the room. */
static double light_from_below(const char *parts)
{
    struct pp_rad_room room = scene_of(parts);
    struct pp_light_scene *scene;
    struct pp_error err = {0};
    assert_int_equal(pp_light_scene_of_description(&scene, &room.scene, &err), PP_OK);
    struct pp_test_mean mean =
        pp_test_irradiance(scene, NULL, NULL, pp_radiance_state_defaults(),
                           pp_vec(2.1, -50.0, 0.01), pp_vec(0.0, 0.0, -1.0), 1024);
    pp_light_scene_destroy(scene);
    pp_rad_room_clear(&room);
    assert_true(mean.error < 0.002);
    return pp_rgb_luminance(mean.value);
}

/* Half a metre from the foot of a black wall, 3 km high and 6 km long, the ground sees
 * half of the sky. Without the wall it sees the sky except for the room, which hides
 * less than 0.1 %. */
static void ground_at_the_foot_of_a_wall_is_half_as_light(void **state)
{
    (void)state;
#define WALL                                                                           \
    "<block x='-3000' y='-60.5' width='6000' depth='10' height='3000' "                \
    "reflectance='0'/>"
    assert_near(light_from_below("<site ground-reflectance='0.37'/>" PLAN WINDOW), 0.37,
                0.002);
    assert_near(light_from_below("<site ground-reflectance='0.37'/>" PLAN WINDOW WALL),
                0.37 / 2.0, 0.004);
    assert_near(light_from_below(
                    "<site ground='open' ground-reflectance='0.37'/>" PLAN WINDOW WALL),
                0.37, 0.002);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ground_reaches_far_beyond_what_stands_on_it),
        cmocka_unit_test(an_open_ground_is_no_surface),
        cmocka_unit_test(a_near_skyline_begins_at_the_ground),
        cmocka_unit_test(ground_higher_than_the_floor_stays_out_of_the_room),
        cmocka_unit_test(ground_at_the_foot_of_a_wall_is_half_as_light),
    };
    add_tests(tests, NULL, NULL);
}
