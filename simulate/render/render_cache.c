/* render_cache.c - hashes records, and projects them into the picture. */
#include "simulate/render/render_cache.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/render/render_parts.h"
#include "simulate/sampling/hash.h"

/* A record is visible if the ray towards it ends nearer to it than this fraction of the
 * distance. */
static const double seen_share = 1e-3;

uint64_t pp_render_cache_hash(const struct pp_irradiance_cache *cache)
{
    size_t count = pp_irradiance_cache_count(cache);
    uint64_t hash = pp_hash(1, count);
    for (size_t i = 0; i < count; i++) {
        struct pp_cache_record record = pp_irradiance_cache_record(cache, i);
        hash = pp_hash_vec(hash, record.point);
        hash = pp_hash_vec(hash, record.normal);
        hash =
            pp_hash_vec(hash, pp_vec(record.value.r, record.value.g, record.value.b));
        hash = pp_hash_double(hash, record.radii_m[0]);
    }
    return hash;
}

/* True if the point is within the picture and nothing hides it. place: position in the
 * picture (pixels). */
static bool is_seen(const struct pp_render *render, struct pp_vec3 point,
                    double place[2])
{
    double x, y, distance_m;
    struct pp_light_ray ray;
    struct pp_light_hit hit;
    if (!pp_camera_project(&render->options.camera, point, &x, &y, &distance_m)
        || !(x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0))
        return false;
    place[0] = x * render->options.width;
    place[1] = y * render->options.height;
    return pp_render_camera_ray(render, place, &ray)
           && pp_light_scene_first(render->scene, &ray, &hit)
           && fabs(hit.distance_m - distance_m) < seen_share * distance_m;
}

enum pp_status pp_render_cache_positions(const struct pp_render *render,
                                         const struct pp_irradiance_cache *cache,
                                         double (**xy)[2], int *count,
                                         struct pp_error *err)
{
    size_t records = pp_irradiance_cache_count(cache);
    *count = 0;
    *xy = malloc((records + !records) * sizeof **xy);
    if (!*xy)
        return pp_fail_memory(err);
    for (size_t i = 0; i < records; i++) {
        struct pp_cache_record record = pp_irradiance_cache_record(cache, i);
        if (record.depth == 0 && is_seen(render, record.point, (*xy)[*count]))
            ++*count;
    }
    return PP_OK;
}
