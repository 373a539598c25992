/* test_waldram_site.c - sites drawn for a vertical receiver: areas of sky are the
 * vertical sky component; counts of squares and marks have no bias. */
#include <stdio.h>

#include "methods/exact/exterior.h"
#include "methods/waldram/skylight_indicator_fill.h"
#include "methods/waldram/waldram_sheet_fill.h"
#include "methods/waldram/waldram_site.h"
#include "methods/waldram/waldram_squares.h"
#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"

static const struct pp_vec3 south = {0.0, -1.0, 0.0};

static struct pp_waldram upright(struct pp_sky sky)
{
    struct pp_waldram waldram;
    assert_int_equal(pp_waldram_scale_init_upright(&waldram, &sky, south, NULL), PP_OK);
    return waldram;
}

/* 3/14 + 4/(7 pi) under the overcast sky, half under the uniform sky: 396 squares of
 * 0.1 %. */
static void the_whole_diagram_is_the_open_skys_vertical_component(void **state)
{
    (void)state;
    struct pp_waldram overcast = upright(pp_sky_overcast());
    struct pp_waldram uniform = upright(pp_sky_uniform());
    assert_near(pp_waldram_scale_total_area(&overcast), 0.396177, 5e-7);
    assert_near(pp_waldram_scale_total_area(&overcast) / PP_WALDRAM_WORTH, 396.2, 0.05);
    assert_near(pp_waldram_scale_total_area(&uniform), 0.5, 1e-12);
}

/* Altitudes of equal shares of the diagram for the overcast sky, by a sum of L cos^2 in
 * steps of a thousandth of a degree. */
static void ordinates_are_the_sum_of_luminance_and_cosines(void **state)
{
    (void)state;
    struct pp_waldram waldram = upright(pp_sky_overcast());
    double sum = 0.0, step = 1e-3 * PP_RAD;
    for (int i = 0; i < 90000; i++) {
        double altitude = (i + 0.5) * step, c = cos(altitude);
        sum += (1.0 + 2.0 * sin(altitude)) / 3.0 * 9.0 / (7.0 * PP_PI) * c * c * step;
        if (i % 7919 == 0)
            assert_near(pp_waldram_scale_y(&waldram, (i + 1) * step), sum, 1e-9);
    }
    assert_near(pp_waldram_scale_x(&waldram, PP_PI / 6.0), 0.5, 1e-12);
}

static void ordinates_of_measured_skies_are_tabulated_alike(void **state)
{
    (void)state;
    struct pp_sky first;
    assert_int_equal(pp_sky_iso(&first, 1, pp_vec(0, 0, 1), NULL), PP_OK);
    struct pp_waldram waldram = upright(first);
    assert_near(pp_waldram_scale_total_area(&waldram), pp_sky_on_plane(&first, south),
                1e-7);
}

/* A room whose window faces one of four directions, with up to four blocks, a skyline
 * or a balcony in front of it. */
static struct pp_world *deal_site(struct dice *dice)
{
    static const char *const walls[] = {"south", "east", "north", "west"};
    char xml[2400];
    const char *wall = walls[(int)between(dice, 0.0, 4.0)];
    int length = snprintf(
        xml, sizeof xml,
        "<room version=\"1\"><plan width=\"4.3\" depth=\"4.3\" height=\"2.9\"/>"
        "<window wall=\"%s\" left=\"%.3f\" sill=\"%.3f\" width=\"1.3\" "
        "height=\"1.1\"/>",
        wall, between(dice, 0.3, 2.6), between(dice, 0.4, 1.6));
    for (int i = (int)between(dice, 0.0, 5.0); i > 0; i--) {
        double around = between(dice, 0.0, 2.0 * PP_PI), far = between(dice, 9.0, 30.0);
        length += snprintf(xml + length, sizeof xml - (size_t)length,
                           "<block x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" depth=\"%.3f\" "
                           "height=\"%.3f\" base=\"%.3f\" rotate=\"%.3f\"/>",
                           2.1 + far * cos(around), 2.1 + far * sin(around),
                           between(dice, 1.0, 5.0), between(dice, 1.0, 5.0),
                           between(dice, 2.0, 30.0), one_in(dice, 4) ? 3.0 : 0.0,
                           between(dice, 0.0, 90.0));
    }
    if (one_in(dice, 3))
        length += snprintf(xml + length, sizeof xml - (size_t)length,
                           "<skyline wall=\"%s\" angle=\"%.3f\"/>", wall,
                           between(dice, 5.0, 60.0));
    if (one_in(dice, 3)) {
        double z = between(dice, 3.0, 4.0), out = between(dice, 0.5, 2.0);
        length += snprintf(
            xml + length, sizeof xml - (size_t)length,
            "<surface reflectance=\"0.3\"><vertex x=\"%.3f\" y=\"%.3f\" z=\"%.3f\"/>"
            "<vertex x=\"%.3f\" y=\"%.3f\" z=\"%.3f\"/><vertex x=\"%.3f\" y=\"%.3f\" "
            "z=\"%.3f\"/><vertex x=\"%.3f\" y=\"%.3f\" z=\"%.3f\"/></surface>",
            -out, -out, z, 4.3 + out, -out, z, 4.3 + out, 4.3 + out, z, -out, 4.3 + out,
            z);
    }
    snprintf(xml + length, sizeof xml - (size_t)length,
             "<point x=\"2\" y=\"2\"/></room>");
    return pp_test_world(xml);
}

/* Sum of differences between counts and the exact area. */
struct bias {
    double sum, sum2;
    int count;
};

static void note(struct bias *bias, double error)
{
    bias->sum += error;
    bias->sum2 += error * error;
    bias->count++;
}

static double mean_of(const struct bias *bias)
{
    return bias->sum / bias->count;
}

static double spread_of(const struct bias *bias)
{
    return sqrt(bias->sum2 / bias->count - mean_of(bias) * mean_of(bias));
}

/* No bias beyond three standard errors of the mean. */
static void assert_unbiased(const struct bias *bias)
{
    assert_true(fabs(mean_of(bias)) <= 3.0 * spread_of(bias) / sqrt(bias->count));
}

static double counted(const struct pp_waldram *waldram, const struct pp_region *sky)
{
    struct pp_waldram_count count;
    assert_int_equal(pp_waldram_squares_count_outline(&count, waldram, sky, NULL),
                     PP_OK);
    double squares = count.squares;
    pp_waldram_squares_clear(&count);
    return squares * PP_WALDRAM_WORTH;
}

static double marked(const struct pp_world *world)
{
    struct pp_skylight_indicator_sheet sheet;
    assert_int_equal(pp_skylight_indicator_fill_site(&sheet, world, 0, NULL), PP_OK);
    double share = sheet.sky_component;
    pp_skylight_indicator_sheet_clear(&sheet);
    return share;
}

/* Joined outlines, drawn to a thousandth of a square's side, keep their areas and
 * together fill the diagram. */
static void assert_joined(struct pp_waldram_site *site, double exact, double whole)
{
    assert_int_equal(pp_waldram_site_join(site, NULL), PP_OK);
    assert_near(pp_region_area(&site->sky), exact, 1e-5);
    assert_near(pp_region_area(&site->sky) + pp_region_area(&site->hidden), whole,
                1e-5);
}

/* The rounding of squares is carried over, which leaves an error of 0.05 squares; 80
 * marks of 0.5 % leave an error of less than three marks. */
static void areas_of_random_sites_are_their_vertical_sky_component(void **state)
{
    (void)state;
    struct dice dice = {20};
    struct bias squares = {0}, marks = {0};
    for (int i = 0; i < PP_SIZED(2000, 1000, 400); i++) {
        struct pp_world *world = deal_site(&dice);
        const struct pp_sky overcast = pp_sky_overcast();
        struct pp_vec3 facing = pp_vec_scale(world->openings[0].inner.normal, -1.0);
        double exact;
        assert_int_equal(pp_exterior_sky_on_plane(&exact, world, world->openings,
                                                  facing, &overcast, NULL),
                         PP_OK);
        struct pp_waldram waldram;
        struct pp_waldram_site site;
        assert_int_equal(
            pp_waldram_scale_init_upright(&waldram, &overcast, facing, NULL), PP_OK);
        assert_int_equal(
            pp_waldram_site_init(&site, &waldram, world,
                                 pp_exterior_opening_centroid(world->openings),
                                 world->openings[0].face, NULL),
            PP_OK);
        assert_near(site.sky_component, exact, 1e-6);
        /* The open sky always has 396.2 squares. */
        double whole = pp_waldram_scale_total_area(&waldram);
        if (exact < whole - 1e-9) {
            note(&squares, counted(&waldram, &site.sky) - exact);
            if (i % 10 == 0)
                note(&marks, marked(world) - exact);
        }
        if (i % 50 == 0)
            assert_joined(&site, exact, whole);
        pp_waldram_site_clear(&site);
        pp_world_destroy(world);
    }
    print_message("# squares: bias %.2g, spread %.2g; marks: bias %.2g, spread %.2g\n",
                  mean_of(&squares), spread_of(&squares), mean_of(&marks),
                  spread_of(&marks));
    assert_unbiased(&squares);
    assert_unbiased(&marks);
    assert_true(spread_of(&squares) < 1e-4);
    assert_true(spread_of(&marks) < 0.014);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_whole_diagram_is_the_open_skys_vertical_component),
        cmocka_unit_test(ordinates_are_the_sum_of_luminance_and_cosines),
        cmocka_unit_test(ordinates_of_measured_skies_are_tabulated_alike),
        cmocka_unit_test(areas_of_random_sites_are_their_vertical_sky_component),
    };
    add_tests(tests, NULL, NULL);
}
