/* test_window_devices.c - blinds, screens and curtains in hand methods, and screens in
 * the tracer. */
#include "methods/evaluate.h"
#include "methods/method.h"
#include "model/light/slats/blind.h"
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

static struct pp_world *room_with(struct pp_outside_light *light, const char *window,
                                  const char *device)
{
    char xml[1000];
    snprintf(xml, sizeof xml,
             "<room version='1'><plan width='4' depth='5' height='2.8'/>"
             "<window wall='south' left='0.9' sill='0.8' width='2.2' height='1.5' %s>"
             "%s</window><point x='1.7' y='2.1'/></room>",
             window, device);
    return pp_test_lit_world(light, xml);
}

static struct pp_report readings_of(const struct pp_world *world,
                                    const struct pp_outside_light *light)
{
    struct pp_report report = {.world = world,
                               .light = *light,
                               .receivers = world->receivers,
                               .receiver_count = world->receiver_count};
    assert_int_equal(pp_methods_evaluate(&report, "all", NULL), PP_OK);
    return report;
}

/* Checks that every figure for the room with the device is `factor` times the figure
 * for the other window; figures that one of them lacks are skipped. */
static int compare_rooms(const char *window, const char *device, double factor)
{
    struct pp_outside_light light, plain_light;
    struct pp_world *plain = room_with(&plain_light, window, ""),
                    *world = room_with(&light, "", device);
    struct pp_report before = readings_of(plain, &plain_light),
                     after = readings_of(world, &light);
    int compared = 0;
    for (int i = 0; i < before.column_count; i++) {
        const struct pp_column *a = before.columns + i, *b = after.columns + i;
        double tolerance =
            strstr(a->name, "nomogram") ? 0.04 : 1e-12; /* read on scales */
        if (a->points && !a->points[0].why && !b->points[0].why) {
            assert_relative(b->points[0].value, factor * a->points[0].value, tolerance);
            compared++;
        }
        if (!a->average.why && !b->average.why)
            assert_relative(b->average.value, factor * a->average.value, tolerance);
    }
    pp_report_clear(&before);
    pp_report_clear(&after);
    pp_world_destroy(plain);
    pp_world_destroy(world);
    return compared;
}

static void a_screen_passes_its_open_share_in_every_method(void **state)
{
    (void)state;
    assert_true(compare_rooms("", "<screen openness='0.13'/>", 0.13) >= 20);
}

/* A pane that transmits 0.37 of the diffuse light that the glass transmits. */
static void a_curtain_makes_the_window_a_diffusing_pane(void **state)
{
    (void)state;
    double glass = pp_glass_clear_single().diffuse;
    char window[64];
    snprintf(window, sizeof window, "diffusing='yes' transmittance='%.17g'",
             0.37 * glass);
    assert_true(compare_rooms(window, "<curtain transmittance='0.37'/>", 1.0) >= 8);
}

/* Black slats as wide as their spacing, perpendicular to the glass: by crossed strings
 * they transmit (2 sqrt 2 - 2) / 2 of uniform light, from either half. */
static void a_blind_multiplies_reflected_light_by_its_mean_transmittance(void **state)
{
    (void)state;
    double mean = sqrt(2.0) - 1.0;
    struct pp_outside_light light;
    static const char black[] =
        "<blind slat-width='0.08' spacing='0.08' reflectance='0'/>";
    struct pp_world *world = room_with(&light, "", black);
    const struct pp_blind *blind = world->openings[0].blind;
    assert_near(blind->sky, mean, 1e-4); /* midpoints of 180 steps */
    assert_near(blind->ground, mean, 1e-4);
    int compared = compare_rooms("", black, blind->mean);
    assert_true(compared >= 9);
    pp_world_destroy(world);
}

static void a_blind_is_refused_by_methods_for_points(void **state)
{
    (void)state;
    static const char *const names[] = {"exact", "brs-table", "waldram", "protractor",
                                        "pepper-pot"};
    struct pp_outside_light light;
    struct pp_world *world = room_with(&light, "", "<blind/>");
    struct pp_report report = readings_of(world, &light);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const struct pp_column *column = pp_report_find(&report, PP_SC, names[i]);
        assert_non_null(column);
        assert_non_null(strstr(column->points[0].why, "has a blind"));
    }
    pp_report_clear(&report);
    pp_world_destroy(world);
}

/* Slats with the outer edge lowered keep out skylight and admit light from the ground.
 * Equal windows share the blind. */
static void blinds_differ_for_sky_and_ground(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='4' depth='5' height='2.8'/>"
        "<window wall='south' left='0.2' sill='0.8' width='1.2' height='1.5'>"
        "<blind angle='-45'/></window>"
        "<window wall='south' left='2.2' sill='0.8' width='1.2' height='1.5'>"
        "<blind angle='-45'/></window>"
        "<rooflight x='1' y='2' width='1' depth='1'><blind angle='-45'/></rooflight>"
        "<point x='1.7' y='2.1'/></room>";
    struct pp_world *world = pp_test_world(xml);
    const struct pp_blind *blind = world->openings[0].blind;
    assert_true(blind->ground > 4.0 * blind->sky);
    assert_near(blind->all, 0.5 * (blind->sky + blind->ground), 1e-3);
    assert_true(world->openings[1].blind == blind);
    assert_near(world->openings[2].blind->mean, blind->all, 1e-12);
    pp_world_destroy(world);
}

static void trace_room(const char *device, struct pp_reading readings[4])
{
    const struct pp_tracer_options options = {.samples = 512, .seed = 5, .threads = 1};
    struct pp_outside_light light;
    struct pp_world *world = room_with(&light, "", device);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
    memcpy(readings, traced[0], sizeof traced[0]);
    free(traced);
    pp_world_destroy(world);
}

/* The fabric reflects some light back into the room. */
static void a_traced_screen_passes_its_open_share(void **state)
{
    (void)state;
    struct pp_reading bare[4], black[4], white[4];
    trace_room("", bare);
    trace_room("<screen openness='0.2' reflectance='0'/>", black);
    trace_room("<screen openness='0.2' reflectance='0.9'/>", white);
    assert_relative(black[PP_SC].value, 0.2 * bare[PP_SC].value, 1e-12);
    assert_relative(white[PP_SC].value, 0.2 * bare[PP_SC].value, 1e-12);
    assert_true(white[PP_IRC].value - black[PP_IRC].value
                > 4.0 * hypot(white[PP_IRC].std_error, black[PP_IRC].std_error));
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_screen_passes_its_open_share_in_every_method),
        cmocka_unit_test(a_curtain_makes_the_window_a_diffusing_pane),
        cmocka_unit_test(a_blind_multiplies_reflected_light_by_its_mean_transmittance),
        cmocka_unit_test(a_blind_is_refused_by_methods_for_points),
        cmocka_unit_test(blinds_differ_for_sky_and_ground),
        cmocka_unit_test(a_traced_screen_passes_its_open_share),
    };
    add_tests(tests, NULL, NULL);
}
