/* test_brs_rooflight.c - simplified daylight tables of rooflights. */
#include "methods/brs/brs_rooflight.h"
#include "methods/brs/brs_table.h"
#include "methods/evaluate.h"
#include "methods/method.h"

#include <stdio.h>

#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

/* Sky component of a rectangle in the plane of the glass, by a sum over the centres of
 * a grid. The point is at distance 1 from the plane. s is measured from the line where
 * the plane meets the level of the point, or, for horizontal glass, from the point's
 * vertical. */
static double by_points(int slope_deg, double s_end, double w_end, int steps)
{
    struct pp_sky sky = pp_sky_overcast();
    struct pp_glass glass = pp_glass_clear_single();
    double beta = slope_deg * PP_RAD, sum = 0.0;
    double begins = slope_deg ? -1.0 / tan(beta) : 0.0;
    for (int i = 0; i < steps; i++)
        for (int k = 0; k < steps; k++) {
            double b = begins + s_end * (i + 0.5) / steps;
            struct pp_vec3 v =
                pp_vec(sin(beta) - b * cos(beta), w_end * (k + 0.5) / steps,
                       cos(beta) + b * sin(beta));
            double r = pp_vec_length(v);
            sum += pp_sky_luminance(&sky, pp_vec_scale(v, 1.0 / r)) * v.z / r
                   * pp_glass_transmittance(&glass, 1.0 / r) / (r * r * r);
        }
    return sum * s_end * w_end / steps / steps;
}

/* Tolerance: half a unit of the last printed digit, and the error of the grid. */
static void cells_are_the_sum_over_the_glass(void **state)
{
    (void)state;
    static const double cells[][2] = {{0.1, 0.1},  {1.0, 0.7}, {2.0, 2.0}, {1.6, 6.0},
                                      {10.0, 0.4}, {4.0, 3.0}, {0.5, 1.4}};
    for (int slope = 0; slope <= 60; slope += 30)
        for (size_t i = 0; i < sizeof cells / sizeof *cells; i++)
            assert_near(100.0 * pp_brs_rooflight_read(slope, cells[i][0], cells[i][1]),
                        100.0 * by_points(slope, cells[i][0], cells[i][1], 250),
                        0.005 + 0.001);
}

/* At the corner at infinity the table gives half of the light that glass of this slope
 * receives. For horizontal glass, whose table begins in the middle, it gives a
 * quarter. */
static void corner_is_all_the_light_through_the_glass(void **state)
{
    (void)state;
    struct pp_sky sky = pp_sky_overcast();
    struct pp_glass glass = pp_glass_clear_single();
    for (int slope = 0; slope <= 60; slope += 30) {
        enum { N = 400 };
        double sum = 0.0, beta = slope * PP_RAD;
        struct pp_vec3 normal = pp_vec(sin(beta), 0.0, cos(beta));
        for (int i = 0; i < N; i++)
            for (int k = 0; k < N; k++) {
                double z = (i + 0.5) / N, phi = 2.0 * PP_PI * (k + 0.5) / N;
                double c = sqrt(1.0 - z * z);
                struct pp_vec3 u = pp_vec(c * cos(phi), c * sin(phi), z);
                double cosine = pp_vec_dot(u, normal);
                if (cosine > 0.0)
                    sum += pp_sky_luminance(&sky, u) * z
                           * pp_glass_transmittance(&glass, cosine) * 2.0 * PP_PI / N
                           / N;
            }
        assert_near(pp_brs_rooflight_read(slope, INFINITY, INFINITY),
                    sum / (slope ? 2.0 : 4.0), 1e-4);
    }
}

/* Horizontal glass has no upper edge, so length and width may be exchanged. */
static void level_table_is_symmetric(void **state)
{
    (void)state;
    for (double l = 0.05; l < 12.0; l *= 1.7)
        for (double w = 0.07; w < 5.0; w *= 1.9)
            assert_near(pp_brs_rooflight_read(0, l, w), pp_brs_rooflight_read(0, w, l),
                        4e-4); /* rows and columns have different spacings */
}

/* Sky component of the first opening at a point 0.85 m above the floor. */
static double at(const struct pp_world *world, const struct pp_outside_light *light,
                 const struct pp_method *method, double x, double y)
{
    struct pp_part part = {0};
    const struct pp_receiver receiver = {{x, y, 0.85}, {0, 0, 1}, 0, 0.0};
    const struct pp_opening *opening = &world->openings[0];
    void *tools = NULL;
    if (method->refuses) {
        assert_null(method->refuses_room(world, light, &receiver));
        assert_null(method->refuses(world, light, opening, &receiver));
    }
    if (method->prepare)
        assert_int_equal(method->prepare(&tools, world, light, NULL), PP_OK);
    assert_int_equal(
        method->evaluate(world, light, opening, &receiver, tools, &part, NULL), PP_OK);
    if (method->destroy_tools)
        method->destroy_tools(tools);
    return part.sky;
}

static void corners_add_up_above_and_aside_of_the_point(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='7' depth='6' height='2.85'/>"
                "<rooflight x='2.1' y='1.7' width='1.6' depth='1.1'/></room>");
    double d = 2.0;
    const struct {
        double x, y;
    } points[] = {{2.6, 2.1}, {4.9, 2.3}, {2.4, 4.4}, {5.3, 4.9}, {1.2, 0.6}};
    for (int i = 0; i < 5; i++) {
        double x = points[i].x, y = points[i].y, sum = 0.0;
        const double jambs[2] = {(2.1 - x) / d, (3.7 - x) / d};
        const double edges[2] = {(1.7 - y) / d, (2.8 - y) / d};
        for (int k = 0; k < 4; k++) {
            double w = jambs[k & 1], l = edges[k >> 1];
            /* Above the point, the sum of four corners; beside the point, two corners
             * are subtracted from the two others. */
            sum += ((k & 1) == (k >> 1) ? 1 : -1) * copysign(1, w) * copysign(1, l)
                   * pp_brs_rooflight_read(0, fabs(l), fabs(w));
        }
        assert_near(at(world, &light, &pp_method_brs_rooflight, x, y), sum, 1e-12);
        /* values between the lines of the table are interpolated */
        assert_relative(sum, at(world, &light, &pp_method_exact, x, y), 0.02);
    }
    pp_world_destroy(world);
}

/* Windows in a mono-pitch roof of 30 or 60 degrees, at random points: readings are
 * within 3 % of `exact`, or within 0.15 % of the open sky where there is little
 * light. */
static void roof_windows_are_near_to_exact(void **state)
{
    (void)state;
    struct dice dice = {17};
    for (int i = 0; i < 40; i++) {
        char xml[2500];
        double rise = i % 2 ? tan(30.0 * PP_RAD) : tan(60.0 * PP_RAD);
        double y = between(&dice, 0.3, 1.2), up = between(&dice, 0.4, 1.1);
        double x = between(&dice, 0.3, 2.5), z = 2.2 + rise * y;
        snprintf(xml, sizeof xml,
                 "<room version='1'><envelope><face role='floor' name='f'>"
                 "<vertex x='0' y='0' z='0'/><vertex x='4' y='0' z='0'/>"
                 "<vertex x='4' y='3' z='0'/><vertex x='0' y='3' z='0'/></face>"
                 "<face role='ceiling' name='r'><vertex x='0' y='0' z='2.2'/>"
                 "<vertex x='0' y='3' z='%.9f'/><vertex x='4' y='3' z='%.9f'/>"
                 "<vertex x='4' y='0' z='2.2'/></face>"
                 "<face role='wall' name='s'><vertex x='0' y='0' z='0'/>"
                 "<vertex x='0' y='0' z='2.2'/><vertex x='4' y='0' z='2.2'/>"
                 "<vertex x='4' y='0' z='0'/></face>"
                 "<face role='wall' name='n'><vertex x='0' y='3' z='0'/>"
                 "<vertex x='4' y='3' z='0'/><vertex x='4' y='3' z='%.9f'/>"
                 "<vertex x='0' y='3' z='%.9f'/></face>"
                 "<face role='wall' name='w'><vertex x='0' y='0' z='0'/>"
                 "<vertex x='0' y='3' z='0'/><vertex x='0' y='3' z='%.9f'/>"
                 "<vertex x='0' y='0' z='2.2'/></face>"
                 "<face role='wall' name='e'><vertex x='4' y='0' z='0'/>"
                 "<vertex x='4' y='0' z='2.2'/><vertex x='4' y='3' z='%.9f'/>"
                 "<vertex x='4' y='3' z='0'/></face></envelope><opening>"
                 "<vertex x='%.9f' y='%.9f' z='%.9f'/>"
                 "<vertex x='%.9f' y='%.9f' z='%.9f'/>"
                 "<vertex x='%.9f' y='%.9f' z='%.9f'/>"
                 "<vertex x='%.9f' y='%.9f' z='%.9f'/></opening></room>",
                 2.2 + 3 * rise, 2.2 + 3 * rise, 2.2 + 3 * rise, 2.2 + 3 * rise,
                 2.2 + 3 * rise, 2.2 + 3 * rise, x, y, z, x, y + up, z + up * rise,
                 x + 1.2, y + up, z + up * rise, x + 1.2, y, z);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        double px = between(&dice, 0.2, 3.8), py = between(&dice, 0.2, 2.8);
        double exact = at(world, &light, &pp_method_exact, px, py);
        assert_near(at(world, &light, &pp_method_brs_rooflight, px, py), exact,
                    0.03 * exact + 0.0015);
        pp_world_destroy(world);
    }
}

/* Windows are read from the printed table of windows. */
static void windows_are_read_off_the_vertical_table(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='7' depth='6' height='2.85'/>"
                "<window wall='south' left='2.1' sill='1.1' width='1.6' "
                "height='1.1'/></room>");
    assert_near(at(world, &light, &pp_method_brs_rooflight, 2.6, 2.1),
                at(world, &light, &pp_method_brs_table, 2.6, 2.1), 0.0);
    pp_world_destroy(world);
}

/* A room that has only windows uses the table of windows. Its figures are those of that
 * table, calculated once; the last point does not face up, which neither table covers. */
static void a_room_of_windows_has_the_figures_of_their_table(void **state)
{
    (void)state;
    static const char roof[] = "<rooflight x='1' y='3' width='1' depth='1'/>";
    const struct pp_receiver points[] = {
        {.position = {1.3, 0.7, 0.85}, .normal = {0.0, 0.0, 1.0}},
        {.position = {2.9, 4.1, 0.85}, .normal = {0.0, 0.0, 1.0}},
        {.position = {2.2, 2.3, 1.2}, .normal = {0.0, -1.0, 0.0}}};
    for (int i = 0; i < 4; i++) {
        bool with_roof = i % 2;
        int count = i < 2 ? 2 : 3;
        char xml[500];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan width='4' depth='6' height='2.7'/>"
                 "<window wall='south' left='1' sill='0.9' width='2' height='1.3'/>%s"
                 "</room>",
                 with_roof ? roof : "");
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        assert_ptr_equal(pp_method_brs_rooflight.same_as(world),
                         with_roof ? NULL : &pp_method_brs_table);
        struct pp_report both = {.world = world,
                                 .light = light,
                                 .receivers = points,
                                 .receiver_count = count},
                         alone = both;
        assert_int_equal(
            pp_methods_evaluate(&both, "brs-table,brs-table-rooflight", NULL), PP_OK);
        assert_int_equal(pp_methods_evaluate(&alone, "brs-table-rooflight", NULL),
                         PP_OK);
        for (int k = PP_SC; k <= PP_ERC; k++) {
            const struct pp_column *a = pp_report_find(&both, k, "brs-table-rooflight");
            const struct pp_column *b =
                pp_report_find(&alone, k, "brs-table-rooflight");
            assert_near(a->average.value, b->average.value, 0.0);
            for (int point = 0; point < count; point++) {
                assert_int_equal(a->points[point].why == NULL, point < 2);
                if (point < 2)
                    assert_near(a->points[point].value, b->points[point].value, 0.0);
                else
                    assert_string_equal(a->points[point].why, b->points[point].why);
            }
        }
        assert_true(pp_report_find(&both, PP_SC, "brs-table-rooflight")->average.value
                    > 0.0);
        pp_report_clear(&both);
        pp_report_clear(&alone);
        pp_world_destroy(world);
    }
}

static void other_slopes_and_diffusing_panes_are_refused(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='7' depth='6' height='2.85'/>"
                "<rooflight x='2.1' y='1.7' width='1.6' depth='1.1' diffusing='yes' "
                "transmittance='0.5'/></room>");
    assert_non_null(
        pp_method_brs_rooflight.refuses(world, &light, world->openings, NULL));
    world->openings[0].glass = pp_glass_clear_single();
    assert_null(pp_method_brs_rooflight.refuses(world, &light, world->openings, NULL));
    world->openings[0].inner.normal = pp_vec_unit(pp_vec(0.0, 0.3, -1.0));
    world->openings[0].slope_rad = atan(0.3);
    assert_non_null(
        pp_method_brs_rooflight.refuses(world, &light, world->openings, NULL));
    assert_true(isnan(pp_brs_rooflight_read(45, 1.0, 1.0)));
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_are_the_sum_over_the_glass),
        cmocka_unit_test(corner_is_all_the_light_through_the_glass),
        cmocka_unit_test(level_table_is_symmetric),
        cmocka_unit_test(corners_add_up_above_and_aside_of_the_point),
        cmocka_unit_test(roof_windows_are_near_to_exact),
        cmocka_unit_test(windows_are_read_off_the_vertical_table),
        cmocka_unit_test(a_room_of_windows_has_the_figures_of_their_table),
        cmocka_unit_test(other_slopes_and_diffusing_panes_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
