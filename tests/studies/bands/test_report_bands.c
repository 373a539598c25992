/* test_report_bands.c - likely ranges from the atlas for the figures of a room, and the
 * advice derived from them: calculated from the table, and for rooms that the atlas
 * does not cover. */
#include "studies/bands/report_bands.h"

#include <stdlib.h>
#include <string.h>

#include "studies/bands/advice.h"
#include "studies/bands/band_table.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<plan width='4.3' depth='6.1' height='2.9'/>"                                     \
    "<window wall='south' left='0.7' sill='0.9' width='2.3' height='1.7'/>"            \
    "<point x='2.1' y='1.7'/><point x='2.1' y='4.7'/>"

static const char hall[] = "<room version='1'>" ROOM "</room>";

/* Made-up figures of a room: a pair with its parts, a simulated column, two
 * averages. */
struct made {
    struct pp_world *world;
    struct pp_receiver receivers[2];
    struct pp_report report;
};

static void add(struct made *m, enum pp_component component, const char *name,
                double near, double far)
{
    struct pp_column *column = pp_report_add(&m->report, component, name, true);
    assert_non_null(column);
    column->average = pp_reading_of((near + far) / 2.0);
    column->points[0] = pp_reading_of(near);
    column->points[1] = pp_reading_of(far);
}

static void make(struct made *m, const char *xml)
{
    struct pp_outside_light light;
    *m = (struct made){.world = pp_test_lit_world(&light, xml)};
    for (int i = 0; i < 2; i++)
        m->receivers[i] = (struct pp_receiver){.position = {2.1, i ? 4.7 : 1.7, 0.85},
                                               .normal = {0.0, 0.0, 1.0}};
    m->report = (struct pp_report){.world = m->world,
                                   .light = light,
                                   .receivers = m->receivers,
                                   .receiver_count = 2,
                                   .finished = true};
    add(m, PP_SC, "exact", 0.061, 0.004);
    add(m, PP_ERC, "exact", 0.0, 0.0);
    add(m, PP_IRC, "bre", 0.009, 0.009);
    add(m, PP_DF, "exact+bre", 0.070, 0.013);
    add(m, PP_DF, "nobody", 0.070, 0.013);
}

static void clear(struct made *m)
{
    pp_report_clear(&m->report);
    pp_world_destroy(m->world);
}

/* The limits of a band are the quantiles of the room's regime applied to the hand
 * figure h: (h + a) q - a, calculated here. */
static void a_band_is_the_table_s_quantiles_on_the_figure(void **state)
{
    (void)state;
    struct made m;
    struct pp_band_index index;
    struct pp_band_regimes regimes;
    double features[PP_BAND_FEATURES];
    const char *why;
    make(&m, hall);
    assert_int_equal(pp_report_bands_fill(&m.report, NULL), PP_OK);
    assert_null(m.report.no_bands);
    const struct pp_column *column = pp_report_find(&m.report, PP_DF, "exact+bre");
    assert_non_null(column->bands);
    const struct pp_band_columns columns = pp_band_features_columns(&m.report, column);
    pp_band_table_index(&index, &pp_band_table_overcast);
    pp_band_table_find(&regimes, &index, PP_DF, "exact+bre");
    assert_true(regimes.count[PP_BAND_POINT] > 1);
    assert_int_equal(pp_report_bands_features(features, &why, &m.report, NULL), PP_OK);
    for (int i = 0; i < 2; i++) {
        assert_true(pp_report_bands_point(features, &m.report, i));
        pp_band_features_of_columns(features, &columns, i);
        const struct pp_band_record *record =
            pp_band_table_regime(&regimes, PP_BAND_POINT, features);
        assert_non_null(record);
        double h = column->points[i].value, a = PP_BAND_OFFSET;
        const struct pp_band_quantiles *q = &record->entry.regime.ratio;
        assert_near(column->bands[i].low, fmax((h + a) * q->low - a, 0.0), 1e-15);
        assert_near(column->bands[i].high, (h + a) * q->high - a, 1e-15);
        assert_true(column->bands[i].low < column->bands[i].high);
    }
    assert_true(pp_band_is_known(column->average_band));
    assert_null(pp_report_find(&m.report, PP_DF, "nobody")->bands);
    clear(&m);
}

/* pp_band_table_find stops at the first row of another column. */
static void the_rows_of_a_column_stand_together(void **state)
{
    (void)state;
    const struct pp_band_table *tables[] = {&pp_band_table_overcast,
                                            &pp_band_table_iso};
    for (int t = 0; t < 2; t++) {
        struct pp_band_record record, other;
        struct pp_band_index index;
        pp_band_table_index(&index, tables[t]);
        for (int i = 0; pp_band_table_at(&record, tables[t], i); i++) {
            struct pp_band_regimes regimes;
            int count[PP_BAND_PLACES] = {0};
            for (int k = 0; pp_band_table_at(&other, tables[t], k); k++)
                if (other.component == record.component
                    && strcmp(other.column, record.column) == 0)
                    count[other.place]++;
            pp_band_table_find(&regimes, &index, record.component, record.column);
            for (int place = 0; place < PP_BAND_PLACES; place++)
                assert_int_equal(regimes.count[place], count[place]);
            i += count[PP_BAND_POINT] / 2; /* the same column once or twice more */
        }
    }
}

static void a_point_that_does_not_face_up_has_no_band(void **state)
{
    (void)state;
    struct made m;
    make(&m, hall);
    m.receivers[1].normal = (struct pp_vec3){0.0, -1.0, 0.0};
    assert_int_equal(pp_report_bands_fill(&m.report, NULL), PP_OK);
    const struct pp_column *column = pp_report_find(&m.report, PP_DF, "exact+bre");
    assert_true(pp_band_is_known(column->bands[0]));
    assert_false(pp_band_is_known(column->bands[1]));
    clear(&m);
}

/* Each of these rooms is reported with a reason that contains the word, and has no
 * band. */
static void rooms_outside_the_atlas_have_a_reason_and_no_band(void **state)
{
    (void)state;
    static const struct {
        const char *xml, *why;
    } rooms[] = {
        {"<room version='1'><sky type='uniform'/>" ROOM "</room>", "overcast"},
        {"<room version='1'><site ground='open'/>" ROOM "</room>", "unshaded"},
        {"<room version='1'>" ROOM "<dado height='1.1' reflectance='0.27'/></room>",
         "dado"},
        {"<room version='1'>" ROOM
         "<window wall='north' left='1' sill='0.9' width='0.6' height='1'>"
         "<screen openness='0.1'/></window></room>",
         "screen"},
        {"<room version='1'><plan width='43' depth='61' height='2.9'/>"
         "<window wall='south' left='0.7' sill='0.9' width='2.3' height='1.7'/></room>",
         "the atlas covers"},
    };
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        struct made m;
        make(&m, rooms[i].xml);
        assert_int_equal(pp_report_bands_fill(&m.report, NULL), PP_OK);
        assert_non_null(m.report.no_bands);
        assert_non_null(strstr(m.report.no_bands, rooms[i].why));
        assert_null(pp_report_find(&m.report, PP_DF, "exact+bre")->bands);
        struct pp_advice advice;
        assert_int_equal(pp_advice_of(&advice, &m.report, NULL), PP_OK);
        assert_int_equal(advice.count, 0);
        assert_non_null(strstr(advice.why_not, rooms[i].why));
        pp_advice_clear(&advice);
        clear(&m);
    }
}

/* A dado slightly darker than the wall of 0.5 behind it, and two darker by 0.2, which
 * does not exceed the limit. */
static void a_dado_like_its_wall_leaves_the_bands(void **state)
{
    (void)state;
    static const char *const rooms[] = {
        "<room version='1'>" ROOM "<dado height='1.1' reflectance='0.33'/></room>",
        "<room version='1'>" ROOM "<dado height='1.1' reflectance='0.3'/></room>",
        "<room version='1'>" ROOM "<finishes walls='0.8'/>"
        "<dado height='1.1' reflectance='0.6'/></room>",
    };
    for (size_t i = 0; i < sizeof rooms / sizeof *rooms; i++) {
        struct made m;
        make(&m, rooms[i]);
        assert_int_equal(pp_report_bands_fill(&m.report, NULL), PP_OK);
        assert_null(m.report.no_bands);
        clear(&m);
    }
}

static double width_of(struct pp_band_ends band, double figure)
{
    double a = PP_BAND_OFFSET;
    return log((band.high + a) / (figure + a)) - log((band.low + a) / (figure + a));
}

/* Two pairs at two points: no recommended method has a band more than 1.25 times as
 * wide as that of another, and there is one recommendation for every point. */
static void advice_is_the_method_of_the_narrowest_band(void **state)
{
    (void)state;
    struct made m;
    struct pp_advice advice;
    make(&m, hall);
    add(&m, PP_IRC, "irc-atlas", 0.012, 0.004);
    add(&m, PP_DF, "exact+irc-atlas", 0.073, 0.008);
    assert_int_equal(pp_report_bands_fill(&m.report, NULL), PP_OK);
    assert_int_equal(pp_advice_of(&advice, &m.report, NULL), PP_OK);
    assert_true(advice.count > 0);
    int seen[2] = {0, 0};
    for (int i = 0; i < advice.count; i++) {
        const struct pp_advice_item *item = &advice.items[i];
        assert_true(!item->of_average || i == 0);
        for (int k = 0; k < item->point_count && !item->of_average; k++) {
            int point = item->points[k];
            const struct pp_column *best =
                pp_report_find(&m.report, PP_DF, item->best.column);
            assert_non_null(best);
            double width = width_of(best->bands[point], best->points[point].value);
            for (int c = 0; c < m.report.column_count; c++) {
                const struct pp_column *other = &m.report.columns[c];
                if (other->component == PP_DF && other->bands)
                    assert_true(width <= 1.25
                                                 * width_of(other->bands[point],
                                                            other->points[point].value)
                                             + 1e-9);
            }
            seen[point]++;
        }
    }
    assert_int_equal(seen[0], 1);
    assert_int_equal(seen[1], 1);
    pp_advice_clear(&advice);
    clear(&m);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_band_is_the_table_s_quantiles_on_the_figure),
        cmocka_unit_test(the_rows_of_a_column_stand_together),
        cmocka_unit_test(a_point_that_does_not_face_up_has_no_band),
        cmocka_unit_test(rooms_outside_the_atlas_have_a_reason_and_no_band),
        cmocka_unit_test(a_dado_like_its_wall_leaves_the_bands),
        cmocka_unit_test(advice_is_the_method_of_the_narrowest_band),
    };
    add_tests(tests, NULL, NULL);
}
