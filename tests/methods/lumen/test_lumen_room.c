/* test_lumen_room.c - flux transfer in the rooms of the lumen method, and the tables
 * calculated from it. */
#include "methods/lumen/lumen_cavity.h"
#include "methods/lumen/lumen_room.h"
#include "methods/lumen/lumen_scope.h"
#include "methods/lumen/lumen_table.h"
#include "methods/lumen/rectangle_factor.h"
#include "methods/exact/solid_angle.h"
#include "tests/lib/room_of.h"
#include "tests/lib/sized.h"
#include "tests/lib/traced.h"

/* Ev/Eh, depth, per cent, then a value for each width; Ev/Eh NAN: light from the
 * ground. */
static const double handbook[][11] = {
#include "tests/methods/lumen/lumen_handbook.inc"
};
enum { HANDBOOK = sizeof handbook / sizeof handbook[0] };

static const double widths[8] = {0.5, 1, 2, 3, 4, 6, 8, INFINITY};

/* Coefficients of a room; Ev/Eh is NAN for the ground. */
static struct pp_lumen_coefficients solve(double width, double depth, double ev_over_eh,
                                          double ceiling, double walls, double *lost)
{
    struct pp_sky sky;
    struct pp_lumen_room *room = NULL;
    bool ground = isnan(ev_over_eh);
    if (!ground)
        assert_int_equal(pp_lumen_room_sky(&sky, ev_over_eh, NULL), PP_OK);
    assert_int_equal(pp_lumen_room_create(&room, width, depth, 1, NULL), PP_OK);
    pp_lumen_room_light(room, ground ? NULL : &sky);
    const struct pp_lumen_finishes finishes = {ceiling, walls};
    struct pp_lumen_coefficients cu = pp_lumen_room_solve(room, &finishes);
    if (lost)
        *lost = pp_lumen_room_imbalance(room);
    pp_lumen_room_destroy(room);
    return cu;
}

/* The two form factors of the unit cube, as printed in handbooks of heat transfer. */
static void faces_of_a_cube_have_the_printed_form_factors(void **state)
{
    (void)state;
    const struct pp_aligned_rectangle floor = {2, {0, 0, 0}, {1, 1, 0}};
    const struct pp_aligned_rectangle ceiling = {2, {0, 0, 1}, {1, 1, 1}};
    const struct pp_aligned_rectangle wall = {0, {0, 0, 0}, {0, 1, 1}};
    assert_near(pp_rectangle_factor_exchange_area(&floor, &ceiling), 0.199825, 5e-7);
    assert_near(pp_rectangle_factor_exchange_area(&floor, &wall), 0.200044, 5e-7);
}

/* All light from a piece of floor arrives on the ceiling and the four walls. */
static void all_light_of_a_piece_of_floor_arrives(void **state)
{
    (void)state;
    const struct pp_aligned_rectangle piece = {2, {0.3, 1.1, 0}, {0.9, 1.3, 0}};
    const struct pp_aligned_rectangle faces[] = {{2, {0, 0, 1.7}, {2.3, 3.1, 1.7}},
                                                 {0, {0, 0, 0}, {0, 3.1, 1.7}},
                                                 {0, {2.3, 0, 0}, {2.3, 3.1, 1.7}},
                                                 {1, {0, 0, 0}, {2.3, 0, 1.7}},
                                                 {1, {0, 3.1, 0}, {2.3, 3.1, 1.7}}};
    double sum = 0.0;
    for (int i = 0; i < 5; i++)
        sum += pp_rectangle_factor_exchange_area(&piece, &faces[i]);
    assert_near(sum, pp_rectangle_factor_area(&piece), 1e-14);
}

/* Form factor of an infinitely long strip to the opposite strip, by crossed strings:
 * (sqrt(w^2 + h^2) - h) / w. */
static void long_strips_go_by_crossed_strings(void **state)
{
    (void)state;
    double w = 1.3, h = 0.7, length = 1e4;
    const struct pp_aligned_rectangle a = {2, {0, 0, 0}, {length, w, 0}};
    const struct pp_aligned_rectangle b = {2, {0, 0, h}, {length, w, h}};
    /* The ends reduce it by 1e-4. */
    assert_relative(pp_rectangle_factor_exchange_area(&a, &b) / (length * w),
                    (hypot(w, h) - h) / w, 2e-4);
}

/* A black room has only direct light, which has a closed form. */
static void black_room_has_the_closed_form_of_its_window(void **state)
{
    (void)state;
    double w = 2.3, d = 3.1;
    struct pp_lumen_room *room = NULL;
    struct pp_sky sky = pp_sky_overcast();
    assert_int_equal(pp_lumen_room_create(&room, w, d, 1, NULL), PP_OK);
    pp_lumen_room_light(room, &sky);
    const struct pp_lumen_finishes black = {0.0, 0.0};
    struct pp_lumen_coefficients cu = pp_lumen_room_solve(room, &black);
    pp_lumen_room_destroy(room);
    const struct pp_vec3 up = {0, 0, 1};
    for (int k = 0; k < PP_LUMEN_POINTS; k++) {
        double y = pp_lumen_places[k] * d;
        const struct pp_vec3 window[4] = {
            {-w / 2, y, 0}, {w / 2, y, 0}, {w / 2, y, 1}, {-w / 2, y, 1}};
        struct pp_moments moments = {0};
        pp_solid_angle_add_moments(&moments, window, 4, up, &up, 1);
        double expected = fabs(pp_solid_angle_sky_component(&moments, &sky))
                          / pp_sky_on_plane(&sky, pp_vec(0, -1, 0));
        assert_relative(cu.at[k], expected,
                        1e-9); /* Gauss-Legendre rule with 48 points */
    }
}

static void light_is_kept(void **state)
{
    (void)state;
    const double lights[] = {1.75, 0.75, 0.396, NAN};
    for (int i = PP_SIZED(0, 2, 2); i < 4; i++) {
        double lost;
        solve(1.7, 4.3, lights[i], 0.7, 0.5, &lost);
        assert_near(lost, 0.0,
                    1e-3); /* lost direct light, since a patch has only four points */
    }
}

/* Compared with the simulation; the working plane is the floor, and no light comes from
 * the ground. Tolerance: the standard error, and 1 % for the mesh. */
static void simulation_agrees(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version='1'><site ground-reflectance='0'/>"
        "<plan width='2' depth='3' height='1'/>"
        "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
        "<window wall='south' left='0' sill='0' width='2' height='1' glazing='none'/>"
        "<working-plane height='0.001'/></room>");
    struct pp_receiver points[PP_LUMEN_POINTS];
    for (int k = 0; k < PP_LUMEN_POINTS; k++)
        points[k] = pp_test_receiver(1.0, 3.0 * pp_lumen_places[k], 0.001, 0, 0, 1);
    struct pp_tracer_options options = pp_test_paths(512);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, points, PP_LUMEN_POINTS, &options, NULL);
    struct pp_lumen_coefficients cu = solve(2.0, 3.0, 0.396, 0.7, 0.5, NULL);
    double ev = pp_sky_on_plane(&light.sky, pp_vec(0, -1, 0));
    for (int k = 0; k < PP_LUMEN_POINTS; k++) {
        struct pp_reading df = traced[k][PP_DF];
        assert_near(df.value / ev, cu.at[k], 3.0 * df.std_error / ev + 0.01 * cu.at[k]);
        assert_true(df.std_error
                    < 0.02 * df.value); /* small enough for a meaningful test */
    }
    free(traced);
    pp_world_destroy(world);
}

static struct pp_lumen_table *own_table(void)
{
    struct pp_lumen_table *table = NULL;
    assert_int_equal(pp_lumen_table_create(&table, NULL), PP_OK);
    return table;
}

static void read_own(double cu[PP_LUMEN_POSITIONS], const struct pp_lumen_table *table,
                     double light, double ceiling, double walls, double depth,
                     double width)
{
    char why[200];
    const struct pp_lumen_query query = {.ev_over_eh = light,
                                         .overcast = light < 0.45,
                                         .at = {ceiling, walls, depth, width}};
    if (!pp_lumen_table_side(cu, table, &query, why, sizeof why))
        fail_msg("%s", why);
}

/* Recalculates a sample of the table: equal to its four digits. */
static void table_is_what_the_rooms_give(void **state)
{
    (void)state;
    static const double cells[][5] = {{0.75, 0.5, 0.9, 3, 0.5},
                                      {1.75, 0.9, 0.3, 1, INFINITY},
                                      {0.396, 0.7, 0.5, 6, 2},
                                      {NAN, 0.7, 0.7, 10, 1}};
    struct pp_lumen_table *table = own_table();
    for (int i = PP_SIZED(0, 1, 2); i < 4; i++) {
        double cu[PP_LUMEN_POSITIONS];
        const double *c = cells[i];
        read_own(cu, table, c[0], c[1], c[2], c[3], c[4]);
        struct pp_lumen_coefficients again = solve(c[4], c[3], c[0], c[1], c[2], NULL);
        for (int k = 0; k < PP_LUMEN_POSITIONS; k++) {
            char printed[32], worked[32];
            snprintf(printed, sizeof printed, "%.4g", cu[k]);
            snprintf(worked, sizeof worked, "%.4g",
                     k < PP_LUMEN_AVERAGE ? again.at[k] : again.average);
            assert_string_equal(printed, worked);
        }
    }
    pp_lumen_table_destroy(table);
}

static void handbook_rows_are_near(void **state)
{
    (void)state;
    struct pp_lumen_table *table = own_table();
    int over = 0, over_wide = 0;
    double squares = 0.0;
    for (int i = 0; i < HANDBOOK; i++)
        for (int w = 0; w < 8; w++) {
            double cu[PP_LUMEN_POSITIONS];
            const double *row = handbook[i];
            read_own(cu, table, row[0], 0.7, 0.5, row[1], widths[w]);
            double off = cu[(int)(row[2] / 20.0)] / row[3 + w] - 1.0;
            squares += off * off;
            over += fabs(off) > 0.20;
            over_wide += fabs(off) > 0.20 && widths[w] > 0.5;
            assert_true(fabs(off) < 0.44);
        }
    /* Differences of 10 to 13 % in each block, mainly at the back of the narrow
     * rooms. */
    assert_true(sqrt(squares / (8 * HANDBOOK)) < 0.12);
    assert_int_equal(HANDBOOK, 25);
    assert_in_range(over, 0, 10);
    assert_in_range(over_wide, 0, 3);
    pp_lumen_table_destroy(table);
}

static void clear_skies_have_their_ratio(void **state)
{
    (void)state;
    const double ratios[] = {1.25, 0.75, 1.0, 1.5, 1.75};
    struct pp_sky sky;
    for (int i = 0; i < PP_SIZED(5, 1, 1); i++) {
        assert_int_equal(pp_lumen_room_sky(&sky, ratios[i], NULL), PP_OK);
        assert_near(pp_sky_on_plane(&sky, pp_vec(0, -1, 0)), ratios[i], 1e-6);
    }
    assert_int_equal(pp_lumen_room_sky(&sky, 4.0, NULL), PP_BAD_INPUT);
}

/* Halfway between the lines of the table, compared with the rooms themselves: 8 %, as
 * documented. */
static void table_is_good_between_its_lines(void **state)
{
    (void)state;
    static const double rooms[][4] = {
        {0.875, 0.4, 5.0, 2.5}, {0.396, 0.6, 1.5, 1.5}, {NAN, 0.6, 2.5, 5.0}};
    struct pp_lumen_table *table = own_table();
    for (int i = PP_SIZED(0, 1, 1); i < 3; i++) {
        double cu[PP_LUMEN_POSITIONS];
        const double *r = rooms[i];
        read_own(cu, table, r[0], 0.8, r[1], r[2], r[3]);
        struct pp_lumen_coefficients own = solve(r[3], r[2], r[0], 0.8, r[1], NULL);
        for (int k = 0; k < PP_LUMEN_POSITIONS; k++)
            assert_relative(cu[k], k < 5 ? own.at[k] : own.average, 0.08);
    }
    pp_lumen_table_destroy(table);
}

/* With very low walls all light falls on the plane; white rooms lose no light; in black
 * rooms the value is the form factor. */
static void light_from_above_has_its_limits(void **state)
{
    (void)state;
    assert_near(pp_lumen_cavity(0.0, 0.0, 0.3, 0.2), 1.0, 1e-12);
    assert_near(pp_lumen_cavity(0.0, 0.5, 0.3, 0.2), 1.0 / 0.9, 1e-12);
    assert_near(pp_lumen_cavity(3.7, 1.0, 1.0, 0.0), 1.0, 1e-12);
    assert_near(pp_lumen_cavity(1e-6, 0.8, 0.5, 0.2),
                pp_lumen_cavity(0.0, 0.8, 0.5, 0.2), 1e-5);
    /* RCR 10: a square room as high as wide, whose form factor is that of the cube. */
    assert_near(pp_lumen_cavity(10.0, 0.0, 0.0, 0.2), 0.199825, 5e-7);
}

static void top_table_is_what_the_cavity_gives(void **state)
{
    (void)state;
    char why[200];
    struct pp_lumen_table *table = own_table();
    for (int rcr = 0; rcr <= 10; rcr++)
        assert_near(pp_lumen_table_top(table, rcr, 0.5, 0.3, why, sizeof why),
                    pp_lumen_cavity(rcr, 0.5, 0.3, 0.2), 5.1e-5);
    assert_true(isnan(pp_lumen_table_top(table, 10.2, 0.5, 0.3, why, sizeof why)));
    assert_string_equal(
        why, "is in a room whose cavity ratio is 10.2; the table covers 0 to 10");
    pp_lumen_table_destroy(table);
}

/* Walls: 2 (4.1 + 5.3) 2.7 = 50.76 m2 of reflectance 0.6, of which a door of 1.9 m2
 * reflects 0.2; the mean is 0.6 - 0.4 * 1.9 / 50.76. */
static void a_door_counts_for_the_area_of_wall_that_it_covers(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan width='4.1' depth='5.3' height='2.7'/>"
        "<finishes floor='0.2' walls='0.6' ceiling='0.7'/>"
        "<door wall='north' left='1' width='0.95' height='2' reflectance='0.2'/>"
        "<point x='2' y='2'/></room>");
    assert_near(pp_lumen_scope_wall_reflectance(world, -1), 0.6 - 0.4 * 1.9 / 50.76,
                1e-12);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_of_a_cube_have_the_printed_form_factors),
        cmocka_unit_test(all_light_of_a_piece_of_floor_arrives),
        cmocka_unit_test(long_strips_go_by_crossed_strings),
        cmocka_unit_test(black_room_has_the_closed_form_of_its_window),
        cmocka_unit_test(light_is_kept),
        cmocka_unit_test(simulation_agrees),
        cmocka_unit_test(table_is_what_the_rooms_give),
        cmocka_unit_test(handbook_rows_are_near),
        cmocka_unit_test(clear_skies_have_their_ratio),
        cmocka_unit_test(table_is_good_between_its_lines),
        cmocka_unit_test(light_from_above_has_its_limits),
        cmocka_unit_test(a_door_counts_for_the_area_of_wall_that_it_covers),
        cmocka_unit_test(top_table_is_what_the_cavity_gives),
    };
    add_tests(tests, NULL, NULL);
}
