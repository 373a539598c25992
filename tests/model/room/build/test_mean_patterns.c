/* test_mean_patterns.c - reflectances of surfaces with a pattern: the means of their
 * visible parts. */
#include "model/light/rough/bump_facets.h"
#include "model/room/surface_materials.h"
#include "tests/lib/room_of.h"

#define START "<room version='1'><plan width='3.6' depth='4.8' height='2.7'/>"
#define WINDOW "<window wall='south' left='0.6' sill='0.9' width='2.4' height='0.9'/>"

static const struct pp_surface *face_of(const struct pp_world *world, const char *name)
{
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (name ? face->name && strcmp(face->name, name) == 0 : face->role == PP_FLOOR)
            return face;
    }
    fail_msg("no face %s", name ? name : "floor");
    return NULL;
}

/* 12 by 16 squares of 0.3 m, as many light as dark ones. */
static void a_chequer_of_two_paints_reflects_their_mean(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        START "<material name='a' diffuse='0.6' "
              "pattern='1 - 2/3 mod(floor(x / 0.3) + floor(y / 0.3), 2)'/>"
              "<finishes floor='#a'/>" WINDOW "</room>");
    assert_near(face_of(world, NULL)->front, 0.4, 2e-4);
    struct pp_material material = pp_surface_materials_of(
        world, (int)(face_of(world, NULL) - world->surfaces), true);
    struct pp_rgb light = pp_material_diffuse_at(&material, pp_vec(0.1, 0.1, 0.0)),
                  dark = pp_material_diffuse_at(&material, pp_vec(0.1, 0.4, 0.0));
    assert_near(light.g, 0.6, 1e-12);
    assert_near(dark.g, 0.2, 1e-12);
    pp_world_destroy(world);
}

/* The mean of a linear function over a rectangle is its value in the middle. The mean of
 * the coordinates of N = 75025 points is wrong by less than 1 / N of their range. */
static void a_slope_reflects_its_value_in_the_middle(void **state)
{
    (void)state;
    struct pp_world *world = pp_test_world(
        START "<material name='a' diffuse='0.8' pattern='0.2 + z / 9 + x / 36'/>"
              "<finish wall='north' reflectance='#a'/>" WINDOW "</room>");
    assert_near(face_of(world, "north")->front, 0.8 * (0.2 + 0.15 + 0.05), 1e-5);
    pp_world_destroy(world);
}

/* The pattern is dark only where the window is, and at the same height beside it:
 * (9.72 - 2.16 - 1.08) / (9.72 - 2.16) of the wall are light. The door covers a light
 * part: it does not count either. */
static void parts_behind_openings_and_doors_do_not_count(void **state)
{
    (void)state;
    static const char wall[] =
        "<material name='a' diffuse='0.7' pattern='min(1, abs(floor((z - 0.9) / "
        "0.9)))'/><finish wall='south' reflectance='#a'/>" WINDOW;
    char xml[1000];
    snprintf(xml, sizeof xml, "%s%s</room>", START, wall);
    struct pp_world *world = pp_test_world(xml);
    assert_near(face_of(world, "south")->front, 0.7 * 6.48 / 7.56, 2e-4);
    pp_world_destroy(world);
    snprintf(xml, sizeof xml,
             "%s%s<door wall='south' left='0' width='0.5' height='0.9'/></room>", START,
             wall);
    world = pp_test_world(xml);
    assert_near(face_of(world, "south")->front, 0.7 * 6.03 / 7.11, 2e-4);
    pp_world_destroy(world);
}

/* To the last bit, so that results do not change. */
static void a_constant_pattern_is_a_plain_reflectance(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world(START "<material name='a' diffuse='0.6' pattern='0.5'/>"
                            "<finishes walls='#a'/>" WINDOW "</room>");
    const struct pp_surface *wall = face_of(world, "east");
    struct pp_material material =
        pp_surface_materials_of(world, (int)(wall - world->surfaces), true);
    assert_true(wall->front == 0.3);
    assert_true(pp_material_diffuse_at(&material, pp_vec(3.6, 0.7, 1.3)).r == 0.3);
    pp_world_destroy(world);
}

/* Varnish over paint: the pattern changes the paint, and the gloss remains. */
static void a_pattern_leaves_the_gloss_of_a_rough_material(void **state)
{
    (void)state;
    static const char form[] =
        START "<material name='a' n='1.5' roughness='0.3' correlation-length='3' "
              "diffuse='0.5 0.4 0.3'%s/><finishes floor='#a'/>" WINDOW "</room>";
    struct pp_material materials[2];
    double fronts[2];
    for (int i = 0; i < 2; i++) {
        char xml[1000];
        snprintf(xml, sizeof xml, form, i ? " pattern='y / 4.8'" : "");
        struct pp_world *world = pp_test_world(xml);
        int floor = (int)(face_of(world, NULL) - world->surfaces);
        materials[i] = pp_surface_materials_of(world, floor, true);
        fronts[i] = world->surfaces[floor].front;
        if (i) {
            struct pp_rgb here =
                pp_material_diffuse_at(&materials[1], pp_vec(1.0, 1.2, 0.0));
            assert_near(here.r, 0.125, 1e-9);
            assert_near(here.b, 0.075, 1e-9);
        }
        pp_world_destroy(world);
    }
    assert_true(materials[0].gloss.g == materials[1].gloss.g);
    assert_near(materials[1].diffuse.g, 0.2, 1e-5);
    /* The luminance of the paint is 0.42; half of it is gone. */
    assert_near(fronts[0] - fronts[1], (0.265 * 0.5 + 0.67 * 0.4 + 0.065 * 0.3) / 2,
                1e-5);
}

/* Half of the floor is black; the other half reflects what its bumps leave of 0.8. A
 * calculation without bumps has that mean everywhere, also on black squares: otherwise
 * the limit at 0 would make the mean brighter. */
static void without_its_bumps_a_floor_has_the_mean_everywhere(void **state)
{
    (void)state;
    struct pp_world *world =
        pp_test_world(START "<material name='a' diffuse='0.8' bump='x' "
                            "pattern='mod(floor(x / 0.3) + floor(y / 0.3), 2)'/>"
                            "<finishes floor='#a'/>" WINDOW "</room>");
    int floor = (int)(face_of(world, NULL) - world->surfaces);
    double mean = pp_bump_facets_reflectance(1.0, 0.8) / 2.0;
    assert_near(world->surfaces[floor].front, mean, 2e-4);
    struct pp_material bumpy = pp_surface_materials_of(world, floor, true),
                       matt = pp_surface_materials_matt(world, floor, true);
    assert_near(pp_material_facet_at(&bumpy, pp_vec(0.1, 0.4, 0.0)).g, 0.8, 1e-12);
    assert_near(pp_material_facet_at(&bumpy, pp_vec(0.1, 0.1, 0.0)).g, 0.0, 1e-12);
    assert_null(matt.bumps);
    assert_near(pp_material_diffuse_at(&matt, pp_vec(0.1, 0.4, 0.0)).g, mean, 2e-4);
    assert_near(pp_material_diffuse_at(&matt, pp_vec(0.1, 0.1, 0.0)).g, mean, 2e-4);
    pp_world_destroy(world);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_chequer_of_two_paints_reflects_their_mean),
        cmocka_unit_test(a_slope_reflects_its_value_in_the_middle),
        cmocka_unit_test(parts_behind_openings_and_doors_do_not_count),
        cmocka_unit_test(a_constant_pattern_is_a_plain_reflectance),
        cmocka_unit_test(a_pattern_leaves_the_gloss_of_a_rough_material),
        cmocka_unit_test(without_its_bumps_a_floor_has_the_mean_everywhere),
    };
    add_tests(tests, NULL, NULL);
}
