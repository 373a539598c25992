/* checkpoint.h - an unfinished render saved in a file.
 *
 * Least significant byte first:
 *
 *     8 bytes   "PPRENDER"
 *     u32       version, 3
 *     u64       a hash of the scene and all options
 *     u32 x 3   width, height, count of tiles
 *     i64 x 2   rays, leaks so far
 *     u8 each   tile: 1 done, 0 not
 *     the done tiles' pixels: three floats and a tag of four bytes each; behind them,
 *                where errors are wanted, three floats
 *     the cache that the picture is read from, as cache_file.h has it; none: nothing
 *     u64       how many bytes those are
 *     u64       a hash of all bytes before
 */
#ifndef PP_SIMULATE_RENDER_CHECKPOINT_H
#define PP_SIMULATE_RENDER_CHECKPOINT_H

#include <stdio.h>

#include "simulate/render/render.h"

/* Writes the tiles that are done, and the cache that the picture is read from (NULL:
 * none). A fault of the stream is PP_SYSTEM. */
enum pp_status pp_checkpoint_save(const struct pp_render *render,
                                  const struct pp_irradiance_cache *cache, FILE *out,
                                  struct pp_error *err);

/* The cache in the bytes that pp_checkpoint_save wrote, for pp_cache_file_unpack: a
 * part of bytes; NULL and 0 where there is none. PP_BAD_INPUT as by
 * pp_checkpoint_resume, but not for another scene or other options. */
enum pp_status pp_checkpoint_cache(const unsigned char *bytes, size_t length,
                                   const char **cache, size_t *cache_length,
                                   struct pp_error *err);

/* Resumes a render of the same scene and options, entirely or not at all. PP_BAD_INPUT
 * if the bytes are of another render or version, truncated or damaged. */
enum pp_status pp_checkpoint_resume(struct pp_render *render,
                                    const unsigned char *bytes, size_t length,
                                    struct pp_error *err);

#endif
