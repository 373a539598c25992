/* checkpoint.c - the tiles of a render written as bytes, and restored. */
#include "simulate/render/checkpoint.h"

#include <stdlib.h>
#include <string.h>

#include "simulate/cache/cache_file.h"
#include "simulate/sampling/little_endian.h"
#include "simulate/render/render_parts.h"
#include "simulate/sampling/hash.h"
#include "simulate/scene/environment.h"

static const char magic[8] = {'P', 'P', 'R', 'E', 'N', 'D', 'E', 'R'};

enum {
    VERSION = 3,
    HEAD = 8 + 4 + 8 + 3 * 4 + 2 * 8,
    TAIL = 8 + 8, /* the cache's length, and the checksum */
    PIXEL = 16,
    ERRORS = 12
};

/* ---- identity of a render ---- */

static uint64_t hash_light(uint64_t hash, const struct pp_radiance_options *light)
{
    hash = pp_hash(hash, light->sources);
    hash = pp_hash(hash, light->windows);
    hash = pp_hash(hash, light->stored);
    hash = pp_hash_double(hash, light->source_size);
    hash = pp_hash(hash, (uint64_t)light->source_most);
    hash = pp_hash(hash, (uint64_t)light->bounces);
    return pp_hash_double(hash, light->least);
}

/* A hash of everything that the pixels depend on: scene, options, ambient store. */
static uint64_t hash_render(const struct pp_render *render)
{
    const struct pp_render_options *options = &render->options;
    const struct pp_camera *camera = &options->camera;
    uint64_t hash = pp_hash(VERSION, pp_light_scene_hash(render->scene));
    if (render->options.plain)
        hash = pp_hash(hash, 1);
    if (render->environment)
        hash = pp_hash(hash, pp_environment_hash(render->environment));
    hash = pp_hash(hash, camera->kind);
    hash = pp_hash_vec(hash, camera->eye);
    hash = pp_hash_vec(hash, camera->toward);
    hash = pp_hash_vec(hash, camera->right);
    hash = pp_hash_vec(hash, camera->up);
    hash = pp_hash_double(hash, camera->across);
    hash = pp_hash_double(hash, camera->down);
    hash = pp_hash(hash, (uint64_t)options->width);
    hash = pp_hash(hash, (uint64_t)options->height);
    hash = pp_hash(hash, options->irradiance);
    hash = pp_hash_double(hash, pp_render_decorations(render));
    hash = pp_hash(hash, options->indoors);
    hash = pp_hash(hash, options->filter);
    hash = pp_hash(hash, (uint64_t)options->samples);
    hash = pp_hash(hash, (uint64_t)options->randomisations);
    hash = hash_light(hash, &options->light);
    hash = pp_hash(hash, options->store != NULL);
    hash = pp_hash(hash, options->ambient != NULL);
    hash = pp_hash(hash, options->ambient_hash);
    return pp_hash(hash, options->seed);
}

static uint64_t hash_bytes(const unsigned char *bytes, size_t length)
{
    return pp_little_endian_hash(pp_hash(VERSION, length), bytes, length);
}

/* ---- its size ---- */

static size_t tile_pixels(const struct pp_render *render, int tile)
{
    struct pp_render_tile box = pp_render_tile(render, tile);
    return (size_t)(box.x1 - box.x0) * (size_t)(box.y1 - box.y0);
}

/* Size (bytes) of a file with these tiles done, without a cache. */
static size_t size_of(const struct pp_render *render, const unsigned char *done)
{
    size_t pixels = 0;
    for (int i = 0; i < render->tile_count; i++)
        pixels += done[i] ? tile_pixels(render, i) : 0;
    size_t each = PIXEL + (render->errors.rgb ? ERRORS : 0);
    return HEAD + (size_t)render->tile_count + each * pixels + TAIL;
}

/* ---- writing ---- */

static void put_tile(unsigned char **at, const struct pp_render *render, int tile)
{
    struct pp_render_tile box = pp_render_tile(render, tile);
    for (int y = box.y0; y < box.y1; y++)
        for (int x = box.x0; x < box.x1; x++) {
            const float *rgb = pp_picture_at(&render->picture, x, y);
            for (int i = 0; i < 3; i++)
                pp_little_endian_put_float(at, rgb[i]);
            int tag =
                render->tags[(size_t)y * (size_t)render->picture.width + (size_t)x];
            pp_little_endian_put(at, (uint32_t)tag, 4);
            for (int i = 0; render->errors.rgb && i < 3; i++)
                pp_little_endian_put_float(at, pp_picture_at(&render->errors, x, y)[i]);
        }
}

/* Writes the whole file; cache: the `kept` bytes of the irradiance cache. */
static void put_all(unsigned char *bytes, size_t size, const struct pp_render *render,
                    const char *cache, size_t kept)
{
    struct pp_render_work work = pp_render_work(render);
    unsigned char *at = bytes;
    memcpy(at, magic, sizeof magic);
    at += sizeof magic;
    pp_little_endian_put(&at, VERSION, 4);
    pp_little_endian_put(&at, hash_render(render), 8);
    pp_little_endian_put(&at, (uint64_t)render->picture.width, 4);
    pp_little_endian_put(&at, (uint64_t)render->picture.height, 4);
    pp_little_endian_put(&at, (uint64_t)render->tile_count, 4);
    pp_little_endian_put(&at, (uint64_t)work.rays, 8);
    pp_little_endian_put(&at, (uint64_t)work.leaks, 8);
    memcpy(at, render->tile_done, (size_t)render->tile_count);
    at += render->tile_count;
    for (int i = 0; i < render->tile_count; i++)
        if (render->tile_done[i])
            put_tile(&at, render, i);
    if (kept > 0)
        memcpy(at, cache, kept);
    at += kept;
    pp_little_endian_put(&at, kept, 8);
    pp_little_endian_put(&at, hash_bytes(bytes, size - 8), 8);
}

enum pp_status pp_checkpoint_save(const struct pp_render *render,
                                  const struct pp_irradiance_cache *cache, FILE *out,
                                  struct pp_error *err)
{
    char *records = NULL;
    size_t kept = 0;
    enum pp_status status =
        cache ? pp_cache_file_pack(cache, &records, &kept, err) : PP_OK;
    if (status != PP_OK)
        return status;
    size_t size = size_of(render, render->tile_done) + kept;
    unsigned char *bytes = malloc(size);
    if (bytes)
        put_all(bytes, size, render, records, kept);
    free(records);
    if (!bytes)
        return pp_fail_memory(err);
    size_t written = fwrite(bytes, 1, size, out);
    free(bytes);
    if (written != size)
        return pp_fail(err, PP_SYSTEM, "the checkpoint cannot be written");
    return PP_OK;
}

/* ---- reading ---- */

/* Checks that the bytes are a complete checkpoint. *kept: number of bytes of its
 * cache. */
static enum pp_status check_whole(const unsigned char *bytes, size_t length,
                                  size_t *kept, struct pp_error *err)
{
    if (length < sizeof magic || memcmp(bytes, magic, sizeof magic) != 0)
        return pp_fail(err, PP_BAD_INPUT, "the file is not a checkpoint of a picture");
    if (length < HEAD + TAIL)
        return pp_fail(err, PP_BAD_INPUT, "the checkpoint is cut off or damaged");
    const unsigned char *head = bytes + sizeof magic, *tail = bytes + length - TAIL;
    unsigned version = (unsigned)pp_little_endian_take(&head, 4);
    if (version != VERSION)
        return pp_fail(err, PP_BAD_INPUT,
                       "the checkpoint has version %u; this program reads version %d",
                       version, VERSION);
    uint64_t cache = pp_little_endian_take(&tail, 8),
             hash = pp_little_endian_take(&tail, 8);
    if (hash != hash_bytes(bytes, length - 8) || cache > length - HEAD - TAIL)
        return pp_fail(err, PP_BAD_INPUT, "the checkpoint is cut off or damaged");
    *kept = (size_t)cache;
    return PP_OK;
}

enum pp_status pp_checkpoint_cache(const unsigned char *bytes, size_t length,
                                   const char **cache, size_t *cache_length,
                                   struct pp_error *err)
{
    size_t kept = 0;
    enum pp_status status = check_whole(bytes, length, &kept, err);
    *cache_length = status == PP_OK ? kept : 0;
    *cache = *cache_length > 0 ? (const char *)bytes + length - TAIL - kept : NULL;
    return status;
}

/* Checks that the checkpoint belongs to this render. On entry *at points to the byte
 * after the version; on return, to the byte after the two counts (rays, leaks). */
static enum pp_status check_checkpoint_head(const struct pp_render *render,
                                            const unsigned char **at, long long work[2],
                                            struct pp_error *err)
{
    uint64_t mark = pp_little_endian_take(at, 8);
    int width = (int)pp_little_endian_take(at, 4),
        height = (int)pp_little_endian_take(at, 4),
        tiles = (int)pp_little_endian_take(at, 4);
    if (mark != hash_render(render) || width != render->picture.width
        || height != render->picture.height || tiles != render->tile_count)
        return pp_fail(err, PP_BAD_INPUT,
                       "the checkpoint belongs to another picture: its room, view or "
                       "options differ");
    work[0] = (long long)pp_little_endian_take(at, 8);
    work[1] = (long long)pp_little_endian_take(at, 8);
    return PP_OK;
}

static void take_tile_pixels(const unsigned char **at, struct pp_render *render,
                             int tile)
{
    struct pp_render_tile box = pp_render_tile(render, tile);
    for (int y = box.y0; y < box.y1; y++)
        for (int x = box.x0; x < box.x1; x++) {
            float *rgb = pp_picture_at(&render->picture, x, y);
            for (int i = 0; i < 3; i++)
                rgb[i] = pp_little_endian_take_float(at);
            render->tags[(size_t)y * (size_t)render->picture.width + (size_t)x] =
                (int32_t)(uint32_t)pp_little_endian_take(at, 4);
            for (int i = 0; render->errors.rgb && i < 3; i++)
                pp_picture_at(&render->errors, x, y)[i] =
                    pp_little_endian_take_float(at);
        }
}

enum pp_status pp_checkpoint_resume(struct pp_render *render,
                                    const unsigned char *bytes, size_t length,
                                    struct pp_error *err)
{
    long long work[2] = {0, 0};
    size_t kept;
    enum pp_status status = check_whole(bytes, length, &kept, err);
    if (status != PP_OK)
        return status;
    const unsigned char *at = bytes + sizeof magic + 4;
    status = check_checkpoint_head(render, &at, work, err);
    if (status != PP_OK)
        return status;
    bool fits = length >= HEAD + (size_t)render->tile_count + TAIL + kept
                && length == size_of(render, at) + kept;
    for (int i = 0; fits && i < render->tile_count; i++)
        fits = at[i] <= 1;
    if (!fits)
        return pp_fail(err, PP_BAD_INPUT, "the checkpoint is cut off or damaged");
    const unsigned char *done = at;
    at += render->tile_count;
    render->done_count = 0;
    for (int i = 0; i < render->tile_count; i++) {
        render->tile_done[i] = done[i];
        if (!done[i])
            continue;
        take_tile_pixels(&at, render, i);
        render->done_count++;
    }
    render->resumed = (struct pp_render_work){work[0], work[1]};
    return PP_OK;
}
