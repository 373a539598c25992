/* cache_warm_up.c - requests records from the cache for the rays of a picture's pixels,
 * one part of the pixels after another. */
#include "simulate/render/cache_warm_up.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/render/render_parts.h"

/* Default number of pixels in a part: about 100 MB of requests. */
enum { PART_PIXELS = 1 << 20 };

/* Fraction of the progress that the first round of parts represents. */
static const double FIRST_ROUND = 0.9;

struct pp_cache_warm_up {
    struct pp_irradiance_cache *cache;
    struct pp_render view; /* camera and scene, without a picture */
    int step;              /* a part has every step-th pixel of every step-th row */
    int part;              /* index of the next part to request; a round has step^2
                            * parts */
    bool first;            /* true during the first round */
    size_t before;         /* number of records when the round began */
    bool done;
};

enum pp_status pp_cache_warm_up_create(struct pp_cache_warm_up **result,
                                       struct pp_irradiance_cache *cache,
                                       const struct pp_light_scene *scene,
                                       const struct pp_render_options *options,
                                       int part_pixels, struct pp_error *err)
{
    *result = NULL;
    struct pp_cache_warm_up *warm_up = calloc(1, sizeof *warm_up);
    if (!warm_up)
        return pp_fail_memory(err);
    double parts = (double)options->width * options->height
                   / (part_pixels > 0 ? part_pixels : PART_PIXELS);
    warm_up->cache = cache;
    warm_up->view.scene = scene;
    warm_up->view.options = *options;
    warm_up->view.eye_space = pp_light_scene_space(scene, options->camera.eye);
    warm_up->step = (int)ceil(sqrt(parts));
    warm_up->first = true;
    warm_up->before = pp_irradiance_cache_count(cache);
    *result = warm_up;
    return PP_OK;
}

void pp_cache_warm_up_destroy(struct pp_cache_warm_up *warm_up)
{
    free(warm_up);
}

/* A part of the picture: every step-th pixel of every step-th row, starting at x, y. */
struct picture_part {
    const struct pp_render *view;
    int x, y, step;
    size_t across; /* pixels in a row of the part */
};

/* The ray through the middle of a pixel of a part; pixels are numbered row by row. */
static bool ray_of(const void *list, size_t number, struct pp_light_ray *ray)
{
    const struct picture_part *part = list;
    int row = (int)(number / part->across), column = (int)(number % part->across);
    const double middle[2] = {part->x + column * part->step + 0.5,
                              part->y + row * part->step + 0.5};
    return pp_render_camera_ray(part->view, middle, ray);
}

/* Number of pixels from `first` to end - 1, in steps of `step`. */
static size_t pixels(int first, int end, int step)
{
    return first < end ? (size_t)((end - first + step - 1) / step) : 0;
}

static enum pp_status show(const struct pp_cache_warm_up *warm_up, int number,
                           struct pp_error *err)
{
    const struct pp_render_options *options = &warm_up->view.options;
    struct picture_part part = {.view = &warm_up->view,
                                .x = number % warm_up->step,
                                .y = number / warm_up->step,
                                .step = warm_up->step};
    part.across = pixels(part.x, options->width, part.step);
    size_t count = part.across * pixels(part.y, options->height, part.step);
    return pp_cache_grow_request_rays(warm_up->cache, ray_of, &part, count, err);
}

/* Requests the next part once the cache covers the current one. After the last part
 * another round begins, unless the last round made no new record. A single part needs
 * no second round, since the cache has then checked all its requests again. */
static enum pp_status show_next_part(struct pp_cache_warm_up *warm_up,
                                     struct pp_error *err)
{
    int parts = warm_up->step * warm_up->step;
    if (warm_up->part == parts) {
        size_t records = pp_irradiance_cache_count(warm_up->cache);
        warm_up->done = parts == 1 || records == warm_up->before;
        if (warm_up->done)
            return PP_OK;
        warm_up->before = records;
        warm_up->part = 0;
        warm_up->first = false;
    }
    return show(warm_up, warm_up->part++, err);
}

enum pp_status pp_cache_warm_up_advance(struct pp_cache_warm_up *warm_up,
                                        double seconds, struct pp_error *err)
{
    double end = pp_clock_s() + seconds;
    enum pp_status status = PP_OK;
    do {
        if (pp_cache_grow_done(warm_up->cache))
            status = show_next_part(warm_up, err);
        if (status == PP_OK && !pp_cache_grow_done(warm_up->cache))
            status = pp_cache_grow(warm_up->cache, fmax(end - pp_clock_s(), 0.0), err);
    } while (status == PP_OK && !warm_up->done && pp_clock_s() < end);
    return status;
}

bool pp_cache_warm_up_done(const struct pp_cache_warm_up *warm_up)
{
    return warm_up->done;
}

double pp_cache_warm_up_progress(const struct pp_cache_warm_up *warm_up)
{
    double part = pp_cache_grow_progress(warm_up->cache);
    double parts = (double)warm_up->step * warm_up->step;
    double shown = (warm_up->part - 1.0 + part * part) / parts;
    if (warm_up->done)
        return 1.0;
    if (warm_up->part == 0)
        return 0.0;
    /* The first requests lead to most of the records, so progress is not linear. */
    return warm_up->first ? sqrt(shown) * (parts > 1.0 ? FIRST_ROUND : 1.0)
                          : FIRST_ROUND + (1.0 - FIRST_ROUND) * shown;
}
