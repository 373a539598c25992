/* little_endian.h - numbers as bytes of a file, least significant first, on any
 * machine, and their hash. */
#ifndef PP_SIMULATE_SAMPLING_LITTLE_ENDIAN_H
#define PP_SIMULATE_SAMPLING_LITTLE_ENDIAN_H

#include <stdint.h>
#include <string.h>

#include "simulate/sampling/hash.h"

/* Writes or reads the lowest 1 to 8 bytes of a number at *at, and moves *at past
 * them. */
static inline void pp_little_endian_put(unsigned char **at, uint64_t value, int bytes)
{
    for (int i = 0; i < bytes; i++)
        *(*at)++ = (unsigned char)(value >> 8 * i);
}

static inline uint64_t pp_little_endian_take(const unsigned char **at, int bytes)
{
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++)
        value |= (uint64_t) * (*at)++ << 8 * i;
    return value;
}

/* Stores a double as the 8 bytes of its bits; the float functions use 4 bytes, those of
 * a vector three doubles. */
static inline void pp_little_endian_put_double(unsigned char **at, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    pp_little_endian_put(at, bits, 8);
}

static inline double pp_little_endian_take_double(const unsigned char **at)
{
    uint64_t bits = pp_little_endian_take(at, 8);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline void pp_little_endian_put_float(unsigned char **at, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    pp_little_endian_put(at, bits, 4);
}

static inline float pp_little_endian_take_float(const unsigned char **at)
{
    uint32_t bits = (uint32_t)pp_little_endian_take(at, 4);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline void pp_little_endian_put_vec(unsigned char **at, struct pp_vec3 v)
{
    pp_little_endian_put_double(at, v.x);
    pp_little_endian_put_double(at, v.y);
    pp_little_endian_put_double(at, v.z);
}

static inline struct pp_vec3 pp_little_endian_take_vec(const unsigned char **at)
{
    double x = pp_little_endian_take_double(at), y = pp_little_endian_take_double(at),
           z = pp_little_endian_take_double(at);
    return pp_vec(x, y, z);
}

/* Hash of bytes in words of eight, continued from `start`; the last word is filled with
 * zeros. */
static inline uint64_t pp_little_endian_hash(uint64_t start, const unsigned char *bytes,
                                             size_t length)
{
    for (size_t i = 0; i < length; i += 8) {
        const unsigned char *at = bytes + i;
        int count = length - i < 8 ? (int)(length - i) : 8;
        start = pp_hash(start, pp_little_endian_take(&at, count));
    }
    return start;
}

#endif
