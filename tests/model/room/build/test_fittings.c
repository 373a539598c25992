/* test_fittings.c - furniture, columns and partitions as surfaces. */
#include "methods/exact/exterior.h"
#include "model/geometry/polygon.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<room version='1'><plan width='6' depth='5' height='2.8'/>"                       \
    "<finishes floor='0.2' walls='0.45' ceiling='0.7'/>"                               \
    "<window wall='south' left='1' sill='0.9' width='3' height='1.5'/>"

/* Index of the first interior surface after faces and reveals. */
static int first_of(const struct pp_world *world)
{
    int i = world->face_count;
    while (i < world->surface_count && world->surfaces[i].role != PP_FREE_SURFACE)
        i++;
    return i;
}

static double area_of(const struct pp_world *world)
{
    double sum = 0.0;
    for (int i = first_of(world); i < world->surface_count; i++) {
        assert_true(world->surfaces[i].inside);
        sum += world->surfaces[i].outline.area_m2;
    }
    return sum;
}

/* A desk of 1.6 x 0.8 x 0.75 m, rotated: four sides and a top. Its base on the floor is
 * not a surface; on legs of 0.1 m the underside is one. The sides face outwards. */
static void furniture_is_a_box_without_its_base_on_the_floor(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        ROOM "<furniture x='2' y='2' width='1.6' depth='0.8' height='0.75' rotate='30' "
             "name='Desk'/></room>");
    assert_int_equal(world->surface_count - first_of(world), 5);
    assert_near(area_of(world), 2.0 * (1.6 + 0.8) * 0.75 + 1.6 * 0.8, 1e-9);
    struct pp_vec3 middle = {2.0 + 0.8 * cos(30 * PP_RAD) - 0.4 * sin(30 * PP_RAD),
                             2.0 + 0.8 * sin(30 * PP_RAD) + 0.4 * cos(30 * PP_RAD),
                             0.375};
    for (int i = first_of(world); i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        assert_true(pp_polygon_height(&surface->outline, middle) < 0.0);
        assert_string_equal(surface->name, "Desk");
        assert_near(surface->front, 0.3, 1e-12);
    }
    pp_world_destroy(world);
    world = pp_test_world(ROOM "<furniture x='2' y='2' z='0.1' width='1.6' depth='0.8' "
                               "height='0.65'/></room>");
    assert_int_equal(world->surface_count - first_of(world), 6);
    pp_world_destroy(world);
}

/* Columns reach the ceiling and have the reflectance of the walls. A round column has
 * the area of its circle, about its centre. */
static void columns_reach_the_ceiling_and_keep_their_area(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world(ROOM "<column x='3' y='2.5' diameter='0.4'/></room>");
    int first = first_of(world);
    assert_int_equal(world->surface_count - first, 12);
    double plan = 0.0;
    for (int i = first; i < world->surface_count; i++) {
        const struct pp_vec3 *v = world->surfaces[i].outline.vertices;
        plan +=
            0.5 * ((v[0].x - 3.0) * (v[1].y - 2.5) - (v[1].x - 3.0) * (v[0].y - 2.5));
        assert_near(world->surfaces[i].front, 0.45, 1e-12);
    }
    assert_near(plan, PP_PI * 0.2 * 0.2, 1e-12);
    pp_world_destroy(world);
    world = pp_test_world(ROOM "<column x='3' y='2.5' width='0.3' height='1'/></room>");
    assert_int_equal(world->surface_count - first_of(world), 5);
    assert_near(area_of(world), 4 * 0.3 + 0.09, 1e-9);
    pp_world_destroy(world);
}

static double sky_seen(const char *partition, double x, double y)
{
    char xml[1024];
    double solid_angle;
    snprintf(xml, sizeof xml, ROOM "%s</room>", partition);
    struct pp_world *world = pp_test_world(xml);
    assert_int_equal(
        pp_exterior_sky_solid_angle(&solid_angle, world, pp_vec(x, y, 0.85), NULL),
        PP_OK);
    pp_world_destroy(world);
    return solid_angle;
}

/* Behind a partition across the whole room no sky is visible. Over one of 1 m a part of
 * the sky is visible, and in front of the partition all of it. */
static void a_partition_hides_the_sky_behind_it(void **state)
{
    (void)state;
    const char *whole = "<partition from='0 2.5' to='6 2.5'/>";
    const char *low = "<partition from='0 2.5' to='6 2.5' height='1'/>";
    assert_true(sky_seen("", 3.0, 4.0) > 0.01);
    assert_near(sky_seen(whole, 3.0, 4.0), 0.0, 0.0);
    assert_near(sky_seen(whole, 3.0, 1.0), sky_seen("", 3.0, 1.0), 1e-12);
    assert_true(sky_seen(low, 3.0, 4.0) < sky_seen("", 3.0, 4.0));
    assert_true(sky_seen(low, 3.0, 4.0) > 0.0);
}

static void check_wrong(const char *fitting, const char *says)
{
    char xml[1024];
    struct pp_mistakes mistakes;
    snprintf(xml, sizeof xml, ROOM "%s</room>", fitting);
    struct pp_world *world = pp_test_resolve(xml, &mistakes);
    assert_null(world);
    assert_int_equal(mistakes.count, 1);
    if (!strstr(mistakes.list[0].text, says))
        fail_msg("\"%s\" does not say \"%s\"", mistakes.list[0].text, says);
    pp_mistakes_clear(&mistakes);
}

/* One message, for any number of sides that are outside. */
static void what_stands_in_a_room_is_all_inside(void **state)
{
    (void)state;
    check_wrong("<furniture x='8' y='2' width='1' depth='1' height='1'/>",
                "is outside the room");
    check_wrong("<furniture x='5.5' y='2' width='1' depth='1' height='1'/>",
                "expected all of it inside");
    check_wrong("<column x='3' y='2' width='0.3' height='4'/>",
                "expected all of it inside");
}

/* Points inside a wardrobe, a round column or a partition, or on the floor below them,
 * are rejected; points above a desk are accepted. */
static void no_receiver_is_inside_an_object_in_a_room(void **state)
{
    (void)state;
    const char *within = "lies inside furniture";
    check_wrong("<furniture x='2' y='2' width='1' depth='0.6' height='2'/>"
                "<point x='2.3' y='2.2'/>",
                within);
    check_wrong("<furniture x='2' y='2' width='1' depth='0.6' height='2'/>"
                "<point x='2.3' y='2.2' z='0'/>",
                within);
    check_wrong("<column x='3' y='2' diameter='0.4'/><point x='3.1' y='2.1'/>", within);
    check_wrong("<partition from='1 2' to='4 2'/><line from='2.3 1' to='2.3 3' "
                "points='3'/>",
                within);
    pp_world_destroy(pp_test_world(
        ROOM "<furniture x='2' y='2' width='1' depth='0.6' height='0.75'/>"
             "<point x='2.3' y='2.2'/></room>"));
}

/* The centres of two of the nine cells of 1.7 by 1.3 m are inside. */
static void grids_leave_out_points_inside_objects(void **state)
{
    (void)state;
    const char *grid = "<grid spacing='1.7' margin='0.5'/></room>";
    const char *cupboard =
        "<furniture x='0.9' y='0.9' width='2.4' depth='0.6' height='2'/>";
    char xml[1024];
    snprintf(xml, sizeof xml, ROOM "%s", grid);
    struct pp_world *bare = pp_test_world(xml);
    snprintf(xml, sizeof xml, ROOM "%s%s", cupboard, grid);
    struct pp_world *world = pp_test_world(xml);
    assert_int_equal(bare->receiver_count, 9);
    assert_int_equal(world->receiver_count, 7);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(furniture_is_a_box_without_its_base_on_the_floor),
        cmocka_unit_test(columns_reach_the_ceiling_and_keep_their_area),
        cmocka_unit_test(a_partition_hides_the_sky_behind_it),
        cmocka_unit_test(what_stands_in_a_room_is_all_inside),
        cmocka_unit_test(no_receiver_is_inside_an_object_in_a_room),
        cmocka_unit_test(grids_leave_out_points_inside_objects),
    };
    add_tests(tests, NULL, NULL);
}
