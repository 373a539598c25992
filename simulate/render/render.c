/* render.c - the pixels of a tile as a sampler, and the tiles of a picture. */
#include "simulate/render/render.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "simulate/estimate/planner.h"
#include "simulate/render/render_parts.h"
#include "simulate/render/render_plain.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"

enum {
    /* Vertex of a path's random numbers for its position in the pixel. The vertices of
     * the path itself are much smaller; those of its branches are hashed and hardly
     * ever the same. */
    PIXEL_VERTEX = 1 << 29,
};

/* Standard deviation and radius of the Gaussian filter, in pixels. */
static const double deviation = 0.5, reach = 1.5;

/* ---- one pixel ---- */

/* Position of a pixel's sample in the picture (in pixels). */
static void place_sample(const struct pp_render *render,
                         const struct pp_radiance_state *state, int x, int y,
                         double place[2])
{
    double u[2];
    pp_sobol_sequence_draw(&state->sequence, state->index, PIXEL_VERTEX, 2, u);
    if (render->options.filter == PP_FILTER_BOX) {
        place[0] = x + u[0];
        place[1] = y + u[1];
        return;
    }
    /* Radius from its distribution up to `reach`, at a uniform angle. */
    double whole = -expm1(-0.5 * reach * reach / (deviation * deviation));
    double r = deviation * sqrt(-2.0 * log1p(-u[0] * whole));
    place[0] = x + 0.5 + r * cos(2.0 * PP_PI * u[1]);
    place[1] = y + 0.5 + r * sin(2.0 * PP_PI * u[1]);
}

bool pp_render_camera_ray(const struct pp_render *render, const double place[2],
                          struct pp_light_ray *ray)
{
    const struct pp_render_options *options = &render->options;
    *ray = (struct pp_light_ray){.space = render->eye_space};
    if (!pp_camera_ray(&options->camera, place[0] / options->width,
                       place[1] / options->height, &ray->from, &ray->to))
        return false;
    if (options->camera.kind == PP_VIEW_ANGULAR
        && hypot(2.0 * place[0] / options->width - 1.0,
                 2.0 * place[1] / options->height - 1.0)
               > 1.0)
        return false; /* outside the circle */
    if (options->camera.kind == PP_VIEW_PARALLEL)
        ray->space = pp_light_scene_space(render->scene, ray->from);
    return !options->indoors || ray->space == PP_INDOORS;
}

double pp_render_decorations(const struct pp_render *render)
{
    return render->options.irradiance ? render->scene->decorations : 1.0;
}

/* Irradiance of the surface that the ray meets; false if there is none, or if the
 * surface is glass or air. */
static bool irradiance_seen(const struct pp_render *render,
                            struct pp_radiance_state *state,
                            const struct pp_light_ray *ray, struct pp_rgb *value)
{
    struct pp_light_hit hit;
    state->rays++;
    if (!pp_light_scene_first(state->scene, ray, &hit))
        return false;
    const struct pp_material *material =
        pp_light_scene_material(state->scene, hit.material);
    if (material->kind == PP_MATERIAL_GLASS || material->kind == PP_MATERIAL_AIR)
        return false;
    struct pp_irradiance e;
    if (state->ambient
        && state->ambient->irradiance(state->ambient->store, &hit, hit.normal, 0,
                                      value)) {
        e = pp_radiance_direct(state, hit.point, hit.normal, hit.space);
        e.rest = *value;
    } else {
        e = pp_radiance_irradiance(state, hit.point, hit.normal, hit.space);
    }
    struct pp_rgb reflected = pp_rgb_add(e.sources, e.rest);
    if (hit.space == PP_INDOORS)
        reflected = pp_rgb_scale(reflected, pp_render_decorations(render));
    *value = pp_rgb_add(reflected, pp_rgb_add(e.sky, e.outside));
    return true;
}

/* ---- the sampler: the pixels of a tile, row by row ---- */

/* Sums of a randomisation: of each channel, and the number of samples with a value. */
enum { RED, GREEN, BLUE, SEEN };
enum { GREY = 3, VALUES };

static void pixel_of_point(const struct pp_render *render, int point, int *x, int *y)
{
    const struct pp_render_tile *tile = &render->tile;
    *x = tile->x0 + point % (tile->x1 - tile->x0);
    *y = tile->y0 + point / (tile->x1 - tile->x0);
}

/* State of one thread: of the transport's paths, or of plain paths. */
struct render_state {
    struct pp_radiance_state radiance;
    struct pp_path_walk walk;
};

static void begin_render_state(const void *client, void *state)
{
    const struct pp_render *render = client;
    const struct pp_render_options *options = &render->options;
    *(struct render_state *)state = (struct render_state){
        .radiance = {.scene = render->scene,
                     .environment = render->environment,
                     .options = options->light,
                     .store = options->store,
                     .ambient = options->ambient},
        .walk = {.scene = render->scene, .environment = render->environment}};
}

/* One sample of the value along the ray; false: no value. */
static bool sample_ray(const struct pp_render *render, struct render_state *state,
                       const struct pp_light_ray *ray, struct pp_rgb *value)
{
    const struct pp_render_options *options = &render->options;
    if (options->irradiance)
        return options->plain ? pp_render_plain_irradiance(
                   &state->walk, *ray, pp_render_decorations(render), value)
                              : irradiance_seen(render, &state->radiance, ray, value);
    *value = options->plain ? pp_render_plain_radiance(&state->walk, *ray)
                            : pp_radiance_along(&state->radiance, ray, NULL);
    return true;
}

static uint64_t pixel_seed(const void *client, int point)
{
    const struct pp_render *render = client;
    int x, y;
    pixel_of_point(render, point, &x, &y);
    return pp_hash(render->options.seed,
                   (uint64_t)y * (uint64_t)render->options.width + (uint64_t)x);
}

static void follow_pixel_paths(const void *client, void *state,
                               const struct pp_path_range *range,
                               struct pp_randomisation *randomisation)
{
    const struct pp_render *render = client;
    struct render_state *own = state;
    struct pp_radiance_state *radiance = &own->radiance;
    long rays = radiance->rays + own->walk.rays;
    long leaks = radiance->leaks + own->walk.leaks;
    int x, y;
    pixel_of_point(render, range->point, &x, &y);
    radiance->sequence = own->walk.sequence = range->sequence;
    for (uint32_t i = range->first; i < range->end; i++) {
        double place[2];
        struct pp_light_ray ray;
        struct pp_rgb value;
        radiance->index = own->walk.index = i;
        place_sample(render, radiance, x, y, place);
        if (!pp_render_camera_ray(render, place, &ray)
            || !sample_ray(render, own, &ray, &value))
            continue;
        randomisation->sums[RED] += value.r;
        randomisation->sums[GREEN] += value.g;
        randomisation->sums[BLUE] += value.b;
        randomisation->sums[SEEN] += 1.0;
    }
    randomisation->rays[0] += radiance->rays + own->walk.rays - rays;
    randomisation->leaks += radiance->leaks + own->walk.leaks - leaks;
}

static double rendered_value(const void *client, int point,
                             const struct pp_randomisation *randomisation, int value)
{
    (void)client, (void)point;
    const double *sums = randomisation->sums;
    double sum = value == GREY
                     ? pp_rgb_luminance(pp_rgb(sums[RED], sums[GREEN], sums[BLUE]))
                     : sums[value];
    return sum / randomisation->done.of[0];
}

static const struct pp_sampler sampler = {
    .estimators = 1,
    .values = VALUES,
    .fall = {1.2},
    .state_size = sizeof(struct render_state),
    .begin = begin_render_state,
    .seed = pixel_seed,
    .follow = follow_pixel_paths,
    .value = rendered_value,
};

/* Fraction of the pixel's paths that have a value. */
static double share_seen(const struct pp_render *render, int point)
{
    struct pp_sampled sampled = pp_planner_sampled(render->planner, point);
    double seen = 0.0;
    for (int i = 0; i < sampled.count; i++)
        seen += sampled.randomisations[i].sums[SEEN];
    return seen / render->options.samples;
}

/* Sets a pixel of the picture and of its errors. Irradiances are means over the part of
 * the pixel with a surface. */
static void read_pixel(struct pp_render *render, int point)
{
    int x, y;
    pixel_of_point(render, point, &x, &y);
    double share = share_seen(render, point), least = 0.0, scale = 1.0;
    if (render->options.irradiance) {
        least = 0.5;
        scale = 1.0 / share;
    }
    struct pp_reading readings[PP_VALUES_MOST];
    pp_planner_read(render->planner, point, readings);
    for (int i = RED; i <= BLUE; i++) {
        bool shows = share > 0.0 && share >= least;
        pp_picture_at(&render->picture, x, y)[i] =
            shows ? (float)(scale * readings[i].value) : NAN;
        if (render->errors.rgb)
            pp_picture_at(&render->errors, x, y)[i] =
                shows ? (float)(scale * readings[i].std_error) : NAN;
    }
}

static int tag_of_pixel(const struct pp_render *render, int x, int y)
{
    const double middle[2] = {x + 0.5, y + 0.5};
    struct pp_light_ray ray;
    struct pp_light_hit hit;
    if (!pp_render_camera_ray(render, middle, &ray)
        || !pp_light_scene_first(render->scene, &ray, &hit))
        return -1;
    return hit.tag;
}

/* ---- tiles ---- */

struct pp_render_tile pp_render_tile(const struct pp_render *render, int tile)
{
    const struct pp_render_options *options = &render->options;
    int x0 = tile % render->tiles_across * PP_RENDER_TILE;
    int y0 = tile / render->tiles_across * PP_RENDER_TILE;
    int x1 = x0 + PP_RENDER_TILE, y1 = y0 + PP_RENDER_TILE;
    return (struct pp_render_tile){x0, y0, x1 < options->width ? x1 : options->width,
                                   y1 < options->height ? y1 : options->height};
}

/* Sets pixel i of the current tile, and its tag, once its paths are done. */
static bool show_pixel(void *data, int worker, int i)
{
    (void)worker;
    struct pp_render *render = data;
    int x, y;
    pixel_of_point(render, i, &x, &y);
    read_pixel(render, i);
    render->tags[(size_t)y * (size_t)render->options.width + (size_t)x] =
        tag_of_pixel(render, x, y);
    return true;
}

/* Renders a tile: follows the paths of all its pixels and randomisations, on any
 * thread, then sets the pixels. */
static enum pp_status draw_tile(struct pp_render *render, int tile,
                                struct pp_error *err)
{
    struct pp_render_tile box = render->tile = pp_render_tile(render, tile);
    int count = (box.x1 - box.x0) * (box.y1 - box.y0);
    pp_planner_restart(render->planner, count);
    enum pp_status status = pp_planner_advance(render->planner, INFINITY, err);
    if (status != PP_OK)
        return status;
    pp_thread_pool_run_small(pp_planner_crew(render->planner), 0, count, show_pixel,
                             render);
    render->tile_done[tile] = 1;
    render->done_count++;
    return PP_OK;
}

enum pp_status pp_render_advance(struct pp_render *render, double seconds,
                                 struct pp_error *err)
{
    double end = pp_clock_s() + seconds;
    enum pp_status status = PP_OK;
    for (int tile = 0; status == PP_OK && tile < render->tile_count; tile++) {
        if (render->tile_done[tile])
            continue;
        status = draw_tile(render, tile, err);
        if (pp_clock_s() >= end)
            break;
    }
    return status;
}

/* ---- from the beginning to the end ---- */

static enum pp_status check_render_options(const struct pp_render_options *options,
                                           struct pp_error *err)
{
    if (options->samples < 1 || options->samples > PP_RENDER_SAMPLES_MOST)
        return pp_fail(err, PP_BAD_INPUT,
                       "the number of samples per pixel is %d; expected 1 to %d",
                       options->samples, PP_RENDER_SAMPLES_MOST);
    int count = options->randomisations;
    if (count != 0
        && (count < PP_RENDER_RANDOMISATIONS_LEAST || count > options->samples
            || (count & (count - 1))))
        return pp_fail(err, PP_BAD_INPUT,
                       "the number of randomisations is %d for %d samples per pixel; "
                       "expected a power of two from %d to the number of samples, or 0",
                       count, options->samples, PP_RENDER_RANDOMISATIONS_LEAST);
    return PP_OK;
}

enum pp_status pp_render_create(struct pp_render **render_out,
                                const struct pp_light_scene *scene,
                                const struct pp_environment *environment,
                                const struct pp_render_options *options,
                                struct pp_error *err)
{
    *render_out = NULL;
    enum pp_status status = check_render_options(options, err);
    if (status != PP_OK)
        return status;
    struct pp_render *render = calloc(1, sizeof *render);
    if (!render)
        return pp_fail_memory(err);
    render->scene = scene;
    render->environment = environment;
    render->options = *options;
    int samples = 1;
    while (samples < options->samples)
        samples *= 2;
    render->options.samples = samples;
    render->eye_space = pp_light_scene_space(scene, options->camera.eye);

    const struct pp_planner_options planned = {
        .samples = samples / (options->randomisations + !options->randomisations),
        .randomisations = options->randomisations + !options->randomisations,
        .threads = options->threads};
    render->tile = (struct pp_render_tile){0, 0, PP_RENDER_TILE, PP_RENDER_TILE};
    status = pp_planner_create(&render->planner, &sampler, render,
                               PP_RENDER_TILE * PP_RENDER_TILE, &planned, err);
    if (status == PP_OK)
        status =
            pp_picture_init(&render->picture, options->width, options->height, err);
    if (status == PP_OK && options->randomisations > 0)
        status = pp_picture_init(&render->errors, options->width, options->height, err);
    if (status != PP_OK) {
        pp_render_destroy(render);
        return status;
    }
    size_t pixels = (size_t)options->width * (size_t)options->height;
    render->tiles_across = (options->width + PP_RENDER_TILE - 1) / PP_RENDER_TILE;
    render->tile_count = render->tiles_across
                         * ((options->height + PP_RENDER_TILE - 1) / PP_RENDER_TILE);
    render->tags = calloc(pixels, sizeof *render->tags);
    render->tile_done = calloc((size_t)render->tile_count, 1);
    if (!render->tags || !render->tile_done) {
        pp_render_destroy(render);
        return pp_fail_memory(err);
    }
    *render_out = render;
    return PP_OK;
}

void pp_render_destroy(struct pp_render *render)
{
    if (!render)
        return;
    pp_planner_destroy(render->planner);
    pp_picture_clear(&render->picture);
    pp_picture_clear(&render->errors);
    free(render->tags);
    free(render->tile_done);
    free(render);
}

bool pp_render_done(const struct pp_render *render)
{
    return render->done_count == render->tile_count;
}

double pp_render_progress(const struct pp_render *render)
{
    return (double)render->done_count / render->tile_count;
}

const struct pp_picture *pp_render_picture(const struct pp_render *render)
{
    return &render->picture;
}

void pp_render_take_picture(struct pp_render *render, struct pp_picture *picture,
                            struct pp_picture *errors)
{
    *picture = render->picture;
    *errors = render->errors;
    render->picture = render->errors = (struct pp_picture){0};
}

const struct pp_picture *pp_render_errors(const struct pp_render *render)
{
    return render->errors.rgb ? &render->errors : NULL;
}

const int *pp_render_tags(const struct pp_render *render)
{
    return render->tags;
}

struct pp_render_work pp_render_work(const struct pp_render *render)
{
    struct pp_path_work work = pp_planner_work(render->planner);
    return (struct pp_render_work){render->resumed.rays + work.rays,
                                   render->resumed.leaks + work.leaks};
}
