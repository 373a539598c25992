/* cmd_render.c - see render.h. */
#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_parts.h"
#include "simulate/sampling/processors.h"
#include "simulate/render/render_parts.h"

enum {
    /* The vertex of a path's random numbers that says where in its pixel it begins: far
     * from all that radiance.c uses. */
    PIXEL_VERTEX = 1 << 29,
};

/* Of the Gaussian, in pixels. */
static const double deviation = 0.5, reach = 1.5;

/* ---- one pixel ---- */

/* Where in the picture (in pixels) the sample of the pixel at x, y lies. */
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
    /* The radius by its distribution up to `reach`, turned to any angle. */
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
        return false; /* outside the circle: beyond the angle */
    if (options->camera.kind == PP_VIEW_PARALLEL)
        ray->space = pp_light_scene_space(render->scene, ray->from);
    return !options->indoors || ray->space == PP_INDOORS;
}

double pp_render_decorations(const struct pp_render *render)
{
    const struct pp_ray_scene *room = render->scene->room;
    return render->options.irradiance && room ? room->decorations : 1.0;
}

/* Irradiance of the surface that the ray meets; false: glass, or nothing. */
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

static struct pp_rgb pixel(const struct pp_render *render,
                           struct pp_radiance_state *state, int x, int y)
{
    const struct pp_render_options *options = &render->options;
    uint64_t number = (uint64_t)y * (uint64_t)options->width + (uint64_t)x;
    pp_sobol_sequence_init(&state->sequence, &render->sobol,
                           pp_hash(options->seed, number));
    struct pp_rgb sum = pp_rgb_grey(0.0);
    int seen = 0;
    for (int i = 0; i < options->samples; i++) {
        double place[2];
        struct pp_light_ray ray;
        struct pp_rgb value;
        state->index = (uint32_t)i;
        place_sample(render, state, x, y, place);
        if (!pp_render_camera_ray(render, place, &ray))
            continue;
        if (!options->irradiance)
            value = pp_radiance_along(state, &ray, NULL);
        else if (!irradiance_seen(render, state, &ray, &value))
            continue;
        sum = pp_rgb_add(sum, value);
        seen++;
    }
    if (seen == 0 || (options->irradiance && 2 * seen < options->samples))
        return pp_rgb_grey(NAN);
    return pp_rgb_scale(sum, 1.0 / (options->irradiance ? seen : options->samples));
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

/* ---- all of them ---- */

struct pp_render_tile pp_render_tile(const struct pp_render *render, int tile)
{
    const struct pp_render_options *options = &render->options;
    int x0 = tile % render->tiles_across * PP_RENDER_TILE;
    int y0 = tile / render->tiles_across * PP_RENDER_TILE;
    int x1 = x0 + PP_RENDER_TILE, y1 = y0 + PP_RENDER_TILE;
    return (struct pp_render_tile){x0, y0, x1 < options->width ? x1 : options->width,
                                   y1 < options->height ? y1 : options->height};
}

static void draw_tile(struct pp_render *render, struct pp_radiance_state *state,
                      int tile)
{
    struct pp_render_tile box = pp_render_tile(render, tile);
    for (int y = box.y0; y < box.y1; y++)
        for (int x = box.x0; x < box.x1; x++) {
            struct pp_rgb value = pixel(render, state, x, y);
            float *at = pp_picture_at(&render->picture, x, y);
            at[0] = (float)value.r;
            at[1] = (float)value.g;
            at[2] = (float)value.b;
            render->tags[(size_t)y * (size_t)render->options.width + (size_t)x] =
                tag_of_pixel(render, x, y);
        }
}

/* The first tile from *next on that is not done, and *next behind it; -1: none. */
static int take_tile(const struct pp_render *render, int *next)
{
    while (*next < render->tile_count && render->tile_done[*next])
        ++*next;
    return *next < render->tile_count ? (*next)++ : -1;
}

void pp_render_advance(struct pp_render *render, double seconds)
{
    const struct pp_render_options *options = &render->options;
    double end = pp_clock_s() + seconds;
    int next = 0;
#pragma omp parallel num_threads(options->threads)
    {
        struct pp_radiance_state state = {.scene = render->scene,
                                          .options = options->light,
                                          .store = options->store,
                                          .ambient = options->ambient};
        do {
            int tile;
#pragma omp critical(pp_render_tiles)
            tile = take_tile(render, &next);
            if (tile < 0)
                break;
            draw_tile(render, &state, tile);
#pragma omp critical(pp_render_tiles)
            {
                render->tile_done[tile] = 1;
                render->done_count++;
            }
        } while (pp_clock_s() < end);
#pragma omp critical(pp_render_tiles)
        {
            render->work.rays += state.rays;
            render->work.leaks += state.leaks;
        }
    }
}

/* ---- from the beginning to the end ---- */

static enum pp_status check(const struct pp_render_options *options,
                            struct pp_error *err)
{
    if (options->samples < 1 || options->samples > PP_RENDER_SAMPLES_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%d samples a pixel; expected 1 to %d",
                       options->samples, PP_RENDER_SAMPLES_MOST);
    return PP_OK;
}

enum pp_status pp_render_create(struct pp_render **render_out,
                                const struct pp_light_scene *scene,
                                const struct pp_render_options *options,
                                struct pp_error *err)
{
    *render_out = NULL;
    enum pp_status status = check(options, err);
    if (status != PP_OK)
        return status;
    struct pp_render *render = calloc(1, sizeof *render);
    if (!render)
        return pp_fail_memory(err);
    render->scene = scene;
    render->options = *options;
    int samples = 1;
    while (samples < options->samples)
        samples *= 2;
    render->options.samples = samples;
    if (options->threads == 0)
        render->options.threads = pp_processors();
    pp_sobol_init(&render->sobol);
    render->eye_space = pp_light_scene_space(scene, options->camera.eye);

    status = pp_picture_init(&render->picture, options->width, options->height, err);
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
    pp_picture_clear(&render->picture);
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

void pp_render_take_picture(struct pp_render *render, struct pp_picture *picture)
{
    *picture = render->picture;
    render->picture = (struct pp_picture){0};
}

const int *pp_render_tags(const struct pp_render *render)
{
    return render->tags;
}

struct pp_render_work pp_render_work(const struct pp_render *render)
{
    return render->work;
}
