/* test_polygon.c - plane polygons in space. */
#include "model/geometry/polygon.h"

#include "model/geometry/polygons_cross.h"
#include "tests/lib/near.h"

/* Pseudo-random number in [0, 1). */
static double next(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static struct pp_vec3 direction(uint64_t *state)
{
    for (;;) {
        struct pp_vec3 v =
            pp_vec(2 * next(state) - 1, 2 * next(state) - 1, 2 * next(state) - 1);
        if (pp_vec_length(v) > 0.1 && pp_vec_length(v) < 1.0)
            return pp_vec_unit(v);
    }
}

/* An L-shape of 5.88 m2 in the plane's own axes. */
static const double ell[6][2] = {{0.0, 0.0}, {3.1, 0.0}, {3.1, 1.1},
                                 {1.3, 1.1}, {1.3, 3.0}, {0.0, 3.0}};
static const double ell_m2 = 3.1 * 1.1 + 1.3 * 1.9;

static struct pp_polygon ell_in(struct pp_vec3 origin, struct pp_vec3 normal,
                                struct pp_vec3 *along, struct pp_vec3 *up)
{
    struct pp_vec3 vertices[6];
    pp_polygon_plane_axes(normal, along, up);
    for (int i = 0; i < 6; i++)
        vertices[i] =
            pp_vec_along(pp_vec_along(origin, ell[i][0], *along), ell[i][1], *up);
    struct pp_polygon polygon;
    assert_int_equal(pp_polygon_of(&polygon, vertices, 6, NULL), PP_OK);
    return polygon;
}

static void axes_are_right_handed_and_along_is_level(void **state)
{
    (void)state;
    uint64_t seed = 11;
    for (int i = 0; i < 1000; i++) {
        struct pp_vec3 n = direction(&seed), along, up;
        pp_polygon_plane_axes(n, &along, &up);
        struct pp_vec3 cross = pp_vec_cross(along, up);
        assert_near(pp_vec_length(pp_vec_sub(cross, n)), 0.0, 1e-15 * 8);
        assert_near(along.z, 0.0, 0.0);
        assert_true(up.z >= 0.0);
    }
}

/* A wall that faces north, seen from the north: right is west. Horizontal planes have
 * no upward direction and use the axes of the plan. */
static void walls_and_level_planes_have_the_axes_of_the_plan(void **state)
{
    (void)state;
    struct pp_vec3 along, up;
    pp_polygon_plane_axes(pp_vec(0.0, 1.0, 0.0), &along, &up);
    assert_true(along.x == -1.0 && along.y == 0.0 && up.z == 1.0);
    pp_polygon_plane_axes(pp_vec(0.0, 0.0, -1.0), &along, &up);
    assert_true(along.x == 1.0 && along.y == 0.0 && up.y == -1.0 && up.z == 0.0);
    pp_polygon_plane_axes(pp_vec(0.0, 0.0, 1.0), &along, &up);
    assert_true(along.x == 1.0 && up.y == 1.0);
    struct pp_vec3 nearly = pp_vec_unit(pp_vec(3e-8, -2e-8, -1.0));
    pp_polygon_plane_axes(nearly, &along, &up);
    assert_near(along.x, 1.0, 1e-12);
    assert_near(pp_vec_dot(along, nearly), 0.0, 1e-15);
}

static void area_and_normal_are_the_same_in_any_plane(void **state)
{
    (void)state;
    uint64_t seed = 5;
    for (int i = 0; i < 200; i++) {
        struct pp_vec3 n = direction(&seed), along, up;
        struct pp_vec3 origin = pp_vec_scale(direction(&seed), 40.0);
        struct pp_polygon polygon = ell_in(origin, n, &along, &up);
        assert_relative(polygon.area_m2, ell_m2, 1e-13);
        assert_near(pp_vec_length(pp_vec_sub(polygon.normal, n)), 0.0, 1e-13);
        assert_true(pp_polygon_unevenness(&polygon) < 1e-13);
        pp_polygon_clear(&polygon);
    }
}

/* In its own axes the L-shape is a union of two rectangles, so the test is simple. */
static void a_point_lies_in_the_polygon_if_it_does_in_its_axes(void **state)
{
    (void)state;
    uint64_t seed = 3;
    int inside = 0;
    for (int i = 0; i < 4000; i++) {
        struct pp_vec3 n = direction(&seed), along, up;
        struct pp_vec3 origin = pp_vec_scale(direction(&seed), 7.0);
        struct pp_polygon polygon = ell_in(origin, n, &along, &up);
        double x = 4.0 * next(&seed) - 0.5, y = 4.0 * next(&seed) - 0.5;
        double off = 2.0 * next(&seed) - 1.0;
        bool in = x > 0.0 && y > 0.0 && ((x < 3.1 && y < 1.1) || (x < 1.3 && y < 3.0));
        struct pp_vec3 point =
            pp_vec_along(pp_vec_along(pp_vec_along(origin, x, along), y, up), off, n);
        if (pp_polygon_ring_edge_distance(ell, 6, x, y, NULL) > 1e-9) {
            assert_int_equal(pp_polygon_side(&polygon, point, 1e-9),
                             in ? PP_INSIDE : PP_OUTSIDE);
            assert_int_equal(pp_polygon_ring_side(ell, 6, x, y, 1e-9),
                             in ? PP_INSIDE : PP_OUTSIDE);
        }
        assert_near(pp_polygon_height(&polygon, point), off, 1e-13);
        double beside = in ? 0.0 : pp_polygon_ring_edge_distance(ell, 6, x, y, NULL);
        assert_near(pp_polygon_distance(&polygon, point), hypot(beside, off), 1e-12);
        inside += in;
        pp_polygon_clear(&polygon);
    }
    /* 5.88 of 16 m2 of the points. */
    assert_near(inside / 4000.0, ell_m2 / 16.0, 0.03);
}

/* The same for walls that face an axis or nearly do, and for floor and ceiling.
 * Projected along one of the other axes such a polygon is a line, which encloses
 * nothing. The distance of a point above the polygon is its height. */
static void walls_along_the_axes_enclose_points_too(void **state)
{
    (void)state;
    static const struct pp_vec3 normals[] = {
        {1, 0, 0},  {-1, 0, 0},   {0, 1, 0},    {0, -1, 0},    {0, 0, 1},
        {0, 0, -1}, {1, 1e-9, 0}, {1e-9, 1, 0}, {0.6, 0.8, 0}, {0.8, 0, 0.6}};
    for (size_t i = 0; i < sizeof normals / sizeof *normals; i++) {
        struct pp_vec3 along, up, n = pp_vec_unit(normals[i]);
        struct pp_polygon polygon = ell_in(pp_vec(0.7, -1.9, 0.3), n, &along, &up);
        static const double xy[4][2] = {
            {0.6, 2.0}, {2.2, 0.4}, {2.2, 2.0}, {-0.5, 1.0}};
        for (int k = 0; k < 4; k++) {
            struct pp_vec3 point = pp_vec_along(
                pp_vec_along(polygon.vertices[0], xy[k][0], along), xy[k][1], up);
            bool inside = k < 2;
            assert_int_equal(pp_polygon_side(&polygon, point, 1e-6),
                             inside ? PP_INSIDE : PP_OUTSIDE);
            /* Distance from the edges at the inner corner (1.3, 1.1), and from the edge
             * x = 0. */
            double aside = inside ? 0.0 : k == 2 ? 0.9 : 0.5;
            assert_near(
                pp_polygon_distance(&polygon, pp_vec_along(point, 1.2, polygon.normal)),
                hypot(aside, 1.2), 1e-9);
        }
        pp_polygon_clear(&polygon);
    }
}

static void points_within_the_tolerance_are_on_an_edge(void **state)
{
    (void)state;
    assert_int_equal(pp_polygon_ring_side(ell, 6, 1.3, 2.2, 0.0), PP_ON_EDGE);
    assert_int_equal(pp_polygon_ring_side(ell, 6, 1.3 + 2e-7, 2.2, 1e-7), PP_OUTSIDE);
    assert_int_equal(pp_polygon_ring_side(ell, 6, 1.3 - 2e-7, 2.2, 1e-7), PP_INSIDE);
    assert_int_equal(pp_polygon_ring_side(ell, 6, 1.3 + 2e-7, 2.2, 3e-7), PP_ON_EDGE);
    double nearest[2];
    assert_near(pp_polygon_ring_edge_distance(ell, 6, 1.6, 1.5, nearest), 0.3, 1e-15);
    assert_near(nearest[0], 1.3, 0.0);
    assert_near(nearest[1], 1.5, 1e-15);
}

static struct pp_polygon quad(struct pp_vec3 a, struct pp_vec3 b, struct pp_vec3 c,
                              struct pp_vec3 d)
{
    struct pp_vec3 vertices[4] = {a, b, c, d};
    struct pp_polygon polygon;
    assert_int_equal(pp_polygon_of(&polygon, vertices, 4, NULL), PP_OK);
    return polygon;
}

static bool cross(const struct pp_polygon *a, const struct pp_polygon *b,
                  struct pp_vec3 *where)
{
    bool one, other;
    assert_int_equal(pp_polygons_cross(&one, a, b, where, NULL), PP_OK);
    assert_int_equal(pp_polygons_cross(&other, b, a, NULL, NULL), PP_OK);
    assert_true(one == other);
    return one;
}

static void polygons_cross_only_where_both_go_on(void **state)
{
    (void)state;
    struct pp_vec3 where;
    struct pp_polygon floor =
        quad(pp_vec(0, 0, 0), pp_vec(4, 0, 0), pp_vec(4, 3, 0), pp_vec(0, 3, 0));
    struct pp_polygon through =
        quad(pp_vec(1, 1, -1), pp_vec(2, 1, -1), pp_vec(2, 1, 1), pp_vec(1, 1, 1));
    assert_true(cross(&floor, &through, &where));
    assert_near(where.x, 1.5, 1e-12);
    assert_near(where.y, 1.0, 1e-12);
    assert_near(where.z, 0.0, 1e-12);
    struct pp_polygon standing =
        quad(pp_vec(1, 1, 0), pp_vec(2, 1, 0), pp_vec(2, 1, 1), pp_vec(1, 1, 1));
    assert_false(cross(&floor, &standing, &where));
    struct pp_polygon beside =
        quad(pp_vec(1, -1, -1), pp_vec(2, -1, -1), pp_vec(2, -1, 1), pp_vec(1, -1, 1));
    assert_false(cross(&floor, &beside, &where));
    struct pp_polygon along_edge =
        quad(pp_vec(1, 0, -1), pp_vec(2, 0, -1), pp_vec(2, 0, 1), pp_vec(1, 0, 1));
    assert_false(cross(&floor, &along_edge, &where));

    /* A plate with a foot on each side of a step, which the plate touches from
     * above. */
    struct pp_polygon step =
        quad(pp_vec(1, 0, 0), pp_vec(2, 0, 0), pp_vec(2, 2, 0), pp_vec(1, 2, 0));
    struct pp_vec3 feet[8] = {{0, 1, -1}, {1, 1, -1}, {1, 1, 0}, {2, 1, 0},
                              {2, 1, -1}, {3, 1, -1}, {3, 1, 1}, {0, 1, 1}};
    struct pp_polygon plate;
    assert_int_equal(pp_polygon_of(&plate, feet, 8, NULL), PP_OK);
    assert_false(cross(&step, &plate, &where));
    /* The step is 2 cm wider than the gap between the feet and cuts into one of
     * them. */
    step.vertices[1].x = step.vertices[2].x = 2.02;
    assert_true(cross(&step, &plate, &where));
    assert_near(where.x, 2.01, 1e-12);

    pp_polygon_clear(&floor);
    pp_polygon_clear(&through);
    pp_polygon_clear(&standing);
    pp_polygon_clear(&beside);
    pp_polygon_clear(&along_edge);
    pp_polygon_clear(&step);
    pp_polygon_clear(&plate);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(axes_are_right_handed_and_along_is_level),
        cmocka_unit_test(walls_and_level_planes_have_the_axes_of_the_plan),
        cmocka_unit_test(area_and_normal_are_the_same_in_any_plane),
        cmocka_unit_test(a_point_lies_in_the_polygon_if_it_does_in_its_axes),
        cmocka_unit_test(walls_along_the_axes_enclose_points_too),
        cmocka_unit_test(points_within_the_tolerance_are_on_an_edge),
        cmocka_unit_test(polygons_cross_only_where_both_go_on),
    };
    add_tests(tests, NULL, NULL);
}
