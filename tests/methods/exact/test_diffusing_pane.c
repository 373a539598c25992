/* test_diffusing_pane.c - the direct component of a diffusing pane that is lit unevenly
 * because of obstructions, compared with sums over small squares of the pane. */
#include "methods/exact/diffusing_pane.h"

#include "methods/exact/exterior.h"
#include "methods/method.h"
#include "tests/lib/room_of.h"

/* A wall 1.3 m away hides the sky from the lower part of the pane, and a fin hides a
 * part of the wall and of the sky. */
#define ROOM                                                                           \
    "<room version='1'><plan width='3.1' depth='4.7' height='2.7'/>"                   \
    "<window wall='south' left='0.35' sill='0.4' width='1.7' height='1.9' reveal='0' " \
    "transmittance='0.6' diffusing='yes'><fin depth='0.4' side='left' gap='0'/>"       \
    "</window><skyline wall='south' angle='50' distance='1.3' reflectance='0.3'/>"

/* A wall 13 m away. */
#define WALL_ROOM                                                                      \
    "<room version='1'><plan width='3.1' depth='4.7' height='2.7'/>"                   \
    "<window wall='south' left='0.35' sill='0.9' width='0.4' height='0.3' reveal='0' " \
    "transmittance='0.6' diffusing='yes'/>"                                            \
    "<skyline wall='south' angle='30' distance='13' reflectance='0.3'/>"

static struct pp_part part_at(const struct pp_world *world,
                              const struct pp_outside_light *light,
                              struct pp_receiver receiver, bool rough)
{
    const struct pp_method *exact = &pp_method_exact;
    struct pp_part part = {0};
    void *tools = NULL;
    assert_int_equal(exact->prepare_fast(&tools, world, light, NULL), PP_OK);
    assert_int_equal((rough ? exact->evaluate_roughly : exact->evaluate)(
                         world, light, world->openings, &receiver, tools, &part, NULL),
                     PP_OK);
    exact->destroy_tools(tools);
    return part;
}

/* tau / pi times the integral of E (n.v) (m.v) / v^4 over squares of the pane, with the
 * illuminance at their centres. */
static struct pp_part sum_of_squares(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     struct pp_receiver receiver)
{
    enum { SQUARES = 90 };
    const struct pp_opening *opening = world->openings;
    const struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    struct pp_part part = {0};
    for (int i = 0; i < SQUARES * SQUARES; i++) {
        struct pp_vec3 at = pp_vec(0.35 + 1.7 * (i % SQUARES + 0.5) / SQUARES, 0.0,
                                   0.4 + 1.9 * (i / SQUARES + 0.5) / SQUARES);
        struct pp_vec3 v = pp_vec_sub(at, receiver.position);
        double facing = pp_vec_dot(v, receiver.normal);
        if (facing <= 0.0)
            continue;
        struct pp_exterior_light outside;
        assert_int_equal(pp_exterior_light_on_plane(&outside, world, light, at, out,
                                                    opening->face, NULL),
                         PP_OK);
        double weight = opening->glass.diffuse / PP_PI * facing * pp_vec_dot(v, out)
                        / (pp_vec_dot(v, v) * pp_vec_dot(v, v)) * 1.7 * 1.9
                        / (SQUARES * SQUARES);
        part.sky += weight * outside.sky;
        part.external += weight * outside.external;
    }
    return part;
}

/* Receivers that face up or down, face the pane, or are tilted so that their horizon
 * crosses the pane. The sums are accurate to 2e-3 near the fin, where the illuminance
 * jumps at the side of the pane. */
static void every_square_of_an_uneven_pane_counts_by_its_own_light(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM "</room>");
    const struct pp_receiver receivers[] = {
        {.position = {1.2, 0.61, 0.85}, .normal = {0.0, 0.0, 1.0}},
        {.position = {2.3, 3.7, 0.85}, .normal = {0.0, 0.0, 1.0}},
        {.position = {1.7, 2.2, 1.3}, .normal = {0.0, -1.0, 0.0}},
        {.position = {0.9, 1.9, 1.1}, .normal = {0.48, -0.6, 0.64}},
        {.position = {1.4, 4.1, 2.6}, .normal = {0.0, 0.0, -1.0}},
    };
    for (size_t i = 0; i < sizeof receivers / sizeof *receivers; i++) {
        struct pp_part sum = sum_of_squares(world, &light, receivers[i]);
        struct pp_part fine = part_at(world, &light, receivers[i], false);
        struct pp_part rough = part_at(world, &light, receivers[i], true);
        assert_relative(fine.sky, sum.sky, 2e-3);
        assert_relative(fine.external, sum.external, 2e-3);
        assert_relative(rough.sky, fine.sky, 2e-5);
        assert_relative(rough.external, fine.external, 2e-5);
    }
    pp_world_destroy(world);
}

/* Close to the pane, cells at 0.5 to 2 times half their longer side are integrated by
 * quadrature for fine values, and as several rectangles for rough ones, to 1e-5. */
static void divided_rectangles_agree_with_quadrature_near_the_pane(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, ROOM "</room>");
    for (int i = 0; i < 4; i++) {
        struct pp_receiver receiver = {
            .position = {0.5 + 0.4 * i, 0.04 * pow(2.2, i), 0.85},
            .normal = i % 2 ? pp_vec(0.0, -0.6, 0.8) : pp_vec(0.0, 0.0, 1.0)};
        struct pp_part fine = part_at(world, &light, receiver, false);
        struct pp_part rough = part_at(world, &light, receiver, true);
        assert_relative(rough.sky, fine.sky, 1e-5);
        assert_relative(rough.external, fine.external, 1e-5);
    }
    pp_world_destroy(world);
}

/* Direct light of the pane at a receiver, by a table of the sky; plain: by
 * quadrature. */
static struct pp_part part_by(const struct pp_world *world,
                              const struct pp_outside_light *light, bool plain)
{
    const struct pp_receiver receiver = {.position = {1.2, 1.6, 0.85},
                                         .normal = {0.0, 0.0, 1.0}};
    struct pp_part part = {0};
    if (!plain)
        return part_at(world, light, receiver, false);
    assert_int_equal(pp_method_exact.evaluate(world, light, world->openings, &receiver,
                                              NULL, &part, NULL),
                     PP_OK);
    return part;
}

/* Suns in front of the pane, beside it and behind it, and a sky without sun. The table
 * of the sky has errors of 1e-6 of the open sky. */
static void a_table_of_the_sky_lights_the_pane_as_quadrature_does(void **state)
{
    (void)state;
    static const char *const skies[] = {
        "<sky type='iso-15' sun-altitude='10' sun-bearing='170'/>",
        "<sky type='iso-12' sun-altitude='40' sun-bearing='100'/>",
        "<sky type='iso-12' sun-altitude='25' sun-bearing='350'/>",
        "<sky type='iso-3'/>"};
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        char text[1000];
        snprintf(text, sizeof text, WALL_ROOM "%s</room>", skies[i]);
        struct pp_outside_light light;
        struct pp_world *world = pp_test_lit_world(&light, text);
        struct pp_part table = part_by(world, &light, false);
        struct pp_part plain = part_by(world, &light, true);
        assert_relative(table.sky, plain.sky, 2e-6);
        assert_relative(table.external, plain.external, 2e-6);
        pp_world_destroy(world);
    }
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_square_of_an_uneven_pane_counts_by_its_own_light),
        cmocka_unit_test(divided_rectangles_agree_with_quadrature_near_the_pane),
        cmocka_unit_test(a_table_of_the_sky_lights_the_pane_as_quadrature_does),
    };
    add_tests(tests, NULL, NULL);
}
