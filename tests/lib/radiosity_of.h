/* radiosity_of.h - daylight factors of a room by finite elements, run to the end, for
 * tests. */
#ifndef PP_TESTS_LIB_RADIOSITY_OF_H
#define PP_TESTS_LIB_RADIOSITY_OF_H

#include "simulate/research/radiosity/radiosity.h"
#include "tests/lib/traced.h"

/* Readings of `count` receivers, all four components, followed by the average. The
 * caller frees them. */
static inline struct pp_reading (*pp_test_elements(
    const struct pp_world *world, const struct pp_outside_light *light,
    const struct pp_receiver *receivers, int count,
    const struct pp_radiosity_options *options, struct pp_radiosity_size *size))[4]
{
    struct pp_radiosity *elements = NULL;
    struct pp_error err = {0};
    if (pp_radiosity_create(&elements, world, light, receivers, count, options, &err)
        != PP_OK)
        fail_msg("no elements: %s", err.message);
    while (!pp_radiosity_done(elements))
        assert_int_equal(pp_radiosity_advance(elements, &err), PP_OK);
    struct pp_reading(*readings)[4] = calloc((size_t)count + 1, sizeof *readings);
    for (int i = 0; i < count; i++)
        pp_radiosity_read(elements, i, readings[i]);
    pp_radiosity_read(elements, -1, readings[count]);
    if (size)
        *size = pp_radiosity_size(elements);
    pp_radiosity_destroy(elements);
    return readings;
}

#endif
