/* test_glare_study.c - daylight glare probability of views in two rooms, compared with
 * independent path tracing and evalglare 3.06, and with values calculated by hand. */
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include "model/light/bsdf/measured_pane.h"
#include "studies/glare/glare_study.h"
#include "tests/lib/made_bsdf.h"

#define OPEN_ROOM                                                                      \
    "<room version='1'><site ground='open'/>"                                          \
    "<plan width='4' depth='6' height='3'/>"                                           \
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"                                \
    "<window wall='south' left='0.5' sill='0.9' width='3' height='1.8' "               \
    "glazing='none' name='W'"

#define GLAZED_ROOM                                                                    \
    "<room version='1'><site ground='open'/>"                                          \
    "<plan width='3.6' depth='5.4' height='2.8'/>"                                     \
    "<finishes floor='0.3' walls='0.6' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.2' sill='0.8' width='3.2' height='1.8' "             \
    "transmittance='0.7' absorbing='yes'/>"

/* Skies of ISO type 12, and overcast skies. */
static const struct pp_moment_standard skies[] = {
    {"overcast", 0, PP_PI / 2.0, 0.0, 0.0, 20000.0},
    {"iso-12", 12, 30.0 * PP_RAD, 180.0 * PP_RAD, 70000.0, 12000.0},
    {"iso-12", 12, 15.0 * PP_RAD, 300.0 * PP_RAD, 40000.0, 8000.0},
    {"overcast", 0, PP_PI / 2.0, 0.0, 0.0, 10000.0},
};
enum { OVERCAST, SUN, LOW_SUN, DARK };

/* The caller clears the sheet and destroys the world. */
static struct pp_world *study_of(struct pp_glare_sheet *sheet, const char *xml, int sky)
{
    struct pp_study_room room = {.file = "test"};
    struct pp_moment moment;
    struct pp_glare_options options = pp_glare_options_default;
    room.world = pp_test_lit_world(&room.light, xml);
    options.annual.samples = 256;
    options.annual.threads = 1;
    assert_int_equal(pp_moment_of_standard(&moment, &skies[sky], NULL), PP_OK);
    assert_int_equal(pp_glare_study_run(sheet, &room, room.world->views,
                                        room.world->view_count, &moment, NULL, &options,
                                        NULL),
                     PP_OK);
    return room.world;
}

/* Ev and its standard error, DGP and the sum of L^2 omega/P^2 without the sun, by an
 * independent path tracer and from pictures by Radiance. DGP may differ by 0.005 because
 * sources are grouped differently. */
static void dgp_is_that_of_pictures(void **state)
{
    (void)state;
    static const struct {
        const char *xml;
        int sky;
        double lx, se, dgp, sum;
    } given[] = {
        {OPEN_ROOM "/><view x='2' y='4' bearing='180'/></room>", OVERCAST, 1315.84, 1.2,
         0.2838, 1.50573e6},
        {OPEN_ROOM "/><view x='1' y='2' bearing='200'/></room>", OVERCAST, 2554.8, 2.1,
         0.3303, 1.56869e6},
        {OPEN_ROOM "/><view x='2' y='4' bearing='180'/></room>", SUN, 7028.24, 6.1,
         0.6206, 3.64419e7},
        {GLAZED_ROOM "<view x='1.8' y='3.5' z='1.25' bearing='180'/></room>", DARK,
         642.174, 0.56, 0.1977, 0.0},
        {GLAZED_ROOM "<view x='1.8' y='3.5' z='1.25' bearing='180'/></room>", LOW_SUN,
         989.459, 0.73, 0.2562, 640639.0},
    };
    for (int i = 0; i < 5; i++) {
        struct pp_glare_sheet sheet;
        struct pp_world *world = study_of(&sheet, given[i].xml, given[i].sky);
        const struct pp_glare_moment *moment = &sheet.moments[0];
        double se = hypot(moment->eye_lx.std_error, given[i].se);
        assert_near(moment->eye_lx.value, given[i].lx,
                    fmax(3.0 * se, 0.005 * given[i].lx));
        assert_near(moment->dgp.value, given[i].dgp, 0.005);
        assert_near(moment->sum, given[i].sum, 0.02 * given[i].sum);
        pp_glare_sheet_clear(&sheet);
        pp_world_destroy(world);
    }
}

/* Sources of the third view by evalglare: 14,517 cd/m2 over 0.2999 sr, and sunlit walls
 * and floor of 2467 cd/m2 over 1.553 sr. Another view contains the sun, with the direct
 * illuminance divided by the solid angle of its disc as luminance. */
static void sources_are_those_of_evalglare(void **state)
{
    (void)state;
    struct pp_glare_sheet sheet;
    struct pp_world *world = study_of(
        &sheet,
        OPEN_ROOM "/><view x='2' y='4' bearing='180'/><view x='1' y='2' bearing='200'/>"
                  "</room>",
        SUN);
    const struct pp_glare_moment *moment = &sheet.moments[0];
    assert_int_equal(moment->part_count, 2);
    assert_near(moment->parts[0].omega_sr, 0.2999, 0.01);
    assert_near(pp_glare_sheet_luminance(&moment->parts[0]), 14517.0, 0.03 * 14517.0);
    assert_near(moment->parts[1].omega_sr, 1.553, 0.03);
    assert_near(pp_glare_sheet_luminance(&moment->parts[1]), 2467.0, 0.03 * 2467.0);
    assert_false(moment->sun.visible);
    const struct pp_glare_sun *sun = &sheet.moments[1].sun;
    assert_true(sun->visible);
    assert_int_equal(sun->opening, 0);
    assert_near(sun->cd_m2, 70000.0 / 6.7967e-5, 1e5);
    assert_near(sun->index, 3.4439, 1e-4);
    assert_near(sheet.moments[1].dgp.value, 1.0, 0.0);
    pp_glare_sheet_clear(&sheet);
    pp_world_destroy(world);
}

static double sum_of(const char *xml, int sky)
{
    struct pp_glare_sheet sheet;
    struct pp_world *world = study_of(&sheet, xml, sky);
    double sum = sheet.moments[0].sum;
    pp_glare_sheet_clear(&sheet);
    pp_world_destroy(world);
    return sum;
}

/* A frame reduces the solid angle of the glass to 0.7 without changing its luminance.
 * Dirt reduces the luminance, and the sum by its square. The sky is far above the
 * threshold, all other luminances are below it. */
static void frames_take_solid_angle_and_dirt_takes_luminance(void **state)
{
    (void)state;
    double clear =
        sum_of(OPEN_ROOM "/><view x='2' y='4' bearing='180'/></room>", OVERCAST);
    assert_relative(sum_of(OPEN_ROOM " frame-factor='0.7'/>"
                                     "<view x='2' y='4' bearing='180'/></room>",
                           OVERCAST),
                    0.7 * clear, 1e-6);
    assert_relative(sum_of(OPEN_ROOM " maintenance='0.9'/>"
                                     "<view x='2' y='4' bearing='180'/></room>",
                           OVERCAST),
                    0.81 * clear, 1e-6);
}

/* An infinitely long wall up to 60 degrees hides the sky in the field of view, and its
 * own luminance is below the threshold, as is that of a block that reflects 0.2. A
 * block that reflects 0.8 exceeds the threshold. */
static void obstructions_hide_the_sky_and_may_be_sources(void **state)
{
    (void)state;
    static const char hidden[] = OPEN_ROOM "/><skyline wall='south' angle='60' "
                                           "reflectance='0.1'/>"
                                           "<view x='2' y='5' bearing='180'/></room>";
    assert_near(sum_of(hidden, OVERCAST), 0.0, 0.0);
    static const char far[] =
        OPEN_ROOM "/><block x='-50' y='-42' width='100' depth='2' base='0' height='60' "
                  "reflectance='0.8'/><view x='2' y='5' bearing='180'/></room>";
    static const char near_wall[] =
        OPEN_ROOM "/><block x='-50' y='-42' width='100' depth='2' base='0' height='60' "
                  "reflectance='0.2'/><view x='2' y='5' bearing='180'/></room>";
    assert_near(sum_of(near_wall, OVERCAST), 0.0, 0.0);
    assert_true(sum_of(far, OVERCAST) > 0.0);
}

/* A diffusing pane without obstructions outside has the luminance tau E/pi: under an
 * overcast sky E is 0.396 of Eh from the sky and 0.1 of Eh from the ground. */
static void a_diffusing_pane_is_one_even_source(void **state)
{
    (void)state;
    struct pp_glare_sheet sheet;
    struct pp_world *world = study_of(
        &sheet,
        "<room version='1'><site ground='open'/>"
        "<plan width='4' depth='6' height='3'/>"
        "<window wall='south' left='0.5' sill='0.9' width='3' height='1.8' "
        "transmittance='0.9' diffusing='yes'/><view x='2' y='4' bearing='180'/></room>",
        OVERCAST);
    const struct pp_glare_part *part = &sheet.moments[0].parts[0];
    assert_relative(pp_glare_sheet_luminance(part),
                    0.9 * (0.396177 + 0.1) * 20000.0 / PP_PI, 0.01);
    pp_glare_sheet_clear(&sheet);
    pp_world_destroy(world);
}

/* ---- panes that scatter light by direction ---- */

/* A black room with a window of 1 x 0.6 m, 4.9 m straight ahead of the eye. Its light is
 * the only light at the eye. */
#define FAR_WINDOW                                                                     \
    "<room version='1'><site ground='open'/>"                                          \
    "<plan width='4' depth='5' height='2.8'/>"                                         \
    "<finishes floor='0' walls='0' ceiling='0'/>"                                      \
    "<window wall='south' left='1.5' sill='0.9' width='1' height='0.6' "
#define FAR_EYE "<view x='2' y='4.9' bearing='180'/></room>"

/* Illuminance at the eye over the luminance of that window: configuration factor times
 * pi, from four corners (x, y) at the distance d. */
static double far_window_projected_sr(void)
{
    double x = 0.5 / 4.9, y = 0.3 / 4.9, rx = sqrt(1.0 + x * x), ry = sqrt(1.0 + y * y);
    return 2.0 * (x / rx * atan(y / rx) + y / ry * atan(x / ry));
}

/* The simulation of Ev follows light paths and does not use the luminances. The field
 * of view resolves the edges of the window only to 2 %, which does not affect its mean
 * luminance. */
static void assert_window_lights_the_eye(struct pp_world *world,
                                         const struct pp_outside_light *light, int sky)
{
    struct pp_study_room room = {.file = "test", .world = world, .light = *light};
    struct pp_glare_options options = pp_glare_options_default;
    struct pp_glare_sheet sheet;
    struct pp_moment moment;
    options.annual.samples = 128;
    options.annual.threads = 1;
    options.threshold_cd_m2 = 1.0;
    assert_int_equal(pp_moment_of_standard(&moment, &skies[sky], NULL), PP_OK);
    assert_int_equal(pp_glare_study_run(&sheet, &room, world->views, 1, &moment, NULL,
                                        &options, NULL),
                     PP_OK);
    struct pp_annual_value lx = sheet.moments[0].eye_lx;
    double cd_m2 = pp_glare_sheet_luminance(&sheet.moments[0].parts[0]);
    assert_false(sheet.moments[0].sun.visible);
    assert_near(cd_m2 * far_window_projected_sr(), lx.value,
                4.0 * lx.std_error + 0.01 * lx.value);
    pp_glare_sheet_clear(&sheet);
}

static void luminance_of_a_blind_gives_the_light_at_the_eye(void **state)
{
    (void)state;
    static const struct {
        const char *xml;
        int sky;
    } of[] = {{FAR_WINDOW "glazing='none'><blind slat-width='0.025' spacing='0.02' "
                          "angle='-45' reflectance='0.6'/></window>" FAR_EYE,
               OVERCAST},
              {FAR_WINDOW "glazing='none'><blind slat-width='0.025' spacing='0.02' "
                          "angle='-45' reflectance='0.6'/></window>" FAR_EYE,
               SUN},
              {FAR_WINDOW
               "glazing='clear-double' maintenance='0.8'>"
               "<blind slat-width='0.03' spacing='0.02' angle='40' direction="
               "'vertical' reflectance='0.7'/></window>" FAR_EYE,
               LOW_SUN}};
    for (int i = 0; i < 3; i++) {
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, of[i].xml);
        assert_window_lights_the_eye(world, &light, of[i].sky);
        pp_world_destroy(world);
    }
}

static void luminance_of_measured_glazing_gives_the_light_at_the_eye(void **state)
{
    (void)state;
    static const int under[] = {OVERCAST, SUN};
    for (int k = 0; k < 2; k++) {
        struct pp_outside_light light;
        struct pp_bsdf bsdf;
        struct pp_measured_pane *pane = NULL;
        struct pp_world *world = pp_test_lit_world(&light, FAR_WINDOW "/>" FAR_EYE);
        struct made_bsdf file = made_bsdf_front("LBNL/Klems Quarter", made_bsdf_prism);
        assert_int_equal(
            pp_bsdf_file_parse(&bsdf, file.text, file.length, "made.xml", NULL), PP_OK);
        assert_int_equal(pp_measured_pane_create(&pane, &bsdf, true, NULL), PP_OK);
        pp_bsdf_clear(&bsdf);
        free(file.text);
        world->openings[0].measured = pane;
        world->openings[0].scatter = &pane->scatter;
        assert_window_lights_the_eye(world, &light, under[k]);
        pp_world_destroy(world);
    }
}

/* Level slats of 25 mm at 20 mm leave 1 - 1.25 tan p between them for the sun at a
 * profile angle p of 25 degrees: that share of its disc is seen, undimmed. */
static void a_share_of_the_sun_is_seen_between_slats(void **state)
{
    (void)state;
    static const struct pp_moment_standard sun = {
        "iso-12", 12, 25.0 * PP_RAD, 180.0 * PP_RAD, 70000.0, 12000.0};
    struct pp_study_room room = {.file = "test"};
    struct pp_moment moment;
    struct pp_glare_options options = pp_glare_options_default;
    struct pp_glare_sheet sheet;
    room.world = pp_test_lit_world(
        &room.light, OPEN_ROOM "><blind slat-width='0.025' spacing='0.02' angle='0' "
                               "reflectance='0.6'/></window>"
                               "<view x='2' y='2' bearing='180'/></room>");
    options.annual.samples = 64;
    options.annual.threads = 1;
    assert_int_equal(pp_moment_of_standard(&moment, &sun, NULL), PP_OK);
    assert_int_equal(pp_glare_study_run(&sheet, &room, room.world->views, 1, &moment,
                                        NULL, &options, NULL),
                     PP_OK);
    const struct pp_glare_sun *seen = &sheet.moments[0].sun;
    double share = 1.0 - 1.25 * tan(25.0 * PP_RAD);
    assert_true(seen->visible);
    assert_near(seen->omega_sr, share * 6.7967e-5, 1e-8);
    assert_relative(seen->cd_m2, 70000.0 / 6.7967e-5, 1e-3);
    pp_glare_sheet_clear(&sheet);
    pp_world_destroy(room.world);
}

/* A year with one occupied hour has the DGP of that moment, calculated with patches,
 * cells and a coarser field of view. DGP is always above 0.45, so no level of EN 17037
 * is met. */
static void an_hour_of_the_year_has_the_glare_of_its_moment(void **state)
{
    (void)state;
    static const char xml[] = OPEN_ROOM "/><view x='2' y='4' bearing='180'/></room>";
    struct pp_glare_sheet sheet;
    struct pp_moment moment;
    struct pp_study_room room = {.file = "test"};
    struct pp_glare_options options = pp_glare_options_default;
    room.world = pp_test_lit_world(&room.light, xml);
    options.annual.threads = 1;
    assert_int_equal(pp_moment_of_standard(&moment, &skies[SUN], NULL), PP_OK);
    struct pp_weather_hour hour = {.date = {3, 21},
                                   .weekday = PP_WEEKDAY_UNKNOWN,
                                   .start_h = 12.0,
                                   .length_h = 1.0,
                                   .known = true,
                                   .lit = true};
    struct pp_weather_year year = {.words = "one hour",
                                   .count = 1,
                                   .hours = &hour,
                                   .sky_count = 1,
                                   .skies = &moment.sky};
    assert_int_equal(pp_glare_study_run(&sheet, &room, room.world->views, 1, NULL,
                                        &year, &options, NULL),
                     PP_OK);
    const struct pp_glare_year *result = &sheet.years[0];
    assert_near(result->dgp[0], 0.6206, 0.01);
    assert_near(sheet.annual.occupied_h, 1.0, 0.0);
    assert_near(result->above_h[PP_GLARE_LIMITS - 1].value, 1.0, 0.0);
    assert_near(result->exceeded_in_5, result->dgp[0], 0.0);
    assert_string_equal(pp_glare_sheet_level(result, 1.0), "none");
    pp_glare_sheet_clear(&sheet);
    pp_world_destroy(room.world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dgp_is_that_of_pictures),
        cmocka_unit_test(sources_are_those_of_evalglare),
        cmocka_unit_test(frames_take_solid_angle_and_dirt_takes_luminance),
        cmocka_unit_test(obstructions_hide_the_sky_and_may_be_sources),
        cmocka_unit_test(a_diffusing_pane_is_one_even_source),
        cmocka_unit_test(luminance_of_a_blind_gives_the_light_at_the_eye),
        cmocka_unit_test(luminance_of_measured_glazing_gives_the_light_at_the_eye),
        cmocka_unit_test(a_share_of_the_sun_is_seen_between_slats),
        cmocka_unit_test(an_hour_of_the_year_has_the_glare_of_its_moment),
    };
    add_tests(tests, NULL, NULL);
}
