/* photons_of.h - daylight factors of a room by photons, run to the end, for tests. */
#ifndef PP_TESTS_LIB_PHOTONS_OF_H
#define PP_TESTS_LIB_PHOTONS_OF_H

#include "simulate/research/photons/photons.h"
#include "tests/lib/traced.h"

/* Readings of `count` receivers in a scene, all four components, followed by the
 * average if options request it. The caller frees them. */
static inline struct pp_reading (*pp_test_photons_in(
    const struct pp_light_scene *scene, const struct pp_outside_light *light,
    const struct pp_receiver *receivers, int count,
    const struct pp_photons_options *options, struct pp_photons_work *work))[4]
{
    struct pp_environment *environment = pp_test_light_on(scene, light);
    struct pp_photons *photons = NULL;
    struct pp_error err = {0};
    if (pp_photons_create(&photons, scene, environment, receivers, count, options, &err)
        != PP_OK)
        fail_msg("no photons: %s", err.message);
    while (!pp_photons_done(photons))
        assert_int_equal(pp_photons_advance(photons, 1.0, &err), PP_OK);
    struct pp_reading(*readings)[4] = calloc((size_t)count + 1, sizeof *readings);
    for (int i = 0; i < count; i++)
        pp_photons_read(photons, i, readings[i]);
    if (options->average)
        pp_photons_read(photons, -1, readings[count]);
    if (work)
        *work = pp_photons_work(photons);
    pp_photons_destroy(photons);
    pp_environment_destroy(environment);
    return readings;
}

/* Readings in a world's diffuse scene. */
static inline struct pp_reading (*pp_test_photons(
    const struct pp_world *world, const struct pp_outside_light *light,
    const struct pp_receiver *receivers, int count,
    const struct pp_photons_options *options, struct pp_photons_work *work))[4]
{
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_reading(*readings)[4] =
        pp_test_photons_in(scene, light, receivers, count, options, work);
    pp_light_scene_destroy(scene);
    return readings;
}

#endif
