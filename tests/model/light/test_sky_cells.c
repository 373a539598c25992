/* test_sky_cells.c - the cells of a sky contribute equally to a horizontal plane and
 * cover the sky. */
#include "model/light/sky_cells.h"

#include <stdlib.h>

#include "tests/lib/near.h"

/* Light of a cell on a horizontal plane divided by Eh, by the midpoint rule. */
static double light_of(const struct pp_sky *sky, const struct pp_sky_cell *cell)
{
    enum { N = 40 };
    double sum = 0.0, da = (cell->high - cell->low) / N,
           db = (cell->to - cell->from) / N;
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++) {
            double a = cell->low + (i + 0.5) * da, b = cell->from + (k + 0.5) * db;
            struct pp_vec3 u = pp_vec(cos(a) * sin(b), cos(a) * cos(b), sin(a));
            sum += pp_sky_luminance(sky, u) * sin(a) * cos(a) * da * db;
        }
    return sum;
}

/* In closed form: a ring's light is (3 s^2 + 4 s^3)/7 between its sines. */
static void cells_of_an_overcast_sky_are_equal_in_closed_form(void **state)
{
    (void)state;
    static const int counts[] = {1, 7, 200, 1000};
    struct pp_sky sky = pp_sky_overcast();
    for (int n = 0; n < 4; n++) {
        struct pp_sky_cell *cells;
        assert_int_equal(pp_sky_cells(&cells, &sky, counts[n], NULL), PP_OK);
        for (int i = 0; i < counts[n]; i++) {
            double s = sin(cells[i].low), t = sin(cells[i].high);
            double ring = (3.0 * (t * t - s * s) + 4.0 * (t * t * t - s * s * s)) / 7.0;
            assert_near(ring * (cells[i].to - cells[i].from) / (2.0 * PP_PI),
                        1.0 / counts[n], 1e-6);
            /* Half of the light is above the centre, except for a cell at the
             * zenith. */
            double m = sin(cells[i].altitude);
            if (cells[i].to - cells[i].from < 2.0 * PP_PI)
                assert_near((3.0 * m * m + 4.0 * m * m * m) / 7.0 - 0.5 * ring,
                            (3.0 * s * s + 4.0 * s * s * s) / 7.0, 1e-6);
        }
        free(cells);
    }
}

/* The sun's aureole makes cells small. The midpoint rule is accurate to a
 * thousandth. */
static void cells_of_a_clear_sky_are_equal_by_quadrature(void **state)
{
    (void)state;
    enum { COUNT = 150 };
    struct pp_sky sky;
    struct pp_sky_cell *cells;
    struct pp_vec3 sun = pp_vec_unit(pp_vec(0.3, -0.7, 0.6));
    assert_int_equal(pp_sky_iso(&sky, 12, sun, NULL), PP_OK);
    assert_int_equal(pp_sky_cells(&cells, &sky, COUNT, NULL), PP_OK);
    double sum = 0.0;
    for (int i = 0; i < COUNT; i++) {
        assert_near(light_of(&sky, &cells[i]) * COUNT, 1.0, 0.01);
        sum += light_of(&sky, &cells[i]);
        assert_true(cells[i].from <= cells[i].bearing
                    && cells[i].bearing <= cells[i].to);
        assert_true(cells[i].low < cells[i].altitude + 1e-12);
    }
    assert_near(sum, 1.0, 1e-3);
    free(cells);
}

static void cells_lie_side_by_side_down_to_the_horizon(void **state)
{
    (void)state;
    enum { COUNT = 333 };
    struct pp_sky sky = pp_sky_uniform();
    struct pp_sky_cell *cells;
    assert_int_equal(pp_sky_cells(&cells, &sky, COUNT, NULL), PP_OK);
    assert_near(cells[0].high, 0.5 * PP_PI, 1e-12);
    assert_near(cells[COUNT - 1].low, 0.0, 1e-9);
    assert_near(cells[COUNT - 1].to, 2.0 * PP_PI, 1e-9);
    for (int i = 1; i < COUNT; i++)
        if (cells[i].from > 1e-9) {
            assert_near(cells[i].from, cells[i - 1].to, 1e-9);
            assert_near(cells[i].low, cells[i - 1].low, 1e-12);
        } else {
            assert_near(cells[i].high, cells[i - 1].low, 1e-12);
            assert_near(cells[i - 1].to, 2.0 * PP_PI, 1e-9);
        }
    free(cells);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_of_an_overcast_sky_are_equal_in_closed_form),
        cmocka_unit_test(cells_of_a_clear_sky_are_equal_by_quadrature),
        cmocka_unit_test(cells_lie_side_by_side_down_to_the_horizon),
    };
    add_tests(tests, NULL, NULL);
}
