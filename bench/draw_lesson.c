/* draw_lesson.c - the pictures of docs/theory.md and of docs/elements/material.md: the
 * same light sampled directly and found by chance, with about the same number of rays;
 * an orange with and without bumps; and a copper sphere by two models of reflection,
 * under an overcast sky, and under the photograph of a hazy one whose light is found in
 * three ways. Writes twelve PNG files to a folder, and prints the noise and time of the
 * three ways. With the word "sphere" it draws the sphere under the photograph only, with
 * "orange" the orange only. */
#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/bench.h"
#include "model/light/photographs/sky_picture.h"
#include "model/room/building.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_scene_of_description.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/transport/radiance.h"

enum { WIDE = 320, HIGH = 240 };

/* ---- a picture ---- */

struct view {
    struct pp_vec3 eye, to, right, up; /* right, up: half the extent of the picture */
    double exposure;
};

static struct view view_of(struct pp_vec3 eye, struct pp_vec3 at, double half_wide,
                           double exposure)
{
    struct view view = {
        .eye = eye, .to = pp_vec_unit(pp_vec_sub(at, eye)), .exposure = exposure};
    struct pp_vec3 right = pp_vec_unit(pp_vec_cross(view.to, pp_vec(0.0, 0.0, 1.0)));
    view.right = pp_vec_scale(right, half_wide);
    view.up = pp_vec_scale(pp_vec_cross(right, view.to), half_wide * HIGH / WIDE);
    return view;
}

static struct pp_rgb pixel(struct pp_radiance_state *path_state,
                           const struct view *view, const struct pp_sobol *sobol, int x,
                           int y, uint64_t seed, uint32_t paths)
{
    struct pp_rgb sum = pp_rgb_grey(0.0);
    pp_sobol_sequence_init(&path_state->sequence, sobol,
                           pp_hash((uint64_t)y, (uint64_t)x) + seed);
    for (path_state->index = 0; path_state->index < paths; path_state->index++) {
        double u[2];
        pp_sobol_sequence_draw(&path_state->sequence, path_state->index, 0, 2, u);
        struct pp_light_ray ray = {.from = view->eye};
        struct pp_vec3 to =
            pp_vec_along(view->to, 2.0 * (x + u[0]) / WIDE - 1.0, view->right);
        ray.to = pp_vec_unit(pp_vec_along(to, 1.0 - 2.0 * (y + u[1]) / HIGH, view->up));
        ray.space = pp_light_scene_space(path_state->scene, view->eye);
        sum = pp_rgb_along(sum, 1.0 / paths, pp_radiance_along(path_state, &ray, NULL));
    }
    return sum;
}

static unsigned shown(double value)
{
    return (unsigned)(255.0 * pow(fmin(fmax(value, 0.0), 1.0), 1.0 / 2.2) + 0.5);
}

static void draw(const char *folder, const char *name,
                 const struct pp_light_scene *scene,
                 const struct pp_environment *environment, const struct view *view,
                 struct pp_radiance_options options, uint32_t paths)
{
    static struct pp_sobol sobol;
    pp_sobol_init(&sobol);
    cairo_surface_t *surface =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDE, HIGH);
    unsigned char *bytes = cairo_image_surface_get_data(surface);
    int stride = cairo_image_surface_get_stride(surface);
    struct pp_radiance_state path_state = {
        .scene = scene, .environment = environment, .options = options};
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++) {
            struct pp_rgb c = pp_rgb_scale(
                pixel(&path_state, view, &sobol, x, y, 0, paths), view->exposure);
            uint32_t word = shown(c.r) << 16 | shown(c.g) << 8 | shown(c.b);
            memcpy(bytes + y * stride + 4 * x, &word, sizeof word);
        }
    cairo_surface_mark_dirty(surface);
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    if (cairo_surface_write_to_png(surface, path) != CAIRO_STATUS_SUCCESS) {
        fprintf(stderr, "draw_lesson: cannot write %s\n", path);
        exit(3);
    }
    cairo_surface_destroy(surface);
    printf("%s: %.0f rays a pixel\n", path, (double)path_state.rays / (WIDE * HIGH));
}

/* ---- a lamp ---- */

static int add(struct pp_scene_description *scene, struct pp_material material)
{
    struct pp_error err;
    int index;
    must(pp_scene_description_add_material(scene, &material, &index, &err), &err);
    return index;
}

static void add_wall(struct pp_scene_description *scene, int material,
                     struct pp_vec3 corner, struct pp_vec3 along, struct pp_vec3 across)
{
    struct pp_vec3 v[4] = {corner, pp_vec_add(corner, along),
                           pp_vec_add(pp_vec_add(corner, along), across),
                           pp_vec_add(corner, across)};
    struct pp_error err;
    must(pp_scene_description_add_polygon(scene, v, 4, material, NULL, &err), &err);
}

/* A room with a brass sphere on a block, under a square lamp. */
static struct pp_light_scene *lamp_room(struct pp_material lamp)
{
    struct pp_scene_description from;
    struct pp_light_scene *scene;
    struct pp_error err;
    pp_scene_description_init(&from);
    int white = add(&from, pp_material_diffuse(pp_rgb(0.75, 0.73, 0.7)));
    int red = add(&from, pp_material_diffuse(pp_rgb(0.6, 0.25, 0.2)));
    int floor = add(&from, pp_material_diffuse(pp_rgb(0.45, 0.36, 0.28)));
    int brass = add(&from, pp_material_metal(pp_rgb(0.8, 0.62, 0.3), 0.8, 0.15, 0.15));
    struct pp_vec3 x = {4.0, 0.0, 0.0}, y = {0.0, 4.0, 0.0}, z = {0.0, 0.0, 2.6};
    struct pp_vec3 o = {0.0, 0.0, 0.0};
    add_wall(&from, floor, o, x, y);
    add_wall(&from, white, z, y, x);
    add_wall(&from, red, o, y, z);
    add_wall(&from, white, x, z, y);
    add_wall(&from, white, y, x, z);
    add_wall(&from, white, o, z, x);
    struct pp_vec3 b = {1.5, 2.2, 0.0}, bx = {0.8, 0.2, 0.0}, by = {-0.2, 0.8, 0.0};
    struct pp_vec3 bz = {0.0, 0.0, 0.7};
    add_wall(&from, white, b, bx, bz);
    add_wall(&from, white, pp_vec_add(b, by), bz, bx);
    add_wall(&from, white, b, bz, by);
    add_wall(&from, white, pp_vec_add(b, bx), by, bz);
    add_wall(&from, white, pp_vec_add(b, bz), bx, by);
    struct pp_shape ball = {.kind = PP_SHAPE_SPHERE,
                            .material = brass,
                            .back_material = -1,
                            .is.sphere = {pp_vec(1.8, 2.7, 1.0), 0.3}};
    must(pp_scene_description_add_shape(&from, &ball, NULL, &err), &err);
    add_wall(&from, add(&from, lamp), pp_vec(1.8, 1.8, 2.58), pp_vec(0.0, 0.4, 0.0),
             pp_vec(0.4, 0.0, 0.0));
    must(pp_light_scene_of_description(&scene, &from, &err), &err);
    pp_scene_description_clear(&from);
    return scene;
}

static void lamp_pictures(const char *folder)
{
    struct view view = view_of(pp_vec(3.2, 0.2, 1.5), pp_vec(1.5, 3.0, 1.0), 0.75, 1.3);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    options.source_size = 0.0;
    struct pp_light_scene *light = lamp_room(pp_material_light(pp_rgb_grey(30.0)));
    draw(folder, "lamp-light", light, NULL, &view, options, 64);
    pp_light_scene_destroy(light);
    struct pp_light_scene *glow = lamp_room(pp_material_glow(pp_rgb_grey(30.0)));
    draw(folder, "lamp-glow", glow, NULL, &view, options, 100);
    pp_light_scene_destroy(glow);
}

/* ---- a window ---- */

static struct pp_world *deep_room(struct pp_outside_light *light)
{
    static const char xml[] =
        "<room version='1'><plan width='3' depth='9' height='2.7'/>"
        "<finishes floor='oak-floor' walls='0.7' ceiling='0.8'/>"
        "<window wall='south' left='0.2' sill='0.8' width='2.6' height='1.5'/>"
        "<block x='-4' y='-14' width='10' depth='6' height='8'/></room>";
    return world_of(light, xml);
}

static void window_pictures(const char *folder)
{
    struct pp_outside_light light;
    struct pp_world *world = deep_room(&light);
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_error err;
    must(pp_light_scene_of_world(&scene, world, &err), &err);
    must(pp_light_scene_under(&environment, scene, &light, &err), &err);
    struct view view =
        view_of(pp_vec(1.3, 8.6, 1.6), pp_vec(1.6, 0.0, 1.15), 0.62, 22.0);
    struct pp_radiance_options options = pp_radiance_state_defaults();
    options.source_size = 0.0;
    draw(folder, "window-aimed-at", scene, environment, &view, options, 64);
    options.windows = false;
    draw(folder, "window-by-chance", scene, environment, &view, options, 160);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    pp_world_destroy(world);
}

/* ---- a copper sphere ---- */

/* Optical constants of copper as in docs/elements/material.md, with less roughness. */
static const struct pp_rough_optics copper = {
    {0.21, 1.04, 1.18}, {3.67, 2.59, 2.40}, {0.65, 0.55, 0.45}, 0.18, 3.0,
    {0.0, 0.0, 0.0}};

/* A sphere of that material on a table of light and dark tiles, over dark ground, under
 * the sky. */
static struct pp_light_scene *sphere_on_table(struct pp_material metal,
                                              const struct pp_sky *light)
{
    enum { TILES = 4 };
    struct pp_scene_description from;
    struct pp_light_scene *scene;
    struct pp_error err;
    int sky_pattern;
    pp_scene_description_init(&from);
    struct pp_pattern pattern = {
        .kind = PP_PATTERN_SKY, .factor = PP_PI, .sky = *light};
    must(pp_scene_description_add_pattern(&from, &pattern, &sky_pattern, &err), &err);
    struct pp_material sky = pp_material_glow(pp_rgb(0.95, 1.0, 1.1));
    sky.pattern = sky_pattern;
    struct pp_shape dome = {.kind = PP_SHAPE_DISTANT,
                            .material = add(&from, sky),
                            .back_material = -1,
                            .is.distant = {pp_vec(0.0, 0.0, 1.0), PP_PI / 2.0}};
    must(pp_scene_description_add_shape(&from, &dome, NULL, &err), &err);
    int ground = add(&from, pp_material_diffuse(pp_rgb(0.13, 0.15, 0.1)));
    add_wall(&from, ground, pp_vec(-4e3, -4e3, -0.75), pp_vec(8e3, 0.0, 0.0),
             pp_vec(0.0, 8e3, 0.0));
    int tiles[2] = {add(&from, pp_material_diffuse(pp_rgb(0.75, 0.72, 0.66))),
                    add(&from, pp_material_diffuse(pp_rgb(0.12, 0.17, 0.25)))};
    for (int i = 0; i < TILES * TILES; i++)
        add_wall(&from, tiles[(i % TILES + i / TILES) % 2],
                 pp_vec(-0.8 + 0.4 * (i % TILES), -0.8 + 0.4 * (i / TILES), 0.0),
                 pp_vec(0.4, 0.0, 0.0), pp_vec(0.0, 0.4, 0.0));
    struct pp_shape ball = {.kind = PP_SHAPE_SPHERE,
                            .material = add(&from, metal),
                            .back_material = -1,
                            .is.sphere = {pp_vec(0.0, 0.0, 0.4), 0.4}};
    must(pp_scene_description_add_shape(&from, &ball, NULL, &err), &err);
    must(pp_light_scene_of_description(&scene, &from, &err), &err);
    pp_scene_description_clear(&from);
    return scene;
}

/* Ward's gloss with the slopes of the same facets, and the same reflectance for diffuse
 * light. */
static struct pp_material ward_copper(const struct pp_rough_surface *rough)
{
    double slope = 2.0 * copper.roughness / copper.correlation;
    return pp_material_metal(pp_rough_surface_reflectance(rough), 1.0, slope, slope);
}

static struct view sphere_view(void)
{
    return view_of(pp_vec(1.2, -2.3, 0.7), pp_vec(0.0, 0.0, 0.42), 0.27, 0.55);
}

static void sphere_pictures(const char *folder, const struct pp_rough_surface *rough)
{
    struct view view = sphere_view();
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_light_scene *scene = sphere_on_table(pp_material_rough(rough), &overcast);
    draw(folder, "copper-he-torrance", scene, NULL, &view, options, 64);
    pp_light_scene_destroy(scene);
    scene = sphere_on_table(ward_copper(rough), &overcast);
    draw(folder, "copper-ward", scene, NULL, &view, options, 64);
    pp_light_scene_destroy(scene);
}

/* ---- an orange ---- */

/* Bumps of the orange's skin; the orange is as large as the sphere. */
static const char skin[] =
    "0.004 (sin(5200 x + 60 sin(3000 y)) "
    "+ sin(5600 y + 60 sin(3300 z)) + sin(4900 z + 60 sin(3600 x)))";

static void orange_pictures(const char *folder)
{
    static struct pp_surface_pattern even, height;
    struct pp_expression_mistake mistake;
    if (!pp_surface_pattern_parse(&even, "1", &mistake)
        || !pp_surface_pattern_parse(&height, skin, &mistake)) {
        fprintf(stderr, "draw_lesson: column %d: %s\n", mistake.column + 1,
                mistake.what);
        exit(1);
    }
    struct view view = sphere_view();
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_sky overcast = pp_sky_overcast();
    struct pp_material orange = pp_material_diffuse(pp_rgb(0.85, 0.4, 0.06));
    struct pp_light_scene *scene = sphere_on_table(orange, &overcast);
    draw(folder, "orange-smooth", scene, NULL, &view, options, 64);
    pp_light_scene_destroy(scene);
    orange.surface_pattern = &even;
    orange.pattern_scale = orange.diffuse;
    orange.pattern_mean = 1.0;
    orange.bumps = &height;
    scene = sphere_on_table(orange, &overcast);
    draw(folder, "orange-bumps", scene, NULL, &view, options, 64);
    pp_light_scene_destroy(scene);
}

/* ---- the sphere under a photograph ---- */

/* A fisheye photograph, calculated, of a hazy sky (ISO type 15) with the sun behind thin
 * clouds at 35 degrees in the south-west. */
static struct pp_sky_picture *photograph(enum pp_sky_sampling sampling)
{
    enum { SIDE = 1024 };
    struct pp_error err;
    struct pp_sky hazy;
    struct pp_sky_picture *picture = calloc(1, sizeof *picture);
    float *pixels = calloc((size_t)SIDE * SIDE, sizeof *pixels);
    if (!picture || !pixels)
        exit(3);
    double altitude = 35.0 * PP_RAD, bearing = 225.0 * PP_RAD;
    must(pp_sky_iso(&hazy, 15,
                    pp_vec(cos(altitude) * sin(bearing), cos(altitude) * cos(bearing),
                           sin(altitude)),
                    &err),
         &err);
    *picture = (struct pp_sky_picture){.frames = {{.width = SIDE,
                                                   .height = SIDE,
                                                   .luminance = pixels,
                                                   .projection = PP_SKY_EQUIDISTANT,
                                                   .half_angle_rad = PP_PI / 2.0,
                                                   .centre = {SIDE / 2.0, SIDE / 2.0},
                                                   .radius = {SIDE / 2.0, SIDE / 2.0},
                                                   .right = {-1.0, 0.0, 0.0},
                                                   .up = {0.0, 1.0, 0.0},
                                                   .toward = {0.0, 0.0, 1.0}}},
                                       .frame_count = 1,
                                       .fill_cd_m2 = NAN,
                                       .sampling = sampling,
                                       .lamps = 16,
                                       .holders = 1};
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct pp_vec3 to;
        if (pp_sky_picture_direction(&picture->frames[0], i % SIDE + 0.5,
                                     i / SIDE + 0.5, &to))
            pixels[i] = (float)(2e4 * pp_sky_luminance(&hazy, to));
    }
    must(pp_sky_picture_settle(picture, NAN, &err), &err);
    return picture;
}

/* RMS noise of the pixels' green channel relative to the mean of the picture, from the
 * differences of two independent pictures of every fourth pixel, and the processor time
 * of a path (microseconds). */
static void measure_noise(const char *name, const struct pp_light_scene *scene,
                          const struct pp_environment *environment,
                          const struct view *view, struct pp_radiance_options options)
{
    enum { STEP = 4, PATHS = 64 };
    static struct pp_sobol sobol;
    struct pp_radiance_state path_state = {
        .scene = scene, .environment = environment, .options = options};
    double squares = 0.0, sum = 0.0, begun = processor_s();
    int count = 0;
    pp_sobol_init(&sobol);
    for (int y = 0; y < HIGH; y += STEP)
        for (int x = 0; x < WIDE; x += STEP, count++) {
            double value[2];
            for (int k = 0; k < 2; k++)
                value[k] = pixel(&path_state, view, &sobol, x, y, k, PATHS).g;
            double off = value[0] - value[1];
            squares += off * off / 2.0;
            sum += (value[0] + value[1]) / 2.0;
        }
    double noise = sqrt(squares / count) / (sum / count);
    double seconds = processor_s() - begun;
    printf("%-28s noise %.4f, %.2f us a path, time for a noise of 0.01 relative %.3g\n",
           name, noise, 1e6 * seconds / (2.0 * PATHS * count),
           1e4 * noise * noise * seconds);
}

static void photograph_pictures(const char *folder,
                                const struct pp_rough_surface *rough)
{
    static const char *const ways[] = {[PP_SKY_SAMPLE_BRIGHT] = "bright",
                                       [PP_SKY_SAMPLE_LAMPS] = "lamps",
                                       [PP_SKY_SAMPLE_CHANCE] = "glow"};
    struct view view = sphere_view();
    struct pp_radiance_options options = pp_radiance_state_defaults();
    struct pp_error err;
    for (int way = PP_SKY_SAMPLE_BRIGHT; way <= PP_SKY_SAMPLE_CHANCE; way++) {
        struct pp_sky_picture *picture = photograph((enum pp_sky_sampling)way);
        const struct pp_outside_light light = {.sky = pp_sky_of_picture(picture, 0.0)};
        for (int ward = 0; ward < 2; ward++) {
            char name[64];
            struct pp_light_scene *scene = sphere_on_table(
                ward ? ward_copper(rough) : pp_material_rough(rough), &light.sky);
            struct pp_environment *environment;
            must(pp_light_scene_under(&environment, scene, &light, &err), &err);
            snprintf(name, sizeof name, "photograph-%s-%s", ways[way],
                     ward ? "ward" : "he-torrance");
            measure_noise(name, scene, environment, &view, options);
            if (way != PP_SKY_SAMPLE_BRIGHT)
                draw(folder, name, scene, environment, &view, options, 16);
            pp_environment_destroy(environment);
            pp_light_scene_destroy(scene);
        }
        pp_sky_picture_release(picture);
    }
}

int main(int argc, char **argv)
{
    static struct pp_rough_surface rough;
    struct pp_error err;
    bool sphere = argc == 3 && strcmp(argv[2], "sphere") == 0,
         orange = argc == 3 && strcmp(argv[2], "orange") == 0;
    if (argc != 2 && !sphere && !orange) {
        fprintf(stderr, "draw_lesson FOLDER [sphere|orange]\n");
        return 2;
    }
    must(pp_rough_surface_init(&rough, &copper, &err), &err);
    if (!sphere && !orange) {
        lamp_pictures(argv[1]);
        window_pictures(argv[1]);
        sphere_pictures(argv[1], &rough);
    }
    if (!sphere)
        orange_pictures(argv[1]);
    if (!orange)
        photograph_pictures(argv[1], &rough);
    return 0;
}
