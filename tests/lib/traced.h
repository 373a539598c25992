/* traced.h - daylight factors of a room by the path tracer, run to the end, for
 * tests. */
#ifndef PP_TESTS_LIB_TRACED_H
#define PP_TESTS_LIB_TRACED_H

#include <stdlib.h>

#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"
#include "tests/lib/light_on.h"
#include "tests/lib/near.h"

static inline struct pp_receiver pp_test_receiver(double x, double y, double z,
                                                  double nx, double ny, double nz)
{
    return (struct pp_receiver){{x, y, z}, pp_vec_unit(pp_vec(nx, ny, nz)), 0, 0.0};
}

static inline struct pp_light_scene *pp_test_matt_scene(const struct pp_world *world)
{
    struct pp_light_scene *scene = NULL;
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    return scene;
}

/* Readings of `count` receivers, all four components, followed by the average if
 * options request it. The caller frees them. */
static inline struct pp_reading (*pp_test_trace(
    const struct pp_world *world, const struct pp_outside_light *light,
    const struct pp_receiver *receivers, int count,
    const struct pp_tracer_options *options, struct pp_tracer_work *work))[4]
{
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, light);
    struct pp_tracer *tracer = NULL;
    struct pp_error err = {0};
    if (pp_tracer_create(&tracer, scene, environment, receivers, count, options, &err)
        != PP_OK)
        fail_msg("no tracer: %s", err.message);
    while (!pp_tracer_done(tracer))
        assert_int_equal(pp_tracer_advance(tracer, 1.0, &err), PP_OK);
    struct pp_reading(*readings)[4] = calloc((size_t)count + 1, sizeof *readings);
    for (int i = 0; i < count; i++)
        pp_tracer_read(tracer, i, readings[i]);
    if (options->average)
        pp_tracer_read(tracer, -1, readings[count]);
    if (work)
        *work = pp_tracer_work(tracer);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return readings;
}

/* Options for a fixed number of paths in each of the 32 randomisations, as in most
 * tests. */
static inline struct pp_tracer_options pp_test_paths(long samples)
{
    return (struct pp_tracer_options){.samples = samples, .seed = 20, .threads = 1};
}

/* Asserts that a traced value is within four of its standard errors of the expected one
 * (exceeded once in 3000 cases by chance; seeds are fixed), and that its standard error
 * is at most `error`. */
#define assert_traced(reading, expected, error)                                        \
    do {                                                                               \
        struct pp_reading reading_ = (reading);                                        \
        assert_near(reading_.value, expected, 4.0 * reading_.std_error + 1e-12);       \
        assert_near(reading_.std_error, 0.0, error);                                   \
    } while (0)

#endif
