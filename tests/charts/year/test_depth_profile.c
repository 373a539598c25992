/* test_depth_profile.c - points at the same distance from the window wall form one
 * step. */
#include "charts/year/depth_profile.h"

#include <math.h>

#include "tests/lib/room_of.h"

enum { POINTS = 5 };

/* Two points at 1 m and two at 3 m from the south wall, which has more glass than the
 * east wall; their autonomies are 0.9 and 0.7, 0.4 and 0.2. A point behind the
 * wall has no depth. */
static void a_step_is_the_mean_over_the_points_at_its_distance(void **state)
{
    (void)state;
    static const double at[POINTS][2] = {
        {1.0, 3.0}, {1.0, 1.0}, {3.0, 1.0}, {3.0, 3.0}, {1.0, -1.0}};
    static const double autonomy[POINTS] = {0.2, 0.9, 0.7, 0.4, 1.0};
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='5' height='3'/>"
        "<window wall='south' left='1' sill='1' width='2' height='1'/>"
        "<window wall='east' left='1' sill='1' width='1' height='1'/></room>");
    struct pp_receiver receivers[POINTS] = {{.line = 0}};
    struct pp_annual_figures points[POINTS] = {{.udi_good = {0.0, 0.0}}};
    for (int i = 0; i < POINTS; i++) {
        receivers[i].position = pp_vec(at[i][0], at[i][1], 0.85);
        points[i].autonomy_300.value = autonomy[i];
        points[i].blinds_autonomy.value = NAN;
        points[i].udi_good.value = 0.5;
    }
    const struct pp_annual_sheet sheet = {.world = world,
                                          .receivers = receivers,
                                          .receiver_count = POINTS,
                                          .points = points};
    struct pp_depth_profile profile;
    assert_int_equal(pp_depth_profile_find(&profile, &sheet, NULL), PP_OK);
    assert_int_equal(profile.count, 2);
    assert_near(profile.steps[0].depth_m, 1.0, 1e-9);
    assert_near(profile.steps[0].autonomy, 0.8, 1e-12);
    assert_near(profile.steps[1].depth_m, 3.0, 1e-9);
    assert_near(profile.steps[1].autonomy, 0.3, 1e-12);
    assert_near(profile.steps[1].udi, 0.5, 1e-12);
    assert_true(isnan(profile.steps[1].blinds_autonomy));
    pp_depth_profile_clear(&profile);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_is_the_mean_over_the_points_at_its_distance),
    };
    add_tests(tests, NULL, NULL);
}
