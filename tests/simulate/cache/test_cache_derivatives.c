/* test_cache_derivatives.c - the gradient of irradiance beside a luminous patch,
 * compared with Lambert's formula. */
#include "simulate/cache/cache_derivatives.h"

#include <stdlib.h>

#include "simulate/cache/cache_grow.h"
#include "simulate/cache/cache_record.h"
#include "simulate/cache/irradiance_cache.h"
#include "simulate/scene/light_scene_of_description.h"
#include "tests/lib/near.h"

enum { SIDE = 128 };

/* A rectangle of 1.1 x 0.8 m, 1.3 m above the floor and to one side, which emits
 * downwards. */
static const struct pp_vec3 patch[4] = {
    {0.2, -0.3, 1.3}, {0.2, 0.5, 1.3}, {1.3, 0.5, 1.3}, {1.3, -0.3, 1.3}};
static const double radiance = 0.7;

/* Contribution of one edge to equation (1) of cache_derivatives.h, by another closed
 * form. */
static double edge_share(struct pp_vec3 r0, struct pp_vec3 r1)
{
    struct pp_vec3 across = pp_vec_cross(r0, r1);
    double angle = atan2(pp_vec_length(across), pp_vec_dot(r0, r1));
    return 0.5 * angle * across.z / pp_vec_length(across);
}

/* Irradiance of the floor at (x, y) from the patch, by Lambert's formula. */
static double irradiance_at(double x, double y)
{
    struct pp_vec3 from = pp_vec(x, y, 0.0);
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += edge_share(pp_vec_sub(patch[i], from),
                          pp_vec_sub(patch[(i + 1) % 4], from));
    return fabs(sum) * radiance;
}

/* Irradiance of a surface tilted by `lean` towards `azimuth`; the whole patch is above
 * its horizon. The scene is rotated instead, since the formula is for a floor. */
static double irradiance_leaning(double x, double y, double azimuth, double lean)
{
    double sum = 0.0, c = cos(azimuth), s = sin(azimuth);
    struct pp_vec3 turned[4];
    for (int i = 0; i < 4; i++) {
        struct pp_vec3 off = pp_vec_sub(patch[i], pp_vec(x, y, 0.0));
        struct pp_vec3 ahead = {c * off.x + s * off.y, c * off.y - s * off.x, off.z};
        turned[i] = pp_vec(cos(lean) * ahead.x - sin(lean) * ahead.z, ahead.y,
                           cos(lean) * ahead.z + sin(lean) * ahead.x);
        assert_true(turned[i].z > 0.0);
    }
    for (int i = 0; i < 4; i++)
        sum += edge_share(turned[i], turned[(i + 1) % 4]);
    return fabs(sum) * radiance;
}

/* The quadrangle has the material `glow`; the floor makes the scene complete. */
static struct pp_light_scene *shining_on_floor(const struct pp_vec3 shines[4])
{
    struct pp_scene_description from;
    struct pp_light_scene *scene = NULL;
    struct pp_material glow = pp_material_glow(pp_rgb_grey(radiance));
    struct pp_material grey = pp_material_diffuse(pp_rgb_grey(0.4));
    const struct pp_vec3 floor[4] = {
        {-3.0, -3.0, 0.0}, {3.0, -3.0, 0.0}, {3.0, 3.0, 0.0}, {-3.0, 3.0, 0.0}};
    pp_scene_description_init(&from);
    assert_int_equal(pp_scene_description_add_material(&from, &glow, NULL, NULL),
                     PP_OK);
    assert_int_equal(pp_scene_description_add_material(&from, &grey, NULL, NULL),
                     PP_OK);
    assert_int_equal(pp_scene_description_add_polygon(&from, shines, 4, 0, NULL, NULL),
                     PP_OK);
    assert_int_equal(pp_scene_description_add_polygon(&from, floor, 4, 1, NULL, NULL),
                     PP_OK);
    assert_int_equal(pp_light_scene_of_description(&scene, &from, NULL), PP_OK);
    pp_scene_description_clear(&from);
    return scene;
}

static struct pp_light_scene *patch_over_floor(void)
{
    return shining_on_floor(patch);
}

/* Central differences with a step of 1e-4, whose error is 1e-8 of the third
 * derivative. */
static void an_edge_changes_as_its_closed_form_does(void **state)
{
    (void)state;
    const struct pp_vec3 ends[][2] = {
        {{0.7, -0.4, 1.1}, {0.2, 0.9, 0.8}},
        {{1.9, 0.3, 0.2}, {0.6, 0.1, 0.05}}, /* nearly in line with the point */
        {{-0.3, 0.2, 0.01}, {-0.1, -0.4, 0.02}},
    };
    const double h = 1e-4;
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
        double gradient[2], hessian[3], at[3][3];
        for (int i = -1; i <= 1; i++)
            for (int j = -1; j <= 1; j++) {
                struct pp_vec3 move = pp_vec(i * h, j * h, 0.0);
                at[i + 1][j + 1] = edge_share(pp_vec_sub(ends[k][0], move),
                                              pp_vec_sub(ends[k][1], move));
            }
        pp_cache_derivatives_edge(ends[k][0], ends[k][1], gradient, hessian);
        double size = fabs(hessian[0]) + fabs(hessian[1]) + fabs(hessian[2]);
        assert_near(gradient[0], (at[2][1] - at[0][1]) / (2 * h), 1e-4 * size);
        assert_near(gradient[1], (at[1][2] - at[1][0]) / (2 * h), 1e-4 * size);
        assert_near(hessian[0], (at[2][1] - 2 * at[1][1] + at[0][1]) / (h * h),
                    1e-3 * size);
        assert_near(hessian[2], (at[1][2] - 2 * at[1][1] + at[1][0]) / (h * h),
                    1e-3 * size);
        assert_near(hessian[1],
                    (at[2][2] - at[2][0] - at[0][2] + at[0][0]) / (4 * h * h),
                    1e-3 * size);
    }
}

/* The outline of the patch follows the edges of cells in steps: an error of about 1 %
 * with 128 x 128 cells. The outline cuts 180 of the 1,150 cells, which are counted or
 * not at random: 0.5 % of the irradiance (one standard error). */
static void a_hemisphere_gives_the_gradient_of_a_patchs_light(void **state)
{
    (void)state;
    static struct pp_cache_hemisphere_cell cells[SIDE * SIDE];
    static struct pp_sobol sobol;
    struct pp_light_scene *scene = patch_over_floor();
    struct pp_vec3 *corners = pp_cache_hemisphere_corners(SIDE);
    struct pp_cache_hemisphere h = {.side = SIDE, .corners = corners, .cells = cells};
    struct pp_cache_place place = {{0.1, 0.2, 0.0}, {0.0, 0.0, 1.0}, PP_ANYWHERE};
    struct pp_radiance_state path_state = {.scene = scene,
                                           .options = pp_radiance_state_defaults()};
    struct pp_irradiance_change change;
    pp_sobol_init(&sobol);
    pp_sobol_sequence_init(&path_state.sequence, &sobol, 5);
    pp_cache_hemisphere_sample(&h, &path_state, &place, 0);
    pp_cache_derivatives_hemisphere(&h, &change);

    const double x = 0.1, y = 0.2, d = 1e-3, e = irradiance_at(x, y);
    double along = (irradiance_at(x + d, y) - irradiance_at(x - d, y)) / (2 * d);
    double across = (irradiance_at(x, y + d) - irradiance_at(x, y - d)) / (2 * d);
    double aa = (irradiance_at(x + d, y) - 2 * e + irradiance_at(x - d, y)) / (d * d);
    double bb = (irradiance_at(x, y + d) - 2 * e + irradiance_at(x, y - d)) / (d * d);
    /* The frame about +z has the axes x and y. */
    assert_near(h.frame.x.x, 1.0, 1e-12);
    assert_near(h.irradiance.g, e, 1.5e-2 * e);
    assert_near(change.along[1][0], along, 0.02 * fabs(along));
    assert_near(change.along[1][1], across, 0.02 * fabs(along));
    assert_near(change.curvature[0], aa, 0.05 * fabs(bb));
    assert_near(change.curvature[2], bb, 0.05 * fabs(bb));

    /* Tilted towards x and y, to 3e-3 of the steepest gradient, because of the sampling
     * by cells. */
    double to_x = irradiance_leaning(x, y, 0.0, d) - irradiance_leaning(x, y, 0.0, -d);
    double to_y = irradiance_leaning(x, y, 0.5 * PP_PI, d)
                  - irradiance_leaning(x, y, 0.5 * PP_PI, -d);
    double steepest = hypot(to_x, to_y) / (2 * d);
    assert_true(fabs(to_y) > 0.05 * fabs(to_x));
    assert_near(change.turned[1][0], to_x / (2 * d), 3e-3 * steepest);
    assert_near(change.turned[1][1], to_y / (2 * d), 3e-3 * steepest);
    free(corners);
    pp_light_scene_destroy(scene);
}

/* A screen on the floor, 1.1 m away and mostly to one side, extends to the horizon: its
 * lower edge is on the edge of the hemisphere. Lambert's formula includes it like any
 * other edge. The steps of the cells are as above. */
static void a_hemisphere_includes_objects_on_its_horizon(void **state)
{
    (void)state;
    static const struct pp_vec3 screen[4] = {
        {1.2, -0.5, 0.0}, {1.2, -0.5, 1.0}, {1.2, 1.6, 1.0}, {1.2, 1.6, 0.0}};
    static struct pp_cache_hemisphere_cell cells[SIDE * SIDE];
    static struct pp_sobol sobol;
    struct pp_light_scene *scene = shining_on_floor(screen);
    struct pp_vec3 *corners = pp_cache_hemisphere_corners(SIDE);
    struct pp_cache_hemisphere h = {.side = SIDE, .corners = corners, .cells = cells};
    struct pp_cache_place place = {{0.1, 0.2, 0.0}, {0.0, 0.0, 1.0}, PP_ANYWHERE};
    struct pp_radiance_state path_state = {.scene = scene,
                                           .options = pp_radiance_state_defaults()};
    struct pp_irradiance_change change;
    pp_sobol_init(&sobol);
    pp_sobol_sequence_init(&path_state.sequence, &sobol, 5);
    pp_cache_hemisphere_sample(&h, &path_state, &place, 0);
    pp_cache_derivatives_hemisphere(&h, &change);

    const double d = 1e-3;
    double at[3][3];
    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++) {
            struct pp_vec3 from = pp_vec(0.1 + i * d, 0.2 + j * d, 0.0);
            double sum = 0.0;
            for (int k = 0; k < 4; k++)
                sum += edge_share(pp_vec_sub(screen[k], from),
                                  pp_vec_sub(screen[(k + 1) % 4], from));
            at[i + 1][j + 1] = fabs(sum) * radiance;
        }
    double along = (at[2][1] - at[0][1]) / (2 * d);
    double across = (at[1][2] - at[1][0]) / (2 * d);
    double aa = (at[2][1] - 2 * at[1][1] + at[0][1]) / (d * d);
    double bb = (at[1][2] - 2 * at[1][1] + at[1][0]) / (d * d);
    assert_near(h.irradiance.g, at[1][1], 5e-3 * at[1][1]);
    assert_near(change.along[1][0], along, 0.03 * fabs(along));
    assert_near(change.along[1][1], across, 0.03 * fabs(along));
    assert_near(change.curvature[0], aa, 0.05 * fabs(aa));
    assert_near(change.curvature[2], bb, 0.05 * fabs(aa));
    free(corners);
    pp_light_scene_destroy(scene);
}

/* Read with a normal tilted by t, a record changes like the irradiance, except for the
 * second order, (1 - cos t) of its value, and noise of 1 % of the largest change. */
static void a_record_is_read_by_a_leaning_surface(void **state)
{
    (void)state;
    struct pp_light_scene *scene = patch_over_floor();
    struct pp_radiance_options light = pp_radiance_state_defaults();
    struct pp_cache_options options = pp_irradiance_cache_defaults();
    options.divisions = SIDE * SIDE;
    options.supersamples = 0;
    struct pp_irradiance_cache *cache = NULL;
    const struct pp_vec3 at = {0.1, 0.2, 0.0}, up = {0.0, 0.0, 1.0};
    assert_int_equal(
        pp_irradiance_cache_create(&cache, scene, NULL, NULL, &light, &options, NULL),
        PP_OK);
    assert_int_equal(pp_cache_grow_request_point(cache, at, up, PP_ANYWHERE, NULL),
                     PP_OK);
    while (!pp_cache_grow_done(cache))
        assert_int_equal(pp_cache_grow(cache, 1.0, NULL), PP_OK);
    double upright = irradiance_at(at.x, at.y);
    struct pp_rgb value, leaning;
    assert_true(pp_irradiance_cache_value(cache, at, up, PP_ANYWHERE, 0, &value));
    for (int deg = 2; deg <= 8; deg += 3)
        for (int azimuth = 0; azimuth < 360; azimuth += 50) {
            double t = deg * PP_RAD, phi = azimuth * PP_RAD;
            struct pp_vec3 normal = {sin(t) * cos(phi), sin(t) * sin(phi), cos(t)};
            double steepest = irradiance_leaning(at.x, at.y, 0.0, t) - upright;
            assert_true(
                pp_irradiance_cache_value(cache, at, normal, PP_ANYWHERE, 0, &leaning));
            assert_near(leaning.g - value.g,
                        irradiance_leaning(at.x, at.y, phi, t) - upright,
                        (1.0 - cos(t)) * upright + 0.01 * steepest);
        }
    pp_irradiance_cache_destroy(cache);
    pp_light_scene_destroy(scene);
}

/* Value and gradient leave an error of second order: it grows with the square of the
 * distance. Fitted over half a decade. */
static void beside_a_record_the_error_is_of_second_order(void **state)
{
    (void)state;
    struct pp_light_scene *scene = patch_over_floor();
    struct pp_radiance_options light = pp_radiance_state_defaults();
    struct pp_cache_options options = pp_irradiance_cache_defaults();
    options.divisions = 256 * 256;
    options.supersamples = 0;
    struct pp_irradiance_cache *cache = NULL;
    struct pp_error err = {0};
    const struct pp_vec3 at = {0.75, 0.1, 0.0}, up = {0.0, 0.0, 1.0};
    assert_int_equal(
        pp_irradiance_cache_create(&cache, scene, NULL, NULL, &light, &options, &err),
        PP_OK);
    assert_int_equal(pp_cache_grow_request_point(cache, at, up, PP_ANYWHERE, &err),
                     PP_OK);
    while (!pp_cache_grow_done(cache))
        assert_int_equal(pp_cache_grow(cache, 1.0, &err), PP_OK);
    struct pp_cache_record record = {.depth = -1};
    for (size_t i = 0; i < pp_irradiance_cache_count(cache); i++)
        if (pp_irradiance_cache_record(cache, i).depth == 0)
            record = pp_irradiance_cache_record(cache, i);
    assert_int_equal(record.depth, 0);

    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    int n = 0;
    for (double d = 0.12; d < 0.5; d *= 1.25, n++) {
        double worst = 0.0;
        for (int k = 0; k < 8; k++) {
            double x = d * cos(k * PP_PI / 4), y = d * sin(k * PP_PI / 4);
            double read =
                record.value.g + record.along[1].x * x + record.along[1].y * y;
            worst = fmax(worst, fabs(read - irradiance_at(at.x + x, at.y + y)));
        }
        sx += log(d);
        sy += log(worst);
        sxx += log(d) * log(d);
        sxy += log(d) * log(worst);
    }
    double exponent = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    print_message("# exponent %.3f\n", exponent);
    assert_true(exponent > 1.8 && exponent < 2.3);
    pp_irradiance_cache_destroy(cache);
    pp_light_scene_destroy(scene);
}

/* The nearest point of a wall is at the foot of the perpendicular, not where a ray met
 * the wall: exact but for the single precision of the normals. */
static void a_wall_is_as_far_as_the_foot_of_its_perpendicular(void **state)
{
    (void)state;
    enum { FEW = 16, SECTOR = 3 };
    static struct pp_cache_hemisphere_cell cells[FEW * FEW];
    static struct pp_sobol sobol;
    const double azimuth = (SECTOR + 0.43) * 2.0 * PP_PI / PP_CACHE_SECTORS;
    const double distance = 1.13;
    struct pp_vec3 out = {cos(azimuth), sin(azimuth), 0.0};
    struct pp_vec3 along = {-out.y, out.x, 0.0};
    struct pp_vec3 low = pp_vec_along(pp_vec_scale(out, distance), -2.0, along);
    struct pp_vec3 far = pp_vec_along(pp_vec_scale(out, distance), 2.0, along);
    const struct pp_vec3 wall[4] = {low, pp_vec(low.x, low.y, 1.0),
                                    pp_vec(far.x, far.y, 1.0), far};
    struct pp_light_scene *scene = shining_on_floor(wall);
    struct pp_vec3 *corners = pp_cache_hemisphere_corners(FEW);
    struct pp_cache_record_settings settings = {.side = FEW,
                                                .corners = corners,
                                                .error = 0.1,
                                                .noise = 0.1,
                                                .least_m = 0.01,
                                                .most_m = 1.0};
    struct pp_cache_place place = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, PP_ANYWHERE};
    struct pp_radiance_state path_state = {.scene = scene,
                                           .options = pp_radiance_state_defaults()};
    struct pp_cache_entry entry;
    pp_sobol_init(&sobol);
    pp_sobol_sequence_init(&path_state.sequence, &sobol, 5);
    pp_cache_record_compute(&settings, &path_state, &place, cells, &entry);
    assert_int_equal(pp_cache_entry_sector(out.x, out.y), SECTOR);
    assert_near(entry.horizon_m[SECTOR], distance, 1e-6 * distance);
    free(corners);
    pp_light_scene_destroy(scene);
}

/* R = (4 e / (pi l))^(1/4) is 1/2 for e = pi/4 and l = 16. */
static void an_ellipse_is_short_where_curvature_is_great(void **state)
{
    (void)state;
    double radii[2], axes[2][2];
    const double steep[3] = {1.0, 0.0, -16.0};
    pp_cache_record_ellipse(steep, PP_PI / 4, 10.0, radii, axes);
    assert_near(radii[0], 0.5, 1e-12);
    assert_near(radii[1], 1.0, 1e-12);
    assert_near(fabs(axes[0][1]), 1.0, 1e-12);
    /* Rotated by 30 degrees. */
    double c = cos(PP_PI / 6), s = sin(PP_PI / 6);
    const double turned[3] = {16 * c * c + s * s, 15 * c * s, 16 * s * s + c * c};
    pp_cache_record_ellipse(turned, PP_PI / 4, 10.0, radii, axes);
    assert_near(radii[0], 0.5, 1e-12);
    assert_near(fabs(axes[0][0] * c + axes[0][1] * s), 1.0, 1e-12);
    /* Without curvature: the largest radius allowed. */
    const double flat[3] = {0.0, 0.0, 0.0};
    pp_cache_record_ellipse(flat, PP_PI / 4, 3.7, radii, axes);
    assert_near(radii[0], 3.7, 1e-12);
    assert_near(radii[1], 3.7, 1e-12);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edge_changes_as_its_closed_form_does),
        cmocka_unit_test(a_hemisphere_gives_the_gradient_of_a_patchs_light),
        cmocka_unit_test(a_hemisphere_includes_objects_on_its_horizon),
        cmocka_unit_test(a_record_is_read_by_a_leaning_surface),
        cmocka_unit_test(beside_a_record_the_error_is_of_second_order),
        cmocka_unit_test(a_wall_is_as_far_as_the_foot_of_its_perpendicular),
        cmocka_unit_test(an_ellipse_is_short_where_curvature_is_great),
    };
    add_tests(tests, NULL, NULL);
}
