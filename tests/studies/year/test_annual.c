/* test_annual.c - the year's daylight of a room compared with values calculated by hand
 * and independently. */
#include "simulate/scene/light_scene_of_world.h"
#include "tests/lib/light_on.h"
#include "tests/lib/made_year.h"
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include <stdlib.h>

#include "methods/exact/sky_view.h"
#include "model/light/sun.h"
#include "simulate/fast/tracer.h"
#include "simulate/year/sun_on_surface.h"
#include "studies/year/annual_work.h"

static const char street[] =
    "<room version='1'><site ground-reflectance='0.2' ground-level='-2.7'/>"
    "<plan width='3.7' depth='5.3' height='2.9'/>"
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
    "<window wall='south' left='0.6' sill='0.9' width='2.3' height='1.7' "
    "transmittance='0.7'/>"
    "<block x='-9' y='-14' width='17' depth='6' base='-2.7' height='9' "
    "reflectance='0.3'/>"
    "<working-plane height='0.85'/><point x='1.1' y='0.9'/><point x='2.3' y='2.2'/>"
    "<point x='1.9' y='4.6'/></room>";

/* ---- one sky ---- */

/* With a and c of 0 the sky is uniform: the result is the daylight factor under the
 * uniform sky by the tracer, times the outdoor illuminance. */
static void under_a_uniform_sky_it_is_the_daylight_factor(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_test_year made;
    pp_test_make_year(&made);
    struct pp_perez_sky sky = {.b = -1.0, .sun = {0, 0, 1}, .N = 2000.0};
    sky.diffuse_lx = PP_PI * sky.N;
    pp_test_add_hour(&made, &sky);
    struct pp_annual_sheet sheet;
    struct pp_annual_options options = pp_test_whole_day(256);
    pp_test_year_of(&sheet, world, &light, &made, &options);

    light.sky = pp_sky_uniform();
    struct pp_light_scene *scene;
    struct pp_tracer *tracer;
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    struct pp_environment *environment = pp_test_light_on(scene, &light);
    const struct pp_tracer_options traced = {.error = 0.002, .seed = 1};
    assert_int_equal(pp_tracer_create(&tracer, scene, environment, world->receivers,
                                      world->receiver_count, &traced, NULL),
                     PP_OK);
    while (!pp_tracer_done(tracer))
        assert_int_equal(pp_tracer_advance(tracer, 0.1, NULL), PP_OK);
    for (int x = 0; x < world->receiver_count; x++) {
        struct pp_reading readings[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, x, readings);
        double expected = readings[PP_DF].value * sky.diffuse_lx;
        double error = hypot(readings[PP_DF].std_error * sky.diffuse_lx,
                             sheet.points[x].year_lxh.std_error);
        assert_near(sheet.points[x].year_lxh.value, expected,
                    3.0 * error + 0.003 * expected);
    }
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

/* ---- compared with the plain implementation ---- */

static void patches_and_cells_agree_with_the_plain_year(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_test_year made;
    pp_test_make_mixed_year(&made);
    struct pp_annual_sheet fast, plain;
    struct pp_annual_options options = pp_test_whole_day(256);
    pp_test_year_of(&fast, world, &light, &made, &options);
    options.exact_sky = true;
    options.blinds = PP_BLINDS_NEVER;
    options.samples = 1024;
    pp_test_year_of(&plain, world, &light, &made, &options);
    for (int x = 0; x < world->receiver_count; x++) {
        const struct pp_annual_value *a = &fast.points[x].year_lxh;
        const struct pp_annual_value *b = &plain.points[x].year_lxh;
        assert_near(a->value, b->value,
                    3.0 * hypot(a->std_error, b->std_error) + 0.004 * b->value);
        assert_near(fast.points[x].sun_lxh.value, plain.points[x].sun_lxh.value, 1e-3);
        double gap = fast.points[x].sun_reflected_lxh.value
                     - plain.points[x].sun_reflected_lxh.value;
        assert_near(gap, 0.0, 0.1 * plain.points[x].sun_reflected_lxh.value);
        assert_true(fast.points[x].sun_reflected_lxh.value > 0.0);
    }
    pp_annual_sheet_clear(&fast);
    pp_annual_sheet_clear(&plain);
    pp_world_destroy(world);
}

/* Sums of a mixed year at the points of a room by coefficients and by the plain way. */
struct two_years {
    struct pp_annual_sheet fast, plain;
};

static void make_two_years(struct two_years *years, const char *text, int plain_paths)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, text);
    struct pp_test_year made;
    pp_test_make_mixed_year(&made);
    struct pp_annual_options options = pp_test_whole_day(256);
    options.blinds = PP_BLINDS_NEVER;
    pp_test_year_of(&years->fast, world, &light, &made, &options);
    options.exact_sky = true;
    options.samples = plain_paths;
    pp_test_year_of(&years->plain, world, &light, &made, &options);
    pp_world_destroy(world);
}

static void assert_same_years(const struct two_years *years, int point, double share)
{
    const struct pp_annual_figures *a = &years->fast.points[point],
                                   *b = &years->plain.points[point];
    assert_near(a->sky_lxh.value, b->sky_lxh.value,
                3.0 * hypot(a->sky_lxh.std_error, b->sky_lxh.std_error)
                    + share * b->sky_lxh.value);
    assert_near(
        a->sun_reflected_lxh.value, b->sun_reflected_lxh.value,
        3.0 * hypot(a->sun_reflected_lxh.std_error, b->sun_reflected_lxh.std_error)
            + share * b->sun_reflected_lxh.value);
}

/* A thin partition, square to the room or oblique, divides squares of the floor. Without
 * pieces of their own on both sides, they led the sun's light through: 40 % too much. */
static void no_light_passes_under_a_partition(void **state)
{
    (void)state;
    static const char *const ends[2][2] = {{"3.05", "3.05"}, {"3.3", "2.6"}};
    for (int i = 0; i < 2; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "<room version='1'><plan width='3.7' depth='5.6' height='2.8'/>"
                 "<finishes floor='0.4' walls='0.6' ceiling='0.8'/>"
                 "<window wall='south' left='0.5' sill='0.8' width='2.7' height='1.6' "
                 "transmittance='0.7'/><surface reflectance='0.6'>"
                 "<vertex x='0.9' y='%s' z='0'/><vertex x='3.7' y='%s' z='0'/>"
                 "<vertex x='3.7' y='%s' z='2.8'/><vertex x='0.9' y='%s' z='2.8'/>"
                 "</surface><working-plane height='0.8'/><point x='2.9' y='3.5'/>"
                 "<point x='1.9' y='4.4'/></room>",
                 ends[i][0], ends[i][1], ends[i][1], ends[i][0]);
        struct two_years years;
        make_two_years(&years, text, 2048);
        for (int x = 0; x < 2; x++)
            assert_same_years(&years, x, 0.02);
        pp_annual_sheet_clear(&years.fast);
        pp_annual_sheet_clear(&years.plain);
    }
}

/* Places of a wall behind a door, and of a floor under a cupboard, are dark, but no light
 * arrives there either. */
static void covered_places_do_not_darken_a_cell(void **state)
{
    (void)state;
    struct two_years years;
    make_two_years(&years,
                   "<room version='1'><plan width='3.7' depth='4.6' height='2.8'/>"
                   "<finishes floor='0.4' walls='0.7' ceiling='0.8'/>"
                   "<window wall='south' left='0.5' sill='0.8' width='2.7' "
                   "height='1.6' transmittance='0.7'/>"
                   "<door wall='north' left='1.3' width='0.9' height='2.07' "
                   "reflectance='0.6'/>"
                   "<door wall='east' left='1.3' width='0.9' height='2.07' "
                   "reflectance='0.6'/>"
                   "<column x='1.2' y='3.1' diameter='0.4'/>"
                   "<furniture x='2.6' y='2.5' width='0.9' depth='0.6' height='1.3' "
                   "reflectance='0.5'/>"
                   "<working-plane height='0.8'/><point x='2.9' y='3.7'/>"
                   "<point x='1.9' y='4.3'/></room>",
                   1024);
    for (int x = 0; x < 2; x++)
        assert_same_years(&years, x, 0.01);
    pp_annual_sheet_clear(&years.fast);
    pp_annual_sheet_clear(&years.plain);
}

/* ---- the error of patches ---- */

/* Patches represent a uniform sky exactly, but not a clear one; 145 patches have a
 * larger error than 2305. All results agree within their standard errors. */
static void patches_err_under_uneven_skies_alone(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_test_year made;
    pp_test_make_year(&made);
    struct pp_perez_sky sky = {.b = -1.0, .sun = {0, 0, 1}, .N = 2000.0};
    sky.diffuse_lx = PP_PI * sky.N;
    pp_test_add_hour(&made, &sky);
    struct pp_annual_sheet even, coarse, fine;
    struct pp_annual_options options = pp_test_whole_day(32);
    options.measure = true;
    pp_test_year_of(&even, world, &light, &made, &options);
    assert_int_equal(even.discretisation.points, 3);
    assert_int_equal(even.discretisation.hours, 1);
    assert_near(even.discretisation.sky.value, 0.0, 1e-6);
    assert_near(even.discretisation.sky_rms, 0.0, 1e-6);

    pp_test_make_mixed_year(&made);
    options.patches = 145;
    pp_test_year_of(&coarse, world, &light, &made, &options);
    options.patches = 2305;
    pp_test_year_of(&fine, world, &light, &made, &options);
    const struct pp_annual_discretisation *a = &coarse.discretisation,
                                          *b = &fine.discretisation;
    assert_int_equal(a->hours, 16);
    assert_true(a->sky_rms > 4.0 * b->sky_rms && b->sky_rms > 0.0);
    assert_true(a->sky_rms < 0.03);
    assert_near(b->all.value, 0.0, 3.0 * b->all.std_error + 0.004);
    assert_true(b->all.std_error > 0.0 && b->all.std_error < 0.05);
    pp_annual_sheet_clear(&even);
    pp_annual_sheet_clear(&coarse);
    pp_annual_sheet_clear(&fine);
    pp_world_destroy(world);
}

/* ---- symmetries ---- */

/* The same office with its window in the south wall, and with its window in the wall
 * named east of a plan whose y axis points east, so that this wall also faces south. */
static void a_turned_plan_has_the_same_year(void **state)
{
    (void)state;
    static const char south[] =
        "<room version='1'><site ground='open'/><plan width='3.7' depth='5.3' "
        "height='2.9'/><window wall='south' left='0.6' sill='0.9' width='2.3' "
        "height='1.7' glazing='none'/><point x='1.1' y='0.9'/><point x='1.9' "
        "y='4.6'/></room>";
    static const char turned[] =
        "<room version='1' north='90'><site ground='open'/><plan width='5.3' "
        "depth='3.7' height='2.9'/><window wall='east' left='0.6' sill='0.9' "
        "width='2.3' height='1.7' glazing='none'/><point x='4.4' y='1.1'/><point "
        "x='0.7' y='1.9'/></room>";
    struct pp_outside_light light;
    struct pp_world *a = pp_test_lit_world(&light, south);
    struct pp_world *b = pp_test_lit_world(&light, turned);
    struct pp_test_year made;
    pp_test_make_mixed_year(&made);
    struct pp_annual_sheet sheet_a, sheet_b;
    struct pp_annual_options options = pp_test_whole_day(256);
    pp_test_year_of(&sheet_a, a, &light, &made, &options);
    pp_test_year_of(&sheet_b, b, &light, &made, &options);
    for (int x = 0; x < 2; x++) {
        const struct pp_annual_figures *p = &sheet_a.points[x], *q = &sheet_b.points[x];
        assert_relative(p->sun_lxh.value, q->sun_lxh.value, 1e-6);
        assert_near(p->year_lxh.value, q->year_lxh.value,
                    3.0 * hypot(p->year_lxh.std_error, q->year_lxh.std_error)
                        + 0.002 * p->year_lxh.value);
        assert_near(p->blinds_autonomy.value, q->blinds_autonomy.value, 0.05);
    }
    assert_near(sheet_a.groups[0].closed_h, sheet_b.groups[0].closed_h, 0.0);
    assert_true(sheet_a.points[0].sun_lxh.value > 0.0);
    pp_annual_sheet_clear(&sheet_a);
    pp_annual_sheet_clear(&sheet_b);
    pp_world_destroy(a);
    pp_world_destroy(b);
}

/* Windows in opposite walls are two groups. Midway between them each gives half of the
 * light of a sky without azimuth dependence; together they give all of it. */
static void opposite_windows_give_half_of_the_light_each(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='4.4' height='2.9'/>"
                "<window wall='south' left='0.6' sill='0.9' width='2.3' height='1.7'/>"
                "<window wall='north' left='1.1' sill='0.9' width='2.3' height='1.7'/>"
                "<point x='2' y='2.2'/></room>");
    struct pp_test_year made;
    pp_test_make_year(&made);
    struct pp_perez_sky sky = {.b = -1.0, .sun = {0, 0, 1}, .N = 2000.0};
    sky.diffuse_lx = PP_PI * sky.N;
    pp_test_add_hour(&made, &sky);
    struct pp_annual_sheet sheet;
    struct pp_annual_options options = pp_test_whole_day(256);
    pp_test_year_of(&sheet, world, &light, &made, &options);
    assert_int_equal(sheet.group_count, 2);
    const struct pp_annual_value all = sheet.points[0].year_lxh,
                                 *half[2] = {&sheet.groups[0].light_lxh,
                                             &sheet.groups[1].light_lxh};
    assert_relative(half[0]->value + half[1]->value, all.value, 1e-5);
    assert_near(half[0]->value, half[1]->value,
                3.0 * hypot(half[0]->std_error, half[1]->std_error)
                    + 0.002 * all.value);
    assert_true(half[0]->value > 0.0);
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

/* ---- direct light ---- */

static void sum_pieces(void *data, const struct pp_sky_piece *piece)
{
    double *sums = data;
    sums[piece->ground] += piece->coefficient;
}

/* Without glass the pieces add up to the configuration factor: that of a rectangle at a
 * point on the normal through its lower corner, facing up, and the same below the
 * horizon at a point facing the window. */
static void pieces_of_sky_are_the_whole_of_it(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        "<room version='1'><site ground='open'/><plan width='5' depth='5' height='3'/>"
        "<window wall='south' left='1' sill='0.8' width='2' height='1.5' "
        "glazing='none'/></room>");
    struct pp_receiver receiver = {.position = {1.0, 1.7, 0.8}, .normal = {0, 0, 1}};
    struct pp_sky_view view;
    double sums[2] = {0.0, 0.0};
    assert_int_equal(pp_sky_view_init(&view, world, &receiver, NULL), PP_OK);
    assert_int_equal(pp_sky_view_pieces(&view, 0.05, sum_pieces, sums, NULL), PP_OK);
    double w = 2.0, h = 1.5, d = 1.7, slant = hypot(d, h);
    double expected = 0.5 * (atan2(w, d) - d / slant * atan2(w, slant));
    assert_near(sums[0], expected, 1e-12);
    assert_near(sums[1], 0.0, 0.0);
    pp_sky_view_clear(&view);

    receiver.position.z = 1.7; /* sees ground below, facing the window */
    receiver.normal = pp_vec(0.0, -1.0, 0.0);
    sums[0] = sums[1] = 0.0;
    assert_int_equal(pp_sky_view_init(&view, world, &receiver, NULL), PP_OK);
    assert_int_equal(pp_sky_view_pieces(&view, 0.05, sum_pieces, sums, NULL), PP_OK);
    double below = 0.9, p = atan2(w, hypot(d, below)), q = atan2(below, hypot(d, w));
    double corner = 0.5 * (below / hypot(d, below) * p + w / hypot(d, w) * q);
    assert_near(sums[1], corner, 1e-12);
    pp_sky_view_clear(&view);
    pp_world_destroy(world);
}

/* The view by polygons and the ray tracer give the same result. */
static void the_sun_is_seen_where_a_ray_reaches_it(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(street);
    struct pp_light_scene *scene;
    assert_int_equal(pp_light_scene_of_world_matt(&scene, world, NULL), PP_OK);
    struct pp_vec3 centre = pp_vec(3.7 / 2.0, 5.3 / 2.0, 2.9 / 2.0);
    int lit = 0, opening;
    for (int x = 0; x < world->receiver_count; x++) {
        const struct pp_receiver *receiver = &world->receivers[x];
        struct pp_sky_view view;
        assert_int_equal(pp_sky_view_init(&view, world, receiver, NULL), PP_OK);
        const struct pp_lit_point at = {pp_vec_sub(receiver->position, centre),
                                        receiver->normal, PP_INDOORS};
        for (double h = 2.3; h < 80.0; h += 4.1)
            for (double az = 91.7; az < 270.0; az += 6.3) {
                struct pp_vec3 sun = pp_test_toward(h, az);
                double seen = pp_sky_view_sun(&view, sun, NULL);
                double traced = pp_sun_on_surface(scene, &at, sun, &opening);
                assert_near(seen, traced, 1e-6);
                lit += seen > 0.0;
            }
        pp_sky_view_clear(&view);
    }
    assert_true(lit > 20);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* ---- counts ---- */

/* 16 of 40 occupied hours are dark: they count as below 100 lx, and reduce autonomy. */
static void dark_hours_count(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_test_year made;
    pp_test_make_mixed_year(&made); /* hours 0 to 19, then 0 to 3 of the next month */
    for (int i = 0; i < 16; i++)
        pp_test_add_hour(&made, NULL);
    struct pp_annual_sheet sheet;
    struct pp_annual_options options = pp_test_whole_day(16);
    pp_test_year_of(&sheet, world, &light, &made, &options);
    assert_near(sheet.occupied_h, 40.0, 0.0);
    assert_true(sheet.points[0].udi_below.value >= 16.0 / 40.0);
    assert_true(sheet.points[0].autonomy[0].value <= 24.0 / 40.0);
    for (int x = 0; x < 3; x++)
        assert_true(sheet.points[x].continuous[0].value
                    >= sheet.points[x].autonomy[0].value);
    pp_annual_sheet_clear(&sheet);
    pp_world_destroy(world);
}

static void annual_results_do_not_depend_on_threads(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, street);
    struct pp_test_year made;
    pp_test_make_mixed_year(&made);
    struct pp_annual_sheet one, three;
    struct pp_annual_options options = pp_test_whole_day(16);
    options.threads = 1;
    pp_test_year_of(&one, world, &light, &made, &options);
    options.threads = 3;
    pp_test_year_of(&three, world, &light, &made, &options);
    assert_memory_equal(one.points, three.points, 3 * sizeof *one.points);
    assert_memory_equal(one.lx, three.lx,
                        3 * (size_t)made.year.sky_count * sizeof *one.lx);
    pp_annual_sheet_clear(&one);
    pp_annual_sheet_clear(&three);
    pp_world_destroy(world);
}

/* With 16 batches of 4700 hours a row has 300 kB. */
static void a_block_of_points_has_at_most_64_rows(void **state)
{
    (void)state;
    assert_int_equal(pp_annual_point_block_size(1), PP_YEAR_BLOCK);
    for (int groups = 1; groups <= PP_YEAR_GROUPS_MOST; groups++)
        assert_in_range(pp_annual_point_block_size(groups) * groups, groups, 64);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(under_a_uniform_sky_it_is_the_daylight_factor),
        cmocka_unit_test(patches_and_cells_agree_with_the_plain_year),
        cmocka_unit_test(no_light_passes_under_a_partition),
        cmocka_unit_test(covered_places_do_not_darken_a_cell),
        cmocka_unit_test(patches_err_under_uneven_skies_alone),
        cmocka_unit_test(a_turned_plan_has_the_same_year),
        cmocka_unit_test(opposite_windows_give_half_of_the_light_each),
        cmocka_unit_test(pieces_of_sky_are_the_whole_of_it),
        cmocka_unit_test(the_sun_is_seen_where_a_ray_reaches_it),
        cmocka_unit_test(dark_hours_count),
        cmocka_unit_test(a_block_of_points_has_at_most_64_rows),
        cmocka_unit_test(annual_results_do_not_depend_on_threads),
    };
    add_tests(tests, NULL, NULL);
}
