/* test_cache_agree.c - smoothing of records with their neighbours: noise decreases,
 * exact values do not change, and records with different surroundings keep their own
 * values. */
#include <stdlib.h>

#include "simulate/cache/cache_parts.h"
#include "simulate/cache/cache_smooth.h"
#include "simulate/sampling/hash.h"
#include "tests/lib/near.h"

enum { SIDE = 9, COUNT = SIDE * SIDE };
static const double STEP_M = 0.31, NOISE = 0.02;

/* A layer without records. */
static void make(struct pp_cache_layer *layer)
{
    *layer = (struct pp_cache_layer){.settings = {.noise = NOISE, .most_m = 1e-9}};
    assert_int_equal(
        pp_cache_octree_init(&layer->tree, pp_vec(-1.0, -1.0, -1.0), 8.0, NULL), PP_OK);
}

static void clear(struct pp_cache_layer *layer)
{
    pp_cache_octree_clear(&layer->tree);
    free(layer->entries);
}

/* Pseudo-random number between -1 and 1, the same for each run. */
static double random_of(uint64_t i)
{
    return 2.0 * (double)(pp_hash(i, 5) >> 11) * 0x1p-53 - 1.0;
}

/* At the edge of its ellipse a record may deviate from its tangent by a tenth of the
 * noise. */
static struct pp_cache_entry record_at(double x, double y, double value, double along_x)
{
    struct pp_cache_entry entry = {
        .is = {.point = {x, y, 0.0},
               .normal = {0.0, 0.0, 1.0},
               .value = pp_rgb(value, 0.7 * value, 0.3 * value),
               .along = {{along_x, 0.0, 0.0},
                         {0.7 * along_x, 0.0, 0.0},
                         {0.3 * along_x, 0.0, 0.0}},
               .axes = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
               .radii_m = {STEP_M, 1.2 * STEP_M}},
        .a = {1.0, 0.0, 0.0},
        .b = {0.0, 1.0, 0.0},
        .along_noise = 1.0 / STEP_M,
        .curvature = 0.2 * NOISE / (STEP_M * STEP_M)};
    for (int i = 0; i < PP_CACHE_SECTORS; i++)
        entry.horizon_m[i] = INFINITY;
    return entry;
}

/* E = 2.3 + 0.4 x on the floor, by records as far apart as their shorter radius, with
 * this relative noise in values and gradients. */
static void fill(struct pp_cache_layer *layer, double noise)
{
    for (int i = 0; i < COUNT; i++) {
        double x = i % SIDE * STEP_M, y = i / SIDE * STEP_M, e = 2.3 + 0.4 * x;
        double off = noise * random_of((uint64_t)i);
        double steeper = noise * random_of((uint64_t)i + COUNT) / STEP_M;
        struct pp_cache_entry entry =
            record_at(x, y, e * (1.0 + off), 0.4 + e * steeper);
        assert_int_equal(pp_cache_layer_put(layer, &entry, NULL), PP_OK);
    }
}

static double value_at(const struct pp_cache_layer *layer, double x, double y)
{
    const struct pp_cache_place place = {{x, y, 0.0}, {0.0, 0.0, 1.0}, PP_ANYWHERE};
    struct pp_rgb value = pp_rgb_grey(-1.0);
    assert_true(pp_cache_layer_read(layer, &place, &value));
    return value.g / 0.7;
}

/* Root mean square of the relative errors of values read at a grid of points. */
static double error_of(const struct pp_cache_layer *layer)
{
    double sum = 0.0;
    int count = 0;
    for (double y = 0.05; y < 2.4; y += 0.083)
        for (double x = 0.05; x < 2.4; x += 0.083, count++) {
            double e = 2.3 + 0.4 * x, off = value_at(layer, x, y) / e - 1.0;
            sum += off * off;
        }
    return sqrt(sum / count);
}

static void smooth(struct pp_cache_layer *layer)
{
    struct pp_thread_pool *pool;
    assert_int_equal(pp_thread_pool_create(&pool, 2, NULL), PP_OK);
    assert_int_equal(pp_cache_smooth_layer(layer, pool, NULL), PP_OK);
    pp_thread_pool_destroy(pool);
}

static void a_plane_of_light_stays_what_it_is(void **state)
{
    (void)state;
    struct pp_cache_layer layer;
    make(&layer);
    fill(&layer, 0.0);
    smooth(&layer);
    assert_near(error_of(&layer), 0.0, 1e-12); /* exact but for rounding */
    clear(&layer);
}

/* Averaging records with their neighbours reduces the noise by more than half. A
 * repetition changes nothing, since it starts from the original values of the
 * records. */
static void noise_becomes_less(void **state)
{
    (void)state;
    struct pp_cache_layer layer;
    make(&layer);
    fill(&layer, NOISE);
    double before = error_of(&layer);
    smooth(&layer);
    double after = error_of(&layer);
    assert_true(after < 0.5 * before);
    smooth(&layer);
    assert_near(error_of(&layer), after, 0.0);
    clear(&layer);
}

/* A record that is much darker than its neighbours, one that is much brighter, and one
 * with walls around it at 0.1 m keep their values and do not change a neighbour. */
static void what_sees_something_else_stands_alone(void **state)
{
    (void)state;
    for (int dark = 0; dark < 3; dark++) {
        struct pp_cache_layer layer;
        make(&layer);
        fill(&layer, 0.0);
        struct pp_cache_record *odd = &layer.entries[40].is;
        double value = dark == 0 ? 0.002 : dark == 1 ? 900.0 : 2.5;
        odd->value = pp_rgb_grey(value);
        if (dark == 2)
            for (int i = 0; i < PP_CACHE_SECTORS; i++)
                layer.entries[40].horizon_m[i] = 0.1;
        smooth(&layer);
        assert_near(layer.entries[40].value.g, value, 1e-12 * value);
        assert_near(layer.entries[41].value.r, layer.entries[41].is.value.r, 1e-12);
        clear(&layer);
    }
}

/* If the light can change by more than the noise, every record keeps its own value. */
static void where_light_changes_quickly_neighbours_have_no_say(void **state)
{
    (void)state;
    struct pp_cache_layer layer;
    make(&layer);
    fill(&layer, NOISE);
    for (int i = 0; i < COUNT; i++)
        layer.entries[i].curvature *= 1000.0;
    smooth(&layer);
    for (int i = 0; i < COUNT; i++)
        assert_near(layer.entries[i].value.b, layer.entries[i].is.value.b, 1e-12);
    clear(&layer);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_of_light_stays_what_it_is),
        cmocka_unit_test(noise_becomes_less),
        cmocka_unit_test(what_sees_something_else_stands_alone),
        cmocka_unit_test(where_light_changes_quickly_neighbours_have_no_say),
    };
    add_tests(tests, NULL, NULL);
}
