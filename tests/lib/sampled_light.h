/* sampled_light.h - irradiance and radiance as means over independent sequences of
 * paths, with standard errors, for tests. */
#ifndef PP_TESTS_LIB_SAMPLED_LIGHT_H
#define PP_TESTS_LIB_SAMPLED_LIGHT_H

#include <stdlib.h>

#include "simulate/scene/environment.h"
#include "simulate/transport/radiance.h"
#include "tests/lib/light_on.h"
#include "tests/lib/near.h"

enum { PP_TEST_SEEDS = 32 };

/* A mean over independent sequences, and its standard error. */
struct pp_test_mean {
    struct pp_rgb value;
    double error; /* standard error of the luminance */
    long rays;    /* total of all sequences */
};

static inline struct pp_test_mean pp_test_mean_of(const struct pp_rgb *values,
                                                  int count)
{
    struct pp_test_mean mean = {.value = pp_rgb_grey(0.0)};
    for (int i = 0; i < count; i++)
        mean.value = pp_rgb_along(mean.value, 1.0 / count, values[i]);
    double off = 0.0;
    for (int i = 0; i < count; i++) {
        double d = pp_rgb_luminance(pp_rgb_sub(values[i], mean.value));
        off += d * d;
    }
    mean.error = sqrt(off / (count - 1) / count);
    return mean;
}

static inline struct pp_rgb pp_test_all_of(struct pp_irradiance e)
{
    return pp_rgb_add(pp_rgb_add(e.sources, e.sky), pp_rgb_add(e.outside, e.rest));
}

/* Irradiance from `paths` paths in each sequence; environment: light of a world. */
static inline struct pp_test_mean pp_test_irradiance(
    const struct pp_light_scene *scene, const struct pp_environment *environment,
    const struct pp_opening_store *store, struct pp_radiance_options options,
    struct pp_vec3 point, struct pp_vec3 normal, uint32_t paths)
{
    struct pp_rgb values[PP_TEST_SEEDS];
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    assert_non_null(sobol);
    pp_sobol_init(sobol);
    enum pp_space space = pp_light_scene_space(scene, point);
    long rays = 0;
    for (int seed = 0; seed < PP_TEST_SEEDS; seed++) {
        struct pp_radiance_state path_state = {.scene = scene,
                                               .environment = environment,
                                               .options = options,
                                               .store = store};
        pp_sobol_sequence_init(&path_state.sequence, sobol, (uint64_t)seed + 77);
        values[seed] = pp_rgb_grey(0.0);
        for (uint32_t i = 0; i < paths; i++) {
            path_state.index = i;
            struct pp_rgb e = pp_test_all_of(
                pp_radiance_irradiance(&path_state, point, normal, space));
            values[seed] = pp_rgb_along(values[seed], 1.0 / paths, e);
        }
        rays += path_state.rays;
    }
    free(sobol);
    struct pp_test_mean mean = pp_test_mean_of(values, PP_TEST_SEEDS);
    mean.rays = rays;
    return mean;
}

/* Radiance along a ray, from `paths` paths in each sequence. */
static inline struct pp_test_mean pp_test_radiance(
    const struct pp_light_scene *scene, const struct pp_environment *environment,
    struct pp_radiance_options options, struct pp_vec3 from, struct pp_vec3 to,
    uint32_t paths)
{
    struct pp_rgb values[PP_TEST_SEEDS];
    struct pp_sobol *sobol = malloc(sizeof *sobol);
    assert_non_null(sobol);
    pp_sobol_init(sobol);
    struct pp_light_ray ray = {.from = from,
                               .to = pp_vec_unit(to),
                               .space = pp_light_scene_space(scene, from)};
    for (int seed = 0; seed < PP_TEST_SEEDS; seed++) {
        struct pp_radiance_state path_state = {
            .scene = scene, .environment = environment, .options = options};
        pp_sobol_sequence_init(&path_state.sequence, sobol, (uint64_t)seed + 77);
        values[seed] = pp_rgb_grey(0.0);
        for (uint32_t i = 0; i < paths; i++) {
            path_state.index = i;
            values[seed] = pp_rgb_along(values[seed], 1.0 / paths,
                                        pp_radiance_along(&path_state, &ray, NULL));
        }
    }
    free(sobol);
    return pp_test_mean_of(values, PP_TEST_SEEDS);
}

/* Asserts that the mean is within four standard errors of the expected value (exceeded
 * once in 3000 cases by chance; seeds are fixed), and that its standard error is at
 * most `most`. */
#define assert_lit(mean, expected, most)                                               \
    do {                                                                               \
        struct pp_test_mean mean_ = (mean);                                            \
        assert_near(pp_rgb_luminance(mean_.value), expected,                           \
                    4.0 * mean_.error + 1e-12);                                        \
        assert_near(mean_.error, 0.0, most);                                           \
    } while (0)

#endif
