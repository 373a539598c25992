/* cache_file.h - a cache's records as a file.
 *
 * All numbers are little-endian; each field except the first (16 bytes) is 8 bytes
 * long:
 *
 *     "pepperpot cache\n", version, hashes of the scene, the light and the options,
 *     number of records of depth 0, of depth 1,
 *     each record: 38 + PP_CACHE_SECTORS doubles (in the order of cache_file.c),
 *     a checksum of all bytes before it
 *
 * Stored radii are already limited by neighbouring records. Stored values and gradients
 * are not yet smoothed (cache_smooth.h). Smoothing is repeated after reading, with the
 * same sums in the same order.
 */
#ifndef PP_SIMULATE_CACHE_CACHE_FILE_H
#define PP_SIMULATE_CACHE_CACHE_FILE_H

#include "simulate/cache/irradiance_cache.h"

/* Converts the records to the bytes of a file. The caller frees *bytes. */
enum pp_status pp_cache_file_pack(const struct pp_irradiance_cache *cache, char **bytes,
                                  size_t *length, struct pp_error *err);

/* Fills an empty cache with the records of a file; `title` is its name in messages.
 * PP_BAD_INPUT, with the cache unchanged, if the file is truncated, damaged, of another
 * version, or of another scene, light or options. */
enum pp_status pp_cache_file_unpack(struct pp_irradiance_cache *cache,
                                    const char *bytes, size_t length, const char *title,
                                    struct pp_error *err);

#endif
