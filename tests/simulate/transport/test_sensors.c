/* test_sensors.c - the value and error of a sensor do not depend on its position in the
 * list. */
#include "simulate/transport/sensors.h"

#include <string.h>

#include "simulate/scene/light_scene_of_description.h"
#include "tests/lib/near.h"

/* A grey floor between two grey walls, and a small square lamp above it. */
static struct pp_light_scene *courtyard(void)
{
    static const struct pp_vec3 corners[3][4] = {
        {{0, 0, 0}, {4, 0, 0}, {4, 5, 0}, {0, 5, 0}},
        {{0, 0, 0}, {0, 5, 0}, {0, 5, 3}, {0, 0, 3}},
        {{4, 0, 0}, {4, 0, 3}, {4, 5, 3}, {4, 5, 0}}};
    struct pp_scene_description from;
    struct pp_light_scene *scene;
    struct pp_material grey = pp_material_diffuse(pp_rgb_grey(0.6));
    struct pp_material lamp = pp_material_light(pp_rgb_grey(40.0));
    int index, shining;
    pp_scene_description_init(&from);
    assert_int_equal(pp_scene_description_add_material(&from, &grey, &index, NULL),
                     PP_OK);
    assert_int_equal(pp_scene_description_add_material(&from, &lamp, &shining, NULL),
                     PP_OK);
    for (int i = 0; i < 3; i++)
        assert_int_equal(
            pp_scene_description_add_polygon(&from, corners[i], 4, index, NULL, NULL),
            PP_OK);
    static const struct pp_vec3 above[4] = {
        {1.9, 2.1, 2.7}, {1.9, 2.5, 2.7}, {2.3, 2.5, 2.7}, {2.3, 2.1, 2.7}};
    assert_int_equal(
        pp_scene_description_add_polygon(&from, above, 4, shining, NULL, NULL), PP_OK);
    assert_int_equal(pp_light_scene_of_description(&scene, &from, NULL), PP_OK);
    pp_scene_description_clear(&from);
    return scene;
}

static void read(const struct pp_light_scene *scene, const struct pp_sensor *list,
                 int count, int threads, struct pp_sensor_reading *readings)
{
    const struct pp_sensors_options options = {
        .error = 0.03, .seed = 7, .threads = threads};
    struct pp_sensors *sensors;
    assert_int_equal(
        pp_sensors_create(&sensors, scene, NULL, list, count, &options, NULL), PP_OK);
    while (!pp_sensors_done(sensors))
        assert_int_equal(pp_sensors_advance(sensors, 0.01, NULL), PP_OK);
    for (int i = 0; i < count; i++)
        readings[i] = pp_sensors_read(sensors, i);
    pp_sensors_destroy(sensors);
}

static void another_order_gives_each_sensor_the_same_bytes(void **state)
{
    (void)state;
    enum { COUNT = 5 };
    struct pp_light_scene *scene = courtyard();
    struct pp_sensor list[COUNT], turned[COUNT];
    struct pp_sensor_reading one[COUNT], other[COUNT];
    for (int i = 0; i < COUNT; i++)
        list[i] = turned[COUNT - 1 - i] = (struct pp_sensor){
            {0.3 + 0.8 * i, 1.1 + 0.6 * i, 0.4 * i}, {0.0, 0.0, 1.0}, i};
    read(scene, list, COUNT, 1, one);
    read(scene, turned, COUNT, 3, other);
    for (int i = 0; i < COUNT; i++) {
        assert_true(one[i].grey > 0.0 && one[i].grey_error > 0.0);
        assert_memory_equal(&one[i], &other[COUNT - 1 - i], sizeof *one);
    }
    pp_light_scene_destroy(scene);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(another_order_gives_each_sensor_the_same_bytes),
    };
    add_tests(tests, NULL, NULL);
}
