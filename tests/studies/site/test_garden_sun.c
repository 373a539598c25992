/* test_garden_sun.c - the sun on gardens, compared with the shadow of a long wall and
 * with points followed minute by minute. */
#include "studies/site/garden_sun.h"

#include "model/light/sun_path.h"
#include "model/room/building.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/pair_rooms.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<room version='1'><site latitude='51.5'/>"                                        \
    "<plan width='4' depth='5' height='3'/>"                                           \
    "<window wall='south' left='1' sill='1' width='1' height='1'/>"
#define GARDEN                                                                         \
    "<garden name='Lawn'><vertex x='100' y='100'/><vertex x='120' y='100'/>"           \
    "<vertex x='120' y='120'/><vertex x='100' y='120'/></garden>"
/* Extends along the south side of the garden for 3 km. */
#define HIGH_WALL "<block x='-1400' y='99' width='3000' depth='1' height='12'/>"
#define WALL "<block x='-1400' y='99' width='3000' depth='1' height='8'/>"

/* At the equinox the sun moves in a plane: its altitude in the section perpendicular to
 * an east-west wall is 90 degrees less the latitude all day, so the edge of the shadow
 * does not move. On 21 March the declination of 0.4 degrees moves it slightly. */
static void behind_an_east_west_wall_the_equinox_shadow_stands_still(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(ROOM WALL GARDEN "</room>");
    struct pp_garden_sun sun;
    assert_int_equal(world->garden_count, 1);
    assert_int_equal(pp_garden_sun_find(&sun, world, &world->gardens[0], NULL), PP_OK);
    assert_near(sun.area_m2, 400.0, 1e-9);
    double declination = pp_sun_path_declination(3, 21);
    double noon = 8.0 * tan(51.5 * PP_RAD - declination);
    assert_near(sun.sunlit_m2, 20.0 * (20.0 - noon), 0.03 * sun.area_m2);
    pp_garden_sun_clear(&sun);
    pp_world_destroy(world);
}

/* True if a box with sides along x and y hides the sun from a point on the ground. */
static bool is_hidden(const double at[2], struct pp_vec3 to_sun, const double low[3],
                      const double high[3])
{
    double from[3] = {at[0], at[1], 0.0}, near = 0.0, far = INFINITY;
    double way[3] = {to_sun.x, to_sun.y, to_sun.z};
    for (int k = 0; k < 3; k++) {
        double a = (low[k] - from[k]) / way[k], b = (high[k] - from[k]) / way[k];
        near = fmax(near, fmin(a, b));
        far = fmin(far, fmax(a, b));
    }
    return near < far;
}

/* Points every half metre in a garden beside a tower: hours counted by the minute. */
static void the_share_is_that_of_points_followed_minute_by_minute(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM "<block x='90' y='82' width='34' depth='16' height='30'/>" GARDEN
             "</room>");
    struct pp_garden_sun sun;
    const double low[3] = {90.0, 82.0, 0.0}, high[3] = {124.0, 98.0, 30.0};
    double declination = pp_sun_path_declination(3, 21);
    int sunlit = 0, all = 0;
    for (double x = 100.25; x < 120.0; x += 0.5)
        for (double y = 100.25; y < 120.0; y += 0.5, all++) {
            double at[2] = {x, y}, minutes = 0.0;
            for (double minute = 0.5; minute < 1440.0; minute += 1.0) {
                struct pp_vec3 u = pp_sun_path_direction(
                    51.5 * PP_RAD, declination, (minute / 1440.0 - 0.5) * 2.0 * PP_PI);
                minutes += u.z > 0.0 && !is_hidden(at, u, low, high);
            }
            sunlit += minutes >= 120.0;
        }
    assert_int_equal(pp_garden_sun_find(&sun, world, &world->gardens[0], NULL), PP_OK);
    assert_near(sun.sunlit_m2 / sun.area_m2, (double)sunlit / all, 0.005);
    assert_true(sun.sunlit_m2 < sun.area_m2);
    pp_garden_sun_clear(&sun);
    pp_world_destroy(world);
}

static struct pp_finding judged(const char *xml, const char *before_xml)
{
    struct pp_world *world = pp_test_world(xml);
    struct pp_world *before = before_xml ? pp_test_world(before_xml) : NULL;
    struct pp_finding_list findings = {0};
    const struct pp_inquiry inquiry = {.world = world, .before = before, .country = ""};
    assert_int_equal(pp_criterion_gardens.evaluate(&inquiry, &findings, NULL), PP_OK);
    assert_int_equal(findings.count, 1);
    struct pp_finding finding = findings.list[0];
    pp_finding_list_clear(&findings);
    pp_world_destroy(world);
    pp_world_destroy(before);
    return finding;
}

/* Half of the area must be sunlit, or 0.8 of the area that was sunlit before. */
static void a_garden_keeps_half_its_sun_or_most_of_what_it_had(void **state)
{
    (void)state;
    const char *open = ROOM GARDEN "</room>", *walled = ROOM HIGH_WALL GARDEN "</room>";
    assert_near(judged(open, NULL).figure, 1.0, 1e-9);
    assert_int_equal(judged(open, NULL).verdict, PP_MET);
    assert_int_equal(judged(walled, NULL).verdict, PP_NOT_MET);
    assert_int_equal(judged(walled, open).verdict, PP_NOT_MET);
    assert_int_equal(judged(walled, walled).verdict, PP_MET);
    assert_int_equal(
        judged("<room version='1'><plan width='4' depth='5' height='3'/>" GARDEN
               "</room>",
               NULL)
            .verdict,
        PP_NOT_JUDGED);
}

/* A garden of a building belongs to one room, in that room's axes. */
static void a_building_s_garden_is_that_of_one_of_its_rooms(void **state)
{
    (void)state;
    static const char xml[] =
        "<building version='1'>" GARDEN "<room name='New' state='proposed' x='5' y='0'>"
        "<plan width='4' depth='5' height='3'/></room>"
        "<room name='Old' x='20' y='0' z='2' rotate='90'>"
        "<plan width='4' depth='5' height='3'/></room></building>";
    struct pp_building *building;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "test");
    assert_int_equal(pp_building_parse(&building, xml, sizeof xml - 1, &mistakes, NULL),
                     PP_OK);
    assert_int_equal(pp_building_room_count(building), 2);
    struct pp_world *worlds[2];
    for (int i = 0; i < 2; i++)
        assert_int_equal(
            pp_world_create(&worlds[i], pp_building_room(building, i), &mistakes, NULL),
            PP_OK);
    assert_int_equal(worlds[0]->garden_count, 0);
    assert_int_equal(worlds[1]->garden_count, 1);
    struct pp_vec3 corner = pp_placement_to_building(
        &worlds[1]->placement, worlds[1]->gardens[0].outline.vertices[0]);
    assert_near(corner.x, 100.0, 1e-9);
    assert_near(corner.y, 100.0, 1e-9);
    assert_near(worlds[1]->gardens[0].outline.vertices[0].x, 100.0, 1e-9);
    assert_near(worlds[1]->gardens[0].outline.vertices[0].y, -80.0, 1e-9);
    for (int i = 0; i < 2; i++)
        pp_world_destroy(worlds[i]);
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(behind_an_east_west_wall_the_equinox_shadow_stands_still),
        cmocka_unit_test(the_share_is_that_of_points_followed_minute_by_minute),
        cmocka_unit_test(a_garden_keeps_half_its_sun_or_most_of_what_it_had),
        cmocka_unit_test(a_building_s_garden_is_that_of_one_of_its_rooms),
    };
    add_tests(tests, NULL, NULL);
}
