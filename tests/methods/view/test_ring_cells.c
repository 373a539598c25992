/* test_ring_cells.c - cutting many outlines out of a figure cell by cell leaves the
 * same areas as without cells. */
#include "methods/view/ring_cells.h"

#include <math.h>
#include <stdlib.h>

#include "tests/lib/dice.h"
#include "tests/lib/near.h"

enum { LEAVES = 1500 };

/* Triangles scattered over the unit square, each at its own depth. */
struct leaves {
    double xy[LEAVES][3][2];
    struct pp_fragment_ring rings[LEAVES];
};

static struct leaves *strew(double size)
{
    struct leaves *leaves = calloc(1, sizeof *leaves);
    struct dice dice = {11};
    assert_non_null(leaves);
    for (int i = 0; i < LEAVES; i++) {
        double x = between(&dice, -size, 1.0), y = between(&dice, -size, 1.0);
        for (int k = 0; k < 3; k++) {
            leaves->xy[i][k][0] = x + between(&dice, 0.0, size);
            leaves->xy[i][k][1] = y + between(&dice, 0.0, size);
        }
        pp_fragments_close_ring(&leaves->rings[i], leaves->xy[i], 3);
        leaves->rings[i].depth[0] = between(&dice, 1.0, 2.0);
    }
    return leaves;
}

static struct pp_fragments square(void)
{
    const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    struct pp_fragments open = {0};
    assert_int_equal(pp_fragments_add(&open, corners, 4, NULL), PP_OK);
    return open;
}

static double area_of(const struct pp_fragments *fragments, int owner)
{
    double sum = 0.0;
    for (int i = 0; i < fragments->count; i++)
        if (fragments->list[i].owner == owner)
            sum += pp_fragments_area(&fragments->list[i]);
    return sum;
}

/* The number of cells, and the most outlines in one of them. */
struct seen {
    const struct leaves *leaves;
    int cells, most;
};

static void see(struct seen *seen, int count)
{
    seen->cells++;
    seen->most = count > seen->most ? count : seen->most;
}

static enum pp_status subtract(void *data, struct pp_fragments *open, const int *rings,
                               int count, struct pp_error *err)
{
    struct seen *seen = data;
    enum pp_status status = PP_OK;
    see(seen, count);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = pp_fragments_subtract(open, &seen->leaves->rings[rings[i]], err);
    return status;
}

static enum pp_status cover(void *data, struct pp_fragments *open, const int *rings,
                            int count, struct pp_error *err)
{
    struct seen *seen = data;
    enum pp_status status = PP_OK;
    see(seen, count);
    for (int i = 0; i < count && status == PP_OK; i++)
        status = pp_fragments_cover(open, seen->leaves->rings, rings[i], err);
    return status;
}

/* Every triangle is cut out once: the remaining area is the same as with one cut after
 * the other. */
static void what_leaves_leave_open_is_the_same_without_cells(void **state)
{
    (void)state;
    struct leaves *leaves = strew(0.07);
    struct pp_fragments by_cells = square(), plain = square();
    struct seen seen = {.leaves = leaves};
    assert_int_equal(
        pp_ring_cells(&by_cells, leaves->rings, LEAVES, subtract, &seen, NULL), PP_OK);
    for (int i = 0; i < LEAVES; i++)
        assert_int_equal(pp_fragments_subtract(&plain, &leaves->rings[i], NULL), PP_OK);
    double left = area_of(&plain, PP_FRAGMENT_FREE);
    assert_true(left > 0.4 && left < 0.8);
    assert_near(area_of(&by_cells, PP_FRAGMENT_FREE), left, 1e-12);
    assert_true(seen.cells > 4 && seen.most < LEAVES / 4);
    pp_fragments_clear(&by_cells);
    pp_fragments_clear(&plain);
    free(leaves);
}

/* The same area is in front of each triangle as without cells. */
static void each_leaf_has_in_front_what_it_has_without_cells(void **state)
{
    (void)state;
    struct leaves *leaves = strew(0.07);
    struct pp_fragments by_cells = square(), plain = square();
    struct seen seen = {.leaves = leaves};
    assert_int_equal(
        pp_ring_cells(&by_cells, leaves->rings, LEAVES, cover, &seen, NULL), PP_OK);
    for (int i = 0; i < LEAVES; i++)
        assert_int_equal(pp_fragments_cover(&plain, leaves->rings, i, NULL), PP_OK);
    for (int i = PP_FRAGMENT_FREE; i < LEAVES; i += 7)
        assert_near(area_of(&by_cells, i), area_of(&plain, i), 1e-12);
    double all = 0.0;
    for (int i = 0; i < by_cells.count; i++)
        all += pp_fragments_area(&by_cells.list[i]);
    assert_near(all, 1.0, 1e-12);
    pp_fragments_clear(&by_cells);
    pp_fragments_clear(&plain);
    free(leaves);
}

/* If every outline is as wide as the figure, dividing the figure does not separate
 * them: there is one cell. */
static void rings_that_halves_do_not_part_stay_together(void **state)
{
    (void)state;
    struct leaves *leaves = strew(0.001);
    for (int i = 0; i < LEAVES; i++) {
        double top = 1.0 - 0.9 * i / LEAVES;
        const double wide[3][2] = {{-1, -1}, {3, -1}, {-1, top}};
        memcpy(leaves->xy[i], wide, sizeof wide);
        pp_fragments_close_ring(&leaves->rings[i], leaves->xy[i], 3);
    }
    struct pp_fragments open = square();
    struct seen seen = {.leaves = leaves};
    assert_int_equal(pp_ring_cells(&open, leaves->rings, LEAVES, subtract, &seen, NULL),
                     PP_OK);
    assert_int_equal(seen.cells, 1);
    assert_int_equal(seen.most, LEAVES);
    pp_fragments_clear(&open);
    free(leaves);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_leaves_leave_open_is_the_same_without_cells),
        cmocka_unit_test(each_leaf_has_in_front_what_it_has_without_cells),
        cmocka_unit_test(rings_that_halves_do_not_part_stay_together),
    };
    add_tests(tests, NULL, NULL);
}
