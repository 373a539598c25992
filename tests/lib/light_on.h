/* light_on.h - outdoor light prepared for a scene, for tests. */
#ifndef PP_TESTS_LIB_LIGHT_ON_H
#define PP_TESTS_LIB_LIGHT_ON_H

#include "simulate/scene/environment.h"
#include "tests/lib/near.h"

static inline struct pp_environment *pp_test_light_on(
    const struct pp_light_scene *scene, const struct pp_outside_light *light)
{
    struct pp_environment *environment = NULL;
    assert_int_equal(pp_light_scene_under(&environment, scene, light, NULL), PP_OK);
    return environment;
}

#endif
