/* test_brs_table.c - the BRS simplified daylight table, and openings and obstructions
 * as rectangles. */
#include "methods/brs/brs_table.h"
#include "methods/method.h"

#include <stdio.h>

#include "tests/lib/near.h"

#include "tests/lib/box_room.h"
#include "tests/lib/room_of.h"

static const double printed[][21] = {
#include "tables/brs_simplified_table.inc"
};
enum { ROWS = sizeof printed / sizeof printed[0], COLUMNS = 21 };

static struct pp_part brs_at(const struct box_room *box, int index,
                             struct pp_vec3 position)
{
    struct pp_part part = {0};
    struct pp_receiver receiver = {.position = position, .normal = {0, 0, 1}};
    const struct pp_opening *opening = box->openings + index;
    assert_null(pp_method_brs_table.refuses_room(&box->world, &box->light, &receiver));
    assert_null(
        pp_method_brs_table.refuses(&box->world, &box->light, opening, &receiver));
    assert_int_equal(pp_method_brs_table.evaluate(&box->world, &box->light, opening,
                                                  &receiver, NULL, &part, NULL),
                     PP_OK);
    return part;
}

static void every_printed_cell_is_read_as_printed(void **state)
{
    (void)state;
    assert_int_equal(ROWS, 30);
    for (int i = 1; i < ROWS; i++)
        for (int k = 1; k < COLUMNS; k++)
            assert_near(100.0 * pp_brs_table_read(printed[i][0], printed[0][k]),
                        printed[i][k], 1e-13);
    /* Corners and single cells, entered by hand, in case table and reader have the same
     * error. */
    assert_near(pp_brs_table_read(INFINITY, INFINITY), 0.15, 1e-15);
    assert_near(pp_brs_table_read(0.1, 0.1), 0.0001, 1e-15);
    assert_near(pp_brs_table_read(2.0, 1.0), 0.075, 1e-15);
    assert_near(pp_brs_table_read(0.4, 0.9), 0.0082, 1e-15);
    assert_near(pp_brs_table_read(5.0, 0.4), 0.048, 1e-15);
}

/* The same test for a room: windows with one jamb on the normal, to the right and to
 * the left, for all finite rows and columns of the table. */
static void every_finite_cell_is_what_a_window_of_that_size_gives(void **state)
{
    (void)state;
    double d = 0.7;
    struct box_room box;
    box_room_build(&box, 20.0, 3.0, 8.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 10.0, 0.85, 1.0, 1.0);
    for (int i = 2; i < ROWS; i++)
        for (int k = 1; k < COLUMNS - 1; k++)
            for (int side = -1; side <= 1; side += 2) {
                double width = printed[0][k] * d, height = printed[i][0] * d;
                box.world.opening_count = 0;
                box_room_south(&box, side > 0 ? 10.0 : 10.0 - width, 0.85, width,
                               height);
                struct pp_part part = brs_at(&box, 0, pp_vec(10.0, d, 0.85));
                assert_near(100.0 * part.sky, printed[i][k], 1e-12);
                assert_near(part.external, 0.0, 0.0);
            }
}

static void between_cells_it_is_read_in_proportion(void **state)
{
    (void)state;
    /* halfway between 2.4 and 2.6, and between 1.2 and 1.4: mean of four */
    assert_near(pp_brs_table_read(2.5, 1.3), (9.1 + 9.5 + 9.3 + 9.8) / 400.0, 1e-15);
    /* 1/w halfway between 1/6 and nothing, 1/h between 1/5 and nothing */
    assert_near(pp_brs_table_read(2.0, 12.0), (10.2 + 10.3) / 200.0, 1e-15);
    assert_near(pp_brs_table_read(10.0, 1.0), (9.4 + 9.6) / 200.0, 1e-15);
    /* linear to zero at size zero */
    assert_near(pp_brs_table_read(0.05, 1.0), 0.0005 / 2, 1e-17);
    assert_near(pp_brs_table_read(1.0, 0.05), 0.0057 / 2, 1e-17);
    assert_near(pp_brs_table_read(0.0, 1.0), 0.0, 0.0);
    assert_near(pp_brs_table_read(-1.0, 1.0), 0.0, 0.0);
}

/* The worked use of the table: point 3.0 m from a window 3.0 m wide that reaches 0.9 m
 * to the left and 2.1 m to the right, sill 0.6 m and head 2.4 m above the point. */
static struct pp_part worked_use(double h_over_d_of_obstruction)
{
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 4.0 - 2.1, 0.85 + 0.6, 3.0, 1.8);
    if (h_over_d_of_obstruction > 0.0)
        box_room_skyline(&box, atan(h_over_d_of_obstruction), 2.35, INFINITY);
    return brs_at(&box, 0, pp_vec(4.0, 3.0, 0.85));
}

static void worked_use_step_by_step(void **state)
{
    (void)state;
    /* The steps add printed cells, so that only rounding errors are left. */
    double head = pp_brs_table_read(0.8, 0.3) + pp_brs_table_read(0.8, 0.7);
    double sill = pp_brs_table_read(0.2, 0.3) + pp_brs_table_read(0.2, 0.7);
    double skyline = pp_brs_table_read(0.5, 0.3) + pp_brs_table_read(0.5, 0.7);
    assert_near(head, 0.0360, 1e-15);
    assert_near(sill, 0.0025, 1e-15);
    assert_near(skyline, 0.0152, 1e-15);
    assert_near(worked_use(0.0).sky, 0.0335, 1e-15);
    assert_near(worked_use(0.0).external, 0.0, 0.0);
    assert_near(worked_use(0.5).sky, 0.0208, 1e-15);
    assert_near(worked_use(0.5).external, 0.00254, 1e-15);
}

/* An obstruction below the sill hides nothing; one above the head hides everything. */
static void only_the_higher_of_sill_and_skyline_cuts(void **state)
{
    (void)state;
    assert_near(worked_use(0.15).sky, worked_use(0.0).sky, 1e-15);
    assert_near(worked_use(0.15).external, 0.0, 0.0);
    assert_near(worked_use(0.9).sky, 0.0, 0.0);
    assert_near(worked_use(0.9).external, 0.2 * 0.0335, 1e-15);
}

static void a_near_skyline_is_seen_from_the_point(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 1.9, 1.45, 3.0, 1.8);
    double tan_alpha = 0.6, distance_m = 9.0;
    box_room_skyline(&box, atan(tan_alpha), 2.35, distance_m);
    double d = 3.0, h = (2.35 + distance_m * tan_alpha - 0.85) / (distance_m + d);
    struct pp_part part = brs_at(&box, 0, pp_vec(4.0, d, 0.85));
    double head = pp_brs_table_read(0.8, 0.3) + pp_brs_table_read(0.8, 0.7);
    double skyline = pp_brs_table_read(h, 0.3) + pp_brs_table_read(h, 0.7);
    assert_near(part.sky, head - skyline, 1e-14);
    assert_near(part.external, 0.2 * (skyline - 0.0025), 1e-14);
}

static void a_sill_below_the_point_is_cut_at_its_level(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 4.0, 0.2, 1.0, 2.65);
    struct pp_part part = brs_at(&box, 0, pp_vec(4.0, 2.0, 0.85));
    assert_near(part.sky, pp_brs_table_read(1.0, 0.5), 1e-15);
}

static void behind_or_beside_the_window_nothing_is_seen(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 4.0, 1.0, 1.0, 1.5);
    assert_near(brs_at(&box, 0, pp_vec(4.0, 0.0, 0.85)).sky, 0.0, 0.0);
    assert_near(brs_at(&box, 0, pp_vec(4.0, -1.0, 0.85)).sky, 0.0, 0.0);
    assert_near(brs_at(&box, 0, pp_vec(4.0, 2.0, 3.0)).sky, 0.0, 0.0);
}

/* With a reveal of 0.5 m, seen from 2 m: head and far jamb of the outer outline are at
 * 2.5 m, sill and near jamb of the inner one at 2 m. */
static void light_passes_both_outlines_of_a_reveal(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 4.5, 1.35, 2.0, 1.5);
    box_room_reveal(&box, 0, 0.5);
    struct pp_part part = brs_at(&box, 0, pp_vec(4.0, 2.0, 0.85));
    double left = 0.5 / 2.0, right = 2.5 / 2.5, low = 0.5 / 2.0, high = 2.0 / 2.5;
    double expected = pp_brs_table_read(high, right) - pp_brs_table_read(high, left)
                      - pp_brs_table_read(low, right) + pp_brs_table_read(low, left);
    assert_near(part.sky, expected, 1e-15);
}

static void halves_of_a_window_make_up_the_whole(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 2.3, 1.1, 3.1, 1.7);
    box_room_south(&box, 2.3, 1.1, 1.2, 1.7);
    box_room_south(&box, 3.5, 1.1, 1.9, 1.7);
    box_room_skyline(&box, 0.3, 2.0, 11.0);
    for (double y = 0.4; y < 6.0; y += 0.9)
        for (double x = 0.3; x < 8.0; x += 1.1) {
            struct pp_part whole = brs_at(&box, 0, pp_vec(x, y, 0.85));
            struct pp_part left = brs_at(&box, 1, pp_vec(x, y, 0.85));
            struct pp_part right = brs_at(&box, 2, pp_vec(x, y, 0.85));
            /* Because the table is rounded, a difference can be slightly negative; it
             * then counts as zero. The error is a few units of the last digit. */
            assert_near(left.sky + right.sky, whole.sky, 3e-4);
            assert_near(left.external + right.external, whole.external, 6e-5);
        }
}

/* A fence 3 m high, 5 m in front of the window and parallel to it, that extends beyond
 * both jambs is a vertical rectangle. It hides the same part as a skyline of its
 * height. */
static void a_wide_block_hides_as_a_skyline_of_its_height(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    box_room_south(&box, 3.0, 1.1, 2.0, 1.7);
    struct pp_vec3 fence[4] = {{-10, -5, 0}, {18, -5, 0}, {18, -5, 3}, {-10, -5, 3}};
    struct pp_surface surfaces[BOX_FACES + 1];
    memcpy(surfaces, box.surfaces, sizeof box.surfaces);
    surfaces[BOX_FACES] = (struct pp_surface){.outline = box_polygon(fence),
                                              .role = PP_FREE_SURFACE,
                                              .front = 0.7,
                                              .back = 0.2,
                                              .owner = -1};
    for (double y = 1.6; y < 6.0; y += 0.7) {
        box.world.surfaces = surfaces;
        box.world.surface_count = BOX_FACES + 1;
        struct pp_part by_fence = brs_at(&box, 0, pp_vec(4.2, y, 0.85));
        box.world.surfaces = box.surfaces;
        box.world.surface_count = BOX_FACES;
        box_room_skyline(&box, atan2(3.0 - 1.95, 5.0), 1.95, 5.0);
        struct pp_part by_skyline = brs_at(&box, 0, pp_vec(4.2, y, 0.85));
        box.world.skyline_count = 0;
        assert_true(by_fence.external > 0.0);
        assert_near(by_fence.sky, by_skyline.sky, 1e-14);
        /* The room sees the back or the front of the fence: its normal is -y or +y. */
        double rho = surfaces[BOX_FACES].outline.normal.y > 0.0 ? 0.7 : 0.2;
        assert_near(by_fence.external, rho / 0.2 * by_skyline.external, 1e-14);
    }
}

/* From here on, worlds are read from room files, since obstructions are resolved when a
 * file is read. */

static struct pp_part brs_in(const struct pp_world *world,
                             const struct pp_outside_light *light,
                             struct pp_vec3 position)
{
    struct pp_part part = {0};
    struct pp_receiver receiver = {.position = position, .normal = {0, 0, 1}};
    assert_int_equal(pp_method_brs_table.evaluate(world, light, world->openings,
                                                  &receiver, NULL, &part, NULL),
                     PP_OK);
    return part;
}

/* Table value of a rectangle of the south wall, seen from the point p; x and z in room
 * coordinates. */
static double table_over(struct pp_vec3 p, double x0, double x1, double z0, double z1)
{
    double sum = 0.0;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            double w = (i ? x1 : x0) - p.x, h = (k ? z1 : z0) - p.z;
            sum += (i == k ? 1.0 : -1.0)
                   * copysign(pp_brs_table_read(h / p.y, fabs(w) / p.y), w);
        }
    return sum;
}

#define HALL                                                                           \
    "<room version=\"1\"><plan width=\"8\" depth=\"6\" height=\"4\"/>\n"               \
    "<window wall=\"south\" left=\"3\" sill=\"1.1\" width=\"2\" height=\"1.7\"/>\n"
#define BLOCK(x, width, y, height, reflectance)                                        \
    "<block x=\"" x "\" y=\"" y "\" width=\"" width "\" depth=\"2\" base=\"-1\" "      \
    "height=\"" height "\" reflectance=\"" reflectance "\"/>\n"

/* A screen halfway between point and window hides the part of the window on its side of
 * the line of sight. */
static void a_screen_in_the_room_leaves_the_visible_half(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, HALL
        "<surface reflectance=\"0.5\"><vertex x=\"4\" y=\"1\" z=\"0.1\"/>"
        "<vertex x=\"7.9\" y=\"1\" z=\"0.1\"/><vertex x=\"7.9\" y=\"1\" z=\"3.9\"/>"
        "<vertex x=\"4\" y=\"1\" z=\"3.9\"/></surface></room>");
    struct pp_vec3 p = pp_vec(4.1, 2.0, 0.85);
    /* the line from x = 4.1 past x = 4 meets the wall at 3.9 */
    assert_near(brs_in(world, &light, p).sky, table_over(p, 3.0, 3.9, 1.1, 2.8), 1e-12);
    pp_world_destroy(world);
}

/* The corner of an L-shaped room limits the visible part of the window by a vertical
 * edge only, so the visible part is a rectangle. */
static void the_arm_of_an_l_sees_past_the_corner(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light,
        "<room version=\"1\"><plan height=\"3\"><vertex x=\"0\" y=\"0\"/>"
        "<vertex x=\"4\" y=\"0\"/><vertex x=\"4\" y=\"3\"/><vertex x=\"9\" y=\"3\"/>"
        "<vertex x=\"9\" y=\"6\"/><vertex x=\"0\" y=\"6\"/></plan>"
        "<window wall=\"1\" left=\"0.5\" sill=\"1\" width=\"3\" "
        "height=\"1.5\"/></room>");
    struct pp_vec3 p = pp_vec(4.6, 4.0, 0.85);
    /* The line past the corner (4, 3) meets the window wall at x = 2.2. */
    assert_near(brs_in(world, &light, p).sky, table_over(p, 0.5, 2.2, 1.0, 2.5), 1e-12);
    assert_near(brs_in(world, &light, pp_vec(8.5, 3.5, 0.85)).sky, 0.0, 1e-12);
    pp_world_destroy(world);
}

static void a_round_window_is_the_square_of_its_area(void **state)
{
    (void)state;
    enum { SIDES = 36 };
    char xml[4000] = "<room version=\"1\"><plan width=\"8\" depth=\"6\" height=\"4\"/>"
                     "<opening>";
    double radius = 0.7;
    for (int i = 0; i < SIDES; i++) {
        /* counter-clockwise seen from inside: x decreases to the right */
        double angle = 2 * PP_PI * i / SIDES;
        size_t used = strlen(xml);
        snprintf(xml + used, sizeof xml - used,
                 "<vertex x=\"%.12f\" y=\"0\" z=\"%.12f\"/>", 4 - radius * cos(angle),
                 2 + radius * sin(angle));
    }
    strcat(xml, "</opening></room>");
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    double area = SIDES / 2.0 * sin(2 * PP_PI / SIDES) * radius * radius;
    double half = sqrt(area) / 2;
    struct pp_vec3 p = pp_vec(3.1, 2.7, 0.85);
    assert_near(brs_in(world, &light, p).sky,
                table_over(p, 4 - half, 4 + half, 2 - half, 2 + half), 1e-9);
    pp_world_destroy(world);
}

/* A block parallel to the window shows only its front. Its front is 7.5 m from the
 * point, the wall 2.5 m, so its projection on the wall is a third of its size. */
static void a_block_hides_the_rectangle_of_its_front(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world =
        pp_test_lit_world(&light, HALL BLOCK("3", "1.5", "-7", "4.5", "0.3") "</room>");
    struct pp_vec3 p = pp_vec(4.0, 2.5, 0.85);
    double x0 = 4.0 - 1.0 / 3, x1 = 4.0 + 0.5 / 3, head = 0.85 + (3.5 - 0.85) / 3;
    double hidden = table_over(p, x0, x1, 1.1, head);
    struct pp_part part = brs_in(world, &light, p);
    assert_near(part.sky, table_over(p, 3.0, 5.0, 1.1, 2.8) - hidden, 1e-12);
    assert_near(part.external, 0.3 * hidden, 1e-12);
    pp_world_destroy(world);
}

static void blocks_side_by_side_are_one_and_the_nearer_one_counts(void **state)
{
    (void)state;
    struct pp_outside_light one_light;
    struct pp_world *one = pp_test_lit_world(
        &one_light, HALL BLOCK("2", "4", "-7", "4.5", "0.2") "</room>");
    struct pp_outside_light two_light;
    struct pp_world *two =
        pp_test_lit_world(&two_light, HALL BLOCK("2", "2.5", "-7", "4.5", "0.2") BLOCK(
                                          "4", "2", "-7", "4.5", "0.2") "</room>");
    /* A second block behind it that reaches a lower altitude changes nothing. */
    struct pp_outside_light behind_light;
    struct pp_world *behind =
        pp_test_lit_world(&behind_light, HALL BLOCK("2", "4", "-17", "5", "0.9") BLOCK(
                                             "2", "4", "-7", "4.5", "0.2") "</room>");
    struct pp_vec3 p = pp_vec(4.0, 2.5, 0.85);
    struct pp_part expected = brs_in(one, &one_light, p);
    assert_true(expected.external > 0.0);
    assert_near(brs_in(two, &two_light, p).sky, expected.sky, 1e-14);
    assert_near(brs_in(two, &two_light, p).external, expected.external, 1e-14);
    assert_near(brs_in(behind, &behind_light, p).sky, expected.sky, 1e-14);
    assert_near(brs_in(behind, &behind_light, p).external, expected.external, 1e-14);
    pp_world_destroy(one);
    pp_world_destroy(two);
    pp_world_destroy(behind);
}

/* Pseudo-random number in [0, 1), the same on all machines. */
static double random_number(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-53;
}

/* The table compared with exact integration with the same glass: random windows and
 * skylines, points 1 to 7 m from the window, readings of at least 1 %. For 20,000
 * windows the bias is -1.4 %, the rms deviation 3.4 % and the largest deviation 19 %,
 * for a window far to one side, which is the small difference of two cells. */
static void from_a_metre_on_the_table_is_a_little_low(void **state)
{
    (void)state;
    uint64_t seed = 20260101;
    double sum = 0.0, sum_squares = 0.0, worst = 0.0;
    int count = 0;
    for (int i = 0; i < 2000; i++) {
        struct box_room box;
        box_room_build(&box, 10.0, 9.0, 4.0, 0.2, 0.5, 0.7);
        double width = 0.5 + 4.0 * random_number(&seed);
        double height = 0.5 + 2.0 * random_number(&seed);
        double left = (10.0 - width) * random_number(&seed);
        box_room_south(&box, left, (4.0 - height) * random_number(&seed), width,
                       height);
        if (i % 2)
            box_room_skyline(&box, 40.0 * PP_RAD * random_number(&seed), 2.0, INFINITY);
        struct pp_receiver receiver = {.normal = {0, 0, 1}};
        receiver.position =
            pp_vec(10.0 * random_number(&seed), 1.0 + 6.0 * random_number(&seed), 0.85);
        struct pp_part exact = {0};
        struct pp_part table = brs_at(&box, 0, receiver.position);
        assert_int_equal(pp_method_exact.evaluate(&box.world, &box.light, box.openings,
                                                  &receiver, NULL, &exact, NULL),
                         PP_OK);
        if (exact.sky < 0.01)
            continue;
        double off = table.sky / exact.sky - 1.0;
        count++;
        sum += off;
        sum_squares += off * off;
        worst = fmax(worst, fabs(off));
    }
    assert_in_range(count, 300, 2000);
    /* Tolerance of the mean: three standard errors for 300 readings. */
    assert_near(sum / count, -0.014, 0.006);
    assert_near(sqrt(sum_squares / count), 0.034, 0.006);
    assert_near(worst, 0.0, 0.25);
}

static void more_window_never_gives_less(void **state)
{
    (void)state;
    for (double h = 0.05; h < 8.0; h += 0.13)
        for (double w = 0.05; w < 8.0; w += 0.13) {
            assert_true(pp_brs_table_read(h + 0.13, w) >= pp_brs_table_read(h, w));
            assert_true(pp_brs_table_read(h, w + 0.13) >= pp_brs_table_read(h, w));
        }
}

static void what_the_table_does_not_hold_is_refused(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 8.0, 6.0, 4.0, 0.2, 0.5, 0.7);
    struct pp_opening *window = box_room_south(&box, 3.0, 1.1, 2.0, 1.7);
    struct pp_opening *rooflight =
        box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 4.0), 1.1, 0.7);
    struct pp_receiver up = {.normal = {0, 0, 1}};
    struct pp_receiver wall = {.normal = {0, 1, 0}};
    const struct pp_method *brs = &pp_method_brs_table;
    assert_null(brs->refuses(&box.world, &box.light, window, &up));
    assert_non_null(
        strstr(brs->refuses(&box.world, &box.light, rooflight, &up), "vertical"));
    window->glass = pp_glass_diffusing(0.6);
    assert_non_null(
        strstr(brs->refuses(&box.world, &box.light, window, &up), "diffusing"));
    assert_non_null(
        strstr(brs->refuses_room(&box.world, &box.light, &wall), "face up"));
    box.light.sky = pp_sky_uniform();
    assert_non_null(strstr(brs->refuses_room(&box.world, &box.light, &up), "overcast"));
}

/* Light by the table at (1.3, 1.1). `outside` ends the window's tag; elements may
 * follow. */
static struct pp_part table_in(const char *outside)
{
    char xml[1000];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='4.1' depth='6' height='2.9'/>"
             "<window wall='south' left='0.7' sill='0.6' width='1.9' height='1.7' %s"
             "</room>",
             outside);
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_receiver up = {.position = {1.3, 1.1, 0.85}, .normal = {0, 0, 1}};
    struct pp_part part = {0};
    assert_int_equal(pp_method_brs_table.evaluate(world, &light, &world->openings[0],
                                                  &up, NULL, &part, NULL),
                     PP_OK);
    pp_world_destroy(world);
    return part;
}

/* A façade whose face is 0.3 m in front of the glass hides the same sky as a reveal of
 * 0.5 m. In the plane of the glass it hides nothing. */
static void a_facade_hides_all_round_its_hole(void **state)
{
    (void)state;
    struct pp_part plain = table_in("reveal='0.2'/>");
    struct pp_part flush =
        table_in("reveal='0.2'/><facade wall='south' left='5' up='9'/>");
    struct pp_part deeper = table_in("reveal='0.5'/>");
    struct pp_part recessed =
        table_in("reveal='0.2'/><facade wall='south' left='5' up='9' depth='0.5' "
                 "reflectance='0.3'/>");
    assert_near(flush.sky, plain.sky, 0.0);
    assert_near(flush.external, 0.0, 0.0);
    assert_near(recessed.sky, deeper.sky, 1e-15);
    assert_near(recessed.external, 0.3 * (plain.sky - deeper.sky), 1e-15);
}

/* In an L-shaped room the façade of one wing extends in front of the window of the
 * other wing. It hides the same part as a surface in its place. */
static void another_wall_s_facade_hides_as_a_screen(void **state)
{
    (void)state;
    static const char *const screens[3] = {
        "<facade wall='2' right='1.7' up='1.3' reflectance='0.3'/>",
        "<surface reflectance='0.3'><vertex x='7' y='0' z='0'/>"
        "<vertex x='7' y='4.7' z='0'/><vertex x='7' y='4.7' z='4'/>"
        "<vertex x='7' y='0' z='4'/></surface>",
        ""};
    struct pp_part parts[3];
    struct pp_receiver up = {.position = {2.9, 4.4, 0.85}, .normal = {0, 0, 1}};
    for (int i = 0; i < 3; i++) {
        char xml[1000];
        snprintf(xml, sizeof xml,
                 "<room version='1'><plan height='2.7'><vertex x='0' y='0'/>"
                 "<vertex x='7' y='0'/><vertex x='7' y='3'/><vertex x='4' y='3'/>"
                 "<vertex x='4' y='6'/><vertex x='0' y='6'/></plan>"
                 "<window wall='4' left='0.4' sill='0.9' width='1.9' height='1.5'/>"
                 "%s</room>",
                 screens[i]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, xml);
        parts[i] = (struct pp_part){0};
        assert_int_equal(pp_method_brs_table.evaluate(world, &light,
                                                      &world->openings[0], &up, NULL,
                                                      &parts[i], NULL),
                         PP_OK);
        pp_world_destroy(world);
    }
    /* The surface is placed 0.1 mm in front of the wall. */
    assert_near(parts[0].sky, parts[1].sky, 1e-5);
    assert_near(parts[0].external, parts[1].external, 1e-5);
    assert_true(parts[0].sky < parts[2].sky - 0.01);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_printed_cell_is_read_as_printed),
        cmocka_unit_test(every_finite_cell_is_what_a_window_of_that_size_gives),
        cmocka_unit_test(between_cells_it_is_read_in_proportion),
        cmocka_unit_test(worked_use_step_by_step),
        cmocka_unit_test(only_the_higher_of_sill_and_skyline_cuts),
        cmocka_unit_test(a_near_skyline_is_seen_from_the_point),
        cmocka_unit_test(a_sill_below_the_point_is_cut_at_its_level),
        cmocka_unit_test(behind_or_beside_the_window_nothing_is_seen),
        cmocka_unit_test(light_passes_both_outlines_of_a_reveal),
        cmocka_unit_test(halves_of_a_window_make_up_the_whole),
        cmocka_unit_test(a_wide_block_hides_as_a_skyline_of_its_height),
        cmocka_unit_test(a_facade_hides_all_round_its_hole),
        cmocka_unit_test(another_wall_s_facade_hides_as_a_screen),
        cmocka_unit_test(a_screen_in_the_room_leaves_the_visible_half),
        cmocka_unit_test(the_arm_of_an_l_sees_past_the_corner),
        cmocka_unit_test(a_round_window_is_the_square_of_its_area),
        cmocka_unit_test(a_block_hides_the_rectangle_of_its_front),
        cmocka_unit_test(blocks_side_by_side_are_one_and_the_nearer_one_counts),
        cmocka_unit_test(from_a_metre_on_the_table_is_a_little_low),
        cmocka_unit_test(more_window_never_gives_less),
        cmocka_unit_test(what_the_table_does_not_hold_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
