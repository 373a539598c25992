/* checkpoint.h - an unfinished render saved in a file.
 *
 * Least significant byte first:
 *
 *     8 bytes   "PPRENDER"
 *     u32       version, 3
 *     u64       hash of the scene and all options
 *     u32 x 3   width, height, number of tiles
 *     i64 x 2   rays, leaks so far
 *     u8 each   tile: 1 done, 0 not done
 *     pixels of the tiles that are done: three floats and a tag of four bytes each,
 *               followed by three floats of errors if the render has them
 *     cache of the picture in the format of cache_file.h; nothing without a cache
 *     u64       size of the cache, bytes
 *     u64       hash of all bytes before it
 */
#ifndef PP_SIMULATE_RENDER_CHECKPOINT_H
#define PP_SIMULATE_RENDER_CHECKPOINT_H

#include <stdio.h>

#include "simulate/render/render.h"

/* Writes the tiles that are done, and the cache of the picture (NULL: none). PP_SYSTEM
 * if the stream fails. */
enum pp_status pp_checkpoint_save(const struct pp_render *render,
                                  const struct pp_irradiance_cache *cache, FILE *out,
                                  struct pp_error *err);

/* Finds the cache in the bytes written by pp_checkpoint_save, for pp_cache_file_unpack.
 * *cache points into `bytes`; without a cache it is NULL and the length is 0.
 * PP_BAD_INPUT as from pp_checkpoint_resume, but not for another scene or other
 * options. */
enum pp_status pp_checkpoint_cache(const unsigned char *bytes, size_t length,
                                   const char **cache, size_t *cache_length,
                                   struct pp_error *err);

/* Resumes a render of the same scene and options. PP_BAD_INPUT, with the render
 * unchanged, if the bytes belong to another render or version, or are truncated or
 * damaged. */
enum pp_status pp_checkpoint_resume(struct pp_render *render,
                                    const unsigned char *bytes, size_t length,
                                    struct pp_error *err);

#endif
