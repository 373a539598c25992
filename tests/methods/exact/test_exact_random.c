/* test_exact_random.c - the direct component of random scenes, against quadrature along
 * meridians. */
#include "tests/lib/near.h"

#include <stdlib.h>

#include "methods/method.h"
#include "model/geometry/convex_parts.h"
#include "tests/lib/dice.h"
#include "tests/lib/meridians.h"
#include "tests/lib/sized.h"

#define SCENES PP_SIZED(10000, 400, 100)

/* ---- a scene: one opening in a face, and random surfaces around the opening ---- */

enum { SURFACES = 24, CORNERS = 8 };

struct scene {
    struct pp_world world;
    struct pp_outside_light light;
    struct pp_opening opening;
    struct pp_surface surfaces[SURFACES];
    struct pp_skyline skyline;
    struct pp_block blocks[2];
    struct pp_vec3 corners[SURFACES + 2][CORNERS];
    struct pp_receiver receiver;
};

/* Draws the numbers one by one, since compilers evaluate arguments in different
 * orders. */
static struct pp_vec3 any_point(struct dice *dice)
{
    struct pp_vec3 v;
    v.x = between(dice, -1.0, 1.0);
    v.y = between(dice, -1.0, 1.0);
    v.z = between(dice, -1.0, 1.0);
    return v;
}

static struct pp_vec3 any_direction(struct dice *dice)
{
    struct pp_vec3 v;
    do
        v = any_point(dice);
    while (pp_vec_dot(v, v) > 1.0 || pp_vec_dot(v, v) < 0.01);
    return pp_vec_unit(v);
}

static struct pp_polygon polygon_of(struct pp_vec3 *corners, int count)
{
    struct pp_polygon polygon = {.count = count, .vertices = corners};
    struct pp_vec3 twice = {0.0, 0.0, 0.0};
    for (int i = 2; i < count; i++)
        twice = pp_vec_add(twice, pp_vec_cross(pp_vec_sub(corners[i - 1], corners[0]),
                                               pp_vec_sub(corners[i], corners[0])));
    polygon.area_m2 = pp_vec_length(twice) / 2.0;
    polygon.normal = pp_vec_unit(twice);
    return polygon;
}

static struct pp_vec3 in_plane(struct pp_vec3 origin, struct pp_vec3 a, double x,
                               struct pp_vec3 b, double y)
{
    return pp_vec_along(pp_vec_along(origin, x, a), y, b);
}

/* Draws an opening of any slope, a rectangle or an outline with a notch, with or
 * without a reveal, and a receiver on its inner side. */
static void deal_opening(struct scene *scene, struct dice *dice)
{
    struct pp_opening *opening = &scene->opening;
    double bearing = between(dice, 0.0, 2.0 * PP_PI);
    double slope = one_in(dice, 3) ? between(dice, 0.0, PP_PI) : PP_PI / 2.0;
    if (one_in(dice, 8))
        slope = 0.0;
    /* Perpendicular to the glass, outwards; slope 0 faces up. */
    struct pp_vec3 level = {cos(bearing), sin(bearing), 0.0};
    struct pp_vec3 out =
        pp_vec_add(pp_vec_scale(level, sin(slope)), pp_vec(0.0, 0.0, cos(slope)));
    opening->along = pp_vec(sin(bearing), -cos(bearing), 0.0);
    opening->up = pp_vec_cross(opening->along, out);
    opening->up = pp_vec_scale(opening->up, -1.0);
    if (pp_vec_dot(pp_vec_cross(opening->along, opening->up), out) > 0.0)
        opening->along = pp_vec_scale(opening->along, -1.0);

    double w = between(dice, 0.3, 3.0), h = between(dice, 0.3, 2.5);
    struct pp_vec3 corner = any_point(dice);
    static const double plain[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const double notched[7][2] = {{0.1, 0.0}, {0.9, 0.1},  {1.0, 0.8},
                                         {0.6, 0.9}, {0.55, 0.5}, {0.3, 0.7},
                                         {0.0, 0.4}};
    opening->rectangle = !one_in(dice, 4);
    int count = opening->rectangle ? 4 : 7;
    opening->reveal_m = one_in(dice, 3) ? between(dice, 0.05, 0.4) : 0.0;
    for (int i = 0; i < count; i++) {
        const double *share = opening->rectangle ? plain[i] : notched[i];
        scene->corners[0][i] =
            in_plane(corner, opening->along, w * share[0], opening->up, h * share[1]);
        scene->corners[1][i] =
            pp_vec_along(scene->corners[0][i], opening->reveal_m, out);
    }
    opening->inner = polygon_of(scene->corners[0], count);
    opening->outer = polygon_of(scene->corners[1], count);
    opening->face = 0;
    scene->surfaces[0] =
        (struct pp_surface){.outline = opening->inner, .role = PP_WALL};
    scene->world.surface_count = 1;
    opening->glass = pp_glass_none();

    double distance = exp(between(dice, log(0.05), log(6.0)));
    double aside = between(dice, -2.0, 4.0), above = between(dice, -2.0, 4.0);
    struct pp_vec3 eye = in_plane(corner, opening->along, aside, opening->up, above);
    scene->receiver.position = pp_vec_along(eye, -distance, out);
    scene->receiver.normal =
        one_in(dice, 2) ? any_direction(dice) : pp_vec(0.0, 0.0, 1.0);
}

static struct pp_surface *deal_surface(struct scene *scene)
{
    struct pp_surface *surface = &scene->surfaces[scene->world.surface_count];
    *surface = (struct pp_surface){
        .role = PP_FREE_SURFACE, .front = 0.2, .back = 0.2, .owner = -1};
    surface->outline.vertices = scene->corners[2 + scene->world.surface_count++ - 1];
    return surface;
}

/* Draws a plate before, across or beyond the opening as seen from the receiver. Some
 * plates have a notch, another reflectance, or an exitance. */
static void deal_plate(struct scene *scene, struct dice *dice)
{
    struct pp_surface *surface = deal_surface(scene);
    const struct pp_opening *opening = &scene->opening;
    double aside = between(dice, -0.5, 2.0), above = between(dice, -0.5, 2.0);
    struct pp_vec3 target =
        in_plane(opening->inner.vertices[0], opening->along, aside, opening->up, above);
    struct pp_vec3 path = pp_vec_sub(target, scene->receiver.position);
    struct pp_vec3 middle =
        pp_vec_along(scene->receiver.position, between(dice, 0.2, 3.0), path);
    struct pp_vec3 n = any_direction(dice), a = any_direction(dice);
    a = pp_vec_unit(pp_vec_cross(n, a));
    struct pp_vec3 b = pp_vec_cross(n, a);
    double size = pp_vec_length(path) * between(dice, 0.1, 0.8);
    static const double plain[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const double notched[6][2] = {{-1, -1},    {1, -1}, {1, 1},
                                         {0.2, -0.1}, {-1, 1}, {-0.6, 0.2}};
    bool has_notch = one_in(dice, 4);
    int count = has_notch ? 6 : 4;
    for (int i = 0; i < count; i++) {
        const double *share = has_notch ? notched[i] : plain[i];
        surface->outline.vertices[i] =
            in_plane(middle, a, size * share[0], b, size * share[1]);
    }
    surface->outline = polygon_of(surface->outline.vertices, count);
    assert_int_equal(pp_convex_parts_triangles(&surface->triangles,
                                               &surface->triangle_count,
                                               &surface->outline, NULL),
                     PP_OK);
    if (one_in(dice, 4))
        surface->front = between(dice, 0.0, 0.9);
    if (one_in(dice, 6))
        surface->exitance = between(dice, 0.0, 0.5);
}

/* Draws a box in front of the opening; its sides face outwards. */
static void deal_block(struct scene *scene, struct dice *dice)
{
    const struct pp_opening *opening = &scene->opening;
    struct pp_block *block = &scene->blocks[scene->world.block_count];
    struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    struct pp_vec3 corner =
        pp_vec_along(opening->inner.vertices[0], between(dice, 0.5, 8.0), out);
    corner.z -= between(dice, 0.0, 3.0);
    block->corner = corner;
    block->width_m = between(dice, 0.5, 4.0);
    block->depth_m = between(dice, 0.5, 4.0);
    block->height_m = between(dice, 0.5, 4.0);
    block->rotate_rad = between(dice, 0.0, 2.0 * PP_PI);
    struct pp_vec3 x = {cos(block->rotate_rad), sin(block->rotate_rad), 0.0};
    struct pp_vec3 y = {-x.y, x.x, 0.0};
    block->along = pp_vec_scale(x, block->width_m);
    block->across = pp_vec_scale(y, block->depth_m);
    block->first_side = scene->world.surface_count;
    block->side_count = 6;
    /* Corners by bits: 1 along x, 2 along y, 4 up. */
    static const int sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                    {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int s = 0; s < 6; s++) {
        struct pp_surface *surface = deal_surface(scene);
        surface->role = PP_BLOCK;
        surface->owner = scene->world.block_count;
        for (int i = 0; i < 4; i++) {
            int bits = sides[s][i];
            struct pp_vec3 at = in_plane(corner, x, bits & 1 ? block->width_m : 0.0, y,
                                         bits & 2 ? block->depth_m : 0.0);
            at.z += bits & 4 ? block->height_m : 0.0;
            surface->outline.vertices[i] = at;
        }
        surface->outline = polygon_of(surface->outline.vertices, 4);
    }
    scene->world.block_count++;
}

static void deal_skyline(struct scene *scene, struct dice *dice)
{
    struct pp_vec3 out = scene->opening.inner.normal;
    if (hypot(out.x, out.y) < 0.3)
        return;
    double distance = one_in(dice, 2) ? INFINITY : between(dice, 2.0, 20.0);
    double angle = between(dice, 5.0, 60.0) * PP_RAD;
    double middle = scene->opening.inner.vertices[0].z + 0.5;
    double reflectance = one_in(dice, 2) ? 0.2 : 0.35;
    scene->skyline = (struct pp_skyline){.face = 0,
                                         .angle_rad = angle,
                                         .middle_z_m = middle,
                                         .distance_m = distance,
                                         .head_z_m = middle + distance * tan(angle),
                                         .reflectance = reflectance};
    scene->world.skylines = &scene->skyline;
    scene->world.skyline_count = 1;
}

static void deal_sky(struct scene *scene, struct dice *dice)
{
    struct pp_sky *sky = &scene->light.sky;
    *sky = one_in(dice, 2) ? pp_sky_overcast() : pp_sky_uniform();
    scene->light.ground_reflectance = between(dice, 0.0, 0.5);
    scene->world.ground_level_m = -4.0;
    if (one_in(dice, 10)) {
        struct pp_vec3 sun = any_direction(dice);
        sun.z = fabs(sun.z);
        assert_int_equal(pp_sky_iso(sky, 1 + (int)between(dice, 0.0, 15.0), sun, NULL),
                         PP_OK);
    }
    if (one_in(dice, 10))
        scene->opening.glass =
            one_in(dice, 2) ? pp_glass_clear_single() : pp_glass_panes(2, 1.52, 0.03);
}

static void deal(struct scene *scene, uint64_t seed)
{
    struct dice dice = {seed * 1000003u};
    *scene = (struct scene){0};
    scene->world.surfaces = scene->surfaces;
    scene->world.openings = &scene->opening;
    scene->world.opening_count = 1;
    scene->world.blocks = scene->blocks;
    deal_opening(scene, &dice);
    deal_sky(scene, &dice);
    int plates = (int)between(&dice, 0.0, 4.0);
    for (int i = 0; i < plates; i++)
        deal_plate(scene, &dice);
    while (scene->world.block_count < 2 && one_in(&dice, 3))
        deal_block(scene, &dice);
    if (one_in(&dice, 3))
        deal_skyline(scene, &dice);
}

/* ---- the comparison ---- */

/* Accuracy promised for `exact`: 1e-9 of the value or 1e-15 of the open sky; with glass
 * 1e-6. */
static double disagreement(double value, double other, double relative)
{
    double difference = fabs(value - other);
    return difference <= 1e-15 ? 0.0 : difference / (relative * fabs(other));
}

/* Result of the method after its preparation for single points, or for points of a
 * plane. */
static struct pp_part prepared(const struct scene *scene, bool for_plane)
{
    const struct pp_method *exact = &pp_method_exact;
    struct pp_part part = {0};
    void *tools = NULL;
    assert_int_equal((for_plane ? exact->prepare_for_plane : exact->prepare_fast)(
                         &tools, &scene->world, &scene->light, NULL),
                     PP_OK);
    assert_int_equal((for_plane ? exact->evaluate_roughly : exact->evaluate)(
                         &scene->world, &scene->light, &scene->opening,
                         &scene->receiver, tools, &part, NULL),
                     PP_OK);
    exact->destroy_tools(tools);
    return part;
}

/* Sums over the edges of all visible parts agree with closed forms and quadratures to
 * 1e-9 of the open sky and 1e-8 of the value, the possible error of quadrature through
 * glass. For points of a plane that faces up they agree to 1e-6. Tilted receivers have
 * no table for skies with azimuth dependence, and approximate quadratures differ. */
static void compare_prepared(const struct scene *scene, int seed,
                             const struct pp_part *part)
{
    const double allowed[2] = {1e-9, 1e-6};
    bool up = scene->receiver.normal.z == 1.0;
    for (int i = 0; i < (up ? 2 : 1); i++) {
        struct pp_part other = prepared(scene, i == 1);
        double sky = fabs(other.sky - part->sky);
        double external = fabs(other.external - part->external);
        double own = i == 0 ? 1e-8 : 0.0;
        if (!(sky <= allowed[i] + own * part->sky)
            || !(external <= allowed[i] + own * part->external))
            fail_msg("scene %d, %s: prepared %.12g and %.12g, else %.12g and %.12g",
                     seed, pp_sky_name(&scene->light.sky), other.sky, other.external,
                     part->sky, part->external);
    }
}

/* Compares the results for one scene; returns whether the scene contains any light. */
static bool compare(int seed, double *worst)
{
    struct scene scene;
    deal(&scene, (uint64_t)seed);
    bool glazed = scene.opening.glass.panes > 0;
    double relative = glazed ? 1e-6 : 1e-9;
    struct pp_part part = {0};
    struct pp_error err = {0};
    if (pp_method_exact.evaluate(&scene.world, &scene.light, &scene.opening,
                                 &scene.receiver, NULL, &part, &err)
        != PP_OK)
        fail_msg("scene %d: %s", seed, err.message);
    if (glazed || scene.light.sky.kind == PP_SKY_ISO)
        compare_prepared(&scene, seed, &part);
    /* If the results differ, the sum over meridians may have missed a narrow feature,
     * so the test repeats the sum with more meridians before it fails. */
    double sky = INFINITY, external = INFINITY;
    struct pp_meridian_sums sums = {0.0, 0.0};
    for (int parts = 3; parts < 200 && fmax(sky, external) > 1.0; parts *= 8) {
        sums = pp_meridians(&scene.world, &scene.light, &scene.opening, &scene.receiver,
                            1e-2 * relative, parts);
        sky = disagreement(part.sky, sums.sky, relative);
        external = disagreement(part.external, sums.external, relative);
    }
    if (!(sky <= 1.0) || !(external <= 1.0))
        print_message(
            "# scene %d, %s %s: sky %.17g or %.17g, external %.17g or %.17g\n", seed,
            pp_sky_name(&scene.light.sky), glazed ? "glazed" : "unglazed", part.sky,
            sums.sky, part.external, sums.external);
    *worst = fmax(*worst, fmax(sky, external));
    for (int i = 0; i < scene.world.surface_count; i++)
        free(scene.surfaces[i].triangles);
    return sums.sky > 0.0 || sums.external > 0.0;
}

static void exact_agrees_with_a_sum_over_meridians(void **state)
{
    (void)state;
    double worst = 0.0;
    const char *one = getenv("PP_TEST_SCENE"); /* runs a single scene */
    if (one)
        compare(atoi(one), &worst);
    int dealt = 0;
    for (int lit = 0; lit < SCENES && !one && dealt < 10 * SCENES;)
        lit += compare(++dealt, &worst);
    print_message(
        "# %d scenes dealt for %d with light; worst disagreement %.2g of what "
        "is allowed\n",
        dealt, SCENES, worst);
    assert_true(worst <= 1.0);
    assert_true(dealt < 10 * SCENES);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_agrees_with_a_sum_over_meridians),
    };
    add_tests(tests, NULL, NULL);
}
