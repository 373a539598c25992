/* round_trip.h - writes every room of examples/ as a Radiance scene, reads it back, and
 * compares its daylight factors with the tracer's for the room itself. */
#ifndef PP_TESTS_LIB_ROUND_TRIP_H
#define PP_TESTS_LIB_ROUND_TRIP_H

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>

#include "simulate/scene/light_scene_of_description.h"
#include "formats/radiance/read/rad_read.h"
#include "formats/radiance/write/rad_room.h"
#include "formats/radiance/write/rad_write.h"
#include "simulate/transport/sensors.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"
#include "formats/radiance/write/rad_write_materials.h"

/* Comparison over all rooms. */
struct pp_test_beside {
    double error; /* target of the tracer; sensors get three times that */
    int rooms, points;
    double squares; /* sum of the squares of (difference / its error) */
};

/* Limits in standard errors, which are from 32 randomisations each. Over 193 points
 * Student's t with 31 degrees of freedom exceeds 5.5 once in 1000 times; over the sums
 * of 11 rooms it exceeds 4.5 as rarely. */
#define PP_TEST_WORST_POINT 5.5
#define PP_TEST_WORST_ROOM 4.5

/* Irradiances in the room's scene; the open horizontal ground has 1. */
static inline void pp_test_sense(const struct pp_world *world,
                                 const struct pp_outside_light *light, double error,
                                 struct pp_sensor_reading *readings)
{
    struct pp_rad_room room;
    struct pp_rad_writer *writer;
    struct pp_scene_description back;
    struct pp_rad_summary summary;
    struct pp_light_scene *scene;
    struct pp_error err = {0};
    assert_int_equal(pp_rad_room_init(&room, world, light, 1.0, false, &err), PP_OK);
    assert_int_equal(pp_rad_write_create(&writer, &room.scene, &err), PP_OK);
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    assert_non_null(out);
    pp_rad_write_materials(writer, out);
    pp_rad_write_shapes(writer, "shape", 0, room.scene.shape_count, out);
    fclose(out);
    pp_rad_write_destroy(writer);
    pp_rad_room_clear(&room);
    assert_int_equal(pp_rad_read_bytes(&back, &summary, text, length, "back.rad", &err),
                     PP_OK);
    free(text);
    assert_int_equal(pp_light_scene_of_description(&scene, &back, &err), PP_OK);
    pp_scene_description_clear(&back);

    int count = world->receiver_count;
    struct pp_sensor *list = calloc((size_t)count, sizeof *list);
    for (int i = 0; i < count; i++)
        list[i] = (struct pp_sensor){world->receivers[i].position,
                                     world->receivers[i].normal, 0};
    const struct pp_sensors_options options = {
        .error = error, .seed = 1, .threads = 1, .horizontal = 1.0};
    struct pp_sensors *sensors;
    assert_int_equal(
        pp_sensors_create(&sensors, scene, NULL, list, count, &options, &err), PP_OK);
    while (!pp_sensors_done(sensors))
        assert_int_equal(pp_sensors_advance(sensors, 1.0, &err), PP_OK);
    for (int i = 0; i < count; i++)
        readings[i] = pp_sensors_read(sensors, i);
    pp_sensors_destroy(sensors);
    pp_light_scene_destroy(scene);
    free(list);
}

static inline void pp_test_room_beside(struct pp_test_beside *all,
                                       const struct pp_world *world,
                                       const struct pp_outside_light *light)
{
    int count = world->receiver_count;
    const struct pp_tracer_options options = {
        .error = all->error, .seed = 1, .threads = 1};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, light, world->receivers, count, &options, NULL);
    struct pp_sensor_reading *sensed = calloc((size_t)count, sizeof *sensed);
    assert_non_null(sensed);
    pp_test_sense(world, light, 3.0 * all->error, sensed);
    double sum = 0.0, noise = 0.0, worst = 0.0, truth = 0.0;
    assert_near(world->decorations, 1.0, 0.0);
    for (int i = 0; i < count; i++) {
        struct pp_reading df = traced[i][PP_DF];
        double off = sensed[i].grey - df.value;
        double error = hypot(sensed[i].grey_error, df.std_error);
        sum += off;
        truth += df.value;
        noise += error * error;
        all->squares += off * off / (error * error);
        worst = fmax(worst, fabs(off) / error);
    }
    print_message("# %s: %d points, %+.2f %% off (%+.2f standard errors), worst %.2f\n",
                  world->name, count, 100.0 * sum / truth, sum / sqrt(noise), worst);
    assert_true(worst < PP_TEST_WORST_POINT);
    assert_near(sum / sqrt(noise), 0.0, PP_TEST_WORST_ROOM);
    all->rooms++;
    all->points += count;
    free(traced);
    free(sensed);
}

/* Compares all examples; `error`: target standard error of the tracer. */
static inline void pp_test_examples_beside(double error)
{
    struct pp_test_beside all = {.error = error};
    const char *top = getenv("srcdir");
    char pattern[4096];
    glob_t files;
    snprintf(pattern, sizeof pattern, "%s/examples/*.xml", top ? top : ".");
    assert_int_equal(glob(pattern, 0, NULL, &files), 0);
    for (size_t k = 0; k < files.gl_pathc; k++) {
        struct pp_building *building = NULL;
        struct pp_mistakes mistakes;
        pp_mistakes_init(&mistakes, files.gl_pathv[k]);
        assert_int_equal(
            pp_building_read(&building, files.gl_pathv[k], &mistakes, NULL), PP_OK);
        for (int i = 0; i < pp_building_room_count(building); i++) {
            struct pp_world *world = NULL;
            struct pp_outside_light light;
            assert_int_equal(
                pp_world_create(&world, pp_building_room(building, i), &mistakes, NULL),
                PP_OK);
            assert_int_equal(pp_room_light(&light, pp_building_room(building, i), NULL),
                             PP_OK);
            pp_test_room_beside(&all, world, &light);
            pp_world_destroy(world);
        }
        pp_building_destroy(building);
        pp_mistakes_clear(&mistakes);
    }
    globfree(&files);
    /* The mean square is about 1 where the errors are true, and less where they are
     * bounds. A square of t has a variance of 2.5: 3.3 deviations of the mean of so
     * many are once in 1000. */
    double mean = all.squares / all.points;
    print_message("# all %d rooms, %d points: mean square %.3f\n", all.rooms,
                  all.points, mean);
    assert_true(all.rooms >= 11 && all.points <= 193);
    assert_true(mean > 0.3 && mean < 1.0 + 3.3 * sqrt(2.5 / all.points));
}

#endif
