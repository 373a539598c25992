/* test_radiosity.c - radiosity compared with known values, to 0.1 %. */
#include "simulate/research/radiosity/plane_points.h"
#include "tests/lib/radiosity_of.h"
#include "tests/lib/random_rooms.h"
#include "tests/lib/sized.h"

static struct pp_radiosity_options level_options(double error)
{
    return (struct pp_radiosity_options){.error = error, .threads = 1};
}

/* Two receivers with the first level of refinement only, which suffices if light
 * changes little. */
static void first_level(const struct pp_world *world,
                        const struct pp_outside_light *light,
                        const struct pp_receiver receivers[2], int threads,
                        struct pp_reading found[2][PP_COMPONENT_COUNT])
{
    struct pp_radiosity_options options = {.error = 0.01, .threads = threads};
    struct pp_radiosity *elements;
    assert_int_equal(
        pp_radiosity_create(&elements, world, light, receivers, 2, &options, NULL),
        PP_OK);
    assert_int_equal(pp_radiosity_advance(elements, NULL), PP_OK);
    for (int i = 0; i < 2; i++)
        pp_radiosity_read(elements, i, found[i]);
    pp_radiosity_destroy(elements);
}

#define BOX "<plan width='3.1' depth='4.3' height='2.6'/>"

static void a_closed_room_is_dark(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'>" BOX "<point x='1.2' y='2.3'/></room>");
    struct pp_radiosity_options options = level_options(0.01);
    struct pp_reading(*found)[4] =
        pp_test_elements(world, &light, world->receivers, 1, &options, NULL);
    for (int point = 0; point < 2; point++)
        for (int i = 0; i < PP_COMPONENT_COUNT; i++)
            assert_near(found[point][i].value, 0.0, 0.0);
    free(found);
    pp_world_destroy(world);
}

static void the_open_sky_is_all_there_is_without_a_room(void **state)
{
    (void)state;
    const struct pp_world world = {0};
    struct pp_outside_light light = {.sky = pp_sky_overcast(),
                                     .ground_reflectance = 0.3};
    const struct pp_receiver receivers[] = {
        pp_test_receiver(1.0, 2.0, 3.0, 0.0, 0.0, 1.0),
        pp_test_receiver(1.0, 2.0, 3.0, 0.3, -0.4, 0.0)};
    struct pp_radiosity_options options = level_options(0.0);
    struct pp_reading(*found)[4] =
        pp_test_elements(&world, &light, receivers, 2, &options, NULL);
    assert_near(found[0][PP_SC].value, 1.0, 1e-3);
    assert_near(found[0][PP_ERC].value, 0.0, 0.0);
    assert_near(found[1][PP_SC].value, 0.396177, 1e-3);
    assert_near(found[1][PP_ERC].value, 0.15, 1e-3);
    free(found);
}

/* Every surface emits 1 and reflects rho of the light it receives: 1 + rho + rho^2 +
 * ... at all points. */
static void a_furnace_glows_with_one_over_one_less_rho(void **state)
{
    (void)state;
    const double reflectances[] = {0.0, 0.5, 0.9};
    const struct pp_receiver receivers[] = {
        pp_test_receiver(1.2, 2.3, 0.7, 0.2, 0.3, 1.0),
        pp_test_receiver(0.001, 2.3, 0.7, -1.0, 0.0, 0.0),
        pp_test_receiver(0.001, 0.001, 0.001, -0.3, -0.5, -0.7),
    };
    enum { COUNT = sizeof receivers / sizeof *receivers };
    struct pp_outside_light light;
    struct pp_world *world =
        pp_test_lit_world(&light, "<room version='1'>" BOX "</room>");
    for (size_t i = 0; i < sizeof reflectances / sizeof *reflectances; i++) {
        for (int k = 0; k < world->surface_count; k++) {
            world->surfaces[k].exitance = 1.0;
            world->surfaces[k].front = reflectances[i];
        }
        struct pp_radiosity_options options = level_options(0.01);
        struct pp_reading(*found)[4] =
            pp_test_elements(world, &light, receivers, COUNT, &options, NULL);
        for (int k = 0; k <= COUNT; k++)
            assert_relative(found[k][PP_IRC].value, 1.0 / (1.0 - reflectances[i]),
                            1e-6);
        free(found);
    }
    pp_world_destroy(world);
}

/* A long or wide room whose walls are black. */
static struct pp_world *black_walled(struct pp_outside_light *light, const char *plan,
                                     const double given[2], const double reflectance[2])
{
    char xml[200];
    snprintf(xml, sizeof xml, "<room version='1'><plan %s/><point x='1' y='1'/></room>",
             plan);
    struct pp_world *world = pp_test_lit_world(light, xml);
    for (int i = 0; i < world->surface_count; i++) {
        struct pp_surface *surface = &world->surfaces[i];
        bool upper = surface->role == PP_CEILING, wall = surface->role == PP_WALL;
        surface->front = wall ? 0.0 : reflectance[upper];
        surface->exitance = wall ? 0.0 : given[upper];
    }
    return world;
}

/* Far from the edges, floor and ceiling of a wide room are infinite plates:
 *
 *    B_f = M_f + rho_f B_c,  B_c = M_c + rho_c B_f
 */
static void two_plates_light_each_other_by_a_geometric_series(void **state)
{
    (void)state;
    const double given[2] = {0.3, 1.7}, reflectance[2] = {0.4, 0.8};
    struct pp_outside_light light;
    struct pp_world *world =
        black_walled(&light, "width='100' depth='100' height='1'", given, reflectance);
    const struct pp_receiver receivers[] = {
        pp_test_receiver(50.0, 50.0, 0.6, 0.0, 0.0, 1.0),
        pp_test_receiver(49.0, 51.0, 0.4, 0.0, 0.0, -1.0)};
    struct pp_reading found[2][PP_COMPONENT_COUNT];
    first_level(world, &light, receivers, 1, found);
    double more = 1.0 - reflectance[0] * reflectance[1];
    assert_relative(found[0][PP_IRC].value,
                    (given[1] + reflectance[1] * given[0]) / more, 1e-3);
    assert_relative(found[1][PP_IRC].value,
                    (given[0] + reflectance[0] * given[1]) / more, 1e-3);
    pp_world_destroy(world);
}

/* ---- a corridor ---- */

enum { NODES = 200 };

/* Floor and ceiling of an infinitely long corridor, w wide and h apart, between black
 * walls. Light only changes across the corridor; a strip dx' of the other plane
 * contributes
 *
 *    K(x - x', h) dx',  K(x, h) = h^2 / (2 (x^2 + h^2)^(3/2)),
 *
 * so B_f = M + rho int K B_c, B_c = rho int K B_f, solved by the midpoint rule and by
 * iteration. Returns the illuminance from above at x, h - z below the ceiling.
 */
static double corridor(double w, double h, double given, double rho, double x, double z)
{
    double f[NODES], c[NODES] = {0.0}, step = w / NODES, sum = 0.0;
    for (int turn = 0; turn < 60; turn++)
        for (int half = 0; half < 2; half++)
            for (int i = 0; i < NODES; i++) {
                double taken = 0.0;
                for (int k = 0; k < NODES; k++) {
                    double off = (i - k) * step;
                    taken += step * h * h / (2.0 * pow(off * off + h * h, 1.5))
                             * (half ? f[k] : c[k]);
                }
                if (half)
                    c[i] = rho * taken;
                else
                    f[i] = given + rho * taken;
            }
    for (int k = 0; k < NODES; k++) {
        double off = x - (k + 0.5) * step, up = h - z;
        sum += step * up * up / (2.0 * pow(off * off + up * up, 1.5)) * c[k];
    }
    return sum;
}

static void a_corridor_solves_its_integral_equation(void **state)
{
    (void)state;
    const double given[2] = {1.0, 0.0}, reflectance[2] = {0.7, 0.7};
    struct pp_outside_light light;
    struct pp_world *world =
        black_walled(&light, "width='2.2' depth='90' height='1.9'", given, reflectance);
    const struct pp_receiver receivers[] = {
        pp_test_receiver(0.6, 45.0, 0.4, 0.0, 0.0, 1.0),
        pp_test_receiver(1.1, 45.0, 1.1, 0.0, 0.0, 1.0)};
    struct pp_reading found[2][PP_COMPONENT_COUNT];
    first_level(world, &light, receivers, 1, found);
    assert_relative(found[0][PP_IRC].value, corridor(2.2, 1.9, 1.0, 0.7, 0.6, 0.4),
                    1e-3);
    assert_relative(found[1][PP_IRC].value, corridor(2.2, 1.9, 1.0, 0.7, 1.1, 1.1),
                    1e-3);
    pp_world_destroy(world);
}

/* ---- a sphere ---- */

enum {
    DIVISIONS = 8
}; /* of each edge of the octahedron from which the sphere is made */

static struct pp_vec3 on_sphere(const double sign[3], int i, int k)
{
    double x = i, y = k, z = DIVISIONS - i - k, off = sqrt(x * x + y * y + z * z) / 2.0;
    return pp_vec(3.0 + sign[0] * x / off, 3.0 + sign[1] * y / off,
                  3.0 + sign[2] * z / off);
}

/* Counter-clockwise seen from inside, as envelopes are written. */
static char *write_face(char *to, const struct pp_vec3 corner[3])
{
    struct pp_vec3 middle = pp_vec(3.0, 3.0, 3.0);
    struct pp_vec3 n = pp_vec_cross(pp_vec_sub(corner[1], corner[0]),
                                    pp_vec_sub(corner[2], corner[0]));
    bool outward = pp_vec_dot(n, pp_vec_sub(corner[0], middle)) > 0.0;
    double up = (outward ? n.z : -n.z) / pp_vec_length(n);
    const char *role = up < -0.7 ? "floor" : up > 0.7 ? "ceiling" : "wall";
    static int number;
    to += sprintf(to, "<face role='%s' name='f%d'>", role, number++);
    for (int i = 0; i < 3; i++) {
        struct pp_vec3 at = corner[outward ? 2 - i : i];
        to += sprintf(to, "<vertex x='%.12f' y='%.12f' z='%.12f'/>", at.x, at.y, at.z);
    }
    return to + sprintf(to, "</face>");
}

/* A sphere of radius 2 m about (3, 3, 3), made of flat triangles. */
static struct pp_world *sphere(struct pp_outside_light *light)
{
    char *xml = malloc(8 * DIVISIONS * DIVISIONS * 320 + 1000);
    assert_non_null(xml);
    char *to = xml + sprintf(xml, "<room version='1'><envelope>");
    for (int octant = 0; octant < 8; octant++) {
        double sign[3] = {octant & 1 ? -1.0 : 1.0, octant & 2 ? -1.0 : 1.0,
                          octant & 4 ? -1.0 : 1.0};
        for (int i = 0; i < DIVISIONS; i++)
            for (int k = 0; k < DIVISIONS - i; k++) {
                struct pp_vec3 a = on_sphere(sign, i, k), b = on_sphere(sign, i + 1, k),
                               c = on_sphere(sign, i, k + 1);
                to = write_face(to, (struct pp_vec3[]){a, b, c});
                if (i + k < DIVISIONS - 1)
                    to = write_face(
                        to, (struct pp_vec3[]){b, on_sphere(sign, i + 1, k + 1), c});
            }
    }
    sprintf(to, "</envelope><working-plane height='2'/></room>");
    struct pp_world *world = pp_test_lit_world(light, xml);
    free(xml);
    return world;
}

/* In an integrating sphere all points receive the same light, wherever it is emitted:
 * if the lower half emits 1, E = 1/2 / (1 - rho). */
static void an_integrating_sphere_is_even(void **state)
{
    (void)state;
    const double rho = 0.8;
    struct pp_outside_light light;
    struct pp_world *world = sphere(&light);
    for (int k = 0; k < world->surface_count; k++) {
        const struct pp_vec3 *corner = world->surfaces[k].outline.vertices;
        bool lower = corner[0].z + corner[1].z + corner[2].z < 9.0;
        world->surfaces[k].exitance = lower ? 1.0 : 0.0;
        world->surfaces[k].front = rho;
    }
    const struct pp_receiver receivers[] = {
        pp_test_receiver(3.0, 3.0, 1.01, 0.0, 0.0, 1.0),
        pp_test_receiver(3.0, 3.0, 4.99, 0.0, 0.0, -1.0)};
    struct pp_reading found[2][PP_COMPONENT_COUNT];
    first_level(world, &light, receivers, 1, found);
    for (int i = 0; i < 2; i++)
        assert_relative(found[i][PP_IRC].value, 0.5 / (1.0 - rho), 1e-3);
    pp_world_destroy(world);
}

/* ---- sky components ---- */

/* Compared with an independent quadrature (random_rooms.h). */
static void sky_components_keep_the_error_that_is_stated(void **state)
{
    (void)state;
    int count = 0, kept = 0;
    for (int room = 0; room < PP_SIZED(2, 1, 1); room++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_random_room(&light, 300 + (uint64_t)room, 6);
        struct pp_radiosity_options options = level_options(0.0);
        struct pp_reading(*found)[4] =
            pp_test_elements(world, &light, world->receivers, 6, &options, NULL);
        for (int i = 0; i < 6; i++) {
            double truth = pp_test_sky_component(world, &light, &world->receivers[i]);
            kept += fabs(found[i][PP_SC].value - truth) <= found[i][PP_SC].std_error;
            assert_near(found[i][PP_SC].value, truth, 0.01 * truth + 1e-5);
            count++;
        }
        free(found);
        pp_world_destroy(world);
    }
    assert_true(kept >= PP_SIZED(0.9, 0.8, 0.8) * count); /* 11 of 12, 5 of 6 */
}

#define SILL "left='0.5' sill='1.4' width='3' height='1.6' glazing='clear-single'"

/* Light at a point at the height of the sill, `away` from the middle of the pane.
 * Midpoint rule over azimuth from its normal and altitude, from a skyline 30 degrees
 * high, which appears lower to the sides, up to the head. */
static double before_the_sill(const struct pp_world *world,
                              const struct pp_outside_light *light, double away)
{
    enum { STEPS = 400 };
    double most = atan(1.5 / away), sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double azimuth = most * (2.0 * (i + 0.5) / STEPS - 1.0);
        double low = atan(tan(PP_PI / 6.0) * cos(azimuth));
        double high = atan(1.6 * cos(azimuth) / away);
        for (int k = 0; k < STEPS; k++) {
            double altitude = low + (high - low) * (k + 0.5) / STEPS;
            double flat = cos(altitude), across = flat * cos(azimuth);
            struct pp_vec3 to = pp_vec(flat * sin(azimuth), -across, sin(altitude));
            sum += 2.0 * most / STEPS * (high - low) / STEPS
                   * pp_sky_luminance(&light->sky, to)
                   * pp_glass_transmittance(&world->openings[0].glass, across)
                   * sin(altitude) * flat;
        }
    }
    return sum;
}

/* Half a millimetre in front of a pane 3 m wide, half of its light comes from the
 * lowest millimetre, near the point. */
static void as_near_a_pane_as_may_be_its_sky_keeps_the_error_that_is_stated(
    void **state)
{
    (void)state;
    const double away[] = {1e-5, 5e-4, 5e-3, 0.05, 0.4};
    enum { COUNT = sizeof away / sizeof *away };
    struct pp_outside_light light;
    struct pp_world *world =
        pp_test_lit_world(&light, "<room version='1'><plan width='4' depth='5' "
                                  "height='3'/><window wall='south' " SILL
                                  "/><skyline wall='south' angle='30'/></room>");
    struct pp_receiver receivers[COUNT];
    for (int i = 0; i < COUNT; i++)
        receivers[i] = pp_test_receiver(2.0, away[i], 1.4, 0.0, 0.0, 1.0);
    struct pp_radiosity_options options = level_options(0.0);
    struct pp_reading(*found)[4] =
        pp_test_elements(world, &light, receivers, COUNT, &options, NULL);
    for (int i = 0; i < COUNT; i++) {
        double truth = before_the_sill(world, &light, away[i]);
        assert_near(found[i][PP_SC].value, truth, found[i][PP_SC].std_error);
        assert_true(found[i][PP_SC].std_error < 0.01 * truth);
    }
    free(found);
    pp_world_destroy(world);
}

/* ---- doors and dados ---- */

/* With the colour of the wall, doors and dados do not change the light: beside the wall
 * of the door, farther from the walls, and on average over the plane. */
static void a_dado_and_a_door_painted_as_the_wall_change_nothing(void **state)
{
    (void)state;
#define WINDOWED                                                                       \
    "<room version='1'><plan width='3.1' depth='4.3' height='2.6'/>"                   \
    "<finishes floor='0.2' walls='0.7' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.6' sill='0.75' width='1.5' height='1.4' "            \
    "reveal='0.3'/><skyline wall='south' angle='18' distance='14'/>"
    static const char *const rooms[] = {
        WINDOWED "</room>", WINDOWED "<door wall='north' left='0.3' reflectance='0.7'/>"
                                     "<dado height='1.1' reflectance='0.7'/></room>"};
    const struct pp_receiver receivers[] = {
        pp_test_receiver(0.4, 4.2, 0.85, 0.0, 0.0, 1.0),
        pp_test_receiver(1.7, 2.9, 0.85, 0.0, 0.0, 1.0)};
    struct pp_reading(*found[2])[4];
    for (int i = 0; i < 2; i++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, rooms[i]);
        struct pp_radiosity_options options = level_options(0.0);
        found[i] = pp_test_elements(world, &light, receivers, 2, &options, NULL);
        pp_world_destroy(world);
    }
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < PP_COMPONENT_COUNT; c++)
            assert_near(found[1][i][c].value, found[0][i][c].value,
                        fmin(found[0][i][c].std_error + found[1][i][c].std_error,
                             0.02 * found[0][i][PP_DF].value));
    free(found[0]);
    free(found[1]);
}

/* ---- determinism ---- */

static void threads_change_nothing_to_the_bit(void **state)
{
    (void)state;
    struct pp_outside_light light;
#define BEHIND(blocks)                                                                 \
    "<room version='1'>" BOX                                                           \
    "<window wall='south' left='0.6' sill='0.9' width='1.5' height='1.2' "             \
    "reveal='0.2'/>" blocks "<point x='0.9' y='0.7'/><point x='1.7' y='3.9'/></room>"
    static const char block[] =
        BEHIND("<block x='-2' y='-4' width='6' depth='2' height='3'/>");
    struct pp_world *world =
        pp_test_lit_world(&light, PP_SIZED(block, BEHIND(""), BEHIND("")));
    struct pp_reading one[2][PP_COMPONENT_COUNT], three[2][PP_COMPONENT_COUNT];
    first_level(world, &light, world->receivers, 1, one);
    first_level(world, &light, world->receivers, 3, three);
    for (int i = 0; i < 2; i++)
        for (int c = 0; c < PP_COMPONENT_COUNT; c++)
            assert_true(one[i][c].value == three[i][c].value);
    pp_world_destroy(world);
}

/* A plane of 3 by 5 m that begins at (1.3, 2.1): about the requested number of points,
 * whose mean is its centre. */
static void points_of_a_plane_lie_evenly_wherever_it_begins(void **state)
{
    (void)state;
    enum { WANTED = 60 };
    struct pp_world *world = pp_test_world(
        "<room version='1'><plan height='2.6'><vertex x='1.3' y='2.1'/>"
        "<vertex x='4.3' y='2.1'/><vertex x='4.3' y='7.1'/><vertex x='1.3' "
        "y='7.1'/></plan></room>");
    struct pp_plane_points points;
    assert_int_equal(pp_plane_points_of(&points, world, WANTED, NULL), PP_OK);
    assert_in_range(points.count, WANTED * 9 / 10, WANTED * 11 / 10);
    double x = 0.0, y = 0.0, whole = 0.0;
    for (int i = 0; i < points.count; i++) {
        x += points.shares[i] * points.list[i].x;
        y += points.shares[i] * points.list[i].y;
        whole += points.shares[i];
    }
    assert_near(whole, 1.0, 1e-12);
    assert_near(x, 2.8, 0.05); /* positions within squares differ */
    assert_near(y, 4.6, 0.05);
    pp_plane_points_clear(&points);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_closed_room_is_dark),
        cmocka_unit_test(the_open_sky_is_all_there_is_without_a_room),
        cmocka_unit_test(a_furnace_glows_with_one_over_one_less_rho),
        cmocka_unit_test(two_plates_light_each_other_by_a_geometric_series),
        cmocka_unit_test(an_integrating_sphere_is_even),
        cmocka_unit_test(a_corridor_solves_its_integral_equation),
        cmocka_unit_test(sky_components_keep_the_error_that_is_stated),
        cmocka_unit_test(threads_change_nothing_to_the_bit),
        cmocka_unit_test(points_of_a_plane_lie_evenly_wherever_it_begins),
    };
    add_tests(tests, NULL, NULL);
    const struct CMUnitTest long_tests[] = {
        cmocka_unit_test(
            as_near_a_pane_as_may_be_its_sky_keeps_the_error_that_is_stated),
        cmocka_unit_test(a_dado_and_a_door_painted_as_the_wall_change_nothing),
    };
    add_long_tests(long_tests, NULL, NULL);
}
