/* test_material.c - materials by name, and skies as in Radiance files. */
#include "model/light/material.h"

#include <string.h>

#include "model/light/finishes.h"
#include "model/light/scene_description.h"
#include "model/room/surface_materials.h"
#include "tests/lib/room_of.h"

/* For any hue and gloss, the reflectance used by hand methods is that of the table, and
 * no channel reflects more light than it receives. */
static void every_finish_is_a_material_of_its_reflectance(void **state)
{
    (void)state;
    int glossy = 0, coloured = 0;
    for (int i = 0; i < pp_finishes_count(); i++) {
        const struct pp_finish *finish = pp_finishes_at(i);
        struct pp_material material = pp_material_finish(finish, finish->reflectance);
        struct pp_error err = {0};
        if (pp_material_check(&material, &err) != PP_OK)
            fail_msg("%s: %s", finish->name, err.message);
        assert_near(pp_material_reflectance(&material), finish->reflectance, 1e-12);
        glossy += !pp_rgb_is_black(material.gloss);
        coloured += material.diffuse.r != material.diffuse.b;
        /* With another reflectance, hue and gloss stay the same. */
        material = pp_material_finish(finish, finish->reflectance / 2.0);
        assert_near(pp_material_reflectance(&material), finish->reflectance / 2.0,
                    1e-12);
    }
    assert_true(glossy >= 8 && coloured >= 20);
}

static void grey_is_weighed_as_the_eye_does(void **state)
{
    (void)state;
    assert_near(pp_rgb_luminance(pp_rgb(1.0, 0.0, 0.0)), 0.265, 1e-15);
    assert_near(pp_rgb_luminance(pp_rgb(0.0, 1.0, 0.0)), 0.670, 1e-15);
    assert_near(pp_rgb_luminance(pp_rgb(0.0, 0.0, 1.0)), 0.065, 1e-15);
    assert_true(pp_rgb_luminance(pp_rgb_grey(0.37)) == 0.37);
}

static void hand_methods_see_gloss_as_reflectance_and_glass_as_a_tenth(void **state)
{
    (void)state;
    struct pp_material material =
        pp_material_plastic(pp_rgb(0.6, 0.5, 0.2), 0.05, 0.1, 0.1);
    double colour = 0.265 * 0.6 + 0.670 * 0.5 + 0.065 * 0.2;
    assert_near(pp_material_reflectance(&material), 0.95 * colour + 0.05, 1e-12);
    material = pp_material_metal(pp_rgb(0.6, 0.5, 0.2), 0.7, 0.1, 0.1);
    assert_near(pp_material_reflectance(&material), colour, 1e-12);
    material = pp_material_pane(pp_rgb_grey(0.96), 1.52);
    assert_near(pp_material_reflectance(&material), 0.1, 0.0);
}

/* A diffusing pane is a translucent material with its hemispherical transmittance. */
static void a_diffusing_glazing_is_translucent(void **state)
{
    (void)state;
    struct pp_glass opal = pp_glass_diffusing(0.55);
    struct pp_material sheet = pp_material_glazing(&opal, 0.8, 0.9, 0.4);
    assert_int_equal(sheet.kind, PP_MATERIAL_TRANSLUCENT);
    assert_near(sheet.through_diffuse.g, 0.55 * 0.8 * 0.9, 1e-12);
    assert_near(sheet.diffuse.g, 0.8 * 0.1 + 0.2 * 0.4, 1e-12);
    assert_int_equal(pp_material_check(&sheet, NULL), PP_OK);
}

/* A frame has the reflectance of the wall on the same side: 0.3 of the opening's
 * area. */
static void a_frame_reflects_as_the_wall_of_its_side(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world("<room version='1'><plan width='4' depth='5' height='3'/>"
                      "<finish wall='south' reflectance='0.62'/>"
                      "<window wall='south' left='1' sill='1' width='2' height='1' "
                      "frame-factor='0.7'/></room>");
    world->surfaces[world->openings[0].face].back = 0.27;
    assert_near(pp_surface_materials_pane(world, 0, true).diffuse.g, 0.3 * 0.62, 1e-12);
    assert_near(pp_surface_materials_pane(world, 0, false).diffuse.g, 0.3 * 0.27,
                1e-12);
    pp_world_destroy(world);
}

/* The tracer treats the pane as a material, radiosity as two shares. Curtains and dirt
 * reduce transmitted light; the frame also reduces mirrored light. Tolerance: rounding
 * of a few products. */
static void radiosity_and_tracer_have_one_pane(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world("<room version='1'><plan width='4' depth='5' height='3'/>"
                      "<window wall='south' left='1' sill='1' width='2' height='1' "
                      "glazing='clear-double' frame-factor='0.73' maintenance='0.87' "
                      "curtains='0.61'/></room>");
    const struct pp_opening *opening = &world->openings[0];
    struct pp_material pane = pp_surface_materials_pane(world, 0, true);
    for (double cosine = 0.07; cosine < 1.0; cosine += 0.31) {
        double tau = pp_glass_transmittance(&opening->glass, cosine);
        double rho = pp_glass_reflectance(&opening->glass, cosine);
        double straight = pp_surface_materials_pane_straight(opening, cosine);
        double mirrored = pp_surface_materials_pane_mirrored(opening, cosine);
        assert_near(straight, tau * 0.73 * 0.87 * 0.61, 1e-15);
        assert_near(mirrored, rho * 0.73, 1e-15);
        assert_near(pp_glass_transmittance(&pane.glass[1], cosine) * pane.clear_share
                        * pane.dirt,
                    straight, 1e-15);
        assert_near(pp_glass_reflectance(&pane.glass[1], cosine) * pane.clear_share,
                    mirrored, 1e-15);
    }
    pp_world_destroy(world);
}

/* Calculated independently from the printed formulae. */
static void skies_have_the_radiances_that_gensky_means(void **state)
{
    (void)state;
    const double expected[4][2] = {{6.478877762951026, 9.413348669128766},
                                   {10.196706314207741, 3.549588106420189},
                                   {11.999916162773584, 7.946292957781702},
                                   {7.680138481388464, 4.733494686895044}};
    struct pp_vec3 up = {0.2, 0.6, sqrt(0.6)}, level = {0.6, 0.8, 0.0};
    for (int type = PP_GENSKY_CLEAR; type <= PP_GENSKY_INTERMEDIATE; type++) {
        struct pp_pattern sky = {.kind = PP_PATTERN_GENSKY,
                                 .type = (enum pp_gensky_kind)type,
                                 .zenith = 12.0,
                                 .ground = 3.0,
                                 .norm = 0.8,
                                 .sun = pp_vec(0.3, -0.5, sqrt(0.66))};
        assert_relative(pp_scene_description_pattern_value(&sky, up),
                        expected[type - 1][0], 1e-12);
        assert_relative(pp_scene_description_pattern_value(&sky, level),
                        expected[type - 1][1], 1e-12);
        /* Directly below is only ground. */
        assert_relative(
            pp_scene_description_pattern_value(&sky, pp_vec(0.0, 0.0, -1.0)), 3.0,
            1e-12);
    }
}

/* Calculated independently from the formula of perezlum.cal. */
static void a_sky_of_gendaylit_has_its_radiances(void **state)
{
    (void)state;
    struct pp_pattern sky = {.kind = PP_PATTERN_GENSKY,
                             .type = PP_GENSKY_PEREZ,
                             .zenith = 12.0,
                             .ground = 3.0,
                             .norm = 1.0,
                             .perez = {-1.04, -0.6, 14.2, -3.7, 0.09},
                             .sun = pp_vec(0.3, -0.5, sqrt(0.66))};
    struct pp_vec3 up = {0.2, 0.6, sqrt(0.6)}, level = {0.6, 0.8, 0.0};
    assert_relative(pp_scene_description_pattern_value(&sky, up), 7.4986419179758395,
                    1e-12);
    assert_relative(pp_scene_description_pattern_value(&sky, level), 8.098325633175213,
                    1e-12);
}

static void materials_are_alike_only_in_all_that_they_are(void **state)
{
    (void)state;
    struct pp_material was =
        pp_material_plastic(pp_rgb(0.41, 0.37, 0.29), 0.05, 0.11, 0.07);
    strcpy(was.name, "a wall");
    struct pp_material is = was;
    assert_true(pp_surface_materials_same(&is, &was));
    is.diffuse.b = was.diffuse.b = 0.0;
    is.grain.y = -0.0; /* which is 0 */
    assert_true(pp_surface_materials_same(&is, &was));
    double *const numbers[] = {
        &is.diffuse.r,    &is.diffuse.g,         &is.diffuse.b,       &is.gloss.r,
        &is.gloss.b,      &is.through_diffuse.g, &is.through_gloss.b, &is.radiance.r,
        &is.roughness[0], &is.roughness[1],      &is.grain.x,         &is.grain.z,
        &is.glass[0].n,   &is.glass[1].kl,       &is.glass[2].scale,  &is.clear_share,
        &is.dirt};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        *numbers[i] += 0.125;
        assert_false(pp_surface_materials_same(&is, &was));
        *numbers[i] -= 0.125;
    }
    is = was;
    is.unseen = true;
    assert_false(pp_surface_materials_same(&is, &was));
    is = was;
    is.pattern = 0;
    assert_false(pp_surface_materials_same(&is, &was));
    is = was;
    is.emits = PP_EMITS_CONCENTRATED;
    assert_false(pp_surface_materials_same(&is, &was));
    is = was;
    strcpy(is.name, "a wal");
    assert_false(pp_surface_materials_same(&is, &was));
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_finish_is_a_material_of_its_reflectance),
        cmocka_unit_test(grey_is_weighed_as_the_eye_does),
        cmocka_unit_test(hand_methods_see_gloss_as_reflectance_and_glass_as_a_tenth),
        cmocka_unit_test(a_diffusing_glazing_is_translucent),
        cmocka_unit_test(a_frame_reflects_as_the_wall_of_its_side),
        cmocka_unit_test(radiosity_and_tracer_have_one_pane),
        cmocka_unit_test(materials_are_alike_only_in_all_that_they_are),
        cmocka_unit_test(skies_have_the_radiances_that_gensky_means),
        cmocka_unit_test(a_sky_of_gendaylit_has_its_radiances),
    };
    add_tests(tests, NULL, NULL);
}
