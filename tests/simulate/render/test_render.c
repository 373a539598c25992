/* test_render.c - pictures compared with known light. */
#include "simulate/cache/cache_file.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/render/cache_warm_up.h"
#include "simulate/render/checkpoint.h"
#include "simulate/render/render.h"

#include "simulate/cache/cache_parts.h"
#include "simulate/render/render_cache.h"
#include "simulate/scene/light_scene_of_world.h"
#include "tests/lib/sampled_light.h"
#include "tests/lib/room_of.h"
#include "tests/lib/traced.h"

#define DEEP                                                                           \
    "<room version='1'><sky type='uniform'/><plan width='3' depth='6' height='2.7'/>"  \
    "<finishes floor='0.2' walls='0.7' ceiling='0.8'/>"                                \
    "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/></room>"

struct scene {
    struct pp_world *world;
    struct pp_light_scene *light;
    struct pp_environment *environment;
};

static struct scene scene_in(struct pp_world *world,
                             const struct pp_outside_light *light)
{
    struct scene scene = {.world = world};
    assert_int_equal(pp_light_scene_of_world(&scene.light, scene.world, NULL), PP_OK);
    scene.environment = pp_test_light_on(scene.light, light);
    return scene;
}

static struct scene scene_of(const char *xml)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, xml);
    return scene_in(world, &light);
}

static void clear(struct scene *scene)
{
    pp_environment_destroy(scene->environment);
    pp_light_scene_destroy(scene->light);
    pp_world_destroy(scene->world);
}

static struct pp_render_options looking(enum pp_view_kind kind, struct pp_vec3 eye,
                                        struct pp_vec3 toward, double across, int side,
                                        int samples)
{
    struct pp_render_options options = {.width = side,
                                        .height = side,
                                        .samples = samples,
                                        .light = pp_radiance_state_defaults(),
                                        .seed = 3,
                                        .threads = 1};
    options.light.source_most = 4;
    struct pp_vec3 up =
        toward.z * toward.z > 0.9 ? pp_vec(0.0, 1.0, 0.0) : pp_vec(0.0, 0.0, 1.0);
    assert_int_equal(
        pp_camera_set(&options.camera, kind, eye, toward, up, across, across, NULL),
        PP_OK);
    return options;
}

static struct pp_render *begun(const struct scene *scene,
                               const struct pp_render_options *options)
{
    struct pp_render *render = NULL;
    assert_int_equal(
        pp_render_create(&render, scene->light, scene->environment, options, NULL),
        PP_OK);
    return render;
}

static struct pp_render *rendered(const struct scene *scene,
                                  const struct pp_render_options *options)
{
    struct pp_render *render = begun(scene, options);
    while (!pp_render_done(render))
        assert_int_equal(pp_render_advance(render, 0.01, NULL), PP_OK);
    assert_near(pp_render_progress(render), 1.0, 0.0);
    assert_int_equal(pp_render_work(render).leaks, 0);
    return render;
}

/* Mean of all pixels; pixels without a surface are black. */
static double mean_of(const struct pp_render *render)
{
    const struct pp_picture *picture = pp_render_picture(render);
    double sum = 0.0;
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double value = pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            sum += isfinite(value) ? value : 0.0;
        }
    return sum / picture->width / picture->height;
}

/* A picture of 2 degrees, almost perpendicular to one pane of clear-single glass with a
 * normal transmittance of 0.900, from a black room. The radiance of the uniform sky is
 * Eh / pi; the transmittance is constant to 1e-4 over the picture. */
static void a_uniform_sky_through_glass_is_dimmed_by_it(void **state)
{
    (void)state;
    struct scene scene =
        scene_of("<room version='1'><sky type='uniform'/>"
                 "<plan width='3' depth='6' height='2.7'/>"
                 "<finishes floor='0' walls='0' ceiling='0'/>"
                 "<window wall='south' left='0.2' sill='0.8' width='2.6' "
                 "height='1.5'/></room>");
    /* Looking up slightly, so that only sky is visible. */
    double tilt = 5.0 * PP_RAD;
    struct pp_render_options options =
        looking(PP_VIEW_PERSPECTIVE, pp_vec(1.5, 2.0, 1.6),
                pp_vec(0.0, -cos(tilt), sin(tilt)), 2.0 * PP_RAD, 8, 4);
    struct pp_render *render = rendered(&scene, &options);
    const struct pp_glass *glass = &scene.world->openings[0].glass;
    double transmittance = pp_glass_transmittance(glass, cos(tilt));
    assert_near(mean_of(render), transmittance / PP_PI, 1e-4);
    assert_near(transmittance, 0.900, 1e-3);
    pp_render_destroy(render);
    clear(&scene);
}

/* The projection weights directions by the cosine: a disc of radius 1 in a square of
 * side 2 has E = pi times its mean, which is 4 / pi times that of the square. The
 * illuminance is also calculated by paths from the point. 4096 pixels of 16 paths give
 * about 1 %; the pixels at the edge of the circle 0.1 %. */
static void a_fisheyes_mean_is_the_illuminance(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_vec3 point = {1.1, 1.7, 0.85}, up = {0.0, 0.0, 1.0};
    struct pp_render_options options =
        looking(PP_VIEW_HEMISPHERICAL, point, up, PP_PI, 64, 16);
    struct pp_render *render = rendered(&scene, &options);
    struct pp_test_mean known =
        pp_test_irradiance(scene.light, scene.environment, NULL,
                           pp_radiance_state_defaults(), point, up, 256);
    assert_true(known.error < 0.003 * known.value.g);
    assert_relative(4.0 * mean_of(render), known.value.g, 0.012);
    pp_render_destroy(render);
    clear(&scene);
}

/* Surfaces emit the share they do not reflect, under a sky of 1: every pixel is 1,
 * except for the noise of 64 paths. */
static void a_furnace_is_even(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><sky type='uniform'/>"
                "<site ground-reflectance='1'/>"
                "<plan width='3.1' depth='4.3' height='2.3'/>"
                "<finishes floor='0.3' walls='0.4' ceiling='0.5'/>"
                "<window wall='south' left='0.4' sill='0.7' width='2.2' "
                "height='1.3' glazing='none'/></room>");
    for (int i = 0; i < world->surface_count; i++)
        world->surfaces[i].exitance = 1.0 - world->surfaces[i].front;
    struct scene scene = scene_in(world, &light);
    struct pp_render_options options =
        looking(PP_VIEW_PERSPECTIVE, pp_vec(1.2, 3.9, 1.1), pp_vec(0.1, -1.0, 0.1), 1.9,
                16, 64);
    struct pp_render *render = rendered(&scene, &options);
    const struct pp_picture *picture = pp_render_picture(render);
    double squares = 0.0;
    for (int y = 0; y < 16; y++)
        for (int x = 0; x < 16; x++) {
            double one = PP_PI * pp_rgb_luminance(pp_picture_rgb(picture, x, y));
            assert_near(one, 1.0,
                        0.15); /* pixels beside the window have the highest noise */
            squares += (one - 1.0) * (one - 1.0) / 256.0;
        }
    assert_true(sqrt(squares) < 0.03);
    /* The mean of 256 pixels has a sixteenth of the error of one; four times this. */
    assert_relative(mean_of(render), 1.0 / PP_PI, 4.0 * 0.03 / 16.0);
    pp_render_destroy(render);
    clear(&scene);
}

/* Looking down, the daylight factor of the floor is that of a receiver on the floor. */
static void a_plan_of_daylight_factors_has_those_of_receivers(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_vec3 eye = {1.4, 2.2, 1.0}, down = {0.0, 0.0, -1.0};
    struct pp_render_options options =
        looking(PP_VIEW_PARALLEL, eye, down, 0.01, 4, 256);
    options.irradiance = true;
    struct pp_render *render = rendered(&scene, &options);
    struct pp_test_mean known = pp_test_irradiance(
        scene.light, scene.environment, NULL, pp_radiance_state_defaults(),
        pp_vec(1.4, 2.2, 0.0), pp_vec(0.0, 0.0, 1.0), 256);
    assert_relative(mean_of(render), known.value.g, 0.015);
    assert_int_equal(pp_render_tags(render)[5], 0); /* the floor is the first face */
    pp_render_destroy(render);
    clear(&scene);
}

/* The factor for decorations reduces light reflected in the room and no other light, as
 * in the tracer, with paths and with a cache. The tracer is accurate to 0.3 % and the
 * picture by paths to 0.5 %; the tolerance is 2 %. */
static void decorations_dim_a_picture_of_daylight_factors(void **state)
{
    (void)state;
    static const char xml[] =
        "<room version='1'><plan width='3' depth='5' height='2.7'/>"
        "<finishes floor='0.3' walls='0.7' ceiling='0.8' decorations='0.53'/>"
        "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/></room>";
    struct scene scene = scene_of(xml);
    const struct pp_outside_light light = pp_test_light(xml);
    struct pp_receiver receiver = pp_test_receiver(1.6, 3.9, 0.0005, 0.0, 0.0, 1.0);
    struct pp_tracer_options traced = pp_test_paths(256);
    struct pp_reading(*known)[4] =
        pp_test_trace(scene.world, &light, &receiver, 1, &traced, NULL);
    assert_true(known[0][PP_DF].std_error < 0.003 * known[0][PP_DF].value);
    assert_true(known[0][PP_IRC].value > 0.3 * known[0][PP_DF].value);

    struct pp_render_options options = looking(PP_VIEW_PARALLEL, pp_vec(1.6, 3.9, 1.0),
                                               pp_vec(0.0, 0.0, -1.0), 0.01, 4, 256);
    options.irradiance = true;
    struct pp_render *render = rendered(&scene, &options);
    assert_relative(mean_of(render), known[0][PP_DF].value, 0.02);
    pp_render_destroy(render);

    struct pp_cache_options sparse = pp_irradiance_cache_defaults();
    struct pp_irradiance_cache *cache = NULL;
    assert_int_equal(pp_irradiance_cache_create(&cache, scene.light, scene.environment,
                                                NULL, &options.light, &sparse, NULL),
                     PP_OK);
    assert_int_equal(pp_cache_grow_request_point(cache, pp_vec(1.6, 3.9, 0.0),
                                                 pp_vec(0.0, 0.0, 1.0), PP_INDOORS,
                                                 NULL),
                     PP_OK);
    while (!pp_cache_grow_done(cache))
        assert_int_equal(pp_cache_grow(cache, 1.0, NULL), PP_OK);
    options.ambient = pp_irradiance_cache_ambient(cache);
    render = rendered(&scene, &options);
    assert_relative(mean_of(render), known[0][PP_DF].value, 0.02);
    pp_render_destroy(render);
    pp_irradiance_cache_destroy(cache);
    free(known);
    clear(&scene);
}

/* Glass, and pixels outside the circle of a fisheye, have no daylight factor. */
static void glass_has_no_daylight_factor(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options = looking(PP_VIEW_ANGULAR, pp_vec(1.5, 0.7, 1.55),
                                               pp_vec(0.0, -1.0, 0.0), PP_PI, 9, 4);
    options.irradiance = true;
    struct pp_render *render = rendered(&scene, &options);
    const struct pp_picture *picture = pp_render_picture(render);
    assert_true(isnan(pp_picture_at(picture, 4, 4)[0]));
    assert_true(isnan(pp_picture_at(picture, 0, 0)[0]));
    assert_true(pp_picture_at(picture, 4, 8)[0] > 0.0f);
    assert_int_equal(pp_render_tags(render)[0], -1);
    pp_render_destroy(render);
    clear(&scene);
}

#define L_SHAPED                                                                       \
    "<room version='1'><plan height='2.6'><vertex x='0' y='0'/>"                       \
    "<vertex x='5.4' y='0'/><vertex x='5.4' y='3.6'/><vertex x='3' y='3.6'/>"          \
    "<vertex x='3' y='6.6'/><vertex x='0' y='6.6'/></plan>"                            \
    "<window wall='1' left='1.8' sill='0.5' width='2.8' height='1.7'/></room>"

/* If an L-shaped room is cut, nothing is visible in its missing corner. In a parallel
 * projection without a cut the ground is visible there. */
static void a_cut_room_ends_at_its_walls(void **state)
{
    (void)state;
    struct scene scene = scene_of(L_SHAPED);
    struct pp_render_options options = looking(PP_VIEW_PARALLEL, pp_vec(2.7, 2.7, 1.2),
                                               pp_vec(0.0, 0.0, -1.0), 5.4, 6, 1);
    for (int indoors = 0; indoors <= 1; indoors++) {
        options.indoors = indoors;
        struct pp_render *render = rendered(&scene, &options);
        const struct pp_picture *picture = pp_render_picture(render);
        float missing = pp_picture_at(picture, 5, 0)[0]; /* about (4.95, 4.95) */
        assert_true(indoors ? isnan(missing) : missing > 0.02f);
        assert_true(pp_picture_at(picture, 0, 5)[0] > 0.0f);
        assert_true(pp_picture_at(picture, 5, 5)[0] > 0.0f);
        pp_render_destroy(render);
    }
    clear(&scene);
}

/* Pixels of 0.9 m on the wall at x = 3 m: a pixel with a third of its area in the room
 * is empty; a pixel with two thirds shows the light there, which is 1 because surfaces
 * emit the share that they do not reflect; within the noise of 256 paths. */
static void a_pixel_shows_the_part_that_is_most_of_it(void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(
        &light, "<room version='1'><sky type='uniform'/>"
                "<site ground-reflectance='1'/><plan height='2.6'>"
                "<vertex x='0' y='0'/><vertex x='5.4' y='0'/>"
                "<vertex x='5.4' y='3.6'/><vertex x='3' y='3.6'/>"
                "<vertex x='3' y='6.6'/><vertex x='0' y='6.6'/></plan>"
                "<finishes floor='0.3' walls='0.4' ceiling='0.5'/>"
                "<window wall='1' left='1.8' sill='0.5' width='2.8' height='1.7' "
                "glazing='none'/></room>");
    for (int i = 0; i < world->surface_count; i++) {
        world->surfaces[i].exitance = 1.0 - world->surfaces[i].front;
        world->surfaces[i].back =
            world->surfaces[i].front; /* as seen from the ground */
    }
    struct scene scene = scene_in(world, &light);
    for (int third = 1; third <= 2; third++) {
        struct pp_vec3 eye = {3.0 + 0.45 - 0.3 * third, 5.1, 1.2};
        struct pp_render_options options =
            looking(PP_VIEW_PARALLEL, eye, pp_vec(0.0, 0.0, -1.0), 2.7, 3, 256);
        options.irradiance = options.indoors = true;
        struct pp_render *render = rendered(&scene, &options);
        const struct pp_picture *picture = pp_render_picture(render);
        double on_the_wall = pp_picture_at(picture, 1, 1)[1];
        if (third == 1)
            assert_true(isnan(on_the_wall));
        else
            assert_near(on_the_wall, 1.0, 0.05);
        assert_near(pp_picture_at(picture, 0, 1)[1], 1.0, 0.05);
        assert_true(isnan(pp_picture_at(picture, 2, 1)[1]));
        pp_render_destroy(render);
    }
    clear(&scene);
}

static void assert_same_pictures(const struct pp_render *a, const struct pp_render *b)
{
    const struct pp_picture *p = pp_render_picture(a), *q = pp_render_picture(b);
    assert_memory_equal(p->rgb, q->rgb,
                        3 * sizeof *p->rgb * (size_t)(p->width * p->height));
    assert_memory_equal(pp_render_tags(a), pp_render_tags(b),
                        sizeof(int) * (size_t)(p->width * p->height));
}

static void a_picture_does_not_depend_on_threads(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options = looking(
        PP_VIEW_PERSPECTIVE, pp_vec(1.3, 4.1, 1.6), pp_vec(0.1, -1.0, 0.0), 1.2, 37, 3);
    options.filter = PP_FILTER_GAUSS;
    struct pp_render *one = rendered(&scene, &options);
    options.threads = 3;
    struct pp_render *three = rendered(&scene, &options);
    assert_same_pictures(one, three);
    assert_true(pp_render_work(one).rays == pp_render_work(three).rays);
    options.seed++;
    struct pp_render *other = rendered(&scene, &options);
    assert_true(mean_of(other) != mean_of(one));
    pp_render_destroy(one);
    pp_render_destroy(three);
    pp_render_destroy(other);
    clear(&scene);
}

/* ---- warming up the cache ---- */

static struct pp_irradiance_cache *new_cache(const struct scene *scene,
                                             const struct pp_render_options *options,
                                             const struct pp_cache_options *wanted)
{
    struct pp_irradiance_cache *cache = NULL;
    assert_int_equal(pp_irradiance_cache_create(&cache, scene->light,
                                                scene->environment, NULL,
                                                &options->light, wanted, NULL),
                     PP_OK);
    return cache;
}

/* A cache filled for the picture, with a given number of pixels at a time. */
static struct pp_irradiance_cache *grown(const struct scene *scene,
                                         const struct pp_render_options *options,
                                         int part_pixels, int threads, double slice_s)
{
    struct pp_cache_options sparse = pp_irradiance_cache_defaults();
    struct pp_cache_warm_up *warm_up = NULL;
    sparse.accuracy = 0.3;
    sparse.divisions = 64;
    sparse.supersamples = 0;
    sparse.bounces = 2;
    sparse.threads = threads;
    struct pp_irradiance_cache *cache = new_cache(scene, options, &sparse);
    assert_int_equal(pp_cache_warm_up_create(&warm_up, cache, scene->light, options,
                                             part_pixels, NULL),
                     PP_OK);
    while (!pp_cache_warm_up_done(warm_up)) {
        double progress = pp_cache_warm_up_progress(warm_up);
        assert_true(progress >= 0.0 && progress <= 1.0);
        assert_int_equal(pp_cache_warm_up_advance(warm_up, slice_s, NULL), PP_OK);
    }
    assert_near(pp_cache_warm_up_progress(warm_up), 1.0, 0.0);
    pp_cache_warm_up_destroy(warm_up);
    return cache;
}

/* Seen through a pane with a frame. The frame and the mirror image in the glass also
 * read the cache before the ray reaches the house opposite, which must have records
 * too. Without them each of its pixels had an error of 10 %. */
static void what_stands_behind_a_framed_pane_is_in_the_cache(void **state)
{
    (void)state;
    struct scene scene =
        scene_of("<room version='1'><plan width='3' depth='4' height='2.7'/>"
                 "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5' "
                 "glazing='clear-double' frame-factor='0.75'/>"
                 "<block x='-9' y='-9' width='21' depth='3' height='9'/></room>");
    struct pp_render_options options = looking(
        PP_VIEW_PERSPECTIVE, pp_vec(1.5, 3.1, 1.6), pp_vec(0.0, -1.0, 0.0), 0.6, 40, 1);
    struct pp_irradiance_cache *cache = grown(&scene, &options, 0, 1, 1.0);
    int outside = 0;
    for (size_t i = 0; i < pp_irradiance_cache_count(cache); i++) {
        struct pp_cache_record record = pp_irradiance_cache_record(cache, i);
        outside += record.depth == 0 && record.point.y < -5.0;
    }
    assert_true(outside > 3);
    pp_irradiance_cache_destroy(cache);
    clear(&scene);
}

/* Whether the cache is filled for the whole picture at once or for one part after
 * another, every pixel has a record near its centre. The records are identical for any
 * number of threads and slices. */
static void every_pixel_is_read_between_records(void **state)
{
    (void)state;
    enum { WIDE = 91, HIGH = 67, PART = 500 };
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options =
        looking(PP_VIEW_PERSPECTIVE, pp_vec(1.3, 4.1, 1.6), pp_vec(0.1, -1.0, 0.0), 1.2,
                WIDE, 1);
    options.height = HIGH;
    struct pp_irradiance_cache *caches[] = {grown(&scene, &options, 0, 1, 1.0),
                                            grown(&scene, &options, PART, 1, 1.0),
                                            grown(&scene, &options, PART, 3, 0.0)};
    for (int which = 0; which < 2; which++)
        for (int i = 0; i < WIDE * HIGH; i++) {
            struct pp_light_ray ray = {.space = PP_INDOORS};
            struct pp_light_hit hit;
            struct pp_rgb value;
            assert_true(pp_camera_ray(&options.camera, (i % WIDE + 0.5) / WIDE,
                                      (i / WIDE + 0.5) / HIGH, &ray.from, &ray.to));
            if (pp_light_scene_first(scene.light, &ray, &hit)
                && pp_light_scene_material(scene.light, hit.material)->kind
                       == PP_MATERIAL_OPAQUE)
                assert_true(pp_irradiance_cache_value(
                    caches[which], hit.point, hit.normal, hit.space, 0, &value));
        }
    assert_true(caches[0]->layers[0].request_capacity >= WIDE * HIGH * 3 / 4);
    assert_true(caches[1]->layers[0].request_capacity <= 1024);

    char *bytes[2];
    size_t lengths[2];
    for (int i = 0; i < 2; i++)
        assert_int_equal(
            pp_cache_file_pack(caches[1 + i], &bytes[i], &lengths[i], NULL), PP_OK);
    assert_int_equal(lengths[0], lengths[1]);
    assert_memory_equal(bytes[0], bytes[1], lengths[0]);
    for (int i = 0; i < 2; i++)
        free(bytes[i]);
    for (int i = 0; i < 3; i++)
        pp_irradiance_cache_destroy(caches[i]);
    clear(&scene);
}

/* ---- checkpoints ---- */

struct kept {
    char *bytes;
    size_t size;
};

static struct kept kept_of(const struct pp_render *render)
{
    struct kept kept;
    FILE *out = open_memstream(&kept.bytes, &kept.size);
    assert_non_null(out);
    assert_int_equal(pp_checkpoint_save(render, NULL, out, NULL), PP_OK);
    assert_int_equal(fclose(out), 0);
    return kept;
}

static enum pp_status take_up(struct pp_render *render, const char *bytes, size_t size,
                              struct pp_error *err)
{
    /* An allocated copy of exactly this size, so that a read beyond its end is
     * detected. */
    unsigned char *copy = malloc(size + !size);
    assert_non_null(copy);
    memcpy(copy, bytes, size);
    enum pp_status status = pp_checkpoint_resume(render, copy, size, err);
    free(copy);
    return status;
}

static void a_picture_continued_from_a_checkpoint_is_the_same(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options = looking(
        PP_VIEW_PERSPECTIVE, pp_vec(1.3, 4.1, 1.6), pp_vec(0.1, -1.0, 0.0), 1.2, 70, 2);
    struct pp_render *whole = rendered(&scene, &options);
    struct pp_render *half = begun(&scene, &options);
    while (pp_render_progress(half) < 0.4)
        assert_int_equal(pp_render_advance(half, 0.0, NULL), PP_OK);
    assert_false(pp_render_done(half));
    struct kept kept = kept_of(half);
    struct pp_render *rest = begun(&scene, &options);
    assert_int_equal(take_up(rest, kept.bytes, kept.size, NULL), PP_OK);
    assert_near(pp_render_progress(rest), pp_render_progress(half), 0.0);
    while (!pp_render_done(rest))
        assert_int_equal(pp_render_advance(rest, 1.0, NULL), PP_OK);
    assert_same_pictures(whole, rest);
    assert_true(pp_render_work(whole).rays == pp_render_work(rest).rays);
    free(kept.bytes);
    pp_render_destroy(whole);
    pp_render_destroy(half);
    pp_render_destroy(rest);
    clear(&scene);
}

static struct pp_irradiance_cache *cache_of(const struct scene *scene,
                                            const struct pp_render_options *options)
{
    struct pp_cache_options few = pp_irradiance_cache_defaults();
    few.accuracy = 0.5;
    few.divisions = 64;
    few.supersamples = 0;
    return new_cache(scene, options, &few);
}

static void see_picture(struct pp_irradiance_cache *cache,
                        const struct pp_light_scene *scene,
                        struct pp_render_options *options)
{
    struct pp_cache_warm_up *warm_up;
    assert_int_equal(pp_cache_warm_up_create(&warm_up, cache, scene, options, 0, NULL),
                     PP_OK);
    while (!pp_cache_warm_up_done(warm_up))
        assert_int_equal(pp_cache_warm_up_advance(warm_up, 1.0, NULL), PP_OK);
    pp_cache_warm_up_destroy(warm_up);
    options->ambient = pp_irradiance_cache_ambient(cache);
    options->ambient_hash = pp_render_cache_hash(cache);
}

/* A checkpoint contains the cache: it is not filled again, and the picture is
 * identical. */
static void a_picture_with_a_cache_continues_with_the_same_cache(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options = looking(
        PP_VIEW_PERSPECTIVE, pp_vec(1.3, 4.1, 1.6), pp_vec(0.1, -1.0, 0.0), 1.2, 40, 2);
    struct pp_irradiance_cache *cache = cache_of(&scene, &options);
    see_picture(cache, scene.light, &options);
    struct pp_render *whole = rendered(&scene, &options);
    struct pp_render *half = begun(&scene, &options);
    assert_int_equal(pp_render_advance(half, 0.0, NULL), PP_OK);
    struct kept kept;
    FILE *out = open_memstream(&kept.bytes, &kept.size);
    assert_int_equal(pp_checkpoint_save(half, cache, out, NULL), PP_OK);
    assert_int_equal(fclose(out), 0);

    const char *records;
    size_t length;
    assert_int_equal(pp_checkpoint_cache((unsigned char *)kept.bytes, kept.size,
                                         &records, &length, NULL),
                     PP_OK);
    options.ambient = NULL;
    struct pp_irradiance_cache *again = cache_of(&scene, &options);
    assert_int_equal(pp_cache_file_unpack(again, records, length, "kept", NULL), PP_OK);
    assert_true(pp_irradiance_cache_count(again) == pp_irradiance_cache_count(cache));
    see_picture(again, scene.light, &options);
    assert_true(pp_irradiance_cache_count(again) == pp_irradiance_cache_count(cache));
    struct pp_render *rest = begun(&scene, &options);
    assert_int_equal(take_up(rest, kept.bytes, kept.size, NULL), PP_OK);
    while (!pp_render_done(rest))
        assert_int_equal(pp_render_advance(rest, 1.0, NULL), PP_OK);
    assert_same_pictures(whole, rest);

    for (size_t size = 0; size < kept.size; size += 1 + size / 16)
        assert_int_equal(pp_checkpoint_cache((unsigned char *)kept.bytes, size,
                                             &records, &length, NULL),
                         PP_BAD_INPUT);
    free(kept.bytes);
    pp_render_destroy(whole);
    pp_render_destroy(half);
    pp_render_destroy(rest);
    pp_irradiance_cache_destroy(cache);
    pp_irradiance_cache_destroy(again);
    clear(&scene);
}

static void a_checkpoint_is_read_completely_or_not_at_all(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options = looking(
        PP_VIEW_PERSPECTIVE, pp_vec(1.3, 4.1, 1.6), pp_vec(0.1, -1.0, 0.0), 1.2, 20, 1);
    struct pp_render *whole = rendered(&scene, &options);
    struct kept kept = kept_of(whole);
    struct pp_render *fresh = begun(&scene, &options);
    struct pp_error err;
    for (size_t size = 0; size < kept.size; size += 1 + size / 16)
        assert_int_equal(take_up(fresh, kept.bytes, size, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "cut off"));
    for (size_t at = 0; at < kept.size; at += 7) {
        kept.bytes[at] ^= 4;
        assert_int_equal(take_up(fresh, kept.bytes, kept.size, &err), PP_BAD_INPUT);
        kept.bytes[at] ^= 4;
    }
    assert_near(pp_render_progress(fresh), 0.0, 0.0);
    assert_int_equal(take_up(fresh, kept.bytes, kept.size, &err), PP_OK);
    assert_true(pp_render_done(fresh));

    /* A different seed or view point is rejected. */
    options.seed++;
    struct pp_render *other = begun(&scene, &options);
    assert_int_equal(take_up(other, kept.bytes, kept.size, &err), PP_BAD_INPUT);
    assert_non_null(strstr(err.message, "another picture"));
    pp_render_destroy(other);
    options.seed--;
    options.camera.eye.x += 1e-9;
    other = begun(&scene, &options);
    assert_int_equal(take_up(other, kept.bytes, kept.size, &err), PP_BAD_INPUT);
    pp_render_destroy(other);
    free(kept.bytes);
    pp_render_destroy(whole);
    pp_render_destroy(fresh);
    clear(&scene);
}

static void what_makes_no_picture_is_refused(void **state)
{
    (void)state;
    struct scene scene = scene_of(DEEP);
    struct pp_render_options options = looking(
        PP_VIEW_PERSPECTIVE, pp_vec(1.3, 4.1, 1.6), pp_vec(0.1, -1.0, 0.0), 1.2, 8, 0);
    struct pp_render *render;
    assert_int_equal(
        pp_render_create(&render, scene.light, scene.environment, &options, NULL),
        PP_BAD_INPUT);
    assert_null(render);
    options.samples = 1;
    options.height = 0;
    assert_int_equal(
        pp_render_create(&render, scene.light, scene.environment, &options, NULL),
        PP_BAD_INPUT);
    clear(&scene);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_uniform_sky_through_glass_is_dimmed_by_it),
        cmocka_unit_test(a_fisheyes_mean_is_the_illuminance),
        cmocka_unit_test(a_furnace_is_even),
        cmocka_unit_test(a_plan_of_daylight_factors_has_those_of_receivers),
        cmocka_unit_test(decorations_dim_a_picture_of_daylight_factors),
        cmocka_unit_test(glass_has_no_daylight_factor),
        cmocka_unit_test(a_cut_room_ends_at_its_walls),
        cmocka_unit_test(a_pixel_shows_the_part_that_is_most_of_it),
        cmocka_unit_test(a_picture_does_not_depend_on_threads),
        cmocka_unit_test(what_stands_behind_a_framed_pane_is_in_the_cache),
        cmocka_unit_test(every_pixel_is_read_between_records),
        cmocka_unit_test(a_picture_continued_from_a_checkpoint_is_the_same),
        cmocka_unit_test(a_picture_with_a_cache_continues_with_the_same_cache),
        cmocka_unit_test(a_checkpoint_is_read_completely_or_not_at_all),
        cmocka_unit_test(what_makes_no_picture_is_refused),
    };
    add_tests(tests, NULL, NULL);
}
