/* test_allowance.c - glass, frame and dirt, each counted once. */
#include "methods/allowance.h"

#include "methods/method.h"
#include "tests/lib/near.h"

static struct pp_opening opening_with(struct pp_glass glass)
{
    return (struct pp_opening){
        .glass = glass, .frame_factor = 0.7, .maintenance = 0.9, .curtains = 1.0};
}

static const unsigned all_bits = PP_ALLOWS_OWN_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT;

static void a_figure_that_contains_all_needs_nothing(void **state)
{
    (void)state;
    struct pp_opening opening = opening_with(pp_glass_of_normal(2, 1.52, 0.02, 0.61));
    assert_near(pp_allowance_factor(all_bits, &opening), 1.0, 0.0);
}

/* Tolerances of the tests below: rounding of a few products and quotients. */

static void missing_corrections_are_applied_once(void **state)
{
    (void)state;
    struct pp_opening opening = opening_with(pp_glass_of_normal(2, 1.52, 0.02, 0.61));
    assert_near(pp_allowance_factor(all_bits & ~PP_ALLOWS_FRAME, &opening), 0.7, 1e-15);
    assert_near(pp_allowance_factor(all_bits & ~PP_ALLOWS_DIRT, &opening), 0.9, 1e-15);
    assert_near(pp_allowance_factor(PP_ALLOWS_OWN_GLASS, &opening), 0.7 * 0.9, 1e-15);
}

static void figures_for_clear_glass_become_those_of_the_glass_by_diffuse_light(
    void **state)
{
    (void)state;
    struct pp_glass tinted = pp_glass_of_normal(1, 1.52, 0.02, 0.45);
    struct pp_opening opening = opening_with(tinted);
    unsigned clear = PP_ALLOWS_CLEAR_GLASS | PP_ALLOWS_FRAME | PP_ALLOWS_DIRT;
    /* A single pane with half the normal transmittance has half the diffuse
     * transmittance. */
    assert_near(pp_allowance_factor(clear, &opening),
                0.45 / pp_glass_clear_single().normal, 1e-14);
    opening.glass = pp_glass_clear_single();
    assert_near(pp_allowance_factor(clear, &opening), 1.0, 1e-15);
    opening.glass = pp_glass_none();
    assert_near(pp_allowance_factor(clear, &opening), 1.0 / 0.85, 1e-15);
}

static void glass_of_the_reflected_component_is_085_for_clear_and_1_for_none(
    void **state)
{
    (void)state;
    struct pp_opening opening = opening_with(pp_glass_clear_single());
    assert_near(pp_allowance_reflected_glass(&opening), 0.85, 1e-15);
    opening.glass = pp_glass_none();
    assert_near(pp_allowance_reflected_glass(&opening), 1.0, 0.0);
    opening.glass = pp_glass_diffusing(0.5);
    assert_near(pp_allowance_reflected_glass(&opening),
                0.85 * 0.5 / pp_glass_clear_single().diffuse, 1e-15);
}

static void a_figure_for_a_bare_hole_gets_all_of_glass_frame_and_dirt(void **state)
{
    (void)state;
    struct pp_opening opening = opening_with(pp_glass_clear_single());
    assert_near(pp_allowance_factor(PP_ALLOWS_NOTHING, &opening), 0.85 * 0.7 * 0.9,
                1e-15);
    opening.glass = pp_glass_none();
    assert_near(pp_allowance_factor(PP_ALLOWS_NOTHING, &opening), 0.7 * 0.9, 1e-15);
}

static void decorations_count_for_the_internally_reflected_component_only(void **state)
{
    (void)state;
    const struct pp_world world = {.decorations = 0.8};
    struct pp_opening opening = opening_with(pp_glass_clear_single());
    struct pp_method method = {.allowances = all_bits & ~PP_ALLOWS_DIRT};
    method.gives = PP_GIVES_INTERNAL;
    assert_near(pp_allowance_of(&method, &world, &opening), 0.9 * 0.8, 1e-15);
    method.gives = PP_GIVES_DIRECT;
    assert_near(pp_allowance_of(&method, &world, &opening), 0.9, 1e-15);
    method.gives = PP_GIVES_WHOLE;
    assert_near(pp_allowance_of(&method, &world, &opening), 0.9, 1e-15);
}

static void a_formula_has_the_openings_own_figures(void **state)
{
    (void)state;
    struct pp_opening opening = opening_with(pp_glass_of_normal(2, 1.52, 0.02, 0.61));
    struct pp_worksheet sheet = {0};
    pp_allowance_put(&sheet, PP_ALLOWS_OWN_GLASS, &opening, "T", "glass");
    pp_allowance_put(&sheet, PP_ALLOWS_FRAME, &opening, "B", "frame");
    pp_allowance_put(&sheet, PP_ALLOWS_DIRT, &opening, "M", "dirt");
    assert_near(pp_worksheet_printed(&sheet, "T"), opening.glass.diffuse, 0.0);
    assert_near(pp_worksheet_printed(&sheet, "B"), 0.7, 0.0);
    assert_near(pp_worksheet_printed(&sheet, "M"), 0.9, 0.0);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_figure_that_contains_all_needs_nothing),
        cmocka_unit_test(missing_corrections_are_applied_once),
        cmocka_unit_test(
            figures_for_clear_glass_become_those_of_the_glass_by_diffuse_light),
        cmocka_unit_test(
            glass_of_the_reflected_component_is_085_for_clear_and_1_for_none),
        cmocka_unit_test(a_figure_for_a_bare_hole_gets_all_of_glass_frame_and_dirt),
        cmocka_unit_test(decorations_count_for_the_internally_reflected_component_only),
        cmocka_unit_test(a_formula_has_the_openings_own_figures),
    };
    add_tests(tests, NULL, NULL);
}
