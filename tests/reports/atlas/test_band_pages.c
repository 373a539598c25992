/* test_band_pages.c - the pages on accuracy contain every regime of the compiled
 * tables, with the bias that follows from its median. */
#include "tests/lib/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reports/atlas/band_pages.h"
#include "studies/bands/band_table.h"

/* In a separate buffer, because of a false warning of gcc about that of the stream. */
static char *pages(void)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    assert_non_null(out);
    pp_band_pages(out);
    fclose(out);
    char *copy = calloc(length + 1, 1);
    assert_non_null(copy);
    memcpy(copy, text, length);
    free(text);
    return copy;
}

static const struct pp_band_table *const tables[] = {&pp_band_table_overcast,
                                                     &pp_band_table_iso};

static int records(void)
{
    struct pp_band_record record;
    int all = 0;
    for (int t = 0; t < 2; t++) {
        int count = 0;
        while (pp_band_table_at(&record, tables[t], count))
            count++;
        assert_true(count > 0);
        all += count;
    }
    return all;
}

/* True if a table has a regime with this number of rooms, band and bias. */
static bool is_known(int rooms, double bias, double low, double high)
{
    struct pp_band_record record;
    for (int t = 0; t < 2; t++)
        for (int i = 0; pp_band_table_at(&record, tables[t], i); i++) {
            const struct pp_band_regime *regime = &record.entry.regime;
            double middle = regime->ratio.median;
            if (regime->rooms == rooms && fabs(regime->ratio.low - low) < 0.0051
                && fabs(regime->ratio.high - high) < 0.0051
                && fabs((1.0 - middle) / middle - bias / 100.0) < 0.0051)
                return true;
        }
    return false;
}

/* Reads "| words | rooms | bias % | spread | low to high | ...". */
static bool read_row(const char *line, int *rooms, double *bias, double *low,
                     double *high)
{
    char words[400];
    double spread;
    return sscanf(line, "| %399[^|]| %d | %lf %% | %lf | %lf to %lf |", words, rooms,
                  bias, &spread, low, high)
           == 6;
}

/* A ratio of true value to figure of 1/2 is a figure 100 % too high: the bias is that
 * of the figure relative to the true value. */
static void every_regime_is_a_row_with_the_figure_s_bias(void **state)
{
    (void)state;
    char *text = pages(), *rest, *line;
    int rows = 0, known = 0;
    for (line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest)) {
        int rooms;
        double bias, low, high;
        if (!read_row(line, &rooms, &bias, &low, &high))
            continue;
        rows++;
        known += is_known(rooms, bias, low, high);
    }
    assert_int_equal(rows, records());
    assert_int_equal(known, rows);
    free(text);
}

/* Position of a heading; -1: none. */
static long place_of(const char *text, const char *heading)
{
    const char *found = strstr(text, heading);
    return found ? (long)(found - text) : -1;
}

static void daylight_factors_come_first(void **state)
{
    (void)state;
    char *text = pages();
    long df = place_of(text, "\n## Daylight factor, overcast sky\n");
    long sky = place_of(text, "\n## Sky component, overcast sky\n");
    long others = place_of(text, "\n## Daylight factor, skies of ISO 15469\n");
    free(text);
    assert_true(df > 0 && df < sky && sky < others);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_regime_is_a_row_with_the_figure_s_bias),
        cmocka_unit_test(daylight_factors_come_first),
    };
    add_tests(tests, NULL, NULL);
}
