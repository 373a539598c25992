/* test_k_factor.c - rooflights by the K factor, windows by the BRE formula. */
#include "methods/reflected/well.h"
#include "methods/method.h"

#include "tests/lib/room_of.h"
#include "tests/methods/box_method.h"

static double value_of(const struct pp_method *method, const struct pp_world *world,
                       const struct pp_outside_light *light, int opening)
{
    struct pp_part part = {0};
    assert_int_equal(method->evaluate(world, light, world->openings + opening, NULL,
                                      NULL, &part, NULL),
                     PP_OK);
    return part.value;
}

/* Calculated by hand: K is 85 %, floor and walls 0.2 and 0.5 with 12 and 36.4 m2. */
static void rooflight_without_a_well_has_a_K_of_85_per_cent(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='3' height='2.6'/>"
                "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
                "<rooflight x='1.2' y='0.4' width='0.6' depth='0.8' "
                "frame-factor='0.75'/></room>");
    double A = 24 + 36.4, reflecting = 12 * 0.2 + 36.4 * 0.5;
    double all = reflecting + (12 - 0.48) * 0.7 + 0.48 * 0.1;
    double irc = 0.85 * 0.48 * 0.75 * reflecting / 48.4 / (A - all);
    assert_relative(value_of(&pp_method_k_factor, world, &light, 0), irc, 1e-12);
    pp_world_destroy(world);
}

/* The same room with a well: the share N of the light enters the room and is reflected
 * as before. Light reflected by the sides of the well is added: its share f falls on
 * the plane of 12 m2. */
static void well_dims_the_light_and_adds_its_own(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><plan width='4' depth='3' height='2.6'/>"
                "<finishes floor='0.2' walls='0.5' ceiling='0.7'/>"
                "<rooflight x='1.2' y='0.4' width='0.6' depth='0.8' reveal='0.7'/>"
                "</room>");
    struct pp_glass glass = pp_glass_clear_single();
    struct pp_well_shape shape = {0.6, 0.8, 0.7, 0.7};
    struct pp_well_efficiency N = pp_well_efficiency(&shape, 2.0, &glass);
    double A = 24 + 36.4, reflecting = 12 * 0.2 + 36.4 * 0.5;
    double all = reflecting + (12 - 0.48) * 0.7 + 0.48 * 0.1;
    double f = pp_well_foot_to_plane(world, &world->openings[0]);
    double irc =
        0.85 * 0.48
        * (N.whole * reflecting / 48.4 / (A - all) + (N.whole - N.direct) * f / 12);
    assert_relative(value_of(&pp_method_k_factor, world, &light, 0), irc, 1e-12);
    /* `sphere` is the same with the 0.827 of this glass. */
    assert_relative(value_of(&pp_method_sphere, world, &light, 0),
                    irc * world->openings[0].glass.diffuse / 0.85, 1e-12);
    pp_world_destroy(world);
}

static void window_is_by_the_bre_formula(void **state)
{
    (void)state;
    struct box_room box;
    box_method_awkward_room(&box, pp_glass_clear_single());
    assert_relative(box_method_value(&pp_method_k_factor, &box, 0),
                    box_method_value(&pp_method_bre, &box, 0), 1e-12);
}

static void glass_that_slopes_is_refused(void **state)
{
    (void)state;
    struct box_room box;
    box_room_build(&box, 3.3, 4.9, 2.6, 0.4, 0.4, 0.8);
    struct pp_opening *pane =
        box_room_open(&box, BOX_CEILING, pp_vec(1.0, 2.4, 2.6), 1.1, 0.7);
    assert_null(pp_method_k_factor.refuses(&box.world, &box.light, pane, NULL));
    pane->slope_rad = 30 * PP_RAD;
    assert_non_null(pp_method_k_factor.refuses(&box.world, &box.light, pane, NULL));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rooflight_without_a_well_has_a_K_of_85_per_cent),
        cmocka_unit_test(well_dims_the_light_and_adds_its_own),
        cmocka_unit_test(window_is_by_the_bre_formula),
        cmocka_unit_test(glass_that_slopes_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
