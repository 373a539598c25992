/* test_scene_skylines.c - rays that just meet a skyline, and rays that just don't. */
#include "simulate/scene/scene_skylines.h"

#include "tests/lib/near.h"

/* A face 8 m to the south, from 0.5 m below the origin to 3.7 m above it. */
static struct pp_near_skyline face = {
    .outward = {0.0, -1.0, 0.0}, .offset_m = 8.0, .head_m = 3.7, .reflectance = 0.2};
static const struct pp_scene_skylines street = {
    .ground_level_m = -0.5, .near = &face, .near_count = 1};

static double distance(struct pp_vec3 from, struct pp_vec3 to, int *side)
{
    int met = -1;
    double t = pp_scene_skylines_near(&street, from, pp_vec_unit(pp_vec_sub(to, from)),
                                      &met, side);
    assert_int_equal(met, isfinite(t) ? 0 : -1);
    return t;
}

/* 6.7 m before the face: to places a centimetre under its head and over it, a centimetre
 * over the ground and under it; wherever along its endless length. */
static void a_face_is_met_between_the_ground_and_its_head(void **state)
{
    (void)state;
    const struct pp_vec3 from = {0.4, -1.3, 1.1};
    for (double x = -300.0; x <= 300.0; x += 150.0) {
        int side = -1;
        struct pp_vec3 to = {x, -8.0, 3.69};
        assert_relative(distance(from, to, &side), pp_vec_length(pp_vec_sub(to, from)),
                        1e-9);
        assert_int_equal(side, 0);
        to.z = -0.49;
        assert_relative(distance(from, to, &side), pp_vec_length(pp_vec_sub(to, from)),
                        1e-9);
        to.z = 3.71;
        assert_true(isinf(distance(from, to, &side)));
        to.z = -0.51;
        assert_true(isinf(distance(from, to, &side)));
    }
}

/* From behind it is met on its other side; who looks away meets nothing. */
static void a_face_has_two_sides(void **state)
{
    (void)state;
    const struct pp_vec3 behind = {0.0, -11.0, 1.0};
    int side = -1;
    assert_relative(distance(behind, pp_vec(0.0, -8.0, 1.0), &side), 3.0, 1e-12);
    assert_int_equal(side, 1);
    assert_true(isinf(distance(behind, pp_vec(0.0, -12.0, 1.0), &side)));
}

/* Without a distance it hides what rises less than its angle, times the cosine of how far
 * aside one looks. */
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
        cmocka_unit_test(a_face_is_met_between_the_ground_and_its_head),
        cmocka_unit_test(a_face_has_two_sides),
        cmocka_unit_test(a_far_face_hides_directions),
    };
    add_tests(tests, NULL, NULL);
}
