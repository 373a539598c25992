/* test_ray_tree.c - the first of many triangles, compared with a test of every
 * triangle. */
#include "simulate/research/radiosity/ray_tree.h"

#include "tests/lib/dice.h"
#include "tests/lib/near.h"

enum { TRIANGLES = 700, RAYS = 2000 };

static struct pp_vec3 anywhere(struct dice *dice, double size)
{
    return pp_vec(between(dice, -size, size), between(dice, -size, size),
                  between(dice, -size, size));
}

/* Uses the signs of three volumes, and only one division, for the distance. */
static double distance_to(const struct pp_ray_triangle *triangle, struct pp_vec3 from,
                          struct pp_vec3 to)
{
    struct pp_vec3 v[3];
    int left = 0, right = 0;
    for (int i = 0; i < 3; i++)
        v[i] = pp_vec_sub(triangle->corners[i], from);
    for (int i = 0; i < 3; i++) {
        double volume = pp_vec_dot(to, pp_vec_cross(v[i], v[(i + 1) % 3]));
        left += volume >= 0.0;
        right += volume <= 0.0;
    }
    struct pp_vec3 n = pp_vec_cross(pp_vec_sub(v[1], v[0]), pp_vec_sub(v[2], v[0]));
    double distance = pp_vec_dot(n, v[0]) / pp_vec_dot(n, to);
    return (left == 3 || right == 3) && distance > 1e-9 ? distance : INFINITY;
}

static void the_first_of_many_is_found(void **state)
{
    (void)state;
    static struct pp_ray_triangle triangles[TRIANGLES];
    struct dice dice = {11};
    struct pp_ray_tree *tree;
    int met = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        struct pp_vec3 middle = anywhere(&dice, 10.0);
        for (int k = 0; k < 3; k++)
            triangles[i].corners[k] = pp_vec_add(middle, anywhere(&dice, 1.0));
        triangles[i].owner = i;
    }
    assert_int_equal(pp_ray_tree_create(&tree, triangles, TRIANGLES, NULL), PP_OK);
    for (int ray = 0; ray < RAYS; ray++) {
        struct pp_vec3 from = anywhere(&dice, 12.0);
        struct pp_vec3 to = pp_vec_unit(anywhere(&dice, 1.0));
        int but = (int)between(&dice, -1.0, TRIANGLES), expected = -1;
        double distance, least = INFINITY;
        for (int i = 0; i < TRIANGLES; i++) {
            double own = i == but ? INFINITY : distance_to(&triangles[i], from, to);
            if (own < least) {
                least = own;
                expected = i;
            }
        }
        assert_int_equal(pp_ray_tree_first(tree, from, to, but, &distance), expected);
        if (expected >= 0)
            assert_relative(distance, least, 1e-10);
        met += expected >= 0;
    }
    assert_true(met > RAYS / 20 && met < RAYS);
    pp_ray_tree_destroy(tree);
}

static void an_empty_tree_is_met_by_nothing(void **state)
{
    (void)state;
    struct pp_ray_tree *tree;
    double distance;
    assert_int_equal(pp_ray_tree_create(&tree, NULL, 0, NULL), PP_OK);
    assert_int_equal(pp_ray_tree_first(tree, pp_vec(0.0, 0.0, 0.0),
                                       pp_vec(0.0, 0.0, 1.0), -1, &distance),
                     -1);
    assert_true(isinf(distance));
    pp_ray_tree_destroy(tree);
}

/* Rays parallel to the axes, exactly in the plane of a box's side and through shared
 * edges. */
static void a_ray_through_a_shared_edge_does_not_slip_through(void **state)
{
    (void)state;
    const struct pp_vec3 c[4] = {
        {0.0, 0.0, 1.0}, {3.0, 0.0, 1.0}, {3.0, 2.0, 1.0}, {0.0, 2.0, 1.0}};
    const struct pp_ray_triangle triangles[2] = {{{c[0], c[1], c[2]}, 0},
                                                 {{c[0], c[2], c[3]}, 0}};
    struct pp_ray_tree *tree;
    double distance;
    assert_int_equal(pp_ray_tree_create(&tree, triangles, 2, NULL), PP_OK);
    for (int i = 0; i <= 100; i++) {
        struct pp_vec3 from = pp_vec(0.03 * i, 0.02 * i, 0.0);
        assert_int_equal(
            pp_ray_tree_first(tree, from, pp_vec(0.0, 0.0, 1.0), -1, &distance), 0);
        assert_near(distance, 1.0, 1e-12);
    }
    pp_ray_tree_destroy(tree);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_of_many_is_found),
        cmocka_unit_test(an_empty_tree_is_met_by_nothing),
        cmocka_unit_test(a_ray_through_a_shared_edge_does_not_slip_through),
    };
    add_tests(tests, NULL, NULL);
}
