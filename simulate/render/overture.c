/* overture.c - rays of a picture's pixels shown to the cache, part by part. */
#include "simulate/render/overture.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/clock.h"
#include "simulate/cache/cache_grow.h"
#include "simulate/render/render_parts.h"

/* Pixels of a part where the caller says nothing: some 170 MB of rays and requests. */
enum { PART_PIXELS = 1 << 20 };

/* The share of the progress that showing the first round of parts is worth. */
static const double FIRST_ROUND = 0.9;

struct pp_overture {
    struct pp_irradiance_cache *cache;
    struct pp_render view; /* camera and scene, without a picture */
    int step;              /* a part has every step-th pixel of every step-th row */
    int part;              /* the next one to be shown; step^2 of them are a round */
    bool first;            /* is it the first round? */
    size_t before;         /* records when the round began */
    bool done;
};

enum pp_status pp_overture_create(struct pp_overture **result,
                                  struct pp_irradiance_cache *cache,
                                  const struct pp_light_scene *scene,
                                  const struct pp_render_options *options,
                                  int part_pixels, struct pp_error *err)
{
    *result = NULL;
    struct pp_overture *overture = calloc(1, sizeof *overture);
    if (!overture)
        return pp_fail_memory(err);
    double parts = (double)options->width * options->height
                   / (part_pixels > 0 ? part_pixels : PART_PIXELS);
    overture->cache = cache;
    overture->view.scene = scene;
    overture->view.options = *options;
    overture->view.eye_space = pp_light_scene_space(scene, options->camera.eye);
    overture->step = (int)ceil(sqrt(parts));
    overture->first = true;
    overture->before = pp_irradiance_cache_count(cache);
    *result = overture;
    return PP_OK;
}

void pp_overture_destroy(struct pp_overture *overture)
{
    free(overture);
}

/* The rays through the middles of a part's pixels, row by row. */
static enum pp_status show(const struct pp_overture *overture, int part,
                           struct pp_error *err)
{
    int step = overture->step, width = overture->view.options.width;
    int height = overture->view.options.height;
    size_t across = (size_t)(width + step - 1) / (size_t)step;
    size_t down = (size_t)(height + step - 1) / (size_t)step, count = 0;
    struct pp_light_ray *rays = malloc((across * down + 1) * sizeof *rays);
    if (!rays)
        return pp_fail_memory(err);
    for (int y = part / step; y < height; y += step)
        for (int x = part % step; x < width; x += step) {
            const double middle[2] = {x + 0.5, y + 0.5};
            count += pp_render_camera_ray(&overture->view, middle, rays + count);
        }
    enum pp_status status =
        pp_cache_grow_request_rays(overture->cache, rays, count, err);
    free(rays);
    return status;
}

/* Once the cache has all that it was shown: the next part, and behind the last one
 * another round, unless this one has brought no record. A single part needs no second
 * round: the cache has looked at all its requests again. */
static enum pp_status go_on(struct pp_overture *overture, struct pp_error *err)
{
    int parts = overture->step * overture->step;
    if (overture->part == parts) {
        size_t records = pp_irradiance_cache_count(overture->cache);
        overture->done = parts == 1 || records == overture->before;
        if (overture->done)
            return PP_OK;
        overture->before = records;
        overture->part = 0;
        overture->first = false;
    }
    return show(overture, overture->part++, err);
}

enum pp_status pp_overture_advance(struct pp_overture *overture, double seconds,
                                   struct pp_error *err)
{
    double end = pp_clock_s() + seconds;
    enum pp_status status = PP_OK;
    do {
        if (pp_cache_grow_done(overture->cache))
            status = go_on(overture, err);
        if (status == PP_OK && !pp_cache_grow_done(overture->cache))
            status = pp_cache_grow(overture->cache, fmax(end - pp_clock_s(), 0.0), err);
    } while (status == PP_OK && !overture->done && pp_clock_s() < end);
    return status;
}

bool pp_overture_done(const struct pp_overture *overture)
{
    return overture->done;
}

double pp_overture_progress(const struct pp_overture *overture)
{
    double part = pp_cache_grow_progress(overture->cache);
    double parts = (double)overture->step * overture->step;
    double shown = (overture->part - 1.0 + part * part) / parts;
    if (overture->done)
        return 1.0;
    if (overture->part == 0)
        return 0.0;
    /* The first requests bring most of the records. */
    return overture->first ? sqrt(shown) * (parts > 1.0 ? FIRST_ROUND : 1.0)
                           : FIRST_ROUND + (1.0 - FIRST_ROUND) * shown;
}
