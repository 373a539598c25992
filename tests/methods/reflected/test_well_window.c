/* test_well_window.c - the light of an atrium or light well on a window, and the average
 * daylight factor of the room behind it. */
#include "methods/reflected/well_window.h"

#include "methods/method.h"
#include "methods/reflected/well.h"
#include "tests/lib/room_of.h"

/* A room and the well in front of its window. */
struct well_rooms {
    struct pp_world *room;
    struct pp_outside_light light;
};

/* A room of 4 x 6 x 3 m whose only window faces the window of that name in the wall
 * "north" of the coarse model. R is 0.45778. */
static const char worked_room[] =
    "<room version='1'><plan width='4' depth='6' height='3'/>"
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
    "<window wall='south' left='0.2' sill='0.9' width='3.6' height='1.5'"
    " glazing='none' maintenance='0.9'/></room>";

static struct well_rooms rooms_with(const char *room, const char *well)
{
    struct well_rooms rooms;
    rooms.room = pp_test_lit_world(&rooms.light, room);
    rooms.room->within = pp_test_world(well);
    rooms.room->within_is_before = true;
    rooms.room->openings[0].is_nested = true;
    rooms.room->openings[0].glass = pp_glass_diffusing(0.68);
    for (int i = 0; i < rooms.room->within->opening_count; i++)
        if (rooms.room->within->openings[i].name)
            rooms.room->openings[0].counterpart = i;
    return rooms;
}

/* A square open well of 10 m, with a window of 0.2 m at a depth below its top. */
static struct well_rooms square_well(double height_m, double depth_m, double walls,
                                     double floor)
{
    char well[700];
    snprintf(well, sizeof well,
             "<room version='1'><plan width='10' depth='10' height='%g'/>"
             "<finishes floor='%g' walls='%g' ceiling='0'/>"
             "<rooflight x='0' y='0' width='10' depth='10' glazing='none'/>"
             "<window name='w' wall='north' left='4.9' sill='%g' width='0.2'"
             " height='0.2' glazing='none'/></room>",
             height_m, floor, walls, height_m - depth_m - 0.1);
    return rooms_with(worked_room, well);
}

static struct pp_well_window light_on(struct well_rooms *rooms)
{
    struct pp_well_window on_window;
    assert_null(pp_well_window_refuses_room(rooms->room));
    assert_null(pp_well_window_refuses(rooms->room, &rooms->light,
                                       &rooms->room->openings[0], NULL));
    assert_int_equal(pp_well_window_of(&on_window, rooms->room, &rooms->light,
                                       &rooms->room->openings[0], NULL),
                     PP_OK);
    return on_window;
}

/* 5 m below the open top of 10 x 10 m, in the middle of a wall: 19.525 % by sums over
 * 360,000 pieces of the top. The window of 0.2 m adds 1e-4. */
static void black_well_gives_the_sky_over_its_rim(void **state)
{
    (void)state;
    struct well_rooms rooms = square_well(10, 5, 0, 0);
    struct pp_well_window on_window = light_on(&rooms);
    assert_near(on_window.sky, 0.19525, 1e-4);
    assert_near(on_window.reflected, 0.0, 0.0);
    pp_world_destroy(rooms.room);
}

/* A floor 5 m below has a configuration factor of 0.19014, by the same sums. Black walls
 * send nothing back, so that the floor has the light that passes a black well. */
static void floor_shines_by_its_configuration_factor(void **state)
{
    (void)state;
    struct well_rooms rooms = square_well(10, 5, 0, 0.37);
    struct pp_glass none = pp_glass_none();
    const struct pp_well_shape cube = {10, 10, 10, 0};
    double on_floor = pp_well_efficiency(&cube, 2.0, &none).direct;
    assert_relative(light_on(&rooms).reflected, 0.37 * on_floor * 0.19014, 1e-3);
    pp_world_destroy(rooms.room);
}

/* Daylight factors of the path tracer on the middle of a wall, with a standard error of
 * about 1 % (docs/cookbook/atrium.md). */
static void light_on_the_wall_is_that_of_the_simulation(void **state)
{
    (void)state;
    static const struct {
        double index, walls, depth, percent;
    } walls[] = {{0.5, 0.7, 0.5, 44.2}, {1, 0.3, 0.75, 18.2},   {1, 0.5, 0.5, 30.0},
                 {1, 0.5, 0.95, 17.8},  {1.5, 0.7, 0.25, 41.4}, {2, 0.3, 0.95, 4.3},
                 {2, 0.5, 0.75, 9.0},   {2, 0.7, 0.95, 9.6}};
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++) {
        double height_m = 10 * walls[i].index;
        struct well_rooms rooms =
            square_well(height_m, walls[i].depth * height_m, walls[i].walls, 0.2);
        struct pp_well_window on_window = light_on(&rooms);
        assert_relative(100.0 * (on_window.sky + on_window.reflected), walls[i].percent,
                        0.05);
        pp_world_destroy(rooms.room);
    }
}

static void well_absorbs_or_loses_all_light_that_enters(void **state)
{
    (void)state;
    struct pp_glass glass = pp_glass_clear_single(), none = pp_glass_none();
    const struct pp_well_shape well = {3.1, 4.7, 9.3, 0.61};
    struct pp_well_flux flux = {.top = 0.0}, open = {.top = 0.0};
    double entering = 0.0, lost = 0.0;
    pp_well_add_sky(&flux, &well, 2.0, &glass, 0.7);
    pp_well_add_sky(&open, &well, 2.0, &none, 1.0);
    for (int i = 0; i < PP_WELL_BANDS; i++) {
        entering += flux.bands[i];
        lost += open.bands[i];
    }
    assert_relative(lost + open.foot, 1.0, 1e-12);
    /* The overcast sky through glass: between its diffuse and its normal share. */
    assert_true(0.7 * glass.diffuse < entering + flux.foot);
    assert_true(entering + flux.foot < 0.7 * 0.9);
    entering += flux.foot;
    pp_well_exchange(&flux, &well, 0.23, 0.41);
    lost = flux.top * (1 - 0.23) + flux.foot * (1 - 0.41);
    for (int i = 0; i < PP_WELL_BANDS; i++)
        lost += flux.bands[i] * (1 - well.sides);
    assert_relative(lost, entering, 1e-12);
}

/* The worked room of test_average_df.c has 2.5163 % for an angle of 65 degrees; 19.525 %
 * on its window is an angle of 39.05 degrees: 1.5117 %. */
static void room_has_the_average_of_the_same_light_on_its_window(void **state)
{
    (void)state;
    struct well_rooms rooms = square_well(10, 5, 0, 0);
    struct pp_part part = {0};
    const struct pp_method *method = &pp_method_average_df_well;
    assert_null(pp_method_refuses_room(method, rooms.room, &rooms.light, NULL));
    assert_int_equal(method->evaluate(rooms.room, &rooms.light,
                                      &rooms.room->openings[0], NULL, NULL, &part,
                                      NULL),
                     PP_OK);
    assert_near(100.0 * part.value, 1.5117, 2e-4);
    pp_world_destroy(rooms.room);
}

/* ---- refusals ---- */

static void assert_refused(const char *well, const char *words)
{
    struct well_rooms rooms = rooms_with(worked_room, well);
    const char *why = pp_well_window_refuses_room(rooms.room);
    if (!why || !strstr(why, words))
        fail_msg("%s: %s", words, why ? why : "not refused");
    pp_world_destroy(rooms.room);
}

#define WALL_WINDOW                                                                    \
    "<window name='w' wall='north' left='1' sill='1' width='3.6' height='1.5'"         \
    " glazing='none'/>"
#define BOX "<room version='1'><plan width='10' depth='8' height='7'/>" WALL_WINDOW
#define ROOF "<rooflight x='1' y='1' width='6' depth='5' "

static void other_models_than_empty_boxes_lit_from_above_are_refused(void **state)
{
    (void)state;
    assert_refused(BOX "</room>", "has no rooflight");
    assert_refused(BOX ROOF "reveal='0.4'/></room>", "slopes or has a reveal");
    assert_refused(BOX ROOF "/><window wall='east' left='1' sill='1' width='2'"
                            " height='2'/></room>",
                   "has a window in a wall");
    assert_refused(BOX ROOF "/><block x='20' y='0' width='9' depth='9' height='30'/>"
                            "</room>",
                   "surfaces, blocks or skylines");
    assert_refused(BOX ROOF "/><skyline wall='south' angle='20'/></room>",
                   "surfaces, blocks or skylines");
    assert_refused(
        "<room version='1'><plan height='7'>"
        "<vertex x='0' y='0'/><vertex x='10' y='0'/><vertex x='8' y='8'/>"
        "<vertex x='0' y='8'/></plan>"
        "<window name='w' wall='3' left='1' sill='1' width='3.6' height='1.5'/>" ROOF
        "/></room>",
        "not a box");
}

static void rooms_without_a_well_are_refused(void **state)
{
    (void)state;
    struct well_rooms rooms = square_well(10, 5, 0, 0);
    rooms.room->within_is_before = false;
    assert_non_null(
        strstr(pp_well_window_refuses_room(rooms.room), "in the place of the room"));
    rooms.room->openings[0].is_nested = false;
    assert_non_null(pp_well_window_refuses(rooms.room, &rooms.light,
                                           &rooms.room->openings[0], NULL));
    pp_world_destroy(rooms.room);

    struct pp_world *alone = pp_test_lit_world(&rooms.light, worked_room);
    assert_non_null(strstr(pp_well_window_refuses_room(alone), "nested"));
    pp_world_destroy(alone);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(black_well_gives_the_sky_over_its_rim),
        cmocka_unit_test(floor_shines_by_its_configuration_factor),
        cmocka_unit_test(light_on_the_wall_is_that_of_the_simulation),
        cmocka_unit_test(well_absorbs_or_loses_all_light_that_enters),
        cmocka_unit_test(room_has_the_average_of_the_same_light_on_its_window),
        cmocka_unit_test(other_models_than_empty_boxes_lit_from_above_are_refused),
        cmocka_unit_test(rooms_without_a_well_are_refused),
    };
    add_tests(tests, NULL, NULL);
}
