/* test_hidden_outline.c - outlines of obstructions on the sky, by plane geometry. */
#include "methods/exact/hidden_outline.h"

#include <stdlib.h>

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

/* An infinitely long horizontal edge parallel to the window appears lower at larger
 * angles to the normal: tan a = tan 20 cos(bearing relative to the window's normal).
 * North is 30 degrees from the plan's +y, so the south wall faces 210 degrees. */
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

/* A tower 4 m wide, 10 m in front of the middle of the window, extends to +-atan(2/10).
 * The front edge of its top is 12 m above the window. */
static void a_tower_extends_between_the_bearings_of_its_corners(void **state)
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

/* Spans of hidden altitudes at a bearing in whole steps; returns their number. Spans
 * with the same lower end, where one piece ends and another begins, count once. */
static int spans_at(const struct pp_sky_mask *mask, double bearing, double spans[8][2])
{
    int count = 0;
    for (int i = 0; i < mask->count; i++)
        for (int k = 0; k < mask->pieces[i].count; k++) {
            const double *edge = mask->pieces[i].edges[k];
            int same = 0;
            if (fabs(edge[0] - bearing) > 1e-9)
                continue;
            while (same < count && fabs(spans[same][0] - edge[1]) > 1e-9)
                same++;
            assert_true(same < 8);
            spans[same][0] = edge[1];
            spans[same][1] = edge[2];
            count = same == count ? count + 1 : count;
        }
    return count;
}

#define SEEN_FROM                                                                      \
    "<room version='1'><plan width='4' depth='5' height='3'/>"                         \
    "<window wall='south' left='1.5' sill='1' width='1' height='1'/>"

/* A screen 12 m wide, 3 to 9 m above the floor and 10 m in front of the window, made of
 * 96 triangles: its lower and upper edges by plane geometry, and at most 8 pieces. */
static void a_screen_of_triangles_is_one_screen(void **state)
{
    (void)state;
    enum { CELLS_X = 8, CELLS_Z = 6 };
    char *text = malloc(1 << 16);
    assert_non_null(text);
    strcpy(text, SEEN_FROM);
    for (int i = 0; i < CELLS_X * CELLS_Z; i++)
        for (int half = 0; half < 2; half++) {
            double x0 = -4.0 + 1.5 * (i % CELLS_X), z0 = 3.0 + i / CELLS_X;
            double x[3] = {x0, x0 + 1.5, half ? x0 : x0 + 1.5};
            double z[3] = {z0, half ? z0 + 1.0 : z0, z0 + 1.0};
            strcat(text, "<surface>");
            for (int k = 0; k < 3; k++)
                sprintf(text + strlen(text), "<vertex x='%g' y='-10' z='%g'/>", x[k],
                        z[k]);
            strcat(text, "</surface>");
        }
    strcat(text, "</room>");
    struct pp_world *world = pp_test_world(text);
    struct pp_sky_mask mask;
    fill(&mask, world);
    assert_true(mask.count <= 8);
    for (int i = 0; i < 100; i++) {
        double bearing = (135.0 + i) * PP_RAD, spans[8][2];
        double distance = 10.0 / -cos(bearing);
        bool before = fabs(distance * sin(bearing)) < 6.0 - 0.05;
        if (!before && fabs(distance * sin(bearing)) < 6.0 + 0.05)
            continue;
        assert_int_equal(spans_at(&mask, bearing, spans), before ? 1 : 0);
        if (before) {
            assert_near(spans[0][0], atan2(1.5, distance), 1e-6);
            assert_near(spans[0][1], atan2(7.5, distance), 1e-6);
        }
    }
    pp_sky_mask_clear(&mask);
    pp_world_destroy(world);
    free(text);
}

/* A bridge above a house: sky is visible between them. Beside the bridge only the house
 * hides sky. */
static void sky_between_two_things_is_seen(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        SEEN_FROM "<block x='-3' y='-14' width='10' depth='4' height='3'/>"
                  "<block x='1' y='-14' width='2' depth='4' base='5' "
                  "height='2'/></room>");
    struct pp_sky_mask mask;
    double spans[8][2];
    fill(&mask, world);
    assert_int_equal(spans_at(&mask, PP_PI, spans), 2);
    assert_int_equal(spans_at(&mask, PP_PI + 10.0 * PP_RAD, spans), 1);
    assert_near(spans[0][0], 0.0, 1e-9);
    assert_near(spans[0][1], atan2(1.5 * cos(10.0 * PP_RAD), 10.0), 1e-9);
    pp_sky_mask_clear(&mask);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_endless_edge_sinks_with_the_cosine_of_the_bearing),
        cmocka_unit_test(a_tower_extends_between_the_bearings_of_its_corners),
        cmocka_unit_test(a_screen_of_triangles_is_one_screen),
        cmocka_unit_test(sky_between_two_things_is_seen),
    };
    add_tests(tests, NULL, NULL);
}
