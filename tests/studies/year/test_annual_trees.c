/* test_annual_trees.c - a year in which trees lose their leaves. */
#include <stdlib.h>

#include "tests/lib/made_year.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<room version='1'><site bare-from='2' bare-to='12'><tree x='1.5' y='-6' "         \
    "height='9' crown-width='7' transmittance='%s' winter-transmittance='%s'/></site>" \
    "<plan width='3.7' depth='5.3' height='2.9'/>"                                     \
    "<window wall='south' left='0.6' sill='0.9' width='2.3' height='1.7' "             \
    "transmittance='0.7'>%s</window><point x='1.1' y='0.9'/>"                          \
    "<point x='2.3' y='4.4'/></room>"

enum { POINTS = 2, HOURS = 24, LEAFY = 20 /* hours of January; the others are bare */ };

static void year_with(struct pp_annual_sheet *sheet, const char *leafy,
                      const char *bare, const char *device, enum pp_blinds blinds,
                      int samples, bool exact)
{
    struct pp_test_year mixed;
    struct pp_annual_options options = pp_test_whole_day(samples);
    struct pp_outside_light light;
    char xml[2000];
    pp_test_make_mixed_year(&mixed);
    options.blinds = blinds;
    options.exact_sky = exact;
    snprintf(xml, sizeof xml, ROOM, leafy, bare, device);
    struct pp_world *world = pp_test_lit_world(&light, xml);
    pp_test_year_of(sheet, world, &light, &mixed, &options);
    pp_world_destroy(world);
}

/* To the bit: each hour is that of a room whose trees are always as in that season. */
static void check_seasons(const char *device, enum pp_blinds blinds)
{
    struct pp_annual_sheet leafy, bare, both;
    year_with(&leafy, "0.1", "0.1", device, blinds, 32, false);
    year_with(&bare, "0.6", "0.6", device, blinds, 32, false);
    year_with(&both, "0.1", "0.6", device, blinds, 32, false);
    int differ = 0;
    for (int x = 0; x < POINTS; x++)
        for (int t = 0; t < HOURS; t++) {
            int i = x * HOURS + t;
            assert_true(both.lx[i] == (t < LEAFY ? leafy.lx[i] : bare.lx[i]));
            differ += leafy.lx[i] != bare.lx[i];
        }
    assert_true(differ > HOURS);
    pp_annual_sheet_clear(&leafy);
    pp_annual_sheet_clear(&bare);
    pp_annual_sheet_clear(&both);
}

static void each_hour_has_the_trees_of_its_season(void **state)
{
    (void)state;
    check_seasons("", PP_BLINDS_AS_DRAWN);
}

static void so_have_closed_blinds(void **state)
{
    (void)state;
    check_seasons("<screen openness='0.2'/>", PP_BLINDS_ALWAYS);
}

/* The plain year has neither patches nor cells. */
static void light_through_crowns_agrees_with_the_plain_year(void **state)
{
    (void)state;
    struct pp_annual_sheet fast, plain;
    year_with(&fast, "0.1", "0.6", "", PP_BLINDS_AS_DRAWN, 128, false);
    year_with(&plain, "0.1", "0.6", "", PP_BLINDS_AS_DRAWN, 512, true);
    for (int x = 0; x < POINTS; x++) {
        double is = 0.0, expected = 0.0;
        for (int t = 0; t < HOURS; t++) {
            is += fast.lx[x * HOURS + t];
            expected += plain.lx[x * HOURS + t];
        }
        assert_near(is, expected, 0.02 * expected);
    }
    pp_annual_sheet_clear(&fast);
    pp_annual_sheet_clear(&plain);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_hour_has_the_trees_of_its_season),
        cmocka_unit_test(so_have_closed_blinds),
        cmocka_unit_test(light_through_crowns_agrees_with_the_plain_year),
    };
    add_tests(tests, NULL, NULL);
}
