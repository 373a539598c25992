/* elements_of.h - daylight factors of a room by finite elements, run to their end, for
 * tests. */
#ifndef PP_TESTS_LIB_ELEMENTS_OF_H
#define PP_TESTS_LIB_ELEMENTS_OF_H

#include "simulate/elements/elements.h"
#include "tests/lib/traced.h"

/* The readings of `count` receivers, all four components, and behind them those of the
 * average. The caller frees them. */
static inline struct pp_reading (*pp_test_elements(
    const struct pp_world *world, const struct pp_outside_light *light,
    const struct pp_receiver *receivers, int count,
    const struct pp_elements_options *options, struct pp_elements_size *size))[4]
{
    struct pp_elements *elements = NULL;
    struct pp_error err = {0};
    if (pp_elements_create(&elements, world, light, receivers, count, options, &err)
        != PP_OK)
        fail_msg("no elements: %s", err.message);
    while (!pp_elements_done(elements))
        assert_int_equal(pp_elements_advance(elements, &err), PP_OK);
    struct pp_reading(*readings)[4] = calloc((size_t)count + 1, sizeof *readings);
    for (int i = 0; i < count; i++)
        pp_elements_read(elements, i, readings[i]);
    pp_elements_read(elements, -1, readings[count]);
    if (size)
        *size = pp_elements_size(elements);
    pp_elements_destroy(elements);
    return readings;
}

#endif
