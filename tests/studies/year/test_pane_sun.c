/* test_pane_sun.c - sun and sky of a moment through a measured pane. */
#include "model/light/bsdf/measured_pane.h"
#include "studies/year/moment.h"
#include "tests/lib/made_bsdf.h"
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#define ROOM                                                                           \
    "<room version='1'><site ground-reflectance='0.2' ground='open'/>"                 \
    "<plan width='4' depth='6' height='3'/>"                                           \
    "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"                                \
    "<window wall='south' left='0.5' sill='0.9' width='3' height='1.8'/>"              \
    "<working-plane height='0.8'/><point x='2' y='2'/><point x='0.8' y='2'/>"          \
    "<point x='3.2' y='2'/></room>"

enum { POINTS = 3 };

static void attach(struct pp_world *world, const char *basis, made_bsdf_law *law,
                   bool split)
{
    struct made_bsdf file = made_bsdf_front(basis, law);
    struct pp_bsdf bsdf;
    struct pp_measured_pane *pane = NULL;
    assert_int_equal(
        pp_bsdf_file_parse(&bsdf, file.text, file.length, "made.xml", NULL), PP_OK);
    assert_int_equal(pp_measured_pane_create(&pane, &bsdf, split, NULL), PP_OK);
    pp_bsdf_clear(&bsdf);
    free(file.text);
    world->openings[0].measured = pane;
    world->openings[0].scatter = &pane->scatter;
}

/* Illuminances of an independent path tracer, standard errors below 0.4 %: ISO sky 12 of
 * 12,000 lx, sun at 160 degrees, 40 degrees high, of 70,000 lx. Its data are those of
 * made_bsdf_prism and made_bsdf_lambertian. */
static void rooms_in_the_sun_agree_with_an_independent_tracer(void **state)
{
    (void)state;
    static const struct {
        const char *basis;
        made_bsdf_law *law;
        bool split;
        double expected[POINTS];
    } of[] = {
        {"LBNL/Klems Half", made_bsdf_lambertian, true, {4364.75, 3801.95, 3802.99}},
        {"LBNL/Klems Quarter", made_bsdf_prism, false, {14699.0, 15026.3, 4661.55}},
        {"LBNL/Klems Quarter", made_bsdf_prism, true, {17933.8, 18179.7, 4613.42}}};
    const struct pp_moment_standard sky = {.name = "iso-12",
                                           .iso = 12,
                                           .sun_altitude_rad = 40.0 * PP_RAD,
                                           .sun_bearing_rad = 160.0 * PP_RAD,
                                           .direct_lx = 70000.0,
                                           .diffuse_lx = 12000.0};
    const struct pp_annual_options options = {.samples = 64, .seed = 1, .threads = 1};
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct pp_outside_light light;
        struct pp_annual_sheet sheet;
        struct pp_moment moment;
        struct pp_world *world = pp_test_lit_world(&light, ROOM);
        attach(world, of[i].basis, of[i].law, of[i].split);
        assert_int_equal(pp_moment_of_standard(&moment, &sky, NULL), PP_OK);
        assert_int_equal(pp_moment_of_room(&sheet, world, &light, world->receivers,
                                           world->receiver_count, &moment, &options,
                                           NULL),
                         PP_OK);
        for (int k = 0; k < POINTS; k++) {
            struct pp_annual_value lx = sheet.points[k].year_lxh;
            assert_true(lx.std_error < 0.02 * of[i].expected[k]);
            assert_near(lx.value, of[i].expected[k],
                        3.0 * lx.std_error + 0.01 * of[i].expected[k]);
        }
        pp_annual_sheet_clear(&sheet);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rooms_in_the_sun_agree_with_an_independent_tracer),
    };
    add_tests(tests, NULL, NULL);
}
