/* test_moment_plan_study.c - the plan of a moment compared with sunlight calculated by
 * hand, and with points of df. */
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include "model/room/position.h"
#include "studies/year/moment_plan_study.h"

/* A window 2 m wide from 1.05 to 2.25 m, working plane at 0.85 m, sun due south at 45
 * degrees: the sunlit area is a rectangle of 2 m x 1.2 m that begins 0.2 m from the
 * wall. */
static const char by_hand[] =
    "<room version='1'><plan width='4' depth='5' height='3'/>"
    "<window wall='south' left='1' sill='1.05' width='2' height='1.2' glazing='none'/>"
    "<point x='2' y='0.8'/><point x='2' y='4'/></room>";

static struct pp_moment moment_of(double altitude_deg, double bearing_deg)
{
    struct pp_moment moment;
    const struct pp_moment_irradiances of = {.direct_w_m2 = 700.0,
                                             .diffuse_w_m2 = 110.0,
                                             .sun_altitude_rad = altitude_deg * PP_RAD,
                                             .sun_bearing_rad = bearing_deg * PP_RAD,
                                             .zone_h = NAN,
                                             .latitude_rad = NAN,
                                             .longitude_rad = NAN};
    assert_int_equal(pp_moment_of_irradiances(&moment, &of, NULL), PP_OK);
    return moment;
}

static void make(struct pp_moment_plan *plan, struct pp_study_room *room,
                 const struct pp_moment *moment)
{
    static const struct pp_annual_options options = {
        .samples = 16, .seed = 1, .threads = 2};
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, by_hand);
    *room = (struct pp_study_room){.file = "by-hand.xml",
                                   .world = world,
                                   .light = light,
                                   .receivers = world->receivers,
                                   .receiver_count = world->receiver_count};
    assert_int_equal(pp_moment_plan_study_make(plan, room, moment, &options, NULL),
                     PP_OK);
}

static void clear(struct pp_moment_plan *plan, struct pp_study_room *room)
{
    pp_moment_plan_study_clear(plan);
    pp_world_destroy(room->world);
}

static float sun_at(const struct pp_moment_plan *plan, double x, double y)
{
    int column = (int)(x / plan->cell_m[0] * PP_MOMENT_PLAN_SUB);
    int row = (int)(y / plan->cell_m[1] * PP_MOMENT_PLAN_SUB);
    return plan->sun[row * plan->columns * PP_MOMENT_PLAN_SUB + column];
}

static void sunlit_area_is_the_window_projected_along_the_sun(void **state)
{
    (void)state;
    struct pp_moment_plan plan;
    struct pp_study_room room;
    struct pp_moment moment = moment_of(45.0, 180.0);
    make(&plan, &room, &moment);
    /* Each of four edges is accurate to half a cell, 16 mm. */
    assert_near(plan.sun_share, 2.0 * 1.2 / 20.0, 0.016 * (2.0 + 1.2) / 20.0);
    double level = moment.sky.direct_lx * sqrt(0.5);
    assert_near(plan.sun_lx, level * plan.sun_share, 1e-4 * level);
    assert_near(sun_at(&plan, 1.1, 0.3), level, 1.0);
    assert_near(sun_at(&plan, 2.9, 1.3), level, 1.0);
    assert_near(sun_at(&plan, 0.9, 0.3), 0.0, 0.0);
    assert_near(sun_at(&plan, 2.0, 0.1), 0.0, 0.0);
    assert_near(sun_at(&plan, 2.0, 1.5), 0.0, 0.0);
    assert_true(plan.highest_lx > level && plan.lowest_lx < 0.1 * level);
    clear(&plan, &room);
}

/* With the sun from the south-west, 45 degrees from the window's normal, the area is a
 * parallelogram. It is shifted east by as much as north, and 1/sqrt 2 as deep for the
 * same altitude. */
static void sun_from_the_side_shears_the_area(void **state)
{
    (void)state;
    struct pp_moment_plan plan;
    struct pp_study_room room;
    struct pp_moment moment = moment_of(45.0, 225.0);
    make(&plan, &room, &moment);
    double deep = 1.2 * sqrt(0.5);
    assert_near(plan.sun_share, 2.0 * deep / 20.0, 0.016 * (2.0 + deep) / 20.0);
    double level = moment.sky.direct_lx * sqrt(0.5);
    assert_near(plan.sun_lx, level * plan.sun_share, 1e-4 * level);
    assert_near(sun_at(&plan, 1.0 + 0.5 + 0.1, 0.5), level, 1.0);
    assert_near(sun_at(&plan, 1.0 + 0.5 - 0.1, 0.5), 0.0, 0.0);
    assert_near(sun_at(&plan, 3.0 + 0.5 - 0.1, 0.5), level, 1.0);
    clear(&plan, &room);
}

/* Counts the calls of the callback, and stops at one of them. */
struct stop_watch {
    int looks, last;
};

static bool look_until(void *data, double done, double error)
{
    struct stop_watch *stop = data;
    (void)done, (void)error;
    return ++stop->looks < stop->last;
}

static void a_plan_stops_in_every_part_of_its_computation(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, by_hand);
    const struct pp_study_room room = {.world = world,
                                       .light = light,
                                       .receivers = world->receivers,
                                       .receiver_count = world->receiver_count};
    const struct pp_moment moment = moment_of(45.0, 180.0);
    struct stop_watch stop = {0, 100000};
    const struct pp_annual_options options = {
        .samples = 4,
        .seed = 1,
        .threads = 1,
        .watch = {.look = look_until, .data = &stop}};
    struct pp_moment_plan plan;
    assert_int_equal(pp_moment_plan_study_make(&plan, &room, &moment, &options, NULL),
                     PP_OK);
    pp_moment_plan_study_clear(&plan);
    int looks = stop.looks;
    /* Twice the 16 randomisations, in two phases each; and rows of cells of 0.25 m. */
    assert_true(looks > 2 * 2 * 16 + 5 / 0.25);
    for (int last = 1; last <= looks; last += looks / 12) {
        stop = (struct stop_watch){0, last};
        struct pp_error err;
        assert_int_equal(
            pp_moment_plan_study_make(&plan, &room, &moment, &options, &err),
            PP_INTERRUPTED);
        assert_int_equal(stop.looks, last);
        pp_moment_plan_study_clear(&plan);
    }
    pp_world_destroy(world);
}

/* The plan's light without sun, at a point between cells, agrees with a simulation of
 * this point; a sun in the north lights nothing. */
static void plan_agrees_with_points(void **state)
{
    (void)state;
    struct pp_moment_plan plan;
    struct pp_study_room room;
    struct pp_moment moment = moment_of(30.0, 0.0);
    make(&plan, &room, &moment);
    assert_near(plan.sun_share, 0.0, 0.0);
    for (int i = 0; i < 2; i++) {
        const struct pp_annual_value *own = &plan.points.points[i].year_lxh;
        int row =
            (int)(room.receivers[i].position.y / plan.cell_m[1] * PP_MOMENT_PLAN_SUB);
        int column =
            (int)(room.receivers[i].position.x / plan.cell_m[0] * PP_MOMENT_PLAN_SUB);
        double lx = plan.diffuse[row * plan.columns * PP_MOMENT_PLAN_SUB + column];
        /* 16 paths: about 3 % at the back; curvature within a cell: below 1 %. */
        assert_near(lx, own->value, 4.0 * own->std_error + 0.02 * own->value);
    }
    clear(&plan, &room);
}

/* Corners of 27 and 63 degrees: the nearest cell centre is one cell away. A cupboard
 * 0.1 m from the wall: no cell has its centre in the gap behind it. */
static void corners_and_gaps_have_values(void **state)
{
    (void)state;
    static const char acute[] =
        "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"
        "<vertex x='4.1' y='0'/><vertex x='0' y='2.1'/></plan>"
        "<window wall='1' left='1' sill='0.9' width='1.5' height='1.2'/>"
        "<furniture x='0.1' y='0.3' width='0.3' depth='0.9' height='2'/></room>";
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, acute);
    const struct pp_study_room room = {.world = world, .light = light};
    const struct pp_moment moment = moment_of(45.0, 0.0);
    const struct pp_annual_options options = {.samples = 1, .seed = 1, .threads = 2};
    struct pp_moment_plan plan;
    assert_int_equal(pp_moment_plan_study_make(&plan, &room, &moment, &options, NULL),
                     PP_OK);
    int columns = plan.columns * PP_MOMENT_PLAN_SUB, missing = 0;
    for (int row = 0; row < plan.rows * PP_MOMENT_PLAN_SUB; row++)
        for (int column = 0; column < columns; column++) {
            struct pp_vec3 at =
                pp_vec((column + 0.5) * plan.cell_m[0] / PP_MOMENT_PLAN_SUB,
                       (row + 0.5) * plan.cell_m[1] / PP_MOMENT_PLAN_SUB, 0.85);
            missing += pp_region_contains(&world->plane, at.x, at.y)
                       && !pp_position_in_fitting(world, at)
                       && isnan(plan.diffuse[row * columns + column]);
        }
    assert_int_equal(missing, 0);
    pp_moment_plan_study_clear(&plan);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sunlit_area_is_the_window_projected_along_the_sun),
        cmocka_unit_test(sun_from_the_side_shears_the_area),
        cmocka_unit_test(a_plan_stops_in_every_part_of_its_computation),
        cmocka_unit_test(corners_and_gaps_have_values),
        cmocka_unit_test(plan_agrees_with_points),
    };
    add_tests(tests, NULL, NULL);
}
