/* cache_file.c - the records of a cache written as bytes, and read back with checks. */
#include "simulate/cache/cache_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/cache/cache_parts.h"
#include "simulate/cache/cache_smooth.h"
#include "simulate/sampling/little_endian.h"
#include "simulate/sampling/lobe.h"
#include "simulate/scene/environment.h"

enum {
    VERSION = 3,
    WORD = 8,
    NUMBERS = 38 + PP_CACHE_SECTORS,
    HEAD = 16 + 6 * WORD,
    ENTRY = NUMBERS * WORD
};

static const char magic[17] = "pepperpot cache\n";

static void put_entry(unsigned char **at, const struct pp_cache_entry *entry)
{
    const struct pp_cache_record *is = &entry->is;
    pp_little_endian_put_vec(at, is->point);
    pp_little_endian_put_vec(at, is->normal);
    pp_little_endian_put_double(at, is->space);
    pp_little_endian_put_vec(at, pp_vec(is->value.r, is->value.g, is->value.b));
    for (int c = 0; c < 3; c++)
        pp_little_endian_put_vec(at, is->along[c]);
    for (int c = 0; c < 3; c++)
        pp_little_endian_put_vec(at, is->turned[c]);
    for (int i = 0; i < 2; i++)
        pp_little_endian_put_vec(at, is->axes[i]);
    for (int i = 0; i < 2; i++)
        pp_little_endian_put_double(at, is->radii_m[i]);
    for (int i = 0; i < PP_CACHE_SECTORS; i++)
        pp_little_endian_put_double(at, entry->horizon_m[i]);
    pp_little_endian_put_double(at, entry->along_noise);
    pp_little_endian_put_double(at, entry->curvature);
}

static bool is_finite(struct pp_vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool is_unit(struct pp_vec3 v)
{
    return is_finite(v) && fabs(pp_vec_dot(v, v) - 1.0) < 1e-6;
}

/* Reads an entry; false if the numbers cannot be those of a record. */
static bool take_entry(const unsigned char **at, struct pp_cache_entry *entry)
{
    struct pp_cache_record *is = &entry->is;
    bool good = true;
    is->point = pp_little_endian_take_vec(at);
    is->normal = pp_little_endian_take_vec(at);
    double space = pp_little_endian_take_double(at);
    struct pp_vec3 value = pp_little_endian_take_vec(at);
    is->value = pp_rgb(value.x, value.y, value.z);
    for (int c = 0; c < 3; c++)
        good = is_finite(is->along[c] = pp_little_endian_take_vec(at)) && good;
    for (int c = 0; c < 3; c++)
        good = is_finite(is->turned[c] = pp_little_endian_take_vec(at)) && good;
    for (int i = 0; i < 2; i++)
        good = is_unit(is->axes[i] = pp_little_endian_take_vec(at)) && good;
    for (int i = 0; i < 2; i++) {
        is->radii_m[i] = pp_little_endian_take_double(at);
        good = good && is->radii_m[i] >= 0.0 && isfinite(is->radii_m[i]);
    }
    for (int i = 0; i < PP_CACHE_SECTORS; i++) {
        entry->horizon_m[i] = pp_little_endian_take_double(at);
        good = good && entry->horizon_m[i] >= 0.0;
    }
    entry->along_noise = pp_little_endian_take_double(at);
    entry->curvature = pp_little_endian_take_double(at);
    good = good && entry->along_noise >= 0.0 && entry->curvature >= 0.0;
    good = good && is_finite(is->point) && is_unit(is->normal) && is_finite(value)
           && value.x >= 0.0 && value.y >= 0.0 && value.z >= 0.0
           && (space == PP_ANYWHERE || space == PP_INDOORS || space == PP_OUTDOORS);
    if (!good)
        return false;
    is->space = (enum pp_space)(int)space;
    pp_lobe_frame(is->normal, &entry->a, &entry->b);
    return true;
}

/* Hash of the light outside; 0 for a scene from a description (no environment), whose
 * own hash includes it. */
static uint64_t hash_of_light(const struct pp_irradiance_cache *cache)
{
    return cache->environment ? pp_environment_hash(cache->environment) : 0;
}

enum pp_status pp_cache_file_pack(const struct pp_irradiance_cache *cache, char **bytes,
                                  size_t *length, struct pp_error *err)
{
    size_t size = HEAD + pp_irradiance_cache_count(cache) * ENTRY + WORD;
    unsigned char *all = malloc(size), *at = all;
    if (!all)
        return pp_fail_memory(err);
    memcpy(at, magic, 16);
    at += 16;
    pp_little_endian_put(&at, VERSION, WORD);
    pp_little_endian_put(&at, pp_light_scene_hash(cache->scene), WORD);
    pp_little_endian_put(&at, hash_of_light(cache), WORD);
    pp_little_endian_put(&at, pp_irradiance_cache_hash_options(cache), WORD);
    for (int i = 0; i < PP_CACHE_DEPTHS; i++)
        pp_little_endian_put(&at, (uint64_t)cache->layers[i].entry_count, WORD);
    for (int i = 0; i < PP_CACHE_DEPTHS; i++)
        for (int k = 0; k < cache->layers[i].entry_count; k++)
            put_entry(&at, &cache->layers[i].entries[k]);
    pp_little_endian_put(&at, pp_little_endian_hash(size - WORD, all, size - WORD),
                         WORD);
    *bytes = (char *)all;
    *length = size;
    return PP_OK;
}

/* Checks everything except the records. counts: the number of records of each depth. */
static enum pp_status check_cache_header(const struct pp_irradiance_cache *cache,
                                         const unsigned char *bytes, size_t length,
                                         const char *title,
                                         uint64_t counts[PP_CACHE_DEPTHS],
                                         struct pp_error *err)
{
    if (length < 16 || memcmp(bytes, magic, 16) != 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is not a cache; expected a file written by --cache", title);
    const unsigned char *at = bytes + 16;
    if (length < HEAD + WORD)
        return pp_fail(err, PP_BAD_INPUT, "%s is cut off: it has no records", title);
    uint64_t version = pp_little_endian_take(&at, WORD);
    if (version != VERSION)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is a cache of version %llu; expected version %d", title,
                       (unsigned long long)version, VERSION);
    uint64_t scene = pp_little_endian_take(&at, WORD),
             light = pp_little_endian_take(&at, WORD),
             options = pp_little_endian_take(&at, WORD), total = 0;
    for (int i = 0; i < PP_CACHE_DEPTHS; i++) {
        counts[i] = pp_little_endian_take(&at, WORD);
        total += counts[i] < INT32_MAX ? counts[i] : INT32_MAX;
    }
    if (total >= INT32_MAX || length != HEAD + total * ENTRY + WORD)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is cut off or damaged: its length does not match its number "
                       "of records",
                       title);
    const unsigned char *end = bytes + length - WORD;
    if (pp_little_endian_take(&end, WORD)
        != pp_little_endian_hash(length - WORD, bytes, length - WORD))
        return pp_fail(err, PP_BAD_INPUT, "%s is damaged: its checksum is wrong",
                       title);
    if (scene != pp_light_scene_hash(cache->scene))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s is the cache of another room; expected a cache of this "
                       "room, or the name of a new file",
                       title);
    if (light != hash_of_light(cache))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s was made for another sky or ground; expected a cache for "
                       "this sky and ground, or the name of a new file",
                       title);
    if (options != pp_irradiance_cache_hash_options(cache))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s was made with other options for light or cache, or with "
                       "another seed; expected the same options and seed, or the name "
                       "of a new file",
                       title);
    return PP_OK;
}

static enum pp_status take_all(struct pp_irradiance_cache *cache,
                               const unsigned char *at, const char *title,
                               const uint64_t counts[PP_CACHE_DEPTHS],
                               struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; status == PP_OK && i < PP_CACHE_DEPTHS; i++)
        for (uint64_t k = 0; status == PP_OK && k < counts[i]; k++) {
            struct pp_cache_entry entry = {.is = {.depth = i}};
            if (!take_entry(&at, &entry))
                return pp_fail(err, PP_BAD_INPUT,
                               "%s is damaged: record %llu is invalid", title,
                               (unsigned long long)k + 1);
            status = pp_cache_layer_put(&cache->layers[i], &entry, err);
        }
    for (int i = 0; status == PP_OK && i < PP_CACHE_DEPTHS; i++)
        status = pp_cache_smooth_layer(&cache->layers[i], cache->pool, err);
    return status;
}

enum pp_status pp_cache_file_unpack(struct pp_irradiance_cache *cache,
                                    const char *bytes, size_t length, const char *title,
                                    struct pp_error *err)
{
    uint64_t counts[PP_CACHE_DEPTHS];
    const unsigned char *at = (const unsigned char *)bytes;
    enum pp_status status = check_cache_header(cache, at, length, title, counts, err);
    if (status == PP_OK)
        status = take_all(cache, at + HEAD, title, counts, err);
    if (status == PP_OK)
        return PP_OK;
    for (int i = 0; i < PP_CACHE_DEPTHS; i++) {
        cache->layers[i].entry_count = 0;
        struct pp_error ignored;
        pp_cache_octree_reset(&cache->layers[i].tree, &ignored);
    }
    return status;
}
