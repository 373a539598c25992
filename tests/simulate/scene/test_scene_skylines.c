/* test_scene_skylines.c - directions just hidden and just not hidden by a skyline. */
#include "simulate/scene/scene_skylines.h"

#include "tests/lib/near.h"

/* Without a distance a skyline hides directions that rise less than its slope, times
 * the cosine of the azimuth from its normal. */
static void a_far_face_hides_directions(void **state)
{
    (void)state;
    struct pp_far_skyline far = {.outward = {0.0, -1.0, 0.0}, .slope = 0.5};
    const struct pp_scene_skylines horizon = {.far = &far, .far_count = 1};
    for (double aside = 0.0; aside < 1.5; aside += 0.3) {
        double limit = 0.5 * cos(aside);
        struct pp_vec3 u = {sin(aside), -cos(aside), 0.99 * limit};
        assert_int_equal(pp_scene_skylines_far(&horizon, pp_vec_unit(u)), 0);
        u.z = 1.01 * limit;
        assert_int_equal(pp_scene_skylines_far(&horizon, pp_vec_unit(u)), -1);
    }
    assert_int_equal(pp_scene_skylines_far(&horizon, pp_vec(0.0, 0.995, 0.0998)), -1);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_far_face_hides_directions),
    };
    add_tests(tests, NULL, NULL);
}
