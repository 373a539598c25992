/* test_region.c - plane figures: operations by GEOS, compared with areas calculated by
 * hand. */
#include "tests/lib/near.h"

#include <stdlib.h>

#include "model/geometry/clipper.h"
#include "model/geometry/region.h"

/* For coordinates of a few metres, areas are accurate to a few units in the last
 * place. */
#define ROUNDING 1e-13

static struct pp_clipper *clipper;

static int set_up(void **state)
{
    (void)state;
    return pp_clipper_create(&clipper, NULL) == PP_OK ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    pp_clipper_destroy(clipper);
    return 0;
}

static struct pp_region rectangle(double x0, double y0, double x1, double y1)
{
    const double xy[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    struct pp_region region;
    assert_int_equal(pp_clipper_of_ring(clipper, &region, xy, 4, NULL), PP_OK);
    return region;
}

static void a_clockwise_ring_is_turned_round(void **state)
{
    (void)state;
    const double xy[4][2] = {{1.3, 0.7}, {1.3, 2.9}, {4.6, 2.9}, {4.6, 0.7}};
    struct pp_region region;
    assert_int_equal(pp_clipper_of_ring(clipper, &region, xy, 4, NULL), PP_OK);
    assert_near(pp_region_area(&region), 3.3 * 2.2, ROUNDING);
    pp_region_clear(&region);
    assert_int_equal(region.count, 0);
}

static void a_line_and_two_points_have_no_figure(void **state)
{
    (void)state;
    const double xy[3][2] = {{0.0, 0.0}, {1.5, 1.5}, {3.0, 3.0}};
    struct pp_region region;
    assert_int_equal(pp_clipper_of_ring(clipper, &region, xy, 3, NULL), PP_OK);
    assert_int_equal(region.count, 0);
    assert_int_equal(pp_clipper_of_ring(clipper, &region, xy, 2, NULL), PP_OK);
    assert_int_equal(region.count, 0);
}

static void a_bow_tie_is_refused(void **state)
{
    (void)state;
    const double bow[4][2] = {{0.0, 0.0}, {2.1, 1.7}, {2.1, 0.0}, {0.0, 1.3}};
    const double spike[5][2] = {
        {0.0, 0.0}, {2.1, 0.0}, {3.4, 0.0}, {2.1, 0.0}, {0.9, 1.3}};
    struct pp_region region;
    struct pp_error err;
    assert_int_equal(pp_clipper_of_ring(clipper, &region, bow, 4, &err), PP_BAD_INPUT);
    assert_int_equal(region.count, 0);
    bool simple = true;
    assert_int_equal(pp_clipper_ring_is_simple(&simple, clipper, bow, 4, NULL), PP_OK);
    assert_false(simple);
    simple = true;
    assert_int_equal(pp_clipper_ring_is_simple(&simple, clipper, spike, 5, NULL),
                     PP_OK);
    assert_false(simple);
}

static double area_by_crossings(const double (*xy)[2], int count)
{
    struct pp_region region;
    struct pp_error err;
    if (pp_clipper_by_crossings(clipper, &region, xy, count, &err) != PP_OK)
        fail_msg("%s", err.message);
    double area = pp_region_area(&region);
    pp_region_clear(&region);
    return area;
}

static void any_closed_line_has_a_figure_by_crossings(void **state)
{
    (void)state;
    /* A hole with the same orientation as its outline, and a hole with an edge on the
     * outline: a notch. */
    const double hole[10][2] = {{0.0, 0.0}, {5.3, 0.0}, {5.3, 2.7}, {0.0, 2.7},
                                {0.0, 0.0}, {1.1, 0.9}, {3.4, 0.9}, {3.4, 2.2},
                                {1.1, 2.2}, {1.1, 0.9}};
    const double notch[10][2] = {{0.0, 0.0}, {5.3, 0.0}, {5.3, 2.7}, {0.0, 2.7},
                                 {0.0, 0.0}, {1.1, 0.0}, {3.4, 0.0}, {3.4, 2.2},
                                 {1.1, 2.2}, {1.1, 0.0}};
    assert_near(area_by_crossings(hole, 10), 5.3 * 2.7 - 2.3 * 1.3, ROUNDING);
    assert_near(area_by_crossings(notch, 10), 5.3 * 2.7 - 2.3 * 2.2, ROUNDING);
    /* A bow tie is two similar triangles on the bases 1.3 and 1.7, which divide the
     * width of 2.1 in the ratio 1.3 to 1.7. */
    const double bow[4][2] = {{0.0, 0.0}, {2.1, 1.7}, {2.1, 0.0}, {0.0, 1.3}};
    double left = 2.1 * 1.3 / 3.0, right = 2.1 * 1.7 / 3.0;
    assert_near(area_by_crossings(bow, 4), (1.3 * left + 1.7 * right) / 2.0, ROUNDING);
    /* A path to and fro encloses nothing, nor does an outline traced twice. */
    const double spike[5][2] = {
        {0.0, 0.0}, {2.1, 0.0}, {3.4, 0.0}, {2.1, 0.0}, {0.9, 1.3}};
    const double twice[6][2] = {{0.0, 0.0}, {2.1, 0.0}, {0.9, 1.3},
                                {0.0, 0.0}, {2.1, 0.0}, {0.9, 1.3}};
    assert_near(area_by_crossings(spike, 5), 2.1 * 1.3 / 2.0, ROUNDING);
    assert_near(area_by_crossings(twice, 6), 0.0, 0.0);
    assert_near(area_by_crossings(twice, 2), 0.0, 0.0);
}

static void a_hole_runs_clockwise_and_takes_its_area(void **state)
{
    (void)state;
    struct pp_region wall = rectangle(0.0, 0.0, 5.3, 2.7);
    struct pp_region window = rectangle(1.1, 0.9, 3.4, 2.2);
    struct pp_region rest;
    assert_int_equal(pp_clipper_difference(clipper, &rest, &wall, &window, NULL),
                     PP_OK);
    assert_int_equal(rest.count, 2);
    assert_near(pp_region_area(&rest), 5.3 * 2.7 - 2.3 * 1.3, ROUNDING);
    assert_true(pp_region_contains(&rest, 0.4, 1.3));
    assert_false(pp_region_contains(&rest, 2.2, 1.6));
    assert_false(pp_region_contains(&rest, 5.4, 1.6));
    /* 0.3 m to the left of the window, 0.8 m from the wall's end. */
    assert_near(pp_region_edge_distance(&rest, 0.8, 1.5), 0.3, ROUNDING);

    /* Regions with holes are unchanged after conversion and back. */
    struct pp_region both[2], whole, none;
    both[0] = rest;
    both[1] = window;
    assert_int_equal(pp_clipper_union(clipper, &whole, both, 2, NULL), PP_OK);
    assert_near(pp_region_area(&whole), 5.3 * 2.7, ROUNDING);
    assert_int_equal(pp_clipper_intersection(clipper, &none, &rest, &window, NULL),
                     PP_OK);
    assert_int_equal(none.count, 0);
    pp_region_clear(&whole);
    pp_region_clear(&rest);
    pp_region_clear(&wall);
    pp_region_clear(&window);
}

static void two_windows_with_holes_keep_each_its_own(void **state)
{
    (void)state;
    struct pp_region parts[2] = {rectangle(0.0, 0.0, 2.0, 3.0),
                                 rectangle(4.0, 0.0, 6.0, 3.0)};
    struct pp_region band = rectangle(0.5, 1.0, 1.5, 2.0),
                     band2 = rectangle(4.5, 1.0, 5.5, 2.0);
    struct pp_region holes[2] = {band, band2}, walls, cut, left;
    assert_int_equal(pp_clipper_union(clipper, &walls, parts, 2, NULL), PP_OK);
    assert_int_equal(pp_clipper_union(clipper, &cut, holes, 2, NULL), PP_OK);
    assert_int_equal(pp_clipper_difference(clipper, &left, &walls, &cut, NULL), PP_OK);
    assert_int_equal(left.count, 4);
    assert_near(pp_region_area(&left), 2.0 * (6.0 - 1.0), ROUNDING);
    struct pp_region copy;
    assert_int_equal(pp_region_copy(&copy, &left, NULL), PP_OK);
    struct pp_region again;
    assert_int_equal(pp_clipper_intersection(clipper, &again, &copy, &parts[1], NULL),
                     PP_OK);
    assert_near(pp_region_area(&again), 5.0, ROUNDING);
    pp_region_clear(&again);
    pp_region_clear(&copy);
    pp_region_clear(&left);
    pp_region_clear(&cut);
    pp_region_clear(&walls);
    for (int i = 0; i < 2; i++) {
        pp_region_clear(&parts[i]);
        pp_region_clear(&holes[i]);
    }
}

static void figures_that_only_touch_share_nothing(void **state)
{
    (void)state;
    struct pp_region a = rectangle(0.0, 0.0, 1.7, 2.3);
    struct pp_region b = rectangle(1.7, 0.4, 3.1, 1.9), shared;
    assert_int_equal(pp_clipper_intersection(clipper, &shared, &a, &b, NULL), PP_OK);
    assert_int_equal(shared.count, 0);
    pp_region_clear(&a);
    pp_region_clear(&b);
}

static void triangles_cover_an_outline_with_a_hole(void **state)
{
    (void)state;
    struct pp_region wall = rectangle(0.0, 0.0, 5.3, 2.7);
    struct pp_region window = rectangle(1.1, 0.9, 3.4, 2.2), rest;
    assert_int_equal(pp_clipper_difference(clipper, &rest, &wall, &window, NULL),
                     PP_OK);
    double(*triangles)[3][2], area = 0.0;
    int count;
    assert_int_equal(pp_clipper_triangulate(clipper, &triangles, &count, &rest, NULL),
                     PP_OK);
    assert_int_equal(count, 8);
    for (int i = 0; i < count; i++) {
        double(*t)[2] = triangles[i];
        double part = ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1])
                       - (t[2][0] - t[0][0]) * (t[1][1] - t[0][1]))
                      / 2.0;
        assert_true(part > 0.0);
        area += part;
        assert_true(pp_region_contains(&rest, (t[0][0] + t[1][0] + t[2][0]) / 3.0,
                                       (t[0][1] + t[1][1] + t[2][1]) / 3.0));
    }
    assert_near(area, pp_region_area(&rest), ROUNDING);
    free(triangles);
    pp_region_clear(&rest);
    pp_region_clear(&window);
    pp_region_clear(&wall);
}

/* A wall with five windows, three of them at its edges. GEOS 3.11 finds no triangles
 * for this outline, in which a corner and a corner of a hole have almost the same
 * coordinate. */
static void triangles_cover_a_wall_with_windows_at_its_edges(void **state)
{
    (void)state;
    double outer[][2] = {{1.05, -3.0},
                         {1.05, -2.4},
                         {2.1, -2.4},
                         {2.1, 0.0},
                         {1.6800000000000002, 0.0},
                         {1.6800000000000002, -0.60000000000000009},
                         {0.63, -0.60000000000000009},
                         {0.63, 0.0},
                         {0.0, 0.0},
                         {0.0, -1.92},
                         {1.05, -1.92},
                         {1.05, -2.34},
                         {0.0, -2.34},
                         {0.0, -3.0}};
    double low[][2] = {{0.63, -1.2000000000000002},
                       {1.6800000000000002, -1.2000000000000002},
                       {1.6800000000000002, -1.8},
                       {0.63, -1.8}};
    double high[][2] = {{0.63, -0.7200000000000002},
                        {1.6800000000000002, -0.7200000000000002},
                        {1.6800000000000002, -1.1400000000000001},
                        {0.63, -1.1400000000000001}};
    struct pp_ring rings[] = {{14, outer}, {4, low}, {4, high}};
    const struct pp_region wall = {3, rings};
    double(*triangles)[3][2], area = 0.0;
    int count;
    assert_int_equal(pp_clipper_triangulate(clipper, &triangles, &count, &wall, NULL),
                     PP_OK);
    for (int i = 0; i < count; i++) {
        double part = pp_region_ring_area((const double(*)[2])triangles[i], 3);
        assert_true(part > 0.0);
        area += part;
    }
    assert_near(area, pp_region_area(&wall), ROUNDING);
    free(triangles);
}

static void the_union_of_nothing_is_empty(void **state)
{
    (void)state;
    struct pp_region none;
    assert_int_equal(pp_clipper_union(clipper, &none, NULL, 0, NULL), PP_OK);
    assert_int_equal(none.count, 0);
    assert_near(pp_region_area(&none), 0.0, 0.0);
    assert_true(isinf(pp_region_edge_distance(&none, 0.3, 0.4)));
    double(*triangles)[3][2];
    int count;
    assert_int_equal(pp_clipper_triangulate(clipper, &triangles, &count, &none, NULL),
                     PP_OK);
    assert_int_equal(count, 0);
    free(triangles);
}

/* An L-shape of 5 by 2 and 2 by 3 above: half a metre inside, 4 by 1 and 1 by 3. Half a
 * metre inside a ring 1 m wide nothing is left; 0.1 m inside it, a ring 0.8 m wide is
 * left. */
static void inside_its_edge_an_l_is_a_smaller_l(void **state)
{
    (void)state;
    const double xy[6][2] = {{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 5}, {0, 5}};
    struct pp_region l, inside;
    assert_int_equal(pp_clipper_of_ring(clipper, &l, xy, 6, NULL), PP_OK);
    assert_int_equal(pp_clipper_inset(clipper, &inside, &l, 0.5, NULL), PP_OK);
    assert_near(pp_region_area(&inside), 4.0 * 1.0 + 1.0 * 3.0, 1e-12);
    assert_true(pp_region_contains(&inside, 1.4, 1.4));
    pp_region_clear(&inside);
    pp_region_clear(&l);
    struct pp_region outer = rectangle(0, 0, 4, 4), inner = rectangle(1, 1, 3, 3), ring;
    assert_int_equal(pp_clipper_difference(clipper, &ring, &outer, &inner, NULL),
                     PP_OK);
    assert_int_equal(pp_clipper_inset(clipper, &inside, &ring, 0.5, NULL), PP_OK);
    assert_near(pp_region_area(&inside), 0.0, 1e-12);
    pp_region_clear(&inside);
    assert_int_equal(pp_clipper_inset(clipper, &inside, &ring, 0.1, NULL), PP_OK);
    assert_near(pp_region_area(&inside), 3.8 * 3.8 - 2.2 * 2.2, 1e-12);
    pp_region_clear(&inside);
    pp_region_clear(&ring);
    pp_region_clear(&inner);
    pp_region_clear(&outer);
}

/* Random convex quadrilaterals on ellipses are divided into two counter-clockwise
 * triangles with the whole area. The diagonal is the one whose opposite angles add up
 * to at most 180 degrees (Delaunay). */
static void a_convex_ring_of_four_is_cut_by_delaunay_s_diagonal(void **state)
{
    (void)state;
    uint32_t seed = 1;
    for (int n = 0; n < 500; n++) {
        double xy[4][2], (*t)[3][2];
        for (int i = 0; i < 4; i++) {
            seed = seed * 1664525u + 1013904223u;
            double angle = (i + 0.1 + 0.8 * (seed >> 8) * 0x1p-24) * 1.5707963267948966;
            xy[n % 2 ? 3 - i : i][0] = 3.0 * cos(angle) + 7.0;
            xy[n % 2 ? 3 - i : i][1] = (1.0 + n % 3) * sin(angle);
        }
        struct pp_ring ring = {4, xy};
        struct pp_region region = {1, &ring};
        int count;
        assert_int_equal(pp_clipper_triangulate(clipper, &t, &count, &region, NULL),
                         PP_OK);
        assert_int_equal(count, 2);
        double area = 0.0, opposite = 0.0;
        for (int i = 0; i < 2; i++) {
            double own = pp_region_ring_area((const double(*)[2])t[i], 3);
            assert_true(own > 0.0);
            area += own;
            for (int k = 0; k < 3; k++) {
                const double *a = t[i][k], *b = t[i][(k + 1) % 3],
                             *c = t[i][(k + 2) % 3];
                bool shared = false;
                for (int m = 0; m < 3; m++)
                    shared |= memcmp(a, t[1 - i][m], sizeof(double[2])) == 0;
                if (!shared)
                    opposite += acos(
                        ((b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]))
                        / (hypot(b[0] - a[0], b[1] - a[1])
                           * hypot(c[0] - a[0], c[1] - a[1])));
            }
        }
        assert_near(area, fabs(pp_region_area(&region)), 1e-12);
        assert_true(opposite < 3.14159265358979 + 1e-6);
        free(t);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_convex_ring_of_four_is_cut_by_delaunay_s_diagonal),
        cmocka_unit_test(a_clockwise_ring_is_turned_round),
        cmocka_unit_test(a_line_and_two_points_have_no_figure),
        cmocka_unit_test(a_bow_tie_is_refused),
        cmocka_unit_test(any_closed_line_has_a_figure_by_crossings),
        cmocka_unit_test(a_hole_runs_clockwise_and_takes_its_area),
        cmocka_unit_test(two_windows_with_holes_keep_each_its_own),
        cmocka_unit_test(figures_that_only_touch_share_nothing),
        cmocka_unit_test(triangles_cover_an_outline_with_a_hole),
        cmocka_unit_test(triangles_cover_a_wall_with_windows_at_its_edges),
        cmocka_unit_test(the_union_of_nothing_is_empty),
        cmocka_unit_test(inside_its_edge_an_l_is_a_smaller_l),
    };
    add_tests(tests, set_up, tear_down);
}
