/* test_traced_plane.c - interpolation between simulated points, with made-up
 * readings. */
#include "studies/traced_plane.h"

#include <stdlib.h>

#include "methods/direct_plane.h"
#include "methods/method.h"
#include "tests/lib/room_of.h"

/* Between the head of the window and a terrace of houses the room sees a strip of sky,
 * which is hidden from points more than about 1.5 m from the window. */
static const char terrace[] =
    "<room version='1'><plan width='4' depth='6' height='2.7'/>"
    "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5'/>"
    "<block x='-40' y='-20' width='84' depth='10' height='12' reflectance='0.2'/>"
    "<point x='2' y='1'/></room>";

/* A room's points, and their light. */
struct made_up {
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_direct_plane *direct;
    struct pp_traced_plane *plane;
    struct pp_receiver *points;
    int count;
};

static void init(struct made_up *room, const char *xml)
{
    room->world = pp_test_lit_world(&room->light, xml);
    assert_int_equal(pp_direct_plane_create(&room->direct, room->world, &room->light,
                                            &pp_method_exact, NULL),
                     PP_OK);
    assert_int_equal(pp_traced_plane_create(&room->plane, &room->points, &room->count,
                                            room->world, &room->light, NULL),
                     PP_OK);
}

static void clear(struct made_up *room)
{
    free(room->points);
    pp_traced_plane_destroy(room->plane);
    pp_direct_plane_destroy(room->direct);
    pp_world_destroy(room->world);
}

/* Made-up results: an obstruction darker than by the convention of `exact`,
 * increasingly to one side, and reflected light that decreases with depth. */
static double external_at(const struct made_up *room, double x, double y, double *sky)
{
    double external;
    assert_int_equal(pp_direct_plane_at(room->direct, x, y, sky, &external, NULL),
                     PP_OK);
    return (0.58 + 0.03 * x) * external;
}

static double factor_at(const struct made_up *room, double x, double y)
{
    double sky, external = external_at(room, x, y, &sky);
    return sky + external + 0.004 + 0.008 * exp(-0.4 * y);
}

/* error: standard error of each point. */
static void fill(struct made_up *room, double error, double common)
{
    struct pp_reading *factors = calloc((size_t)room->count, sizeof *factors);
    struct pp_reading *external = calloc((size_t)room->count, sizeof *external);
    assert_true(factors && external);
    for (int i = 0; i < room->count; i++) {
        struct pp_vec3 at = room->points[i].position;
        double sky;
        factors[i] = pp_reading_of(factor_at(room, at.x, at.y));
        factors[i].std_error = error;
        external[i] = pp_reading_of(external_at(room, at.x, at.y, &sky));
    }
    assert_int_equal(pp_traced_plane_fill(room->plane, factors, external, common, NULL),
                     PP_OK);
    free(factors);
    free(external);
}

/* Points are about 0.3 m apart, and where the sky becomes hidden the factor changes
 * within a shorter distance: interpolation of the simulated factors had an error of 15
 * % there. The test positions are in rows over the whole plane, except for 0.1 m along
 * its edge. */
static void between_points_the_edge_of_the_sky_is_followed(void **state)
{
    (void)state;
    struct made_up room;
    init(&room, terrace);
    fill(&room, 0.0, 0.0);
    double worst = 0.0;
    for (double y = 0.1; y < 5.9; y += 0.083)
        for (double x = 0.1; x < 3.9; x += 0.097) {
            double value, expected = factor_at(&room, x, y);
            assert_int_equal(pp_traced_plane_value(room.plane, x, y, &value, NULL),
                             PP_OK);
            worst = fmax(worst, fabs(value / expected - 1.0));
        }
    print_message("# within %.3g\n", worst);
    assert_true(worst < 0.005);
    clear(&room);
}

/* The coefficients of the fit add up to 1: common errors of all points are unchanged,
 * individual errors are reduced by averaging. */
static void only_errors_of_their_own_are_evened_out(void **state)
{
    (void)state;
    struct made_up room;
    init(&room, terrace);
    for (double y = 0.7; y < 5.5; y += 0.9) {
        double alone, together;
        fill(&room, 3e-4, 0.0);
        assert_int_equal(pp_traced_plane_error(room.plane, 1.9, y, &alone, NULL),
                         PP_OK);
        fill(&room, 3e-4, 1.0);
        assert_int_equal(pp_traced_plane_error(room.plane, 1.9, y, &together, NULL),
                         PP_OK);
        assert_relative(together, 3e-4, 1e-9);
        assert_true(alone < 0.75 * together);
    }
    clear(&room);
}

/* `exact` does not cover a window with a blind, so nothing is subtracted. */
static void a_room_with_a_blind_has_a_plane(void **state)
{
    (void)state;
    struct made_up room;
    room.world = pp_test_lit_world(
        &room.light,
        "<room version='1'><plan width='4' depth='6' height='2.7'/>"
        "<window wall='south' left='0.5' sill='0.9' width='3' height='1.5'>"
        "<blind angle='-45'/></window><point x='2' y='1'/></room>");
    assert_int_equal(pp_traced_plane_create(&room.plane, &room.points, &room.count,
                                            room.world, &room.light, NULL),
                     PP_OK);
    size_t size = (size_t)room.count + 1;
    struct pp_reading *factors = calloc(size, sizeof *factors);
    struct pp_reading *external = calloc(size, sizeof *external);
    for (int i = 0; i < room.count; i++) {
        struct pp_vec3 at = room.points[i].position;
        factors[i] = pp_reading_of(0.03 * exp(-0.5 * at.y) * (1.0 + 0.1 * at.x));
        external[i] = pp_reading_of(0.0);
    }
    assert_int_equal(pp_traced_plane_fill(room.plane, factors, external, 0.0, NULL),
                     PP_OK);
    for (int i = 0; i < 40; i++) {
        double x = 0.11 + 0.097 * i, y = 5.83 - 0.139 * i, value;
        double expected = 0.03 * exp(-0.5 * y) * (1.0 + 0.1 * x);
        assert_int_equal(pp_traced_plane_value(room.plane, x, y, &value, NULL), PP_OK);
        assert_near(value, expected, 0.01 * expected);
    }
    free(factors);
    free(external);
    free(room.points);
    pp_traced_plane_destroy(room.plane);
    pp_world_destroy(room.world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(between_points_the_edge_of_the_sky_is_followed),
        cmocka_unit_test(only_errors_of_their_own_are_evened_out),
        cmocka_unit_test(a_room_with_a_blind_has_a_plane),
    };
    add_tests(tests, NULL, NULL);
}
