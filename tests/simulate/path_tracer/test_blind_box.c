/* test_blind_box.c - blinds and screens treated as scattering panes, compared with
 * their slats and strips as surfaces, and the limits of closed black slats and of very
 * narrow ones. */
#include <stdlib.h>

#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

#define ROOM                                                                           \
    "<room version='1'><site ground='open'/><plan width='4' depth='5' height='2.8'/>"  \
    "<finishes floor='0.25' walls='0.55' ceiling='0.75'/>"                             \
    "<window wall='south' left='0.9' sill='0.8' width='2.2' height='1.5' "             \
    "glazing='%s'>%s</window>%s<point x='2' y='3.5'/></room>"

enum { XML = 60000 };

static struct pp_reading factor_of(const char *glazing, const char *blind,
                                   const char *slats, int samples)
{
    const struct pp_tracer_options options = {
        .samples = samples, .seed = 3, .threads = 1};
    struct pp_outside_light light;
    char *xml = malloc(XML);
    snprintf(xml, XML, ROOM, glazing, blind, slats);
    struct pp_world *world = pp_test_lit_world(&light, xml);
    struct pp_reading(*traced)[4] =
        pp_test_trace(world, &light, world->receivers, 1, &options, NULL);
    struct pp_reading factor = traced[0][PP_DF];
    free(traced);
    pp_world_destroy(world);
    free(xml);
    return factor;
}

/* Flat slats of 30 mm at 25 mm spacing inside the window, tilted by `tilt`, with the
 * same reflectance on both sides. */
static void write_slats(char *text, double tilt_deg, double reflectance)
{
    double a = 0.015 * cos(tilt_deg * PP_RAD), b = -0.015 * sin(tilt_deg * PP_RAD);
    int length = 0;
    for (int i = 0; i < 60; i++) {
        double y = fabs(a) + 0.001, z = 0.8125 + 0.025 * i;
        length += snprintf(
            text + length, XML / 2 - (size_t)length,
            "<surface reflectance='%g'><vertex x='0.9' y='%.6f' z='%.6f'/>"
            "<vertex x='3.1' y='%.6f' z='%.6f'/><vertex x='3.1' y='%.6f' z='%.6f'/>"
            "<vertex x='0.9' y='%.6f' z='%.6f'/></surface>",
            reflectance, y - a, z - b, y - a, z - b, y + a, z + b, y + a, z + b);
    }
}

/* The ends of a stack of slats scatter a little more light than infinitely long slats:
 * with slats of half this size the difference is half as large. */
static void a_blind_gives_the_light_of_its_slats(void **state)
{
    (void)state;
    static const struct {
        const char *glazing, *blind;
        double tilt_deg, reflectance;
    } cases[] = {
        {"none",
         "<blind slat-width='0.03' spacing='0.025' angle='-45' reflectance='0.6'/>",
         -45.0, 0.6},
        {"clear-double",
         "<blind slat-width='0.03' spacing='0.025' angle='10' reflectance='0.7'/>",
         10.0, 0.7},
    };
    char *slats = malloc(XML / 2);
    for (int i = 0; i < 2; i++) {
        write_slats(slats, cases[i].tilt_deg, cases[i].reflectance);
        struct pp_reading box = factor_of(cases[i].glazing, cases[i].blind, "", 1024);
        struct pp_reading truth = factor_of(cases[i].glazing, "", slats, 1024);
        assert_near(box.value, truth.value,
                    0.02 * truth.value + 3.0 * hypot(box.std_error, truth.std_error));
    }
    free(slats);
}

/* Strips of 25 mm every 40 mm in one plane have an openness of 0.375 at all angles. */
static void a_screen_gives_the_light_of_strips_in_one_plane(void **state)
{
    (void)state;
    char *strips = malloc(XML / 2);
    int length = 0;
    for (int i = 0; i < 37; i++) {
        double z = 0.82 + 0.04 * i;
        length += snprintf(
            strips + length, XML / 2 - (size_t)length,
            "<surface reflectance='0.5'><vertex x='0.9' y='0.005' z='%.4f'/>"
            "<vertex x='3.1' y='0.005' z='%.4f'/><vertex x='3.1' y='0.005' z='%.4f'/>"
            "<vertex x='0.9' y='0.005' z='%.4f'/></surface>",
            z, z, z + 0.025, z + 0.025);
    }
    struct pp_reading box =
        factor_of("none", "<screen openness='0.375' reflectance='0.5'/>", "", 1024);
    struct pp_reading truth = factor_of("none", "", strips, 512);
    assert_near(box.value, truth.value,
                0.015 * truth.value + 3.0 * hypot(box.std_error, truth.std_error));
    free(strips);
}

static void closed_black_slats_let_nothing_pass(void **state)
{
    (void)state;
    struct pp_reading closed = factor_of(
        "none", "<blind slat-width='0.04' spacing='0.02' angle='90' reflectance='0'/>",
        "", 64);
    assert_near(closed.value, 0.0, 1e-6);
}

/* Horizontal slats of 1 mm, 1 m apart, hardly change the light. */
static void the_narrowest_slats_hide_nothing(void **state)
{
    (void)state;
    struct pp_reading bare = factor_of("clear-single", "", "", 512);
    struct pp_reading narrow =
        factor_of("clear-single",
                  "<blind slat-width='0.001' spacing='1' reflectance='0'/>", "", 512);
    assert_near(narrow.value, bare.value,
                0.002 * bare.value + 3.0 * hypot(bare.std_error, narrow.std_error));
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_blind_gives_the_light_of_its_slats),
        cmocka_unit_test(a_screen_gives_the_light_of_strips_in_one_plane),
        cmocka_unit_test(closed_black_slats_let_nothing_pass),
        cmocka_unit_test(the_narrowest_slats_hide_nothing),
    };
    add_tests(tests, NULL, NULL);
}
