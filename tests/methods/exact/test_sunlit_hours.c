/* test_sunlit_hours.c - hours of sun in closed form, compared with known facts about
 * days and walls, and with a count minute by minute with the calculated sun. */
#include "methods/exact/sunlit_hours.h"

#include <stdlib.h>

#include "model/light/sun.h"
#include "model/light/sun_path.h"
#include "tests/lib/room_of.h"

#define HALF_TURN 12.0 /* hours */

#define PLAN "<plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>"
#define WINDOW(wall)                                                                   \
    "<window wall=\"" wall                                                             \
    "\" left=\"0.75\" sill=\"0.95\" width=\"2.6\" height=\"1.3\" reveal=\"0.23\"/>"

static struct pp_world *room(const char *north, const char *body)
{
    char text[4096];
    snprintf(text, sizeof text,
             "<room version=\"1\" name=\"Test\" north=\"%s\">" PLAN "%s</room>", north,
             body);
    return pp_test_world(text);
}

/* Hours of sun on the outside of the world's first window on a day. */
static double hours_of_day(const struct pp_world *world, double latitude_deg,
                           double declination_rad)
{
    struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
    struct pp_sunlit_place place = {latitude_deg * PP_RAD, world->north_rad, NAN};
    struct pp_sunlit_sun sun = {declination_rad, -PP_PI, PP_PI};
    struct pp_hidden_cones cones;
    struct pp_sunlit_day day = {0};
    assert_int_equal(pp_hidden_cones_init(&cones, world, &view, NULL), PP_OK);
    assert_int_equal(pp_sunlit_hours_add(&day, &cones, place, &sun, NULL), PP_OK);
    double hours = pp_sunlit_hours_sum(&day);
    pp_sunlit_hours_clear(&day);
    pp_hidden_cones_clear(&cones);
    return hours;
}

static double hours_in(const char *north, const char *body, double latitude_deg,
                       double declination_deg)
{
    struct pp_world *world = room(north, body);
    double hours = hours_of_day(world, latitude_deg, declination_deg * PP_RAD);
    pp_world_destroy(world);
    return hours;
}

static double open_hours(double latitude_deg, double declination_deg)
{
    struct pp_sunlit_place place = {latitude_deg * PP_RAD, 0.0, NAN};
    struct pp_sunlit_sun sun = {declination_deg * PP_RAD, -PP_PI, PP_PI};
    struct pp_sunlit_day day = {0};
    assert_int_equal(pp_sunlit_hours_add(&day, NULL, place, &sun, NULL), PP_OK);
    double hours = pp_sunlit_hours_sum(&day);
    pp_sunlit_hours_clear(&day);
    return hours;
}

static void the_equinox_has_twelve_hours_everywhere(void **state)
{
    (void)state;
    static const double latitudes[] = {-71.3, -33.7, 0.0, 17.9, 51.5, 83.1};
    for (int i = 0; i < 6; i++)
        assert_near(open_hours(latitudes[i], 0.0), HALF_TURN, 1e-9);
}

/* The longest day at 51.5 degrees: 2/15 acos(-tan 51.5 tan 23.44) = 16.404 h. Beyond
 * the polar circle the sun does not set in summer and does not rise in winter. */
static void days_grow_until_the_sun_does_not_set(void **state)
{
    (void)state;
    double half = acos(-tan(51.5 * PP_RAD) * tan(23.44 * PP_RAD));
    assert_near(open_hours(51.5, 23.44), 24.0 * half / PP_PI, 1e-9);
    assert_near(24.0 * half / PP_PI, 16.404, 0.002);
    assert_near(open_hours(70.1, 23.44), 24.0, 0.0);
    assert_near(open_hours(70.1, -23.44), 0.0, 0.0);
    assert_near(open_hours(90.0, 11.3), 24.0, 0.0);
    assert_near(open_hours(-90.0, 11.3), 0.0, 0.0);
}

/* The hours of sun in single hours add up to those of the day, which form one
 * interval. */
static void a_day_by_hours_is_one_time(void **state)
{
    (void)state;
    struct pp_sunlit_place place = {51.5 * PP_RAD, 0.0, NAN};
    struct pp_sunlit_day day = {0};
    assert_int_equal(pp_sunlit_hours_of_day(&day, NULL, place, 6, 21, NULL), PP_OK);
    assert_int_equal(day.count, 1);
    assert_near(pp_sunlit_hours_sum(&day), open_hours(51.5, 23.437), 1e-3);
    pp_sunlit_hours_clear(&day);
}

/* In winter the sun rises and sets south of east and west. In summer the two sides of a
 * wall have sun for the whole day together; east and west walls have half of the day
 * each. */
static void two_sides_of_a_wall_share_the_day(void **state)
{
    (void)state;
    assert_near(hours_in("0", WINDOW("north"), 51.5, -11.7), 0.0, 0.0);
    assert_near(hours_in("0", WINDOW("south"), 51.5, -11.7), open_hours(51.5, -11.7),
                1e-9);
    for (double declination = -23.0; declination < 23.5; declination += 7.3) {
        double day = open_hours(51.5, declination);
        for (int turn = 0; turn < 2; turn++) {
            const char *north = turn ? "37.3" : "0";
            assert_near(hours_in(north, WINDOW("south"), 51.5, declination)
                            + hours_in(north, WINDOW("north"), 51.5, declination),
                        day, 1e-9);
        }
        assert_near(hours_in("0", WINDOW("east"), 51.5, declination), 0.5 * day, 1e-9);
        assert_near(hours_in("0", WINDOW("west"), 51.5, declination), 0.5 * day, 1e-9);
    }
}

/* At the equinox the sun moves in a plane through due east and due west that is
 * inclined 90 - 51.5 = 38.5 degrees above the south. The plane over an infinitely long
 * skyline in front of a south wall contains the same axis, so the sun is above or below
 * it all day. */
static void an_endless_skyline_takes_all_of_the_equinox_or_nothing(void **state)
{
    (void)state;
    assert_near(hours_in("0",
                         WINDOW("south") "<skyline wall=\"south\" angle=\"38.4\"/>",
                         51.5, 0.0),
                HALF_TURN, 1e-9);
    assert_near(hours_in("0",
                         WINDOW("south") "<skyline wall=\"south\" angle=\"38.6\"/>",
                         51.5, 0.0),
                0.0, 1e-9);
}

/* At the equinox the azimuth of the sun from south has the tangent tan h / sin
 * latitude. A very tall tower, 10 m in front of the window, from 3 m west to 5 m east
 * of its middle, hides the sun between the azimuths of its edges. */
static void a_tower_hides_the_hours_of_its_azimuths(void **state)
{
    (void)state;
    double phi = 51.5 * PP_RAD;
    double lost = atan(sin(phi) * 3.0 / 10.0) + atan(sin(phi) * 5.0 / 10.0);
    assert_near(hours_in("0",
                         WINDOW("south") "<block x=\"-0.95\" y=\"-17.23\" "
                                         "width=\"8\" depth=\"7\" height=\"900\"/>",
                         51.5, 0.0),
                HALF_TURN - lost * HALF_TURN / PP_PI, 1e-9);
}

/* The same tower, for single directions at an altitude of 10 degrees; all directions
 * behind the wall are hidden. */
static void a_tower_hides_the_directions_between_its_edges(void **state)
{
    (void)state;
    struct pp_world *world =
        room("0", WINDOW("south") "<block x=\"-0.95\" y=\"-17.23\" "
                                  "width=\"8\" depth=\"7\" height=\"900\"/>");
    struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
    struct pp_hidden_cones cones;
    assert_int_equal(pp_hidden_cones_init(&cones, world, &view, NULL), PP_OK);
    for (int degree = -179; degree < 180; degree++) {
        double east = degree * PP_RAD, altitude = 10.0 * PP_RAD; /* from the south */
        bool hidden = fabs(east) > 0.5 * PP_PI
                      || (east > -atan(3.0 / 10.0) && east < atan(5.0 / 10.0));
        if (abs(degree) == 90)
            continue; /* parallel to the wall */
        assert_int_equal(pp_hidden_cones_hide(&cones, pp_vec(sin(east) * cos(altitude),
                                                             -cos(east) * cos(altitude),
                                                             sin(altitude))),
                         hidden);
    }
    pp_hidden_cones_clear(&cones);
    pp_world_destroy(world);
}

/* Obstructions in the east hide as much in the morning as their mirror images hide in
 * the afternoon. */
static void mornings_mirror_afternoons(void **state)
{
    (void)state;
    const char *east = WINDOW("south") "<block x=\"5.05\" y=\"-13\" width=\"6\" "
                                       "depth=\"4\" height=\"11\"/>";
    const char *west = WINDOW("south") "<block x=\"-6.95\" y=\"-13\" width=\"6\" "
                                       "depth=\"4\" height=\"11\"/>";
    double open = hours_in("0", WINDOW("south"), 48.2, 3.1);
    double hours = hours_in("0", east, 48.2, 3.1);
    assert_near(hours_in("0", west, 48.2, 3.1), hours, 1e-9);
    assert_true(hours < open - 0.5);
}

/* ---- a year, counted minute by minute ---- */

/* True if the sun is above the horizon, in front of the wall, and not hidden, tested
 * with rays. */
static bool shines(const struct pp_world *world, const struct pp_hidden_view *view,
                   double latitude_rad, double days)
{
    struct pp_sun sun = pp_sun_at(days, latitude_rad, 0.0);
    double azimuth = sun.bearing_rad - world->north_rad;
    struct pp_vec3 u = {cos(sun.altitude_rad) * sin(azimuth),
                        cos(sun.altitude_rad) * cos(azimuth), sin(sun.altitude_rad)};
    if (u.z <= 0.0 || pp_vec_dot(u, view->out) <= 0.0)
        return false;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        const struct pp_polygon *polygon = &surface->outline;
        double toward = pp_vec_dot(polygon->normal, u);
        if (i == view->face || surface->role == PP_REVEAL || toward == 0.0)
            continue;
        double far =
            pp_vec_dot(polygon->normal, pp_vec_sub(polygon->vertices[0], view->eye))
            / toward;
        if (far > 1e-9
            && pp_polygon_side(polygon, pp_vec_along(view->eye, far, u), 0.0)
                   != PP_OUTSIDE)
            return false;
    }
    return true;
}

/* Counts minutes, and seconds in those minutes in which the sun appears or
 * disappears. */
static double counted_hours(const struct pp_world *world, double latitude_rad)
{
    struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
    const double start = pp_sun_days_since_2000(2025, 1, 1, 0.0);
    const double minute = 1.0 / 1440.0;
    double minutes = 0.0;
    bool before = shines(world, &view, latitude_rad, start);
    for (int i = 1; i <= 365 * 1440; i++) {
        bool now = shines(world, &view, latitude_rad, start + i * minute);
        if (now && before)
            minutes += 1.0;
        for (int s = 0; now != before && s < 60; s++)
            minutes += shines(world, &view, latitude_rad,
                              start + (i - 1 + (s + 0.5) / 60.0) * minute)
                       / 60.0;
        before = now;
    }
    return minutes / 60.0;
}

/* The closed form uses the declination at noon, which changes by up to 0.2 degrees
 * until the end of the day, with the opposite sign half a year later. A rotated block,
 * a second block and a slab overhead that is not convex cause about a thousand ends of
 * sun periods in the year. Measured: 2244.53 and 2244.49 h. */
static void a_year_is_what_counting_makes_of_it(void **state)
{
    (void)state;
    struct pp_world *world =
        room("23.7",
             WINDOW("south") "<block x=\"-9\" y=\"-16\" width=\"9\" depth=\"5\" "
                             "height=\"12\" rotate=\"11\"/>"
                             "<block x=\"4\" y=\"-19\" width=\"7\" depth=\"8\" "
                             "height=\"8\"/>"
                             "<surface><vertex x=\"0\" y=\"-0.01\" z=\"2.601\"/>"
                             "<vertex x=\"0.2\" y=\"-1.1\" z=\"2.71\"/>"
                             "<vertex x=\"1.9\" y=\"-1.1\" z=\"2.71\"/>"
                             "<vertex x=\"1.9\" y=\"-0.5\" z=\"2.65\"/>"
                             "<vertex x=\"3.9\" y=\"-0.5\" z=\"2.65\"/>"
                             "<vertex x=\"3.9\" y=\"-0.01\" z=\"2.601\"/></surface>");
    double latitude = 51.5 * PP_RAD;
    struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
    struct pp_sunlit_place place = {latitude, world->north_rad, NAN};
    struct pp_hidden_cones cones;
    struct pp_sunlit_year year, open;
    assert_int_equal(pp_hidden_cones_init(&cones, world, &view, NULL), PP_OK);
    assert_int_equal(pp_sunlit_hours_of_year(&year, &cones, place, NULL, NULL), PP_OK);
    assert_int_equal(pp_sunlit_hours_of_year(&open, NULL, place, NULL, NULL), PP_OK);
    pp_hidden_cones_clear(&cones);
    assert_near(year.all, counted_hours(world, latitude), 0.1);
    assert_true(year.all < 0.6 * open.all && year.winter < 0.7 * year.all);
    pp_world_destroy(world);
}

/* 60 slender blocks, any orientation, latitudes from the equator to beyond the polar
 * circle. The hours of the year are the same without the caps of cones, which save most
 * of the tests of half-spaces. */
static void caps_change_no_hour(void **state)
{
    (void)state;
    char body[8192];
    int length = snprintf(body, sizeof body, WINDOW("south"));
    for (int i = 0; i < 60; i++)
        length += snprintf(body + length, sizeof body - (size_t)length,
                           "<block x='%g' y='%g' width='0.%d' depth='0.4' height='%g' "
                           "rotate='%d'/>",
                           -12.0 + i * 5 % 23 * 1.1, -2.0 - i * 7 % 31 * 0.9, 3 + i % 6,
                           1.5 + i * 11 % 17 * 0.7, i * 29 % 90);
    static const double latitudes[] = {0.0, 34.1, 51.5, -41.7, 71.2};
    for (int k = 0; k < 5; k++) {
        char north[16];
        snprintf(north, sizeof north, "%g", 61.0 * k);
        char text[9216];
        snprintf(text, sizeof text, "<room version='1' north='%s'>" PLAN "%s</room>",
                 north, body);
        struct pp_world *world = pp_test_world(text);
        struct pp_hidden_view view = pp_hidden_cones_outside(&world->openings[0]);
        struct pp_sunlit_place place = {latitudes[k] * PP_RAD, world->north_rad, NAN};
        struct pp_hidden_cones cones;
        struct pp_sunlit_year with, without;
        assert_int_equal(pp_hidden_cones_init(&cones, world, &view, NULL), PP_OK);
        assert_int_equal(pp_sunlit_hours_of_year(&with, &cones, place, NULL, NULL),
                         PP_OK);
        int caps = 0;
        for (int i = 0; i < cones.count; i++) {
            caps += cones.list[i].cos_radius > 0.0;
            cones.list[i].cos_radius = 0.0;
        }
        assert_int_equal(pp_sunlit_hours_of_year(&without, &cones, place, NULL, NULL),
                         PP_OK);
        assert_true(caps > 60 && caps < cones.count);
        assert_true(without.all > 0.0);
        assert_near(with.all, without.all, 0.0);
        assert_near(with.winter, without.winter, 0.0);
        pp_hidden_cones_clear(&cones);
        pp_world_destroy(world);
    }
}

/* 21 March begins 10 hours earlier in Sydney (151.2 degrees east) than in Greenwich,
 * when the sun is 10 x 0.0165 degrees farther south. In the open the day in Sydney is
 * therefore longer by 2 x 0.165 tan(33.9) / 15 h, and at 151.2 degrees west shorter by
 * the same time. */
static void the_day_is_that_of_the_place(void **state)
{
    (void)state;
    double hours[3];
    static const double longitudes_deg[] = {151.2, 0.0, -151.2};
    for (int i = 0; i < 3; i++) {
        struct pp_sunlit_place place = {-33.9 * PP_RAD, 0.0,
                                        longitudes_deg[i] * PP_RAD};
        struct pp_sunlit_day day = {0};
        assert_int_equal(pp_sunlit_hours_of_day(&day, NULL, place, 3, 21, NULL), PP_OK);
        hours[i] = pp_sunlit_hours_sum(&day);
        pp_sunlit_hours_clear(&day);
    }
    double longer = 2.0 * 10.08 * 0.01645 * tan(33.9 * PP_RAD) / 15.0;
    assert_near(hours[0] - hours[1], longer, 0.02 * longer);
    assert_near(hours[1] - hours[2], longer, 0.02 * longer);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_day_is_that_of_the_place),
        cmocka_unit_test(the_equinox_has_twelve_hours_everywhere),
        cmocka_unit_test(days_grow_until_the_sun_does_not_set),
        cmocka_unit_test(a_day_by_hours_is_one_time),
        cmocka_unit_test(two_sides_of_a_wall_share_the_day),
        cmocka_unit_test(an_endless_skyline_takes_all_of_the_equinox_or_nothing),
        cmocka_unit_test(a_tower_hides_the_hours_of_its_azimuths),
        cmocka_unit_test(a_tower_hides_the_directions_between_its_edges),
        cmocka_unit_test(mornings_mirror_afternoons),
        cmocka_unit_test(a_year_is_what_counting_makes_of_it),
        cmocka_unit_test(caps_change_no_hour),
    };
    add_tests(tests, NULL, NULL);
}
