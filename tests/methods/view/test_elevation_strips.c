/* test_elevation_strips.c - rectangles in front of a rectangle: the visible object at
 * each place. */
#include "tests/lib/near.h"

#include <stdlib.h>

#include "methods/view/elevation_cover.h"
#include "methods/view/elevation_strips.h"

static const struct pp_elevation_part seen = {
    .left = -1.3, .right = 2.1, .low = 0.2, .high = 1.7};

/* Pseudo-random number in [0, 1). */
static double next(uint64_t *row)
{
    *row = *row * 6364136223846793005u + 1442695040888963407u;
    return (double)(*row >> 11) * 0x1p-53;
}

/* Few different reflectances, so that neighbours often have the same. */
static struct pp_elevation_obstruction random_obstruction(uint64_t *row, int order)
{
    double left = -2.0 + 4.0 * next(row), low = -0.5 + 2.0 * next(row);
    return (struct pp_elevation_obstruction){
        .outline = {left, left + 0.02 + next(row), next(row) < 0.5 ? -INFINITY : low,
                    low + 0.02 + next(row), 0.1 * (1 + (int)(3.0 * next(row)))},
        .distance_m = 1 + (int)(40.0 * next(row)),
        .order = order};
}

static bool is_within(const struct pp_elevation_part *part, double x, double z)
{
    return x > part->left && x < part->right && z > part->low && z < part->high;
}

/* The nearest obstruction at a place; NAN: sky. */
static double seen_there(const struct pp_elevation_obstruction *all, int count,
                         double x, double z)
{
    const struct pp_elevation_obstruction *nearest = NULL;
    for (int i = 0; i < count; i++)
        if (is_within(&all[i].outline, x, z)
            && (!nearest || all[i].distance_m < nearest->distance_m
                || (all[i].distance_m == nearest->distance_m
                    && all[i].order < nearest->order)))
            nearest = &all[i];
    return nearest ? nearest->outline.reflectance : NAN;
}

/* The only part at a place. */
static const struct pp_elevation_part *part_at(const struct pp_elevation *elevation,
                                               double x, double z)
{
    const struct pp_elevation_part *found = NULL;
    for (int i = 0; i < elevation->count; i++)
        if (is_within(&elevation->parts[i], x, z)) {
            assert_null(found);
            found = &elevation->parts[i];
        }
    assert_non_null(found);
    return found;
}

static void each_place_shows_the_nearest_obstruction(void **state)
{
    (void)state;
    enum { MOST = 30, PLACES = 300 };
    uint64_t row = 17;
    for (int count = 0; count <= MOST; count++) {
        struct pp_elevation_obstruction all[MOST], moved[MOST];
        for (int i = 0; i < count; i++)
            all[i] = moved[i] = random_obstruction(&row, i);
        struct pp_elevation elevation = {0};
        struct pp_elevation_obstructions obstructions = {count, moved};
        assert_int_equal(
            pp_elevation_strips_cut(&elevation, &seen, &obstructions, NULL), PP_OK);
        for (int i = 0; i < PLACES; i++) {
            double x = seen.left + (seen.right - seen.left) * next(&row);
            double z = seen.low + (seen.high - seen.low) * next(&row);
            double shown = part_at(&elevation, x, z)->reflectance;
            double expected = seen_there(all, count, x, z);
            if (isnan(expected))
                assert_true(isnan(shown));
            else
                assert_near(shown, expected, 0.0);
        }
        pp_elevation_clear(&elevation);
    }
}

static void the_parts_fill_the_opening(void **state)
{
    (void)state;
    enum { COUNT = 200 };
    uint64_t row = 5;
    struct pp_elevation_obstruction all[COUNT];
    for (int i = 0; i < COUNT; i++)
        all[i] = random_obstruction(&row, i);
    struct pp_elevation elevation = {0};
    struct pp_elevation_obstructions obstructions = {COUNT, all};
    assert_int_equal(pp_elevation_strips_cut(&elevation, &seen, &obstructions, NULL),
                     PP_OK);
    double area = 0.0;
    for (int i = 0; i < elevation.count; i++) {
        const struct pp_elevation_part *part = &elevation.parts[i];
        area += (part->right - part->left) * (part->high - part->low);
    }
    assert_near(area, (seen.right - seen.left) * (seen.high - seen.low), 1e-12);
    pp_elevation_clear(&elevation);
}

/* Four thousand blocks that a single wall hides completely: only the wall and the sky
 * above it remain. */
static void what_stands_behind_a_wall_makes_no_parts(void **state)
{
    (void)state;
    enum { COUNT = 4000 };
    static struct pp_elevation_obstruction all[COUNT + 1];
    uint64_t row = 3;
    for (int i = 0; i < COUNT; i++) {
        all[i] = random_obstruction(&row, i);
        all[i].outline.low = -INFINITY;
        all[i].outline.high = 0.3 + 0.6 * next(&row);
    }
    all[COUNT] = (struct pp_elevation_obstruction){
        .outline = {-INFINITY, INFINITY, -INFINITY, 0.93, 0.45},
        .distance_m = 0.7,
        .order = COUNT};
    struct pp_elevation elevation = {0};
    struct pp_elevation_obstructions obstructions = {COUNT + 1, all};
    assert_int_equal(pp_elevation_strips_cut(&elevation, &seen, &obstructions, NULL),
                     PP_OK);
    assert_int_equal(elevation.count, 2);
    assert_near(elevation.parts[0].high, 0.93, 0.0);
    assert_near(elevation.parts[0].reflectance, 0.45, 0.0);
    assert_true(isnan(elevation.parts[1].reflectance));
    assert_near(elevation.parts[1].right, seen.right, 0.0);
    pp_elevation_clear(&elevation);
}

/* Each of 40 obstructions is tested after all others have been added. Most stand on the
 * ground, as in real scenes. */
static void what_counts_as_covered_is_seen_nowhere(void **state)
{
    (void)state;
    enum { ROUNDS = 60, COUNT = 40, PLACES = 60 };
    uint64_t row = 23;
    int hidden = 0;
    for (int round = 0; round < ROUNDS; round++) {
        struct pp_elevation_obstruction all[COUNT];
        for (int i = 0; i < COUNT; i++)
            all[i] = random_obstruction(&row, i);
        for (int i = 0; i < COUNT; i++) {
            const struct pp_elevation_part *own = &all[i].outline;
            struct pp_elevation_cover cover;
            pp_elevation_cover_init(&cover, &seen);
            for (int k = 0; k < COUNT; k++)
                if (k != i)
                    pp_elevation_cover_add(&cover, &all[k].outline, all[k].distance_m);
            if (!pp_elevation_cover_hides(&cover, own->left, own->right, own->high,
                                          all[i].distance_m))
                continue;
            hidden++;
            double reflectance = own->reflectance;
            all[i].outline.reflectance =
                0.77; /* a reflectance that no other obstruction has */
            double left = fmax(own->left, seen.left), low = fmax(own->low, seen.low);
            double width = fmin(own->right, seen.right) - left;
            double height = fmin(own->high, seen.high) - low;
            for (int p = 0; p < PLACES && width > 0.0 && height > 0.0; p++) {
                double x = left + width * next(&row), z = low + height * next(&row);
                assert_true(seen_there(all, COUNT, x, z) != 0.77);
            }
            all[i].outline.reflectance = reflectance;
        }
    }
    assert_true(hidden > ROUNDS * COUNT / 10);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_place_shows_the_nearest_obstruction),
        cmocka_unit_test(the_parts_fill_the_opening),
        cmocka_unit_test(what_stands_behind_a_wall_makes_no_parts),
        cmocka_unit_test(what_counts_as_covered_is_seen_nowhere),
    };
    add_tests(tests, NULL, NULL);
}
