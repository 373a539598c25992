/* test_year_metrics.c - annual figures of a point from its illuminances. */
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include "studies/year/blind_groups.h"
#include "studies/year/year_metrics.h"

/* Eight lit hours of twelve occupied hours. */
static double occupied[] = {1, 1, 1, 1, 1, 1, 1, 1};
static double lengths[] = {1, 1, 1, 1, 1, 1, 1, 1};
static bool daylight[] = {true, true, true, true, true, true, false, false};
static const struct pp_year_clock twelve = {.sky_count = 8,
                                            .occupied_h = occupied,
                                            .length_h = lengths,
                                            .is_daylight = daylight,
                                            .all_occupied_h = 12.0,
                                            .median_rank = 2};
static const float E[] = {100.0f,  99.0f,   300.0f, 299.0f,
                          3000.0f, 3001.0f, 600.0f, 30.0f};
static const float sun[] = {0, 1000.0f, 1001.0f, 0, 0, 2000.0f, 0, 0};

static struct pp_annual_figures figures_of(void)
{
    static const double targets[] = {300.0, 600.0};
    struct pp_annual_figures figures;
    float space[8], zero[8] = {0};
    const struct pp_year_values values = {
        .open = E, .sky = E, .sun = sun, .sun_reflected = zero, .space = space};
    pp_year_metrics_of(&figures, &values, &twelve, targets, 2);
    return figures;
}

static void limits_belong_to_the_bins_that_they_should(void **state)
{
    (void)state;
    struct pp_annual_figures f = figures_of();
    assert_near(f.autonomy[0].value, 4.0 / 12.0, 1e-12); /* 300 counts, 299 does not */
    assert_near(f.autonomy[1].value, 3.0 / 12.0, 1e-12);
    assert_near(f.udi_below.value, 6.0 / 12.0, 1e-12); /* with the four dark hours */
    assert_near(f.udi_low.value, 2.0 / 12.0, 1e-12);
    assert_near(f.udi_good.value, 3.0 / 12.0, 1e-12); /* 3000 is useful */
    assert_near(f.udi_above.value, 1.0 / 12.0, 1e-12);
    assert_near(f.sun_h.value, 2.0, 0.0); /* more than 1000 */
    assert_true(isnan(f.blinds_autonomy.value));
}

/* Relative useful exposure by DIN 5034: the sum of min(E, target) divided by the
 * target. */
static void continuous_autonomy_gives_part_of_an_hour(void **state)
{
    (void)state;
    double sum = (100.0 + 99.0 + 300.0 + 299.0 + 300.0 + 300.0 + 300.0 + 30.0) / 300.0;
    assert_near(figures_of().continuous[0].value, sum / 12.0, 1e-9);
}

/* The third of six daylight hours: 3001, 3000, 300. */
static void the_median_is_of_daylight_hours(void **state)
{
    (void)state;
    assert_near(figures_of().median_lx.value, 300.0, 0.0);
}

/* For a mean, the jackknife gives the standard error of the mean, s / sqrt(n). */
static void the_jackknife_is_that_of_a_mean(void **state)
{
    (void)state;
    static const double x[] = {3.1, 2.7, 4.4, 3.9, 1.8};
    double without[5], sum = 0.0, squares = 0.0;
    for (int i = 0; i < 5; i++)
        sum += x[i];
    for (int i = 0; i < 5; i++) {
        without[i] = (sum - x[i]) / 4.0;
        squares += (x[i] - sum / 5.0) * (x[i] - sum / 5.0);
    }
    assert_near(pp_year_metrics_error(without, 5), sqrt(squares / 4.0 / 5.0), 1e-12);
    for (int i = 0; i < 5; i++)
        without[i] = 0.1;
    assert_near(pp_year_metrics_error(without, 5), 0.0, 0.0);
}

static void blinds_close_for_more_than_two_per_cent(void **state)
{
    (void)state;
    assert_false(pp_blind_groups_closes(2, 100));
    assert_true(pp_blind_groups_closes(3, 100));
    assert_false(pp_blind_groups_closes(0, 24));
    assert_true(pp_blind_groups_closes(1, 24));
    /* The sun is on one of 40 points, which is 2.5 %, but this point represents only
     * half a cell: 0.5 of 39.5. */
    assert_true(pp_blind_groups_closes(1, 40));
    assert_false(pp_blind_groups_closes(0.5, 39.5));
}

/* Windows in one wall: two bare ones, screens with two values of openness, a blind. The
 * closed blind of LM-83 is added to each: transmittances for uniform light are
 * multiplied. */
static void windows_with_their_own_devices_close_apart(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='9' depth='5' height='2.8'/>"
        "<window wall='south' left='0.3' sill='0.9' width='1' height='1.5'/>"
        "<window wall='south' left='1.8' sill='0.9' width='1' height='1.5'/>"
        "<window wall='south' left='3.3' sill='0.9' width='1' height='1.5'>"
        "<screen openness='0.05'/></window>"
        "<window wall='south' left='4.8' sill='0.9' width='1' height='1.5'>"
        "<screen openness='0.3'/></window>"
        "<window wall='south' left='6.3' sill='0.9' width='1' height='1.5'>"
        "<blind slat-width='0.08' spacing='0.08' reflectance='0'/></window>"
        "<point x='1' y='2'/></room>";
    static const int groups_of[] = {0, 0, 1, 2, 3};
    struct pp_world *world = pp_test_world(xml);
    struct pp_blind_groups groups;
    assert_int_equal(pp_blind_groups_of_world(&groups, world, NULL), PP_OK);
    assert_int_equal(groups.count, 4);
    for (int i = 0; i < 5; i++)
        assert_int_equal(groups.of_opening[i], groups_of[i]);
    assert_relative(groups.transmittance[1], 0.05 * groups.transmittance[0], 1e-12);
    assert_relative(groups.transmittance[2], 0.3 * groups.transmittance[0], 1e-12);
    /* Black slats as wide as their spacing, by crossed strings. */
    assert_relative(groups.transmittance[3],
                    (sqrt(2.0) - 1.0) * groups.transmittance[0], 1e-3);
    pp_blind_groups_clear(&groups);
    pp_world_destroy(world);
}

/* World of a room with `south` windows in one wall and `west` in another, each with its
 * own transmittance, and `blinds` in the north, each with its own tilt. */
static struct pp_world *room_of_many(int south, int west, int blinds)
{
    char xml[8000];
    int used = snprintf(xml, sizeof xml,
                        "<room version='1'><plan width='40' depth='40' height='3'/>"
                        "<point x='1' y='2'/>");
    for (int i = 0; i < south + west; i++)
        used +=
            snprintf(xml + used, sizeof xml - (size_t)used,
                     "<window wall='%s' left='%d' sill='1' width='1' height='1' "
                     "transmittance='%g' maintenance='1'/>",
                     i < south ? "south" : "west", 1 + 2 * (i % 18), 0.3 + 0.01 * i);
    for (int i = 0; i < blinds; i++)
        used += snprintf(xml + used, sizeof xml - (size_t)used,
                         "<window wall='north' left='%d' sill='1' width='1' height='1'>"
                         "<blind angle='%d'/></window>",
                         1 + 2 * i, i);
    snprintf(xml + used, sizeof xml - (size_t)used, "</room>");
    return pp_test_world(xml);
}

static void many_kinds_of_windows_close_by_wall(void **state)
{
    (void)state;
    struct pp_world *world = room_of_many(10, 7, 2);
    struct pp_blind_groups groups;
    assert_int_equal(pp_blind_groups_of_world(&groups, world, NULL), PP_OK);
    assert_int_equal(groups.grouping, PP_BLIND_GROUPS_BY_FACE);
    assert_int_equal(groups.count, 4);
    for (int i = 0; i < 19; i++)
        assert_int_equal(groups.of_opening[i], i < 10 ? 0 : i < 17 ? 1 : i - 15);
    double sum = 0.0; /* of equal areas */
    for (int i = 0; i < 10; i++)
        sum += world->openings[i].glass.diffuse * world->openings[i].frame_factor;
    assert_relative(groups.transmittance[0], sum / 10.0, 1e-9);
    pp_blind_groups_clear(&groups);
    pp_world_destroy(world);
}

static void scattering_windows_keep_their_own_groups_or_are_refused(void **state)
{
    (void)state;
    static const struct {
        int south, west, blinds;
        enum pp_status status;
    } rooms[] = {{0, 0, 16, PP_OK}, {3, 3, 15, PP_OK}, {1, 0, 16, PP_BAD_INPUT}};
    for (size_t k = 0; k < sizeof rooms / sizeof *rooms; k++) {
        struct pp_world *world =
            room_of_many(rooms[k].south, rooms[k].west, rooms[k].blinds);
        struct pp_blind_groups groups;
        assert_int_equal(pp_blind_groups_of_world(&groups, world, NULL),
                         rooms[k].status);
        if (rooms[k].status == PP_OK)
            assert_int_equal(groups.count, 16);
        pp_blind_groups_clear(&groups);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limits_belong_to_the_bins_that_they_should),
        cmocka_unit_test(continuous_autonomy_gives_part_of_an_hour),
        cmocka_unit_test(the_median_is_of_daylight_hours),
        cmocka_unit_test(the_jackknife_is_that_of_a_mean),
        cmocka_unit_test(blinds_close_for_more_than_two_per_cent),
        cmocka_unit_test(windows_with_their_own_devices_close_apart),
        cmocka_unit_test(many_kinds_of_windows_close_by_wall),
        cmocka_unit_test(scattering_windows_keep_their_own_groups_or_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
