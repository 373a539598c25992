/* test_rays.c - the first triangle along a ray. */
#include "simulate/scene/rays.h"

#include "tests/lib/near.h"

static const float triangles[][3][3] = {
    {{-3.1f, 2.0f, -2.7f}, {2.9f, 2.0f, -2.3f}, {0.1f, 2.0f, 3.3f}},
    {{-3.1f, 5.0f, -2.7f}, {0.1f, 5.0f, 3.3f}, {2.9f, 5.0f, -2.3f}},
};

static void the_nearer_of_two_is_met_from_either_side(void **state)
{
    (void)state;
    struct pp_rays *rays;
    assert_int_equal(pp_rays_create(&rays, triangles, 2, NULL, 0, NULL), PP_OK);
    float from[3] = {0.0f, -1.0f, 0.0f}, to[3] = {0.0f, 1.0f, 0.0f}, t;
    assert_int_equal(pp_rays_first(rays, from, to, &t), 0);
    assert_near(t, 3.0, 1e-6);
    float behind[3] = {0.0f, 7.5f, 0.0f}, back[3] = {0.0f, -1.0f, 0.0f};
    assert_int_equal(pp_rays_first(rays, behind, back, &t), 1);
    assert_near(t, 2.5, 1e-6);
    float between[3] = {0.0f, 3.0f, 0.0f};
    assert_int_equal(pp_rays_first(rays, between, to, &t), 1);
    assert_int_equal(pp_rays_first(rays, between, back, &t), 0);
    float up[3] = {0.0f, 0.0f, 1.0f};
    assert_int_equal(pp_rays_first(rays, between, up, &t), -1);
    pp_rays_destroy(rays);
}

/* From beyond each side of all triangles, a ray that leads away meets none, even if the
 * line behind it does; from the same place back, it meets one. */
static void rays_that_lead_away_meet_nothing(void **state)
{
    (void)state;
    struct pp_rays *rays;
    assert_int_equal(pp_rays_create(&rays, triangles, 2, NULL, 0, NULL), PP_OK);
    const float middle[3] = {0.0f, 2.0f, 0.2f};
    for (int axis = 0; axis < 3; axis++)
        for (int side = -1; side <= 1; side += 2) {
            const float skew[3] = {0.3f, 0.2f, 0.1f};
            float from[3], away[3], back[3], t;
            for (int k = 0; k < 3; k++) {
                away[k] = k == axis ? (float)side : (float)side * skew[k];
                from[k] = middle[k] + 10.0f * away[k];
                back[k] = -away[k];
            }
            assert_int_equal(pp_rays_first(rays, from, away, &t), -1);
            assert_true(pp_rays_first(rays, from, back, &t) >= 0);
        }
    pp_rays_destroy(rays);
}

static void no_triangles_stop_no_ray(void **state)
{
    (void)state;
    struct pp_rays *rays;
    assert_int_equal(pp_rays_create(&rays, NULL, 0, NULL, 0, NULL), PP_OK);
    float from[3] = {0.0f, 0.0f, 0.0f}, to[3] = {0.0f, 1.0f, 0.0f}, t;
    assert_int_equal(pp_rays_first(rays, from, to, &t), -1);
    pp_rays_destroy(rays);
    pp_rays_destroy(NULL);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_nearer_of_two_is_met_from_either_side),
        cmocka_unit_test(rays_that_lead_away_meet_nothing),
        cmocka_unit_test(no_triangles_stop_no_ray),
    };
    add_tests(tests, NULL, NULL);
}
