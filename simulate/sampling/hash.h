/* hash.h - seeds as hashes of the point, randomisation and path that they belong to, so
 * that no two parts of the work share a seed.
 *
 * The 64-bit mixer is the finaliser of SplitMix64 [SLF14]; the 32-bit one is lowbias32
 * [WELLONS18]. Both are bijections without state.
 */
#ifndef PP_SIMULATE_SAMPLING_HASH_H
#define PP_SIMULATE_SAMPLING_HASH_H

#include <stdint.h>
#include <string.h>

#include "model/geometry/vec.h"

static inline uint64_t pp_hash_mix64(uint64_t x)
{
    x ^= x >> 30;
    x *= UINT64_C(0xbf58476d1ce4e5b9);
    x ^= x >> 27;
    x *= UINT64_C(0x94d049bb133111eb);
    return x ^ x >> 31;
}

/* The seed of part number `part` of a piece of work that has seed `seed`. */
static inline uint64_t pp_hash(uint64_t seed, uint64_t part)
{
    return pp_hash_mix64(pp_hash_mix64(seed + UINT64_C(0x9e3779b97f4a7c15)) ^ part);
}

/* The seed of a part identified by its name; NULL or "": the seed itself. */
static inline uint64_t pp_hash_name(uint64_t seed, const char *name)
{
    for (const char *c = name ? name : ""; *c; c++)
        seed = pp_hash(seed, (unsigned char)*c);
    return seed;
}

/* The seed of a part identified by a number (-0 counts as 0), or by a point. */
static inline uint64_t pp_hash_double(uint64_t seed, double part)
{
    uint64_t bits;
    part += 0.0;
    memcpy(&bits, &part, sizeof bits);
    return pp_hash(seed, bits);
}

static inline uint64_t pp_hash_vec(uint64_t seed, struct pp_vec3 part)
{
    seed = pp_hash_double(seed, part.x);
    seed = pp_hash_double(seed, part.y);
    return pp_hash_double(seed, part.z);
}

/* Applies to one number or to lanes of numbers (lanes.h). */
#define PP_HASH_MIX32(x)                                                               \
    do {                                                                               \
        x ^= x >> 16;                                                                  \
        x *= UINT32_C(0x7feb352d);                                                     \
        x ^= x >> 15;                                                                  \
        x *= UINT32_C(0x846ca68b);                                                     \
        x ^= x >> 16;                                                                  \
    } while (0)

static inline uint32_t pp_hash_mix32(uint32_t x)
{
    PP_HASH_MIX32(x);
    return x;
}

#endif
