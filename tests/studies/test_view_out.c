/* test_view_out.c - angle, distance and layers of the view through windows. */
#include "studies/view_out.h"

#include <stdlib.h>

#include "simulate/scene/light_scene_of_world.h"
#include "tests/lib/dice.h"
#include "tests/lib/room_of.h"

/* A plan of 4 x 6 m with windows in its south wall, and objects outside. */
#define ROOM(inside)                                                                   \
    "<room version='1'><plan width='4' depth='6' height='3'/>" inside "</room>"

static struct pp_view_out view_from(const char *text, double x, double y, double z)
{
    struct pp_world *world = pp_test_world(text);
    struct pp_light_scene *scene;
    struct pp_view_out view;
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    assert_int_equal(
        pp_view_out_from(&view, world, scene, pp_vec(x, y, z), PP_VIEW_OUT_LINES, NULL),
        PP_OK);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
    return view;
}

static void a_window_2_m_wide_takes_2_atan_1_over_3_from_3_m(void **state)
{
    (void)state;
    struct pp_view_out view = view_from(
        ROOM("<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"), 2.0,
        3.0, 1.2);
    assert_near(view.sight_angle_rad, 2.0 * atan(1.0 / 3.0), 1e-9);
    assert_int_equal(pp_view_out_angle_level(&view), PP_VIEW_MEDIUM);
}

static void a_reveal_narrows_the_angle(void **state)
{
    (void)state;
    struct pp_view_out view =
        view_from(ROOM("<window wall='south' left='1' sill='0.8' width='2' height='1.5'"
                       " reveal='0.3'/>"),
                  2.0, 3.0, 1.2);
    assert_near(view.sight_angle_rad, 2.0 * atan(1.0 / 3.3), 1e-9);
}

static void windows_above_each_other_count_once_and_beside_each_other_twice(
    void **state)
{
    (void)state;
    struct pp_view_out above = view_from(
        ROOM("<window wall='south' left='1' sill='0.8' width='2' height='0.7'/>"
             "<window wall='south' left='1' sill='1.6' width='2' height='0.7'/>"),
        2.0, 3.0, 1.2);
    assert_near(above.sight_angle_rad, 2.0 * atan(1.0 / 3.0), 1e-9);
    struct pp_view_out beside = view_from(
        ROOM("<window wall='south' left='0' sill='0.8' width='1' height='1.5'/>"
             "<window wall='south' left='3' sill='0.8' width='1' height='1.5'/>"),
        2.0, 3.0, 1.2);
    assert_near(beside.sight_angle_rad, 2.0 * (atan(2.0 / 3.0) - atan(1.0 / 3.0)),
                1e-9);
}

/* Windows in four walls: the east window extends across due east, where azimuths
 * begin. */
static void windows_all_round_add_up(void **state)
{
    (void)state;
    static const char *const wall[] = {"south", "east", "north", "west"};
    char text[1024] = "<room version='1'><plan width='4' depth='4' height='3'/>";
    for (int i = 0; i < 4; i++) {
        char window[160];
        snprintf(window, sizeof window,
                 "<window wall='%s' left='1' sill='0.8' width='2' height='1.5'/>",
                 wall[i]);
        strcat(text, window);
    }
    strcat(text, "</room>");
    struct pp_view_out view = view_from(text, 2.0, 2.0, 1.2);
    assert_near(view.sight_angle_rad, 4.0 * 2.0 * atan(0.5), 1e-9);
}

/* Seen through a small hole 3 m away and 0.9 m up, an infinitely long high wall 12 m in
 * front of the glass ends lines of sight after 12 m / cos. */
static void a_wall_opposite_gives_its_distance_along_the_line(void **state)
{
    (void)state;
    struct pp_view_out view = view_from(
        ROOM("<window wall='south' left='1.95' sill='2.05' width='0.1' height='0.1'/>"
             "<block x='-400' y='-22' width='800' depth='10' height='60'/>"),
        2.0, 3.0, 1.2);
    assert_near(view.distance_m, 12.0 * hypot(1.0, 0.9 / 3.0), 0.01);
    assert_int_equal(view.layers, PP_VIEW_LANDSCAPE);
    assert_int_equal(view.layers_together, 1);
    assert_int_equal(pp_view_out_distance_level(&view), PP_VIEW_MINIMUM);
}

static void a_skyline_hides_as_the_block_in_its_place(void **state)
{
    (void)state;
    struct pp_view_out skyline = view_from(
        ROOM("<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"
             "<skyline wall='south' angle='60' distance='12'/>"),
        2.0, 3.0, 1.2);
    struct pp_view_out block = view_from(
        ROOM("<window wall='south' left='1' sill='0.8' width='2' height='1.5'/>"
             "<block x='-400' y='-22' width='800' depth='10' height='22.33'/>"),
        2.0, 3.0, 1.2);
    assert_near(skyline.distance_m, block.distance_m, 0.02);
    assert_int_equal(skyline.layers, block.layers);
}

static void a_high_window_shows_sky_alone_and_is_no_view(void **state)
{
    (void)state;
    struct pp_view_out view = view_from(
        ROOM("<window wall='south' left='1' sill='2' width='2' height='0.8'/>"), 2.0,
        3.0, 1.2);
    assert_int_equal(view.layers, PP_VIEW_SKY);
    assert_int_equal(view.layers_together, 0);
    assert_int_equal(pp_view_out_level(&view), PP_VIEW_NONE);
}

/* Over open ground the horizon counts as landscape at an infinite distance. */
static void a_french_window_over_open_ground_has_all_layers(void **state)
{
    (void)state;
    struct pp_view_out view = view_from(
        ROOM("<window wall='south' left='0.5' sill='0' width='3' height='2.5'/>"), 2.0,
        2.5, 1.2);
    assert_int_equal(view.layers, PP_VIEW_LAYERS);
    assert_int_equal(view.layers_together, 3);
    assert_int_equal(pp_view_out_level(&view), PP_VIEW_HIGH);
}

/* A narrow slit shows level ground from atan(1.2/3) below the horizon up to it. Half of
 * its solid angle lies below the mean of the sines: sin a = 0.1874, and the ground is
 * (21.2 - 3 tan a)/sin a beyond the glass. */
static void median_over_open_ground_is_at_the_mean_of_the_sines(void **state)
{
    (void)state;
    struct pp_view_out view =
        view_from("<room version='1'><site ground-level='-20'/>"
                  "<plan width='4' depth='6' height='3'/>"
                  "<window wall='south' left='1.99' sill='0' width='0.02' "
                  "height='1.19'/></room>",
                  2.0, 3.0, 1.2);
    double sine = (sin(atan(1.2 / 3.0)) + sin(atan(0.01 / 3.0))) / 2.0;
    double distance_m = 21.2 / sine - 3.0 / sqrt(1.0 - sine * sine);
    assert_near(view.distance_m, distance_m, 0.003 * distance_m);
}

static void rooflights_and_diffusing_glass_give_no_view(void **state)
{
    (void)state;
    struct pp_view_out view =
        view_from(ROOM("<rooflight x='1' y='1' width='2' depth='2'/>"
                       "<window wall='south' left='1' sill='0.8' width='2' height='1.5'"
                       " transmittance='0.5' diffusing='yes'/>"),
                  2.0, 3.0, 1.2);
    assert_near(view.sight_angle_rad, 0.0, 0.0);
    assert_int_equal(view.layers, 0);
    assert_near(view.distance_m, 0.0, 0.0);
}

static int by_distance(const void *a, const void *b)
{
    const struct pp_view_line *s = a, *t = b;
    return (s->distance_m > t->distance_m) - (s->distance_m < t->distance_m);
}

/* Lists of 0 to 40 lines, some with equal distances or views of the sky (infinite
 * distances), and weights that are sums of powers of two, so that sums have no rounding
 * errors. */
static void the_median_distance_is_that_of_the_sorted_lines(void **state)
{
    (void)state;
    struct dice dice = {7};
    struct pp_view_line lines[40];
    assert_near(pp_view_out_median_distance(lines, 0), 0.0, 0.0);
    for (int trial = 0; trial < 2000; trial++) {
        int count = 1 + trial % 40;
        double half = 0.0, sum = 0.0, sorted = NAN;
        for (int i = 0; i < count; i++) {
            double distance_m = floor(between(&dice, 0.0, 30.0));
            lines[i].distance_m = distance_m > 24.0 ? INFINITY : distance_m;
            lines[i].solid_angle = floor(between(&dice, 0.0, 9.0)) / 64.0;
            half += lines[i].solid_angle / 2.0;
        }
        double found = pp_view_out_median_distance(lines, count);
        qsort(lines, (size_t)count, sizeof *lines, by_distance);
        for (int i = 0; i < count && isnan(sorted); i++) {
            sum += lines[i].solid_angle;
            sorted = sum >= half ? lines[i].distance_m : NAN;
        }
        assert_true(found == sorted);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_window_2_m_wide_takes_2_atan_1_over_3_from_3_m),
        cmocka_unit_test(a_reveal_narrows_the_angle),
        cmocka_unit_test(
            windows_above_each_other_count_once_and_beside_each_other_twice),
        cmocka_unit_test(windows_all_round_add_up),
        cmocka_unit_test(a_wall_opposite_gives_its_distance_along_the_line),
        cmocka_unit_test(a_skyline_hides_as_the_block_in_its_place),
        cmocka_unit_test(a_high_window_shows_sky_alone_and_is_no_view),
        cmocka_unit_test(a_french_window_over_open_ground_has_all_layers),
        cmocka_unit_test(median_over_open_ground_is_at_the_mean_of_the_sines),
        cmocka_unit_test(rooflights_and_diffusing_glass_give_no_view),
        cmocka_unit_test(the_median_distance_is_that_of_the_sorted_lines),
    };
    add_tests(tests, NULL, NULL);
}
