/* test_sunlight.c - hours of sun as used by criteria, in rooms with results calculated
 * by hand. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/light/sun_path.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/pair_rooms.h"
#include "tests/lib/room_of.h"

#define SITE(latitude) "<site latitude=\"" #latitude "\"/>"
#define PLAN "<plan width=\"4.1\" depth=\"6.3\" height=\"2.9\"/>"
#define WINDOW(wall)                                                                   \
    "<window wall=\"" wall                                                             \
    "\" left=\"0.7\" sill=\"0.95\" width=\"1.0\" height=\"1.3\" reveal=\"0.7\"/>"
#define SKYLINE(angle) "<skyline wall=\"south\" angle=\"" #angle "\"/>"

static struct pp_world *world_of(const char *body)
{
    char text[4096];
    snprintf(text, sizeof text, "<room version=\"1\" name=\"Test\">%s</room>", body);
    return pp_test_world(text);
}

/* Settings of the inquiries below. */
static bool with_sunshine = true;
static double least_altitude_rad = 1e-9;
static double shortest_h = 0.0;
static char basis[2048]; /* of the latest findings */

/* Finding number `index` of one criterion for a room given by the content of its
 * element. */
static struct pp_finding finding_in(const struct pp_criterion *criterion, int index,
                                    const char *body, const char *before_body)
{
    struct pp_world *world = world_of(body);
    struct pp_world *before = before_body ? world_of(before_body) : NULL;
    int *pairs = NULL;
    if (before)
        assert_int_equal(pp_pair_rooms(&pairs, world, before, NULL), PP_OK);
    /* Sunshine in every hour, so that probable hours are possible hours, and the sun
     * counts down to the horizon. */
    struct pp_sunshine always = {.known = true};
    for (int i = 0; i < PP_SUNSHINE_MONTHS * PP_SUNSHINE_HOURS; i++)
        (&always.share[0][0])[i] = 1.0;
    const struct pp_inquiry inquiry = {.world = world,
                                       .before = before,
                                       .pairs = pairs,
                                       .sunshine = with_sunshine ? &always : NULL,
                                       .least_altitude_rad = least_altitude_rad,
                                       .shortest_h = shortest_h,
                                       .country = ""};
    struct pp_finding_list findings = {0};
    assert_int_equal(criterion->evaluate(&inquiry, &findings, NULL), PP_OK);
    assert_true(index < findings.count);
    struct pp_finding finding = findings.list[index];
    snprintf(basis, sizeof basis, "%s", findings.basis);
    pp_finding_list_clear(&findings);
    pp_world_destroy(world);
    pp_world_destroy(before);
    free(pairs);
    return finding;
}

static struct pp_finding sun(int index, const char *body, const char *before)
{
    return finding_in(&pp_criterion_sunlight, index, body, before);
}

static double exposure(const char *body)
{
    return finding_in(&pp_criterion_sun_exposure, 0, body, NULL).figure;
}

static void assert_verdict(struct pp_finding finding, double figure, double tolerance,
                           enum pp_verdict verdict)
{
    assert_near(finding.figure, figure, tolerance);
    assert_int_equal(finding.verdict, verdict);
}

static void assert_not_judged(struct pp_finding finding, const char *why)
{
    assert_int_equal(finding.verdict, PP_NOT_JUDGED);
    if (!strstr(finding.note, why))
        fail_msg("\"%s\" does not say \"%s\"", finding.note, why);
}

static double half_day(double cosine)
{
    return acos(fmax(-1.0, fmin(1.0, cosine)));
}

/* Half days by the textbook: the sun is above the horizon while cos h > -tan phi tan
 * delta, and in front of an unobstructed south wall while cos h > tan delta / tan phi.
 * Sets the hours in front of the wall, of the year and of winter, as shares of the
 * year's hours with the sun above the horizon. */
static void south_shares(double latitude_deg, double shares[2])
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    double all = 0.0, phi = latitude_deg * PP_RAD;
    shares[0] = shares[1] = 0.0;
    for (int month = 1; month <= 12; month++)
        for (int day = 1; day <= days[month - 1]; day++) {
            double t = tan(pp_sun_path_declination(month, day));
            double up = half_day(-tan(phi) * t), south = half_day(t / tan(phi));
            int date = 100 * month + day;
            all += up;
            shares[0] += fmin(up, south);
            shares[1] += date <= 321 || date >= 921 ? fmin(up, south) : 0.0;
        }
    shares[0] /= all;
    shares[1] /= all;
}

static void an_open_south_wall_has_the_textbooks_hours(void **state)
{
    (void)state;
    double shares[2];
    south_shares(51.5, shares);
    assert_verdict(sun(0, SITE(51.5) PLAN WINDOW("south"), NULL), shares[0], 1e-9,
                   PP_MET);
    assert_verdict(sun(1, SITE(51.5) PLAN WINDOW("south"), NULL), shares[1], 1e-9,
                   PP_MET);
    /* The sky and the glass do not matter. */
    assert_verdict(
        sun(0, SITE(51.5) "<sky type=\"uniform\"/>" PLAN WINDOW("south"), NULL),
        shares[0], 1e-9, PP_MET);
}

/* The plane over the skyline is slightly steeper than the sun's path at the equinox. The
 * winter sun is below it, except on 21 September and 21 March, with declinations of +0.5
 * and +0.4 degrees: at most 24 of 4406 hours. */
static void a_skyline_of_the_equinox_leaves_hardly_any_winter_sun(void **state)
{
    (void)state;
    const char *body = SITE(51.5) PLAN WINDOW("south") SKYLINE(39.3);
    assert_verdict(sun(1, body, NULL), 0.0, 24.0 / 4406.0, PP_NOT_MET);
    assert_true(sun(0, body, NULL).figure > 0.05);
}

/* [BR209]: a value below 25 or 5 % is not a loss if 0.8 of the previous hours of year
 * and winter are left, or if the loss is at most 4 % of the year's hours. */
static void sunlight_kept_or_hardly_lost_is_no_failure(void **state)
{
    (void)state;
    const char *deep = SITE(51.5) PLAN WINDOW("south") SKYLINE(39.3);
    const char *deeper = SITE(51.5) PLAN WINDOW("south") SKYLINE(39.5);
    const char *open = SITE(51.5) PLAN WINDOW("south");
    assert_int_equal(sun(1, deep, deep).verdict, PP_MET);
    assert_int_equal(sun(1, deeper, deep).verdict, PP_MET);
    assert_int_equal(sun(1, deep, open).verdict, PP_NOT_MET);
    struct pp_finding loss = sun(0, deep, open);
    double shares[2];
    south_shares(51.5, shares);
    assert_near(loss.before, shares[0], 1e-9);
    assert_true(loss.now < loss.before - 0.04);
}

static void only_windows_towards_the_noon_sun_are_assessed(void **state)
{
    (void)state;
    assert_not_judged(sun(0, SITE(51.5) PLAN WINDOW("north"), NULL), "due south");
    assert_not_judged(sun(0, SITE(-33.9) PLAN WINDOW("south"), NULL), "due north");
    assert_true(sun(0, SITE(-33.9) PLAN WINDOW("north"), NULL).verdict == PP_MET);
    /* Within 90 degrees of south, including due east and due west, which have half of
     * the day. */
    assert_verdict(sun(0, SITE(51.5) PLAN WINDOW("east"), NULL), 0.5, 1e-9, PP_MET);
    assert_verdict(sun(0, SITE(51.5) PLAN WINDOW("west"), NULL), 0.5, 1e-9, PP_MET);
}

static void without_a_latitude_there_is_no_sun(void **state)
{
    (void)state;
    assert_not_judged(sun(0, PLAN WINDOW("south"), NULL), "latitude");
    assert_not_judged(
        finding_in(&pp_criterion_sun_exposure, 0, PLAN WINDOW("south"), NULL),
        "latitude");
    assert_not_judged(sun(0, SITE(51.5) PLAN, NULL), "no openings");
}

/* At the pole the sun is in front of any wall for half of the summer; beyond the polar
 * circle winter has days without sun. */
static void poles_and_the_equator_have_their_hours(void **state)
{
    (void)state;
    double shares[2];
    south_shares(0.001, shares);
    assert_near(sun(0, SITE(0.001) PLAN WINDOW("south"), NULL).figure, shares[0], 1e-6);
    assert_near(sun(0, SITE(90) PLAN WINDOW("south"), NULL).figure, 0.5, 1e-9);
    south_shares(78.2, shares);
    assert_near(sun(1, SITE(78.2) PLAN WINDOW("south"), NULL).figure, shares[1], 1e-9);
    assert_true(shares[1] < 0.25);
}

/* The jambs are 0.5 m to the sides of the point and 0.7 m in front of it: they admit
 * the sun while the tangent of its azimuth from south is at most 0.5 / 0.7, found by
 * bisection of the hour angle. Head and sill do not hide it: the sun's path rises by
 * 38.5 degrees, the head by 55. */
static void on_the_equinox_jambs_cut_the_sun(void **state)
{
    (void)state;
    double phi = 51.5 * PP_RAD, delta = pp_sun_path_declination(3, 21);
    double low = 0.0, high = 0.45 * PP_PI;
    for (int i = 0; i < 60; i++) {
        double h = 0.5 * (low + high);
        struct pp_vec3 u = pp_sun_path_direction(phi, delta, h);
        if (-u.x <= -u.y * 0.5 / 0.7)
            low = h;
        else
            high = h;
    }
    double hours = low * 24.0 / PP_PI;
    const char *body = SITE(51.5) PLAN WINDOW("south");
    assert_near(hours, 3.9, 0.1);
    /* Before and after noon the declination differs by 0.03 degrees. At most 4 h. */
    const struct pp_criterion *criterion = &pp_criterion_sun_exposure;
    assert_verdict(finding_in(criterion, 2, body, NULL), hours, 1e-4, PP_NOT_MET);
    assert_verdict(finding_in(criterion, 0, body, NULL), hours, 1e-4, PP_MET);
}

/* At the equinox the sun at the equator rises due east by 15 degrees an hour: from 20
 * degrees to noon in 70/15 h. An overhang that hides the sun above 35 degrees (1 m
 * above the point, 1.43 m deep) leaves 1 h above 20 degrees, 2 h above 5 degrees and
 * 1.5 h above 12.5 degrees. */
static void low_sun_decides_only_where_a_level_needs_it(void **state)
{
    (void)state;
    const struct pp_criterion *criterion = &pp_criterion_sun_exposure;
    const char *east = SITE(0.001) PLAN
        "<window wall=\"east\" left=\"0.4\" sill=\"0.95\" width=\"4\" height=\"1.3\"/>";
    least_altitude_rad = 0.0;
    struct pp_finding high = finding_in(criterion, 2, east, NULL);
    assert_verdict(high, 70.0 / 15.0, 0.02, PP_MET);
    least_altitude_rad = 15.0 * PP_RAD;
    assert_verdict(finding_in(criterion, 2, east, NULL), 75.0 / 15.0, 0.02, PP_MET);
    least_altitude_rad = 0.0;
    const char *low = SITE(0.001) PLAN
        "<window wall=\"east\" left=\"0.4\" sill=\"0.95\" width=\"4\" height=\"1.3\">"
        "<overhang depth=\"1.43\" left=\"50\" right=\"50\"/></window>";
    struct pp_finding minimum = finding_in(criterion, 0, low, NULL);
    assert_int_equal(minimum.verdict, PP_UNDECIDED);
    assert_non_null(strstr(minimum.note, "counts the sun from an altitude of 12."));
    least_altitude_rad = 1e-9;
}

/* At the equinox the sun at the equator rises due east by 15 degrees an hour. A wall in
 * front of the window hides it up to 40 degrees, but for a slit from 20 to 21 degrees:
 * 4 minutes, and 50/15 h from 40 degrees to noon. The sun's disc of 0.53 degrees takes 2
 * minutes to pass an edge. */
static void minutes_of_sun_through_a_slit_can_be_left_out(void **state)
{
    (void)state;
    const char *slit = SITE(0.001) PLAN
        "<window wall=\"east\" left=\"0.4\" sill=\"0.95\" width=\"4\" "
        "height=\"1.3\"/>"
        "<block x=\"14.1\" y=\"-200\" width=\"0.001\" depth=\"400\" base=\"0\" "
        "height=\"4.8897\"/>" /* 1.25 + 10 tan 20 */
        "<block x=\"14.1\" y=\"-200\" width=\"0.001\" depth=\"400\" "
        "base=\"5.0886\" height=\"4.5524\"/>"; /* to 1.25 + 10 tan 40 */
    assert_near(exposure(slit), 51.0 / 15.0, 0.02);
    assert_null(strstr(basis, "intervals of sun"));
    shortest_h = 3.0 / 60.0;
    assert_near(exposure(slit), 51.0 / 15.0, 0.02);
    assert_non_null(strstr(basis, "0 shorter than 3 minutes left out"));
    shortest_h = 5.0 / 60.0;
    assert_near(exposure(slit), 50.0 / 15.0, 0.02);
    assert_non_null(strstr(basis, "in solar time: 08:4"));
    assert_non_null(strstr(basis, "-12:00; 1 shorter than 5 minutes left out"));
    shortest_h = 0.0;
}

static void possible_hours_are_not_judged(void **state)
{
    (void)state;
    with_sunshine = false;
    struct pp_finding year = sun(0, SITE(51.5) PLAN WINDOW("south"), NULL);
    with_sunshine = true;
    assert_int_equal(year.verdict, PP_STATED);
    assert_true(isnan(year.wanted) && year.figure > 0.5);
}

/* If the sun shines through several windows at the same time, the hours count once. */
static void the_same_sun_through_two_windows_counts_once(void **state)
{
    (void)state;
    double south = exposure(SITE(51.5) PLAN WINDOW("south"));
    double east = exposure(SITE(51.5) PLAN WINDOW("east"));
    double west = exposure(SITE(51.5) PLAN WINDOW("west"));
    assert_near(east, west,
                0.05); /* the declination increases from morning to evening */
    assert_true(east > 0.5);
    assert_near(exposure(SITE(51.5) PLAN WINDOW("east") WINDOW("west")), east + west,
                1e-9);
    assert_near(exposure(SITE(51.5) PLAN WINDOW(
                    "south") "<window wall=\"south\" left=\"2.7\" sill=\"0.95\" "
                             "width=\"1.0\" height=\"1.3\" reveal=\"0.7\"/>"),
                south, 1e-9);
}

/* In the morning the sun reaches the south-east before it rises above a wall there. The
 * end of the skyline is within 0.6 degrees of east, which the sun passes in 0.05
 * hours. */
static void a_skyline_with_a_distance_hides_the_sun_from_windows_of_other_walls(
    void **state)
{
    (void)state;
    const char *open = SITE(51.5) PLAN WINDOW("east");
    const char *skyline = SITE(51.5)
        PLAN WINDOW("east") "<skyline wall=\"south\" angle=\"70\" distance=\"4\"/>";
    const char *block = SITE(51.5)
        PLAN WINDOW("east") "<block x=\"-4000\" y=\"-14\" width=\"8000\" depth=\"10\" "
                            "height=\"12.43990968\"/>"; /* 1.45 + 4 tan 70 */
    assert_near(exposure(skyline), exposure(block), 0.05);
    assert_true(exposure(skyline) < exposure(open) - 0.5);
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_open_south_wall_has_the_textbooks_hours),
        cmocka_unit_test(a_skyline_of_the_equinox_leaves_hardly_any_winter_sun),
        cmocka_unit_test(sunlight_kept_or_hardly_lost_is_no_failure),
        cmocka_unit_test(only_windows_towards_the_noon_sun_are_assessed),
        cmocka_unit_test(without_a_latitude_there_is_no_sun),
        cmocka_unit_test(poles_and_the_equator_have_their_hours),
        cmocka_unit_test(on_the_equinox_jambs_cut_the_sun),
        cmocka_unit_test(low_sun_decides_only_where_a_level_needs_it),
        cmocka_unit_test(minutes_of_sun_through_a_slit_can_be_left_out),
        cmocka_unit_test(possible_hours_are_not_judged),
        cmocka_unit_test(the_same_sun_through_two_windows_counts_once),
        cmocka_unit_test(
            a_skyline_with_a_distance_hides_the_sun_from_windows_of_other_walls),
    };
    add_tests(tests, NULL, NULL);
}
