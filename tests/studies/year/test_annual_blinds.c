/* test_annual_blinds.c - the year of a room with blinds, screens and curtains in its
 * file. */
#include <stdlib.h>

#include "studies/year/annual.h"
#include "tests/lib/made_year.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<room version='1'><site ground='open'/><plan width='3.7' depth='5.3' "            \
    "height='2.9'/><finishes floor='0.2' walls='0.5' ceiling='0.7'/>"                  \
    "%s<point x='1.1' y='0.9'/><point x='1.9' y='2.6'/><point x='2.3' "                \
    "y='4.4'/></room>"
#define SOUTH(device)                                                                  \
    "<window wall='south' left='0.6' sill='0.9' width='2.3' height='1.7' "             \
    "transmittance='0.7'>" device "</window>"
#define SLATS "<blind slat-width='0.03' spacing='0.025' angle='-35' reflectance='0.6'/>"

/* The year of a room with these windows, under the mixed skies if `made` is NULL. */
static void year_of(struct pp_annual_sheet *sheet, const char *windows,
                    const struct pp_test_year *made,
                    const struct pp_annual_options *options)
{
    static struct pp_test_year mixed;
    char xml[2000];
    struct pp_outside_light light;
    if (!made)
        pp_test_make_mixed_year(&mixed);
    snprintf(xml, sizeof xml, ROOM, windows);
    struct pp_world *world = pp_test_lit_world(&light, xml);
    pp_test_year_of(sheet, world, &light, made ? made : &mixed, options);
    pp_world_destroy(world);
}

static void same_light(const float *a, const float *b, size_t count)
{
    for (size_t i = 0; i < count; i++)
        assert_true(a[i] == b[i]);
}

/* Open windows give the results of the room without its blind; windows closed at all
 * hours give those of the room as in the file, identical to the bit. */
static void a_blind_is_the_closed_state_of_its_window(void **state)
{
    (void)state;
    struct pp_annual_options options = pp_test_whole_day(32);
    struct pp_annual_sheet bare, drawn, never, always;
    options.blinds = PP_BLINDS_AS_DRAWN;
    year_of(&bare, SOUTH(""), NULL, &options);
    year_of(&drawn, SOUTH(SLATS), NULL, &options);
    options.blinds = PP_BLINDS_NEVER;
    year_of(&never, SOUTH(SLATS), NULL, &options);
    options.blinds = PP_BLINDS_ALWAYS;
    year_of(&always, SOUTH(SLATS), NULL, &options);
    size_t count = 3 * (size_t)bare.sky_count;
    same_light(never.lx, bare.lx, count);
    same_light(always.lx, drawn.lx, count);
    for (int x = 0; x < 3; x++) {
        assert_true(always.points[x].year_lxh.value == bare.points[x].year_lxh.value);
        assert_true(always.points[x].blinds_autonomy.value
                    == drawn.points[x].autonomy_300.value);
        assert_true(isnan(never.points[x].blinds_autonomy.value));
    }
    assert_true(drawn.points[2].autonomy_300.value < bare.points[2].autonomy_300.value);
    assert_near(always.groups[0].closed_h, 24.0, 1e-9);
    assert_string_equal(always.groups[0].device, "blind");
    assert_false(always.blinds_of_lm83);
    pp_annual_sheet_clear(&bare);
    pp_annual_sheet_clear(&drawn);
    pp_annual_sheet_clear(&never);
    pp_annual_sheet_clear(&always);
}

/* In another program slats fixed at an angle and slats scheduled at that angle gave
 * different daylight (EnergyPlus, issues 2898 and 2788). */
static void a_scheduled_blind_gives_the_light_of_a_fixed_one(void **state)
{
    (void)state;
    unsigned char hours[24];
    struct pp_annual_options options = pp_test_whole_day(16);
    struct pp_annual_sheet always, scheduled, open, part;
    options.blinds = PP_BLINDS_ALWAYS;
    year_of(&always, SOUTH(SLATS), NULL, &options);
    options.blinds = PP_BLINDS_SCHEDULE;
    options.schedule = hours;
    options.schedule_count = 24;
    memset(hours, 1, sizeof hours);
    year_of(&scheduled, SOUTH(SLATS), NULL, &options);
    memset(hours, 0, sizeof hours);
    year_of(&open, SOUTH(SLATS), NULL, &options);
    memset(hours, 1, 7);
    year_of(&part, SOUTH(SLATS), NULL, &options);
    same_light(scheduled.lx, always.lx, 72);
    for (int x = 0; x < 3; x++) {
        assert_true(open.points[x].blinds_autonomy.value
                    == open.points[x].autonomy_300.value);
        same_light(part.lx + x * 24, always.lx + x * 24, 7);
        same_light(part.lx + x * 24 + 7, open.lx + x * 24 + 7, 17);
    }
    assert_near(part.groups[0].closed_h, 7.0, 1e-9);
    pp_annual_sheet_clear(&always);
    pp_annual_sheet_clear(&scheduled);
    pp_annual_sheet_clear(&open);
    pp_annual_sheet_clear(&part);
}

/* In the file the room has a closed blind in the south and bare glass in the north. */
static void windows_close_one_by_one(void **state)
{
    (void)state;
    static const char windows[] = SOUTH(
        SLATS) "<window wall='north' left='0.9' sill='0.9' width='1.9' height='1.5' "
               "transmittance='0.6'/>";
    struct pp_annual_options options = pp_test_whole_day(32);
    struct pp_annual_sheet drawn, always;
    options.blinds = PP_BLINDS_AS_DRAWN;
    year_of(&drawn, windows, NULL, &options);
    options.blinds = PP_BLINDS_ALWAYS;
    year_of(&always, windows, NULL, &options);
    assert_int_equal(always.group_count, 2);
    assert_near(always.groups[0].closed_h, 24.0, 1e-9);
    assert_near(always.groups[1].closed_h, 0.0, 1e-9);
    assert_null(always.groups[1].device);
    same_light(always.lx, drawn.lx, 72);
    pp_annual_sheet_clear(&drawn);
    pp_annual_sheet_clear(&always);
}

/* Sun of 100 klx at an altitude of 30 degrees through glass of 0.70 gives 35,000 lx on
 * a horizontal plane. A screen with an openness of 0.05 leaves 1,750 lx, which exceeds
 * LM-83's limit of 1,000 lx; 0.02 leaves 700 lx. The limit is 1,000/35,000, 2.86 %. */
static void lm83_is_met_by_the_straight_light_of_a_screen(void **state)
{
    (void)state;
    static const struct {
        const char *window;
        double unmet_h;
    } cases[] = {
        {SOUTH("<screen openness='0.05' reflectance='0.5'/>"), 1.0},
        {SOUTH("<screen openness='0.029' reflectance='0.5'/>"), 1.0},
        {SOUTH("<screen openness='0.028' reflectance='0.5'/>"), 0.0},
        {SOUTH("<screen openness='0.02' reflectance='0.5'/>"), 0.0},
        {SOUTH("<curtain transmittance='0.05'/>"), 0.0},
        {SOUTH(""), 0.0}, /* LM-83's own blind is diffuse */
    };
    struct pp_test_year made;
    pp_test_make_year(&made);
    struct pp_perez_sky sky = {
        .b = -1.0, .sun = pp_test_toward(30.0, 180.0), .N = 3000.0};
    sky.diffuse_lx = PP_PI * sky.N;
    sky.direct_lx = 1e5;
    pp_test_add_hour(&made, &sky);
    struct pp_annual_options options = pp_test_whole_day(16);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct pp_annual_sheet sheet;
        year_of(&sheet, cases[i].window, &made, &options);
        float most = 0.0f;
        for (int x = 0; x < 3; x++)
            most = fmaxf(most, sheet.sun_lx[x]);
        assert_near(most, 35000.0,
                    700.0); /* 35,000 lx, with a transmittance of 0.7 at this angle */
        assert_near(sheet.groups[0].closed_h, 1.0, 1e-9);
        assert_near(sheet.groups[0].unmet_h, cases[i].unmet_h, 1e-9);
        assert_true(sheet.blinds_of_lm83);
        pp_annual_sheet_clear(&sheet);
    }
}

/* The plain year has neither patches nor cells. */
static void a_closed_blind_agrees_with_the_plain_year(void **state)
{
    (void)state;
    struct pp_annual_options options = pp_test_whole_day(128);
    struct pp_annual_sheet fast, plain;
    options.blinds = PP_BLINDS_ALWAYS;
    year_of(&fast, SOUTH(SLATS), NULL, &options);
    options.exact_sky = true;
    options.samples = 512;
    year_of(&plain, SOUTH(SLATS), NULL, &options);
    for (int x = 0; x < 3; x++) {
        double is = 0.0, expected = 0.0;
        for (int t = 0; t < 24; t++) {
            is += fast.lx[x * 24 + t];
            expected += plain.lx[x * 24 + t];
        }
        assert_near(is, expected, 0.02 * expected);
    }
    pp_annual_sheet_clear(&fast);
    pp_annual_sheet_clear(&plain);
}

/* The office of another program: light at a point with closed blinds of LM-83, lx per lx
 * on the outside of the wall; means of two mirrored points, each with a standard error of
 * 1.5 %. The brightness of the sky rises from hour to hour until the point has 300 lx. */
static void blinds_of_lm83_give_the_light_of_another_program(void **state)
{
    (void)state;
    enum { STEPS = 240, POINTS = 6 };
    static const double given[POINTS] = {0.048949, 0.025649, 0.013201,
                                         0.008401, 0.006378, 0.005554};
    const char *xml =
        "<room version='1'><site ground='open'/><plan width='4' depth='6' height='3'/>"
        "<finishes floor='0.2' walls='0.5' ceiling='0.7'/><window wall='south' "
        "left='0.5' sill='0.9' width='3' height='1.8' glazing='none' "
        "maintenance='0.65'/><point x='1.875' y='0.625'/><point x='1.875' y='1.625'/>"
        "<point x='1.875' y='2.875'/><point x='1.875' y='3.875'/><point x='1.875' "
        "y='4.875'/><point x='1.875' y='5.625'/></room>";
    double outside[STEPS];
    struct pp_test_year made;
    pp_test_make_year(&made);
    for (int i = 0; i < STEPS; i++) {
        struct pp_perez_sky sky = {.b = -1.0,
                                   .sun = pp_test_toward(30.0, 180.0),
                                   .N = 620.0 * pow(16.0, i / 239.0)};
        sky.diffuse_lx = PP_PI * sky.N;
        sky.direct_lx = 1.65 * sky.diffuse_lx;
        outside[i] = 0.6 * sky.diffuse_lx + 0.1 * sky.direct_lx * sin(30.0 * PP_RAD)
                     + sky.direct_lx * cos(30.0 * PP_RAD);
        pp_test_add_hour(&made, &sky);
    }
    struct pp_annual_options options = pp_test_whole_day(256);
    struct pp_annual_sheet sheet;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    pp_test_year_of(&sheet, world, &light, &made, &options);
    assert_near(sheet.groups[0].closed_h, STEPS, 1e-9);
    for (int x = 0; x < POINTS; x++) {
        int dark = (int)lround(STEPS * (1.0 - sheet.points[x].blinds_autonomy.value));
        assert_true(dark > 0 && dark < STEPS);
        assert_near(300.0 / sqrt(outside[dark - 1] * outside[dark]), given[x],
                    0.035 * given[x]);
    }
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_blind_is_the_closed_state_of_its_window),
        cmocka_unit_test(a_scheduled_blind_gives_the_light_of_a_fixed_one),
        cmocka_unit_test(windows_close_one_by_one),
        cmocka_unit_test(lm83_is_met_by_the_straight_light_of_a_screen),
        cmocka_unit_test(a_closed_blind_agrees_with_the_plain_year),
        cmocka_unit_test(blinds_of_lm83_give_the_light_of_another_program),
    };
    add_tests(tests, NULL, NULL);
}
