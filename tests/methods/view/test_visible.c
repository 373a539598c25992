/* test_visible.c - views with unusual openings, surfaces in the room and obstructions
 * outside, by two independent calculations. */
#include "tests/lib/near.h"

#include <stdio.h>

#include "methods/exact/direct.h"
#include "methods/method.h"
#include "methods/exact/exterior.h"
#include "methods/view/visible.h"
#include "tests/lib/meridians.h"
#include "tests/lib/room_of.h"

static struct pp_receiver receiver_at(double x, double y, double z)
{
    return (struct pp_receiver){{x, y, z}, {0.0, 0.0, 1.0}, 0, 0.0};
}

static struct pp_part part_of(const struct pp_world *world,
                              const struct pp_outside_light *light,
                              const struct pp_receiver *receiver)
{
    struct pp_part sum = {0};
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_part part = {0};
        struct pp_error err = {0};
        if (pp_method_exact.evaluate(world, light, &world->openings[i], receiver, NULL,
                                     &part, &err)
            != PP_OK)
            fail_msg("exact: %s", err.message);
        sum.sky += part.sky;
        sum.external += part.external;
    }
    return sum;
}

/* Compares `exact` with the sum over meridians, for every opening of a room. */
static struct pp_part assert_by_two_routes(const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           struct pp_receiver receiver)
{
    struct pp_part part = part_of(world, light, &receiver);
    double sky = 0.0, external = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        struct pp_meridian_sums sums =
            pp_meridians(world, light, &world->openings[i], &receiver, 1e-11, 3);
        sky += sums.sky;
        external += sums.external;
    }
    assert_near(part.sky, sky, fmax(1e-15, 1e-9 * sky));
    assert_near(part.external, external, fmax(1e-15, 1e-9 * external));
    return part;
}

#define PLAN(inside)                                                                   \
    "<room version='1'><plan width='4.2' depth='5.1' height='2.9'/>" inside "</room>"
#define WINDOW                                                                         \
    "<window wall='south' left='0.7' sill='0.9' width='2.3' height='1.4'"              \
    " glazing='none'/>"

/* An L-shaped room: a wing along the south side, another up the west side. From the end
 * of the west wing the corner hides the window in the east wall; from the junction the
 * window is fully visible. */
static void walls_of_an_l_shaped_room_hide_its_windows(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan height='2.8'><vertex x='0' y='0'/>"
        "<vertex x='7.3' y='0'/><vertex x='7.3' y='3.1'/><vertex x='2.9' y='3.1'/>"
        "<vertex x='2.9' y='8.2'/><vertex x='0' y='8.2'/></plan>"
        "<window wall='2' left='0.4' sill='0.9' width='2.2' height='1.3'"
        " glazing='none'/></room>");
    struct pp_receiver joint = receiver_at(1.3, 1.6, 0.85);
    struct pp_receiver round = receiver_at(1.1, 7.4, 0.85);
    struct pp_receiver partly = receiver_at(2.2, 3.3, 0.85);
    assert_true(assert_by_two_routes(world, &light, joint).sky > 1e-4);
    struct pp_part some = assert_by_two_routes(world, &light, partly);
    assert_true(some.sky > 0.0);
    assert_near(assert_by_two_routes(world, &light, round).sky, 0.0, 0.0);
    double seen;
    assert_int_equal(pp_exterior_sky_solid_angle(&seen, world, round.position, NULL),
                     PP_OK);
    assert_near(seen, 0.0, 0.0);
    assert_int_equal(pp_exterior_sky_solid_angle(&seen, world, partly.position, NULL),
                     PP_OK);
    assert_true(seen > 1e-3);
    pp_world_destroy(world);
}

/* In the same room another window faces the outer wall of the other wing. This wall is
 * an obstruction with the reflectance of outer faces, 0.2. */
static void another_wing_obstructs_from_outside(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan height='2.8'><vertex x='0' y='0'/>"
        "<vertex x='7.3' y='0'/><vertex x='7.3' y='3.1'/><vertex x='2.9' y='3.1'/>"
        "<vertex x='2.9' y='8.2'/><vertex x='0' y='8.2'/></plan>"
        "<window wall='3' left='0.5' sill='0.9' width='3.2' height='1.6'"
        " glazing='none'/></room>");
    struct pp_part part =
        assert_by_two_routes(world, &light, receiver_at(4.4, 1.2, 0.85));
    assert_true(part.sky > 0.0);
    assert_true(part.external > 1e-4);
    pp_world_destroy(world);
}

static void a_partition_inside_hides_light_and_emits_none(void **state)
{
    (void)state;
    struct pp_outside_light bare_light;
    struct pp_world *bare = pp_test_lit_world(&bare_light, PLAN(WINDOW));
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        PLAN(WINDOW "<surface reflectance='0.6'><vertex x='1.9' y='0' z='0'/>"
                    "<vertex x='1.9' y='1.7' z='0'/><vertex x='1.9' y='1.7' z='2.9'/>"
                    "<vertex x='1.9' y='0' z='2.9'/></surface>"));
    struct pp_receiver receiver = receiver_at(1.1, 3.3, 0.85);
    struct pp_part part = assert_by_two_routes(world, &light, receiver);
    assert_true(part.sky < part_of(bare, &bare_light, &receiver).sky);
    assert_near(part.external, 0.0, 0.0);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

/* A block behind the room, a block below the sill and a surface behind the point hide
 * nothing. */
static void objects_out_of_the_way_change_nothing(void **state)
{
    (void)state;
    struct pp_outside_light bare_light;
    struct pp_world *bare = pp_test_lit_world(&bare_light, PLAN(WINDOW));
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, PLAN(WINDOW "<block x='-3' y='6' width='9' depth='4' height='30'/>"
                            "<block x='-9' y='-3' width='30' depth='1' height='0.6'/>"
                            "<surface reflectance='0.5'><vertex x='1' y='4.5' z='0'/>"
                            "<vertex x='2' y='4.5' z='0'/><vertex x='2' y='4.5' z='2'/>"
                            "<vertex x='1' y='4.5' z='2'/></surface>"));
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 0.85);
    struct pp_part part = part_of(world, &light, &receiver),
                   plain = part_of(bare, &bare_light, &receiver);
    assert_near(part.sky, plain.sky, 0.0);
    assert_near(part.external, 0.0, 0.0);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

/* A block against the wall covers the lower half of the window. If it covers the whole
 * window, no sky is left, and the block fills the view. */
static void a_block_against_the_window_covers_it(void **state)
{
    (void)state;
    struct pp_outside_light bare_light;
    struct pp_world *bare = pp_test_lit_world(&bare_light, PLAN(WINDOW));
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, PLAN(WINDOW "<block x='-3' y='-2' width='9' depth='2' height='1.6'/>"));
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 0.85);
    struct pp_part part = assert_by_two_routes(world, &light, receiver);
    double whole = part_of(bare, &bare_light, &receiver).sky;
    assert_near(part.sky + part.external / 0.2, whole, 1e-15);
    assert_true(part.sky > 0.3 * whole && part.sky < 0.9 * whole);
    pp_world_destroy(world);

    world = pp_test_lit_world(
        &light, PLAN(WINDOW "<block x='-3' y='-2' width='9' depth='2' height='5'/>"));
    part = part_of(world, &light, &receiver);
    assert_near(part.sky, 0.0, 1e-15);
    assert_near(part.external, 0.2 * whole, 1e-15);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

/* The nearer of two obstructions with different reflectances counts, in any order in
 * the file. */
static void the_nearer_obstruction_counts(void **state)
{
    (void)state;
#define DARK "<block x='-9' y='-9' width='22' depth='1' height='4' reflectance='0.1'/>"
#define LIGHT                                                                          \
    "<block x='-9' y='-30' width='22' depth='1' height='20' reflectance='0.7'/>"
    struct pp_outside_light one_light;
    struct pp_world *one = pp_test_lit_world(&one_light, PLAN(WINDOW DARK LIGHT));
    struct pp_outside_light other_light;
    struct pp_world *other = pp_test_lit_world(&other_light, PLAN(WINDOW LIGHT DARK));
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 0.85);
    struct pp_part a = assert_by_two_routes(one, &one_light, receiver);
    struct pp_part b = assert_by_two_routes(other, &other_light, receiver);
    assert_near(a.sky, b.sky, 1e-16);
    assert_near(a.external, b.external, 1e-16);
    assert_true(a.external > 0.0);
    pp_world_destroy(one);
    pp_world_destroy(other);
}

static void a_skyline_at_a_distance_is_a_long_wall_there(void **state)
{
    (void)state;
    /* At the middle of the window, z = 1.6: 25 degrees at 12 m. */
    struct pp_outside_light skyline_light;
    struct pp_world *skyline = pp_test_lit_world(
        &skyline_light,
        PLAN(WINDOW "<skyline wall='south' angle='25' distance='12'/>"));
    char xml[1024];
    double head = 1.6 + 12.0 * tan(25.0 * PP_RAD);
    snprintf(xml, sizeof xml,
             PLAN(WINDOW "<surface><vertex x='-1e4' y='-12' z='0'/>"
                         "<vertex x='1e4' y='-12' z='0'/>"
                         "<vertex x='1e4' y='-12' z='%.17g'/>"
                         "<vertex x='-1e4' y='-12' z='%.17g'/></surface>"),
             head, head);
    struct pp_outside_light wall_light;
    struct pp_world *wall = pp_test_lit_world(&wall_light, xml);
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 0.85);
    struct pp_part part = assert_by_two_routes(skyline, &skyline_light, receiver);
    assert_true(part.sky > 0.0 && part.external > 0.0);
    assert_relative(part.sky, part_of(wall, &wall_light, &receiver).sky, 1e-12);
    assert_relative(part.external, part_of(wall, &wall_light, &receiver).external,
                    1e-12);
    struct pp_receiver high = {
        {2.0, 1.0, 2.5}, pp_vec_unit(pp_vec(0.0, -1.0, -0.2)), 0, 0.0};
    part = assert_by_two_routes(skyline, &skyline_light, high);
    assert_relative(part.external, part_of(wall, &wall_light, &high).external, 1e-12);
    pp_world_destroy(skyline);
    pp_world_destroy(wall);
}

/* Through a reveal less is visible, and nothing from beside the window, close to its
 * wall. */
static void a_reveal_narrows_the_view(void **state)
{
    (void)state;
    struct pp_outside_light bare_light;
    struct pp_world *bare = pp_test_lit_world(&bare_light, PLAN(WINDOW));
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        PLAN("<window wall='south' left='0.7' sill='0.9' width='2.3' height='1.4'"
             " glazing='none' reveal='0.35'/>"));
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 0.85);
    struct pp_part part = assert_by_two_routes(world, &light, receiver);
    assert_true(part.sky < part_of(bare, &bare_light, &receiver).sky);
    struct pp_receiver beside = receiver_at(4.1, 0.02, 0.85);
    assert_near(part_of(world, &light, &beside).sky, 0.0, 0.0);
    assert_true(part_of(bare, &bare_light, &beside).sky > 0.0);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

static void a_round_headed_window_is_the_sum_of_its_outline(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        PLAN("<opening glazing='none' reveal='0.1'><vertex x='3.0' y='0' z='0.9'/>"
             "<vertex x='1.0' y='0' z='0.9'/><vertex x='1.0' y='0' z='1.8'/>"
             "<vertex x='1.4' y='0' z='2.3'/><vertex x='2.0' y='0' z='2.5'/>"
             "<vertex x='2.6' y='0' z='2.3'/><vertex x='3.0' y='0' "
             "z='1.8'/></opening>"));
    assert_true(assert_by_two_routes(world, &light, receiver_at(1.2, 2.2, 0.85)).sky
                > 0.01);
    pp_world_destroy(world);
}

/* A rooflight with one corner directly above the point and an edge through its
 * zenith. */
static void a_rooflight_corner_may_stand_overhead(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        PLAN("<rooflight x='1.2' y='1.6' width='1.1' depth='1.7' glazing='none'/>"
             "<block x='9' y='1' width='3' depth='4' height='40'/>"));
    struct pp_part corner = part_of(
        world, &light, &(struct pp_receiver){{1.2, 1.6, 0.8}, {0, 0, 1}, 0, 0.0});
    struct pp_part beside =
        assert_by_two_routes(world, &light, receiver_at(1.2003, 1.6002, 0.8));
    assert_near(corner.sky, beside.sky, 2e-4);
    pp_world_destroy(world);
}

/* A luminous plate that fills the view is a Lambertian emitter: its exitance times the
 * configuration factor of the window, calculated with the uniform sky. */
static void what_shines_outside_gives_its_configuration_factor(void **state)
{
    (void)state;
    struct pp_outside_light bare_light;
    struct pp_world *bare =
        pp_test_lit_world(&bare_light, PLAN("<sky type='uniform'/>" WINDOW));
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        PLAN("<sky type='uniform'/>" WINDOW
             "<surface reflectance='0' exitance='0.3'><vertex x='-200' y='-2' z='-90'/>"
             "<vertex x='200' y='-2' z='-90'/><vertex x='200' y='-2' z='300'/>"
             "<vertex x='-200' y='-2' z='300'/></surface>"));
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 0.85);
    struct pp_part part = part_of(world, &light, &receiver);
    assert_near(part.sky, 0.0, 1e-15);
    assert_relative(part.external, 0.3 * part_of(bare, &bare_light, &receiver).sky,
                    1e-12);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

/* ---- outside ---- */

static void outside_nothing_hides_the_open_sky(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        PLAN(WINDOW "<block x='-40' y='-44' width='3' depth='2' height='0.1'/>"));
    struct pp_exterior_light outside;
    const struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                           .ground_reflectance = 0.2};
    assert_int_equal(pp_exterior_light_on_plane(&outside, world, &light,
                                                pp_vec(2.0, -9.0, 9.0),
                                                pp_vec(0.0, 0.0, 1.0), -1, NULL),
                     PP_OK);
    assert_near(outside.sky, 1.0, 1e-13);
    assert_near(outside.external, 0.0, 1e-13);
    pp_world_destroy(world);
}

/* A wall so long and near that it hides the sky below 30 degrees. */
static void a_long_block_opposite_is_a_continuous_obstruction(void **state)
{
    (void)state;
    double alpha = 30.0 * PP_RAD;
    char xml[512];
    snprintf(xml, sizeof xml,
             PLAN(WINDOW "<block x='-20000' y='-11' width='40000' depth='1'"
                         " height='%.17g'/>"),
             1.6 + 10.0 * tan(alpha));
    struct pp_world *world = pp_test_world(xml);
    double share, paper = 3.0 / 14.0 * (1.0 - sin(alpha))
                          + 4.0 / (7.0 * PP_PI) * cos(alpha) * cos(alpha);
    struct pp_sky sky = pp_sky_overcast();
    assert_int_equal(pp_exterior_sky_on_plane(&share, world, &world->openings[0],
                                              pp_vec(0.0, -1.0, 0.0), &sky, NULL),
                     PP_OK);
    assert_near(share, paper,
                1e-6); /* because of the ends of the block, at 1/2000 of its length */
    pp_world_destroy(world);
}

/* ---- diffusing panes ---- */

static void a_diffusing_pane_emits_what_falls_on_it(void **state)
{
    (void)state;
#define PANE                                                                           \
    "<window wall='south' left='0.7' sill='0.9' width='2.3' height='1.4'"              \
    " transmittance='0.6' diffusing='yes'/>"
    struct pp_outside_light bare_light;
    struct pp_world *bare =
        pp_test_lit_world(&bare_light, PLAN("<sky type='uniform'/>" WINDOW));
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, PLAN(PANE));
    struct pp_receiver receiver = receiver_at(1.4, 2.3, 1.6);
    /* Configuration factor of the whole pane: the value for the uniform sky above the
     * horizon, and, by symmetry about the middle of the window, below it. */
    struct pp_receiver upside_down = receiver;
    upside_down.normal.z = -1.0;
    double factor = part_of(bare, &bare_light, &receiver).sky;
    double vertical = 3.0 / 14.0 + 4.0 / (7.0 * PP_PI);
    struct pp_part part = part_of(world, &light, &receiver);
    assert_relative(part.sky, 0.6 * vertical * factor, 1e-12);
    assert_relative(part.external, 0.6 * 0.2 / 2.0 * factor, 1e-12);
    assert_relative(part_of(world, &light, &upside_down).sky, part.sky, 1e-12);
    double seen;
    assert_int_equal(pp_exterior_sky_solid_angle(&seen, world, receiver.position, NULL),
                     PP_OK);
    assert_near(seen, 0.0, 0.0);
    pp_world_destroy(world);
    pp_world_destroy(bare);
}

/* Positions and weights in ascending order: between borders (at most one) at most 0.3 m
 * apart, a rule of eight positions. */
enum { RULE = 8, PLACES_MOST = 12 * RULE };
static int places_of(double places[][2], double low, double high, double border)
{
    static const double rule[RULE / 2][2] = {
        {0.18343464249564980, 0.36268378337836198},
        {0.52553240991632899, 0.31370664587788729},
        {0.79666647741362674, 0.22238103445337447},
        {0.96028985649753623, 0.10122853629037626}};
    double ends[3] = {low, border > low && border < high ? border : high, high};
    int count = 0;
    for (int part = 0; part < 2; part++) {
        int pieces = (int)ceil((ends[part + 1] - ends[part]) / 0.3);
        double half = pieces ? (ends[part + 1] - ends[part]) / pieces / 2.0 : 0.0;
        for (int i = 0; i < pieces * RULE; i++) {
            const double *node = rule[i % RULE / 2];
            double middle = ends[part] + half * (2 * (i / RULE) + 1);
            assert_true(count < PLACES_MOST);
            places[count][0] = middle + (i % 2 ? half : -half) * node[0];
            places[count++][1] = node[1] * half;
        }
    }
    return count;
}

/* Light of an obstructed pane at points from 0.4 m to the back, compared with a sum
 * over the area of the pane. Its illuminance is not smooth at x and at z. */
static void assert_sum_of_pieces(const char *before, double x, double z)
{
    char xml[2000];
    snprintf(xml, sizeof xml, PLAN(PANE "%s"), before);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    enum { POINTS = 3 };
    double sky[POINTS] = {0.0}, external[POINTS] = {0.0};
    double across[PLACES_MOST][2], up[PLACES_MOST][2];
    int columns = places_of(across, 0.7, 3.0, x), rows = places_of(up, 0.9, 2.3, z);
    const struct pp_receiver points[POINTS] = {receiver_at(1.4, 0.4, 0.85),
                                               receiver_at(2.7, 1.9, 0.85),
                                               receiver_at(0.3, 4.1, 0.2)};
    for (int i = 0; i < columns; i++)
        for (int k = 0; k < rows; k++) {
            struct pp_vec3 at = {across[i][0], 0.0, up[k][0]};
            struct pp_exterior_light outside;
            assert_int_equal(pp_exterior_light_on_plane(&outside, world, &light, at,
                                                        pp_vec(0.0, -1.0, 0.0),
                                                        world->openings[0].face, NULL),
                             PP_OK);
            for (int p = 0; p < POINTS; p++) {
                struct pp_vec3 v = pp_vec_sub(at, points[p].position);
                double r2 = pp_vec_dot(v, v);
                double weight = 0.6 / PP_PI * fmax(0.0, v.z) * -v.y / (r2 * r2)
                                * across[i][1] * up[k][1];
                sky[p] += weight * outside.sky;
                external[p] += weight * outside.external;
            }
        }
    void *tools = NULL;
    assert_int_equal(pp_method_exact.prepare_fast(&tools, world, &light, NULL), PP_OK);
    for (int p = 0; p < POINTS; p++) {
        struct pp_part part = {0};
        assert_int_equal(pp_method_exact.evaluate(world, &light, &world->openings[0],
                                                  &points[p], tools, &part, NULL),
                         PP_OK);
        assert_relative(part.sky, sky[p],
                        1e-6); /* accuracy promised by exact.h with glass */
        assert_relative(part.external, external[p], 1e-6);
    }
    pp_method_exact.destroy_tools(tools);
    pp_world_destroy(world);
}

#define SHELF(y)                                                                       \
    "<surface reflectance='0.1'><vertex x='0.2' y='" y "' z='1.5'/>"                   \
    "<vertex x='3.4' y='" y "' z='1.5'/><vertex x='3.4' y='-1' z='1.5'/>"              \
    "<vertex x='0.2' y='-1' z='1.5'/></surface>"

/* Smooth illuminance, with kinks and with a jump: a block whose top and side are in
 * line with the pane, a shelf 0.2 m in front of it, a shelf that touches it, and a fin
 * that touches it. */
static void a_pane_lit_unevenly_is_the_sum_of_its_pieces(void **state)
{
    (void)state;
    assert_sum_of_pieces("<block x='3.5' y='-5' width='3' depth='2' height='6'/>", 0,
                         0);
    assert_sum_of_pieces("<block x='1.9' y='-5' width='3' depth='2' height='1.7'/>",
                         1.9, 1.7);
    assert_sum_of_pieces(SHELF("-0.2"), 0, 1.5);
    assert_sum_of_pieces(SHELF("0"), 0, 1.5);
    assert_sum_of_pieces("<surface reflectance='0.1'><vertex x='1.2' y='0' z='0.5'/>"
                         "<vertex x='1.2' y='0' z='2.7'/><vertex x='1.2' y='-1' "
                         "z='2.7'/><vertex x='1.2' y='-1' z='0.5'/></surface>",
                         1.2, 0);
}

/* The illuminance of the pane, calculated once for the room or for the receiver, is
 * identical. The approximate rule of averages is as accurate as stated in method.h,
 * from 0.1 to 2.75 m. */
static void an_uneven_pane_is_the_same_prepared_and_roughly(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, PLAN(PANE "<block x='1.9' y='-5' width='3' depth='2' height='6'/>"));
    const struct pp_method *exact = &pp_method_exact;
    void *tools = NULL;
    assert_int_equal(exact->prepare_fast(&tools, world, &light, NULL), PP_OK);
    assert_non_null(tools);
    for (int i = 0; i < 6; i++) {
        struct pp_receiver receiver = receiver_at(0.7 + 0.37 * i, 0.1 + 0.53 * i, 0.85);
        struct pp_part plain = part_of(world, &light, &receiver), prepared = {0},
                       rough = {0};
        assert_int_equal(exact->evaluate(world, &light, &world->openings[0], &receiver,
                                         tools, &prepared, NULL),
                         PP_OK);
        assert_int_equal(exact->evaluate_roughly(world, &light, &world->openings[0],
                                                 &receiver, tools, &rough, NULL),
                         PP_OK);
        assert_true(plain.sky > 0.0 && prepared.sky == plain.sky);
        assert_true(prepared.external == plain.external);
        assert_relative(rough.sky, plain.sky, 1e-4);
        assert_relative(rough.external, plain.external, 1e-4);
    }
    exact->destroy_tools(tools);
    pp_world_destroy(world);
}

/* Light of an obstruction that replaces the hidden sky: rho times that sky under the
 * overcast sky, half of rho under any other. */
static void hidden_sky_counts_by_the_reflectance_or_by_half_of_it(void **state)
{
    (void)state;
    static const struct {
        const char *sky;
        double share;
    } skies[] = {{"<sky type='overcast'/>", 1.0},
                 {"<sky type='uniform'/>", 0.5},
                 {"<sky type='iso-5'/>", 0.5}};
    for (int i = 0; i < 3; i++) {
        struct pp_part parts[2];
        for (int block = 0; block < 2; block++) {
            char xml[600];
            snprintf(xml, sizeof xml, PLAN("%s" WINDOW "%s"), skies[i].sky,
                     block ? "<block x='-2' y='-9' width='6.3' depth='4' height='5.7' "
                             "reflectance='0.34'/>"
                           : "");
            struct pp_outside_light light;
            struct pp_world *world = pp_test_lit_world(&light, xml);
            struct pp_receiver point = receiver_at(1.7, 1.3, 0.75);
            parts[block] = part_of(world, &light, &point);
            pp_world_destroy(world);
        }
        assert_near(parts[0].external, 0.0, 1e-15);
        assert_true(parts[1].external > 1e-3);
        assert_near(parts[1].external,
                    0.34 * skies[i].share * (parts[0].sky - parts[1].sky), 1e-8);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_of_an_l_shaped_room_hide_its_windows),
        cmocka_unit_test(another_wing_obstructs_from_outside),
        cmocka_unit_test(a_partition_inside_hides_light_and_emits_none),
        cmocka_unit_test(objects_out_of_the_way_change_nothing),
        cmocka_unit_test(a_block_against_the_window_covers_it),
        cmocka_unit_test(the_nearer_obstruction_counts),
        cmocka_unit_test(hidden_sky_counts_by_the_reflectance_or_by_half_of_it),
        cmocka_unit_test(a_skyline_at_a_distance_is_a_long_wall_there),
        cmocka_unit_test(a_reveal_narrows_the_view),
        cmocka_unit_test(a_round_headed_window_is_the_sum_of_its_outline),
        cmocka_unit_test(a_rooflight_corner_may_stand_overhead),
        cmocka_unit_test(what_shines_outside_gives_its_configuration_factor),
        cmocka_unit_test(outside_nothing_hides_the_open_sky),
        cmocka_unit_test(a_long_block_opposite_is_a_continuous_obstruction),
        cmocka_unit_test(a_diffusing_pane_emits_what_falls_on_it),
        cmocka_unit_test(a_pane_lit_unevenly_is_the_sum_of_its_pieces),
        cmocka_unit_test(an_uneven_pane_is_the_same_prepared_and_roughly),
    };
    add_tests(tests, NULL, NULL);
}
