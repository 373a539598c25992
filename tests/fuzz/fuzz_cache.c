/* fuzz_cache.c - a cache file with any bytes is read safely.
 *
 * For clang's libFuzzer (make fuzz). A file is rejected with a reason and leaves the
 * cache empty, or it is accepted, and the irradiance at any point is a number. In half
 * of the files header and checksum are corrected first; otherwise nearly all would be
 * rejected there.
 */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/cache/cache_file.h"
#include "simulate/sampling/hash.h"
#include "simulate/cache/irradiance_cache.h"
#include "tests/fuzz/floor_scene.h"
#include "tests/fuzz/must.h"

static struct pp_irradiance_cache *empty_cache(void)
{
    struct pp_radiance_options light = pp_radiance_state_defaults();
    struct pp_cache_options options = pp_irradiance_cache_defaults();
    struct pp_irradiance_cache *cache = NULL;
    options.threads = 1;
    must(pp_irradiance_cache_create(&cache, floor_scene(), NULL, NULL, &light, &options,
                                    NULL)
         == PP_OK);
    return cache;
}

static uint64_t word_at(const unsigned char *at)
{
    uint64_t word = 0;
    for (int i = 0; i < 8; i++)
        word |= (uint64_t)at[i] << 8 * i;
    return word;
}

static void put_right(char *bytes, size_t length, const char *head)
{
    if (length < 72 || length % 8 != 0)
        return;
    memcpy(bytes, head, 48); /* to the end of the hashes */
    uint64_t sum = length - 8;
    for (size_t i = 0; i + 8 < length; i += 8)
        sum = pp_hash(sum, word_at((unsigned char *)bytes + i));
    for (int i = 0; i < 8; i++)
        bytes[length - 8 + (size_t)i] = (char)(sum >> 8 * i);
}

int LLVMFuzzerTestOneInput(const uint8_t *given, size_t length)
{
    struct pp_error err = {PP_OK, ""};
    struct pp_irradiance_cache *cache = empty_cache();
    char *head, *bytes = malloc(length + 1);
    size_t head_length;
    must(bytes && pp_cache_file_pack(cache, &head, &head_length, NULL) == PP_OK);
    memcpy(bytes, given, length);
    if (length > 0 && given[length - 1] & 1)
        put_right(bytes, length, head);
    enum pp_status status = pp_cache_file_unpack(cache, bytes, length, "fuzz", &err);
    must(status == PP_OK
         || (err.message[0] != '\0' && pp_irradiance_cache_count(cache) == 0));
    for (int i = 0; status == PP_OK && i < 16; i++) {
        struct pp_rgb value;
        if (pp_irradiance_cache_value(cache, pp_vec(0.1 * i, 0.2, 0.0),
                                      pp_vec(0.0, 0.0, 1.0), PP_ANYWHERE, i % 3,
                                      &value))
            must(value.g >= 0.0);
    }
    free(head);
    free(bytes);
    pp_irradiance_cache_destroy(cache);
    return 0;
}
