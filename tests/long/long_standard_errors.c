/* long_standard_errors.c - the stated standard errors are correct: 60 seeds in each of
 * eight rooms, for points, cached points, sensors and pixels. The reference is a long
 * run with another seed, whose error is included. Prints a table and tests the
 * totals. */
#include <stdio.h>
#include <string.h>

#include "simulate/cache/cached_points.h"
#include "simulate/render/render.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/opening_store.h"
#include "simulate/transport/sensors.h"
#include "tests/lib/light_scenes.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

enum { SEEDS = 60, POINTS = 3, TRUE_SEED = 4242 };

#define PLAN "<room version='1'><plan width='4' depth='6' height='2.8'/>"
#define AT                                                                             \
    "<point x='1.1' y='1.3'/><point x='2.3' y='3.2'/><point x='3.1' y='5.4'/></room>"

static const struct {
    const char *name, *xml;
} rooms[] = {
    {"small window", PLAN "<window wall='south' left='1.8' sill='1.2' width='0.4' "
                          "height='0.4'/>" AT},
    {"light well", PLAN "<window wall='south' left='1' sill='0.9' width='2' "
                        "height='1.4'/><block x='-1' y='-3' width='6' depth='1' "
                        "height='9'/><block x='-2' y='-3' width='1' depth='3' "
                        "height='9'/><block x='5' y='-3' width='1' depth='3' "
                        "height='9'/>" AT},
    {"slit", PLAN "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5'/>"
                  "<block x='-30' y='-1' width='32' depth='0.5' height='40'/>"
                  "<block x='2.1' y='-1' width='30' depth='0.5' height='40'/>" AT},
    {"deep obstructed", "<room version='1'><plan width='4' depth='11' height='2.8'/>"
                        "<window wall='south' left='0.5' sill='0.9' width='3' "
                        "height='1.5'/><block x='-9' y='-9' width='22' depth='1' "
                        "height='12'/><point x='1.1' y='1.3'/><point x='2.3' y='6.2'/>"
                        "<point x='3.1' y='10.4'/></room>"},
    {"rooflight", PLAN "<rooflight x='1.2' y='2' width='1.4' depth='1.1'/>" AT},
};

static int all_count, all_within_1, all_within_2;

/* One row of the table. */
struct line {
    int count, within_1, within_2, nothing;
};

static void add(struct line *line, double value, double error, double truth,
                double its_error)
{
    double off = fabs(value - truth), both = hypot(error, its_error);
    line->count++;
    line->within_1 += off < both;
    line->within_2 += off < 2.0 * both;
    line->nothing += !(error > 0.0);
}

static void end(const char *room, const char *client, const struct line *line)
{
    print_message("# %-16s %-8s %5d  %5.1f %%  %5.1f %%\n", room, client, line->count,
                  100.0 * line->within_1 / line->count,
                  100.0 * line->within_2 / line->count);
    assert_int_equal(line->nothing, 0);
    all_count += line->count;
    all_within_1 += line->within_1;
    all_within_2 += line->within_2;
}

static void errors_of_points(const char *name, const struct pp_world *world,
                             const struct pp_outside_light *light)
{
    struct line line = {0};
    struct pp_tracer_options options = {
        .samples = 8192, .seed = TRUE_SEED, .threads = 0};
    struct pp_reading(*truth)[4] =
        pp_test_trace(world, light, world->receivers, POINTS, &options, NULL);
    for (int seed = 0; seed < SEEDS; seed++) {
        options = (struct pp_tracer_options){.error = 0.03, .seed = (uint64_t)seed};
        struct pp_reading(*traced)[4] =
            pp_test_trace(world, light, world->receivers, POINTS, &options, NULL);
        for (int i = 0; i < POINTS; i++)
            add(&line, traced[i][PP_DF].value, traced[i][PP_DF].std_error,
                truth[i][PP_DF].value, truth[i][PP_DF].std_error);
        free(traced);
    }
    free(truth);
    end(name, "points", &line);
}

/* One cache for all seeds, so that its systematic error is also in the reference. */
static void cached(const struct pp_world *world, const struct pp_light_scene *scene,
                   const struct pp_opening_store *store,
                   struct pp_irradiance_cache *cache,
                   const struct pp_cached_options *options,
                   struct pp_reading (*readings)[4])
{
    struct pp_cached_points *points;
    assert_int_equal(pp_cached_points_create(&points, scene, store, cache,
                                             world->receivers, POINTS, options, NULL),
                     PP_OK);
    while (!pp_cached_points_done(points))
        assert_int_equal(pp_cached_points_advance(points, 1.0, NULL), PP_OK);
    for (int i = 0; i < POINTS; i++)
        pp_cached_points_read(points, i, readings[i]);
    pp_cached_points_destroy(points);
}

static void errors_of_cached_points(const char *name, const struct pp_world *world,
                                    const struct pp_light_scene *scene,
                                    const struct pp_environment *outside,
                                    const struct pp_opening_store *store)
{
    struct line line = {0};
    struct pp_irradiance_cache *cache;
    struct pp_cache_options wanted = pp_irradiance_cache_defaults();
    struct pp_radiance_options light = pp_cached_points_light();
    struct pp_reading truth[POINTS][4], one[POINTS][4];
    assert_int_equal(pp_irradiance_cache_create(&cache, scene, outside, store, &light,
                                                &wanted, NULL),
                     PP_OK);
    struct pp_cached_options options = {.samples = 8192, .seed = TRUE_SEED};
    cached(world, scene, store, cache, &options, truth);
    for (int seed = 0; seed < SEEDS; seed++) {
        options = (struct pp_cached_options){.error = 0.03, .seed = (uint64_t)seed};
        cached(world, scene, store, cache, &options, one);
        for (int i = 0; i < POINTS; i++)
            add(&line, one[i][PP_DF].value, one[i][PP_DF].std_error,
                truth[i][PP_DF].value, truth[i][PP_DF].std_error);
    }
    pp_irradiance_cache_destroy(cache);
    end(name, "cached", &line);
}

static void sense(const struct pp_light_scene *scene,
                  const struct pp_environment *outside, const struct pp_sensor *list,
                  const struct pp_sensors_options *options,
                  struct pp_sensor_reading *readings)
{
    struct pp_sensors *sensors;
    assert_int_equal(
        pp_sensors_create(&sensors, scene, outside, list, POINTS, options, NULL),
        PP_OK);
    while (!pp_sensors_done(sensors))
        assert_int_equal(pp_sensors_advance(sensors, 1.0, NULL), PP_OK);
    for (int i = 0; i < POINTS; i++)
        readings[i] = pp_sensors_read(sensors, i);
    pp_sensors_destroy(sensors);
}

static void errors_of_sensors(const char *name, const struct pp_sensor *list,
                              const struct pp_light_scene *scene,
                              const struct pp_environment *outside)
{
    struct line line = {0};
    struct pp_sensor_reading truth[POINTS], one[POINTS];
    struct pp_sensors_options options = {
        .samples = 8192, .seed = TRUE_SEED, .horizontal = 1.0};
    sense(scene, outside, list, &options, truth);
    for (int seed = 0; seed < SEEDS; seed++) {
        options = (struct pp_sensors_options){
            .error = 0.03, .seed = (uint64_t)seed, .horizontal = 1.0};
        sense(scene, outside, list, &options, one);
        for (int i = 0; i < POINTS; i++)
            add(&line, one[i].grey, one[i].grey_error, truth[i].grey,
                truth[i].grey_error);
    }
    end(name, "sensors", &line);
}

/* A picture of 3 x 3 pixels; its green channel. */
static void draw(const struct pp_light_scene *scene,
                 const struct pp_environment *outside, int samples, int randomisations,
                 uint64_t seed, double values[9], double errors[9])
{
    struct pp_render_options options = {.width = 3,
                                        .height = 3,
                                        .samples = samples,
                                        .randomisations = randomisations,
                                        .light = pp_radiance_state_defaults(),
                                        .seed = seed};
    struct pp_render *render;
    options.light.source_most = 1;
    assert_int_equal(pp_camera_set(&options.camera, PP_VIEW_PERSPECTIVE,
                                   pp_vec(2.1, 5.6, 1.4), pp_vec(0.0, 1.0, -0.2),
                                   pp_vec(0.0, 0.0, 1.0), 0.9, 0.9, NULL),
                     PP_OK);
    assert_int_equal(pp_render_create(&render, scene, outside, &options, NULL), PP_OK);
    while (!pp_render_done(render))
        assert_int_equal(pp_render_advance(render, 1.0, NULL), PP_OK);
    for (int i = 0; i < 9; i++) {
        values[i] = pp_render_picture(render)->rgb[3 * i + 1];
        errors[i] = pp_render_errors(render)->rgb[3 * i + 1];
    }
    pp_render_destroy(render);
}

static void errors_of_pixels(const char *name, const struct pp_light_scene *scene,
                             const struct pp_environment *outside)
{
    struct line line = {0};
    double truth[9], its_errors[9], values[9], errors[9];
    draw(scene, outside, 1 << 16, 32, TRUE_SEED, truth, its_errors);
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        draw(scene, outside, 2048, 32, seed, values, errors);
        for (int i = 0; i < 9; i++)
            add(&line, values[i], errors[i], truth[i], its_errors[i]);
    }
    end(name, "pixels", &line);
}

/* A closed box of 4 x 6 x 2.8 m with a lamp below its ceiling, and a sheet of this
 * material on its floor. */
static struct pp_light_scene *lamp_room(struct pp_material sheet)
{
    struct pp_scene_description room;
    pp_scene_description_init(&room);
    pp_test_box(&room, pp_test_material(&room, pp_material_diffuse(pp_rgb_grey(0.5))),
                4.0, 6.0, 2.8);
    pp_test_rectangle(&room, pp_test_material(&room, sheet), pp_vec(0.5, 0.5, 0.02),
                      pp_vec(3.0, 0.0, 0.0), pp_vec(0.0, 2.5, 0.0));
    pp_test_rectangle(
        &room, pp_test_material(&room, pp_material_light(pp_rgb_grey(4.0))),
        pp_vec(1.8, 1.6, 2.6), pp_vec(0.0, 0.4, 0.0), pp_vec(0.4, 0.0, 0.0));
    return pp_test_built(&room);
}

/* Sensors and pixels lit by a lamp directly, by a mirror and by polished metal. */
static void errors_of_lamps(void)
{
    static const struct pp_vec3 up = {0.0, 0.0, 1.0}, down = {0.0, 0.0, -1.0};
    const struct pp_sensor list[POINTS] = {{{1.1, 1.3, 0.85}, up, 0},
                                           {{2.3, 3.2, 0.85}, up, 0},
                                           {{3.1, 2.4, 1.5}, down, 0}};
    const struct pp_rgb bright = pp_rgb_grey(0.85);
    const struct {
        const char *name;
        struct pp_material sheet;
    } cases[] = {
        {"lamp", pp_material_diffuse(bright)},
        {"mirror", pp_material_mirror(bright)},
        {"polished metal", pp_material_metal(bright, 0.9, 0.1, 0.1)},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_light_scene *scene = lamp_room(cases[i].sheet);
        errors_of_sensors(cases[i].name, list, scene, NULL);
        errors_of_pixels(cases[i].name, scene, NULL);
        pp_light_scene_destroy(scene);
    }
}

static void values_lie_within_their_errors_in_every_client(void **state)
{
    (void)state;
    print_message("# %-16s %-8s %5s  %7s  %7s\n", "room", "client", "count", "1 se",
                  "2 se");
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, rooms[i].xml);
        struct pp_light_scene *scene = pp_test_matt_scene(world);
        struct pp_environment *outside = pp_test_light_on(scene, &light);
        struct pp_opening_store *store;
        assert_int_equal(pp_opening_store_create(&store, scene, outside, 1, 0, NULL),
                         PP_OK);
        errors_of_points(rooms[i].name, world, &light);
        errors_of_cached_points(rooms[i].name, world, scene, outside, store);
        struct pp_sensor list[POINTS];
        for (int k = 0; k < POINTS; k++)
            list[k] = (struct pp_sensor){world->receivers[k].position,
                                         world->receivers[k].normal, 0};
        errors_of_sensors(rooms[i].name, list, scene, outside);
        errors_of_pixels(rooms[i].name, scene, outside);
        pp_opening_store_destroy(store);
        pp_environment_destroy(outside);
        pp_light_scene_destroy(scene);
        pp_world_destroy(world);
    }
    errors_of_lamps();
    print_message("# all: %d values, %.1f %% and %.1f %%\n", all_count,
                  100.0 * all_within_1 / all_count, 100.0 * all_within_2 / all_count);
    assert_in_range(1000 * all_within_1 / all_count, 640, 740);
    assert_in_range(1000 * all_within_2 / all_count, 930, 970);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_lie_within_their_errors_in_every_client),
    };
    return cmocka_run_group_tests_name("long_standard_errors", tests, NULL, NULL);
}
