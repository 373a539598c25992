/* test_lit_line.c - the no-sky line by similar triangles, the sky factor by its closed
 * form, and the equivalent first zone loss. */
#include "studies/lit_line.h"

#include "tests/lib/room_of.h"

/* An infinitely long house at 30 degrees, 10 m from the middle of a window as wide as
 * the room. From the no-sky line the head of the window and the top of the house are in
 * line, in the section and, since all edges are parallel, everywhere along the room.
 * The head is 1.65 m above the plane, the top 1.7 + 10 tan 30 - 0.85 m: d / 1.65 = (d +
 * 10) / 6.6235. */
static void the_no_sky_line_lies_where_head_and_house_are_in_line(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='6' height='3'/>"
        "<window wall='south' left='0' sill='0.9' width='4' height='1.6'/>"
        "<skyline wall='south' angle='30' distance='10'/></room>");
    double top = 1.7 + 10.0 * tan(30.0 * PP_RAD) - 0.85, head = 2.5 - 0.85;
    double depth = 10.0 * head / (top - head);
    struct pp_lit_area area;
    assert_int_equal(pp_lit_line_find(&area, world, PP_LIT_NO_SKY, NULL), PP_OK);
    assert_near(area.plane_m2, 24.0, 1e-9);
    assert_near(area.lit_m2, 4.0 * depth, 0.01);
    assert_true(fabs(area.lit_m2 - 4.0 * depth) < area.error_m2 + 0.01);
    assert_int_equal(area.line.count, 1);
    for (int i = 0; i < area.line.list[0].count; i++)
        assert_near(area.line.list[0].xy[i][1], depth, 2e-3);
    pp_lit_area_clear(&area);
    pp_world_destroy(world);
}

/* Sky factor of a vertical rectangle that stands on the plane, from a point at distance
 * d in front of one of its lower corners [WW23]: from the angles subtended at its lower
 * and upper edges. */
static double corner_factor(double width, double height, double d)
{
    double slant = hypot(d, height);
    return (atan(width / d) - d / slant * atan(width / slant)) / (2.0 * PP_PI);
}

/* For a point at x, and a window from `left` to `right` and from the plane up to
 * `head`. */
static double sky_factor(double x, double d, double left, double right, double head)
{
    return (right > x ? 1.0 : -1.0) * corner_factor(fabs(right - x), head, d)
           - (left > x ? 1.0 : -1.0) * corner_factor(fabs(left - x), head, d);
}

/* The room's overcast sky, glass, frame and working plane of 0.7 m do not matter: the
 * factor is that of the uniform sky through the unglazed opening, at 0.85 m. */
static void along_the_legal_line_the_sky_factor_is_a_fifth_of_a_per_cent(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4' depth='14' height='3'/>"
        "<window wall='south' left='1.2' sill='0.85' width='1.1' height='0.9' "
        "glazing='clear-double' frame-factor='0.7'/>"
        "<working-plane height='0.7'/></room>");
    struct pp_lit_area area;
    int seen = 0;
    assert_int_equal(pp_lit_line_find(&area, world, PP_LIT_SKY_FACTOR, NULL), PP_OK);
    assert_near(area.plane_m, 0.85, 1e-12);
    for (int i = 0; i < area.line.count; i++)
        for (int k = 0; k < area.line.list[i].count; k++) {
            const double *at = area.line.list[i].xy[k];
            if (at[1] < 0.5 || at[0] < 0.01 || at[0] > 3.99)
                continue;
            assert_near(sky_factor(at[0], at[1], 1.2, 2.3, 0.9), 0.002, 1e-5);
            seen++;
        }
    assert_true(seen > 20);
    pp_lit_area_clear(&area);
    pp_world_destroy(world);
}

/* A room of 20 m2, lit over 14 m2 and then over 4 m2, loses 1 m2 of its front quarter,
 * all 5 m2 of the first and 4 m2 of the second: 3/2 + 5 + 4/2 m2 of first zone. */
static void a_loss_is_counted_by_quarters_of_the_room(void **state)
{
    (void)state;
    struct pp_lit_loss loss = pp_lit_area_loss(20.0, 14.0, 4.0);
    assert_near(loss.zones_m2[PP_ZONE_FRONT], 1.0, 1e-12);
    assert_near(loss.zones_m2[PP_ZONE_FIRST], 5.0, 1e-12);
    assert_near(loss.zones_m2[PP_ZONE_SECOND], 4.0, 1e-12);
    assert_near(loss.zones_m2[PP_ZONE_MAKEWEIGHT], 0.0, 1e-12);
    assert_near(loss.equivalent_m2, 8.5, 1e-12);
    loss = pp_lit_area_loss(20.0, 20.0, 16.0);
    assert_near(loss.zones_m2[PP_ZONE_MAKEWEIGHT], 4.0, 1e-12);
    assert_near(loss.equivalent_m2, 1.0, 1e-12);
    loss = pp_lit_area_loss(20.0, 4.0, 14.0);
    assert_near(loss.equivalent_m2, 0.0, 0.0);
}

/* A room 0.6 m high has no plane at 0.85 m, and without windows sees no sky. */
static void no_plane_and_no_window_are_no_lit_area(void **state)
{
    (void)state;
    struct pp_world *low =
        pp_test_world("<room version='1'><plan width='4' depth='6' height='0.6'/>"
                      "<working-plane height='0.3'/></room>");
    struct pp_lit_area area;
    assert_int_equal(pp_lit_line_find(&area, low, PP_LIT_SKY_FACTOR, NULL), PP_OK);
    assert_near(area.plane_m2, 0.0, 0.0);
    assert_near(area.lit_m2, 0.0, 0.0);
    pp_lit_area_clear(&area);
    assert_int_equal(pp_lit_line_find(&area, low, PP_LIT_NO_SKY, NULL), PP_OK);
    assert_near(area.plane_m2, 24.0, 1e-9);
    assert_near(area.lit_m2, 0.0, 1e-9);
    pp_lit_area_clear(&area);
    pp_world_destroy(low);
}

/* A room of 20 m2, lit over 14 m2 and then over 4 m2, has lost 1 m2 of its front zone,
 * its first zone, and the lit 4 m2 of its second zone. A room without a previous state
 * contributes only its plane and its present lit area. */
static void a_sum_of_rooms_includes_the_known_areas_of_each(void **state)
{
    (void)state;
    struct pp_lit_change sum = pp_lit_area_change(NAN, NAN, NAN);
    struct pp_lit_change one = pp_lit_area_change(20.0, 14.0, 4.0),
                         other = pp_lit_area_change(13.0, NAN, 7.5);
    assert_true(isnan(other.lost_m2) && isnan(other.loss.zones_m2[PP_ZONE_FIRST])
                && isnan(other.loss.equivalent_m2));
    pp_lit_area_add(&sum, &other);
    assert_near(sum.lit_m2, 7.5, 1e-12);
    assert_true(isnan(sum.before_m2) && isnan(sum.lost_m2)
                && isnan(sum.loss.equivalent_m2));
    pp_lit_area_add(&sum, &one);
    assert_near(sum.plane_m2, 33.0, 1e-12);
    assert_near(sum.lit_m2, 11.5, 1e-12);
    assert_near(sum.before_m2, 14.0, 1e-12);
    assert_near(sum.lost_m2, 10.0, 1e-12);
    assert_near(sum.loss.zones_m2[PP_ZONE_SECOND], 4.0, 1e-12);
    assert_near(sum.loss.zones_m2[PP_ZONE_FIRST], 5.0, 1e-12);
    assert_near(sum.loss.zones_m2[PP_ZONE_FRONT], 1.0, 1e-12);
    assert_near(sum.loss.equivalent_m2, 0.5 * 4.0 + 5.0 + 1.5, 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_no_sky_line_lies_where_head_and_house_are_in_line),
        cmocka_unit_test(along_the_legal_line_the_sky_factor_is_a_fifth_of_a_per_cent),
        cmocka_unit_test(a_loss_is_counted_by_quarters_of_the_room),
        cmocka_unit_test(a_sum_of_rooms_includes_the_known_areas_of_each),
        cmocka_unit_test(no_plane_and_no_window_are_no_lit_area),
    };
    add_tests(tests, NULL, NULL);
}
