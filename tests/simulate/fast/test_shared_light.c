/* test_shared_light.c - light calculated once for all receivers is the same as the
 * light calculated for each receiver. */
#include "simulate/estimate/common_variance.h"
#include "simulate/fast/shared_light.h"

#include <math.h>
#include <string.h>

#include "model/results/common_error.h"
#include "simulate/sampling/lobe.h"
#include "simulate/fast/tracer.h"
#include "tests/lib/guessed_room.h"
#include "tests/lib/sized.h"

#define ROOM                                                                           \
    "<room version='1'><plan width='3.3' depth='5.2' height='2.6'/>"                   \
    "<finishes floor='0.3' walls='0.6' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.4' sill='0.9' width='1.7' height='1.2'/>"            \
    "<working-plane height='0.8'/><point x='1.3' y='1.1'/><point x='0.02' y='2.7'/>"   \
    "<point x='3.28' y='5.17'/><point x='1.9' y='4.4' z='0.01'/>"                      \
    "<point x='1.6' y='3.9' nx='0.3' ny='-1' nz='0.2'/></room>"

/* A room and the data shared by its receivers. */
struct shared_room {
    struct pp_test_guessed_room of;
    struct pp_shared_density *density;
    struct pp_shared_lights *lights;
};

static void init(struct shared_room *room, const char *xml)
{
    struct pp_test_guessed_room *of = &room->of;
    pp_test_guessed_room_init(of, xml);
    assert_int_equal(
        pp_shared_density_create(&room->density, of->scene, of->guess, NULL), PP_OK);
    struct pp_path_state path = pp_path_state(of->scene, of->environment, of->guess);
    path.shared = room->density;
    assert_int_equal(pp_shared_light_create(&room->lights, &path, &of->sobol, 4, NULL),
                     PP_OK);
}

static void clear(struct shared_room *room)
{
    pp_shared_light_destroy(room->lights);
    pp_shared_density_destroy(room->density);
    pp_test_guessed_room_clear(&room->of);
}

/* Extends the shared data with this number of threads. */
static enum pp_status extended(struct shared_room *room, int stage, int first,
                               int count, const uint32_t *wanted, int threads)
{
    struct pp_thread_pool *pool;
    assert_int_equal(pp_thread_pool_create(&pool, threads, NULL), PP_OK);
    enum pp_status status =
        pp_shared_light_extend(room->lights, stage, first, count, wanted, pool, NULL);
    pp_thread_pool_destroy(pool);
    return status;
}

/* In a room without windows, with a light of 1 on every surface, its mean over the
 * cosine lobe is 1. The shared part and the part left to rays of the lobe add up to 1,
 * for a tilted receiver and for one a centimetre from a wall, where the second part is
 * large. */
static void shared_and_left_light_are_the_whole_lobe(void **state)
{
    (void)state;
    struct shared_room room;
    init(&room,
         "<room version='1'><plan width='3.3' depth='5.2' height='2.6'/></room>");
    enum { POINTS = 4096, SETS = 16, RAYS = 1 << 15 };
    uint32_t wanted[SETS];
    for (int i = 0; i < SETS; i++)
        wanted[i] = POINTS;
    assert_int_equal(extended(&room, 1, 0, SETS, wanted, 2), PP_OK);
    const struct {
        struct pp_vec3 point, normal;
        double least_left;
    } at[] = {{{1.3, 2.9, 0.8}, {0.0, 0.0, 1.0}, 0.0},
              {{1.1, 0.7, 1.7}, {0.6, 0.0, -0.8}, 0.0},
              {{0.01, 2.9, 0.8}, {0.0, 0.0, 1.0}, 0.4}};
    for (int p = 0; p < 3; p++) {
        struct pp_vec3 from = pp_vec_sub(at[p].point, room.of.scene->centre);
        double shared = 0.0, squares = 0.0;
        for (int i = 0; i < SETS; i++) {
            const struct pp_shared_light *list = pp_shared_light_list(room.lights, i);
            double mean = 0.0;
            for (int k = 0; k < POINTS; k++) {
                struct pp_shared_light one = list[k];
                one.light = 1.0;
                mean += pp_shared_density_taken(&one, from, at[p].normal) / POINTS;
            }
            shared += mean / SETS;
            squares += mean * mean / SETS;
        }
        struct pp_path_state path =
            pp_path_state(room.of.scene, room.of.environment, room.of.guess);
        pp_sobol_sequence_init(&path.light.sequence, &room.of.sobol, 11);
        double left = 0.0;
        struct pp_vec3 a, b;
        pp_lobe_frame(at[p].normal, &a, &b);
        for (uint32_t i = 0; i < RAYS; i++) {
            double u[2];
            pp_sobol_sequence_draw(&path.light.sequence, i, 0, 2, u);
            struct pp_light_ray ray = {
                from, at[p].normal,
                pp_lobe_sample_in_frame(a, b, at[p].normal, u[0], u[1]), PP_INDOORS};
            struct pp_light_hit hit = {.part = -1};
            assert_int_equal(pp_light_scene_meet(room.of.scene, &ray, &hit),
                             PP_MEETS_PART);
            left += pp_shared_density_left(room.density, &ray, &hit) / RAYS;
        }
        double error = sqrt((squares - shared * shared) / (SETS - 1));
        assert_true(left >= at[p].least_left);
        assert_near(error, 0.0, 0.01);
        assert_near(shared + left, 1.0, 4.0 * error + 1e-3);
    }
    clear(&room);
}

/* Without planes of a convex room all rays use the general ray tracer, and each of five
 * points uses its own paths. */
static void compare_with_own_paths(struct pp_world *world,
                                   const struct pp_outside_light *light, double error)
{
    struct pp_light_scene *scene = pp_test_matt_scene(world);
    struct pp_environment *environment = pp_test_light_on(scene, light);
    struct pp_convex_room *convex = scene->convex;
    struct pp_reading df[2][6];
    assert_non_null(convex);
    for (int alone = 0; alone < 2; alone++) {
        scene->convex = alone ? NULL : convex;
        struct pp_tracer_options options = {
            .error = error, .seed = 6, .average = true, .threads = 2};
        struct pp_tracer *tracer;
        assert_int_equal(pp_tracer_create(&tracer, scene, environment, world->receivers,
                                          5, &options, NULL),
                         PP_OK);
        while (!pp_tracer_done(tracer))
            assert_int_equal(pp_tracer_advance(tracer, 1.0, NULL), PP_OK);
        for (int i = 0; i < 6; i++) {
            struct pp_reading readings[PP_COMPONENT_COUNT];
            pp_tracer_read(tracer, i < 5 ? i : -1, readings);
            df[alone][i] = readings[PP_DF];
        }
        pp_tracer_destroy(tracer);
    }
    scene->convex = convex;
    for (int i = 0; i < 6; i++) {
        double both = hypot(df[0][i].std_error, df[1][i].std_error);
        assert_near(df[0][i].value, df[1][i].value, 3.0 * both);
        assert_near(both / df[1][i].value, 0.0, 3.0 * error);
    }
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* Points beside walls, near the floor and tilted, and the average over the working
 * plane. */
static void a_point_that_shares_agrees_with_one_that_does_not(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM);
    compare_with_own_paths(world, &light, PP_SIZED(0.004, 0.008, 0.016));
}

/* The sides of reveals are bright, and not visible from everywhere. One of the points
 * is in a niche, from which most of the room is hidden. */
static void points_share_light_in_a_room_with_reveals(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><plan width='3.3' depth='5.2' height='2.6'/>"
        "<finishes floor='0.3' walls='0.7' ceiling='0.8'/>"
        "<window wall='south' left='0.4' sill='0.9' width='1.2' height='1.2' "
        "reveal='0.4'/>"
        "<window wall='east' left='1.7' sill='0.9' width='1.1' height='1.3' "
        "reveal='0.2'/>"
        "<block x='-3' y='-7' width='9' depth='1' height='5' reflectance='0.5'/>"
        "<working-plane height='0.8'/><point x='1.3' y='1.1'/>"
        "<point x='1' y='0.2' z='1.1'/><point x='0.3' y='4.9'/>"
        "<point x='2.9' y='0.3' z='0.9'/><point x='1.6' y='3.9' nx='0.3' ny='-1' "
        "nz='0.2'/></room>");
    world->receivers[1].position.y = -0.2;
    compare_with_own_paths(world, &light, PP_SIZED(0.01, 0.02, 0.03));
}

/* A receiver in a niche uses no shared light. */
static void not_all_is_seen_from_a_niche(void **state)
{
    (void)state;
    struct shared_room room;
    init(&room, "<room version='1'><plan width='3.3' depth='5.2' height='2.6'/>"
                "<window wall='south' left='0.4' sill='0.9' width='1.7' height='1.2' "
                "reveal='0.4'/></room>");
    struct pp_vec3 in = pp_vec(2.0, 0.1, 1.2), out = pp_vec(2.0, -0.1, 1.2);
    assert_non_null(room.density);
    assert_true(
        pp_shared_density_serves(room.density, pp_vec_sub(in, room.of.scene->centre)));
    assert_false(
        pp_shared_density_serves(room.density, pp_vec_sub(out, room.of.scene->centre)));
    clear(&room);
}

/* A shared point is determined by its number, not by the number of later points, the
 * time of its calculation, or the threads. */
static void shared_points_do_not_depend_on_earlier_requests(void **state)
{
    (void)state;
    struct shared_room room;
    init(&room, ROOM);
    const uint32_t few[] = {7, 0, 40}, many[] = {200, 100, 40};
    struct pp_shared_light once[3][200];
    assert_int_equal(extended(&room, 1, 64, 3, many, 1), PP_OK);
    for (int i = 0; i < 3; i++)
        memcpy(once[i], pp_shared_light_list(room.lights, 64 + i),
               many[i] * sizeof **once);
    assert_int_equal(extended(&room, 0, 0, 3, few, 1), PP_OK);
    assert_true(memcmp(once[0], pp_shared_light_list(room.lights, 0), sizeof once[0][0])
                != 0);
    assert_int_equal(extended(&room, 1, 64, 3, few, 2), PP_OK);
    assert_int_equal(extended(&room, 1, 64, 3, many, 2), PP_OK);
    for (int i = 0; i < 3; i++)
        assert_memory_equal(once[i], pp_shared_light_list(room.lights, 64 + i),
                            many[i] * sizeof **once);
    clear(&room);
}

/* Identical to the bit: alone with one thread, and with other points and three
 * threads. */
static void a_point_that_shares_depends_on_no_other(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM);
    struct pp_tracer_options options = {.error = 0.03, .seed = 9, .threads = 3};
    struct pp_reading(*all)[4] =
        pp_test_trace(world, &light, world->receivers, 5, &options, NULL);
    options.threads = 1;
    for (int i = 4; i >= 0; i--) {
        struct pp_reading(*alone)[4] =
            pp_test_trace(world, &light, &world->receivers[i], 1, &options, NULL);
        for (int k = 0; k < PP_COMPONENT_COUNT; k++) {
            assert_memory_equal(&all[i][k].value, &alone[0][k].value, sizeof(double));
            assert_memory_equal(&all[i][k].std_error, &alone[0][k].std_error,
                                sizeof(double));
        }
        free(alone);
    }
    free(all);
    pp_world_destroy(world);
}

/* Standard errors of the sum over the first points of a list: as stated, for the part
 * common to all points and for that of near points; as observed over runs with
 * different seeds; and as stated if the points were independent. */
struct sum_errors {
    double said, said_near, seen, alone;
};

static struct sum_errors errors_of_sum(struct shared_room *room,
                                       const struct pp_receiver *points, int count,
                                       int first, int seeds)
{
    double mean = 0.0, squares = 0.0, said = 0.0, near = 0.0, alone = 0.0;
    for (int seed = 0; seed < seeds; seed++) {
        struct pp_tracer_options options = {
            .error = 0.03, .seed = (uint64_t)seed, .threads = 1};
        struct pp_tracer *tracer;
        assert_int_equal(pp_tracer_create(&tracer, room->of.scene, room->of.environment,
                                          points, count, &options, NULL),
                         PP_OK);
        while (!pp_tracer_done(tracer))
            assert_int_equal(pp_tracer_advance(tracer, 10.0, NULL), PP_OK);
        double sum = 0.0, errors = 0.0, variance = 0.0;
        for (int i = 0; i < first; i++) {
            struct pp_reading readings[PP_COMPONENT_COUNT];
            pp_tracer_read(tracer, i, readings);
            sum += readings[PP_DF].value;
            errors += readings[PP_DF].std_error;
            variance += readings[PP_DF].std_error * readings[PP_DF].std_error;
        }
        double error = pp_common_error(errors, variance, pp_tracer_common(tracer));
        double error_near =
            pp_common_error(errors, variance, pp_tracer_common_near(tracer));
        double off = sum - mean;
        mean += off / (seed + 1);
        squares += off * (sum - mean);
        said += error * error / seeds;
        near += error_near * error_near / seeds;
        alone += variance / seeds;
        pp_tracer_destroy(tracer);
    }
    struct sum_errors found = {sqrt(said), sqrt(near), sqrt(squares / (seeds - 1)),
                               sqrt(alone)};
    print_message("# said %.3g, of near ones %.3g, seen %.3g, alone %.3g\n", found.said,
                  found.said_near, found.seen, found.alone);
    return found;
}

/* Mean of 30 points over 48 seeds: its observed spread agrees with the one calculated
 * from the standard errors and the stated common part. If the points were assumed
 * independent, the calculated spread would be too small. */
static void what_points_have_in_common_is_known(void **state)
{
    (void)state;
    enum { COLUMNS = 6, POINTS = 30 };
    struct shared_room room;
    init(&room, ROOM);
    struct pp_receiver points[POINTS];
    for (int i = 0; i < POINTS; i++)
        points[i] = pp_test_receiver(0.3 + 0.54 * (i % COLUMNS),
                                     0.4 + 1.0 * (i / COLUMNS), 0.8, 0.0, 0.0, 1.0);
    struct sum_errors sum = errors_of_sum(&room, points, POINTS, POINTS, 48);
    assert_relative(sum.said, sum.seen, 0.3);
    assert_true(sum.seen * sum.seen > 1.3 * sum.alone * sum.alone);
    clear(&room);
}

/* A dozen points 0.2 m apart, and two more dozens far away from them and from each
 * other: points of the same dozen have more in common than points of different
 * dozens. */
static void near_points_have_more_in_common_than_all(void **state)
{
    (void)state;
    enum { DOZEN = PP_COMMON_VARIANCE_NEAREST, POINTS = 3 * DOZEN };
    static const double corner[3][2] = {{1.4, 2.9}, {0.2, 4.3}, {2.4, 1.2}};
    struct shared_room room;
    init(&room, ROOM);
    struct pp_receiver points[POINTS];
    for (int i = 0; i < POINTS; i++)
        points[i] = pp_test_receiver(corner[i / DOZEN][0] + 0.2 * (i % 4),
                                     corner[i / DOZEN][1] + 0.2 * (i % DOZEN / 4), 0.8,
                                     0.0, 0.0, 1.0);
    struct sum_errors sum = errors_of_sum(&room, points, POINTS, DOZEN, 32);
    assert_relative(sum.said_near, sum.seen, 0.3);
    assert_true(sum.said < 0.8 * sum.said_near);
    clear(&room);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shared_and_left_light_are_the_whole_lobe),
        cmocka_unit_test(a_point_that_shares_agrees_with_one_that_does_not),
        cmocka_unit_test(points_share_light_in_a_room_with_reveals),
        cmocka_unit_test(not_all_is_seen_from_a_niche),
        cmocka_unit_test(shared_points_do_not_depend_on_earlier_requests),
        cmocka_unit_test(a_point_that_shares_depends_on_no_other),
        cmocka_unit_test(what_points_have_in_common_is_known),
        cmocka_unit_test(near_points_have_more_in_common_than_all),
    };
    add_tests(tests, NULL, NULL);
}
