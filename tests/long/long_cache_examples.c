/* long_cache_examples.c - daylight factors of every room of examples/ by the irradiance
 * cache with its default options agree with the path tracer at a standard error of 0.2
 * %. */
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>

#include "simulate/cache/cached_points.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/opening_store.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

static void read_all(const struct pp_world *world,
                     const struct pp_outside_light *outside,
                     struct pp_reading (*readings)[4])
{
    struct pp_light_scene *scene = NULL;
    struct pp_environment *environment = NULL;
    struct pp_opening_store *store = NULL;
    struct pp_irradiance_cache *cache = NULL;
    struct pp_cached_points *points = NULL;
    const struct pp_radiance_options light = pp_cached_points_light();
    const struct pp_cache_options options = pp_irradiance_cache_defaults();
    const struct pp_cached_options wanted = {.error = 0.002, .seed = 1};
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    assert_int_equal(pp_light_scene_under(&environment, scene, outside, NULL), PP_OK);
    assert_int_equal(pp_opening_store_create(&store, scene, environment, 1, 0, NULL),
                     PP_OK);
    assert_int_equal(pp_irradiance_cache_create(&cache, scene, environment, store,
                                                &light, &options, NULL),
                     PP_OK);
    assert_int_equal(pp_cached_points_create(&points, scene, store, cache,
                                             world->receivers, world->receiver_count,
                                             &wanted, NULL),
                     PP_OK);
    while (!pp_cached_points_done(points))
        assert_int_equal(pp_cached_points_advance(points, 1.0, NULL), PP_OK);
    for (int i = 0; i < world->receiver_count; i++)
        pp_cached_points_read(points, i, readings[i]);
    pp_cached_points_destroy(points);
    pp_irradiance_cache_destroy(cache);
    pp_opening_store_destroy(store);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
}

/* Asserts the mean within 1 %, and every point within 3 % or a daylight factor of 0.005
 * %. */
static void compare(const struct pp_world *world, const struct pp_outside_light *light)
{
    int n = world->receiver_count;
    const struct pp_tracer_options options = {.error = 0.002, .seed = 1};
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, light, world->receivers, n, &options, NULL);
    struct pp_reading(*cached)[4] = calloc((size_t)n, sizeof *cached);
    double sum = 0.0, truth = 0.0, worst = 0.0;
    read_all(world, light, cached);
    for (int i = 0; i < n; i++) {
        double found = cached[i][PP_DF].value, df = traced[i][PP_DF].value;
        assert_near(found, df, fmax(0.03 * df, 5e-5));
        worst = fmax(worst, fabs(found - df) / df);
        sum += found;
        truth += df;
    }
    print_message("# %s: mean %+.2f %%, worst %.2f %%\n",
                  world->name ? world->name : "room", 100.0 * (sum / truth - 1.0),
                  100.0 * worst);
    assert_near(sum, truth, 0.01 * truth);
    free(traced);
    free(cached);
}

static void the_examples_are_as_light_as_by_paths(void **state)
{
    (void)state;
    const char *top = getenv("srcdir");
    char pattern[4096];
    glob_t files;
    snprintf(pattern, sizeof pattern, "%s/examples/*.xml", top ? top : ".");
    assert_int_equal(glob(pattern, 0, NULL, &files), 0);
    assert_true(files.gl_pathc >= 8);
    for (size_t k = 0; k < files.gl_pathc; k++) {
        struct pp_building *building = NULL;
        struct pp_mistakes mistakes;
        pp_mistakes_init(&mistakes, files.gl_pathv[k]);
        assert_int_equal(
            pp_building_read(&building, files.gl_pathv[k], &mistakes, NULL), PP_OK);
        for (int i = 0; i < pp_building_room_count(building); i++) {
            struct pp_world *world = NULL;
            struct pp_outside_light light;
            pp_world_create(&world, pp_building_room(building, i), &mistakes, NULL);
            assert_non_null(world);
            assert_int_equal(pp_room_light(&light, pp_building_room(building, i), NULL),
                             PP_OK);
            compare(world, &light);
            pp_world_destroy(world);
        }
        pp_mistakes_clear(&mistakes);
        pp_building_destroy(building);
    }
    globfree(&files);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_examples_are_as_light_as_by_paths),
    };
    return cmocka_run_group_tests_name("long_cache_examples", tests, NULL, NULL);
}
