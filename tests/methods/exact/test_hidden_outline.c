/* test_hidden_outline.c - where on the sky things are that hide it, by plane geometry. */
#include "methods/exact/hidden_outline.h"

#include "tests/lib/room_of.h"

static void fill(struct pp_sky_mask *mask, const struct pp_world *world)
{
    const struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
    struct pp_hidden_cones cones;
    *mask = (struct pp_sky_mask){0};
    assert_int_equal(pp_hidden_cones_init(&cones, world, &view, NULL), PP_OK);
    assert_int_equal(pp_hidden_outline_add(mask, &cones, world->north_rad, NULL),
                     PP_OK);
    pp_hidden_cones_clear(&cones);
}

/* An endless edge square to the window is the lower, the farther off it is looked at:
 * tan a = tan 20 cos(bearing from the window's). North is 30 degrees off the plan's +y: the
 * south wall looks towards 210. */
static void an_endless_edge_sinks_with_the_cosine_of_the_bearing(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1' north='30'><plan width='4' depth='5' height='3'/>"
        "<window wall='south' left='1' sill='1' width='1' height='1'/>"
        "<skyline wall='south' angle='20'/></room>");
    struct pp_sky_mask mask;
    int edges = 0;
    fill(&mask, world);
    for (int i = 0; i < mask.count; i++)
        for (int k = 0; k < mask.pieces[i].count; k++) {
            const double *edge = mask.pieces[i].edges[k];
            double off = cos(edge[0] - 210.0 * PP_RAD);
            if (edge[2] > 0.5 * PP_PI - 1e-9) { /* behind the wall */
                assert_true(off < 1e-9);
                continue;
            }
            assert_near(edge[1], 0.0, 1e-12);
            assert_near(edge[2], atan(tan(20.0 * PP_RAD) * off), 1e-9);
            edges++;
        }
    assert_true(edges >= 4 * 179);
    pp_sky_mask_clear(&mask);
    pp_world_destroy(world);
}

/* A tower of 4 m at 10 m before the window's middle: it ends at +-atan(2/10), and its top's
 * front edge is 12 m above the window. */
static void a_tower_stands_between_the_bearings_of_its_corners(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='5' height='3'/>"
        "<window wall='south' left='1.5' sill='1' width='1' height='1'/>"
        "<block x='0' y='-14' width='4' depth='4' height='13.5'/></room>");
    struct pp_sky_mask mask;
    double low = INFINITY, high = -INFINITY, top = 0.0;
    fill(&mask, world);
    for (int i = 0; i < mask.count; i++)
        for (int k = 0; k < mask.pieces[i].count; k++) {
            const double *edge = mask.pieces[i].edges[k];
            if (edge[2] > 0.5 * PP_PI - 1e-9)
                continue;
            low = fmin(low, edge[0]);
            high = fmax(high, edge[0]);
            if (fabs(edge[0] - PP_PI) < 1e-9)
                top = fmax(top, edge[2]);
        }
    assert_near(low, PP_PI - atan(0.2), 2e-5);
    assert_near(high, PP_PI + atan(0.2), 2e-5);
    assert_near(top, atan(1.2), 1e-9);
    pp_sky_mask_clear(&mask);
    pp_world_destroy(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_endless_edge_sinks_with_the_cosine_of_the_bearing),
        cmocka_unit_test(a_tower_stands_between_the_bearings_of_its_corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
