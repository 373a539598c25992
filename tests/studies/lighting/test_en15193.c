/* test_en15193.c - EN 15193:2007 compared with values calculated by hand. */
#include "tests/lib/near.h"
#include "tests/lib/room_of.h"

#include "studies/lighting/en15193.h"

/* 4.13 + 20 x 0.25 - 1.36 x 1.5 = 7.09. */
static void wide_openings_of_a_shallow_zone_give_strong_daylight(void **state)
{
    (void)state;
    assert_near(pp_en15193_factor(0.25, 1.5, 1.0), 0.0709, 1e-12);
    assert_int_equal(pp_en15193_class(0.0709), 3);
    assert_int_equal(pp_en15193_class(0.0599), 2);
    assert_int_equal(pp_en15193_class(0.0399), 1);
    assert_int_equal(pp_en15193_class(0.0199), 0);
    assert_near(pp_en15193_factor(0.0, 5.0, 1.0), 0.0, 0.0);
}

/* 500 lx at 52 degrees, medium: 1.2425 - 0.0117 x 52 = 0.6341. */
static void the_supply_falls_towards_the_pole_and_with_the_target(void **state)
{
    (void)state;
    assert_near(pp_en15193_supply(2, 500.0, 52.0 * PP_RAD), 0.6341, 1e-12);
    for (int class = 1; class <= 3; class ++)
        for (double latitude = 38.5; latitude < 59.0; latitude += 4.3) {
            double rad = latitude * PP_RAD, north = (latitude + 0.5) * PP_RAD;
            assert_true(pp_en15193_supply(class, 500.0, rad)
                        > pp_en15193_supply(class, 500.0, north));
            assert_true(pp_en15193_supply(class, 300.0, rad)
                        > pp_en15193_supply(class, 500.0, rad));
            assert_true(pp_en15193_supply(class, 500.0, rad)
                        > pp_en15193_supply(class, 750.0, rad));
        }
    assert_true(isnan(pp_en15193_supply(2, 500.0, 36.0 * PP_RAD)));
    assert_true(isnan(pp_en15193_supply(2, 400.0, 50.0 * PP_RAD)));
}

#define OFFICE                                                                         \
    "<room version='1'><plan width='4.2' depth='5.4' height='2.8'/>"                   \
    "<finishes floor='0.25' walls='0.6' ceiling='0.8'/>"                               \
    "<window wall='south' left='0.5' sill='0.9' width='1.3' height='1.6'/>"            \
    "<window wall='south' left='2.4' sill='0.9' width='1.3' height='1.6'%s"            \
    "<working-plane height='0.72'/>%s</room>"

static struct pp_lighting_standard standard_of(const char *window, const char *rest,
                                               enum pp_lighting_kind kind)
{
    char text[1200];
    struct pp_lighting_standard standard;
    const struct pp_lighting_control control = {.kind = kind, .target_lx = 500.0};
    snprintf(text, sizeof text, OFFICE, window, rest);
    struct pp_world *world = pp_test_world(text);
    pp_en15193_of_room(&standard, world, 50.0 * PP_RAD, &control);
    pp_world_destroy(world);
    return standard;
}

/* a_D = 2.5 x (2.5 - 0.72) = 4.45 m; I_T = 4.16/(4.45 x 4.2) = 0.22258; I_De = 2.5; I_O =
 * cos 30 degrees: D_C = (4.13 + 4.4516 - 3.4) x 0.86603 = 4.4873 %, medium. F_D,S =
 * 0.6575; x 0.77 x 4.45/5.4 = 0.41721; manual: x 0.30 in place of 0.77. */
static void an_office_saves_in_the_zone_along_its_windows(void **state)
{
    (void)state;
    const char *opposite = "<skyline wall='south' angle='20'/>";
    struct pp_lighting_standard s = standard_of("/>", opposite, PP_LIGHTING_DIMMED);
    assert_true(s.why == NULL);
    assert_near(s.depth_m, 4.45, 1e-9);
    assert_near(s.factor, 0.044873, 1e-6);
    assert_int_equal(s.class, 2);
    assert_near(s.supply, 0.6575, 1e-9);
    assert_near(s.saved, 0.41721, 1e-5);
    s = standard_of("/>", opposite, PP_LIGHTING_MANUAL);
    assert_near(s.saved, 0.41721 * 0.30 / 0.77, 1e-5);
}

static void rooms_beyond_the_formula_have_a_reason(void **state)
{
    (void)state;
    struct pp_lighting_standard s = standard_of(
        "/>", "<window wall='north' left='1' sill='1' width='1' height='1'/>",
        PP_LIGHTING_DIMMED);
    assert_true(s.why && isnan(s.saved));
    s = standard_of("><overhang depth='0.6'/></window>", "", PP_LIGHTING_DIMMED);
    assert_true(s.why && isnan(s.saved));
    s = standard_of("/>", "<skyline wall='south' angle='61'/>", PP_LIGHTING_DIMMED);
    assert_true(s.why == NULL && s.class == 0);
    assert_near(s.saved, 0.0, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wide_openings_of_a_shallow_zone_give_strong_daylight),
        cmocka_unit_test(the_supply_falls_towards_the_pole_and_with_the_target),
        cmocka_unit_test(an_office_saves_in_the_zone_along_its_windows),
        cmocka_unit_test(rooms_beyond_the_formula_have_a_reason),
    };
    add_tests(tests, NULL, NULL);
}
