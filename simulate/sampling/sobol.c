/* sobol.c - direction numbers, tables by byte, and the scramble. */
#include "simulate/sampling/sobol.h"

#include <string.h>

#include "simulate/sampling/hash.h"
#include "simulate/sampling/lanes.h"

/* Primitive polynomials and first direction numbers of dimensions 2 to 6 [JK08]; the
 * first dimension is the van der Corput sequence. */
struct joe_kuo {
    int degree;
    uint32_t coefficients;
    uint32_t m[4];
};

static const struct joe_kuo joe_kuo[PP_SOBOL_DIMENSIONS - 1] = {
    {1, 0, {1}},       {2, 1, {1, 3}},       {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}}, {4, 1, {1, 1, 3, 3}},
};

/* Applies to one number or to lanes of numbers. */
#define REVERSE_IN_BYTES(x)                                                            \
    do {                                                                               \
        x = (x >> 1 & UINT32_C(0x55555555)) | (x & UINT32_C(0x55555555)) << 1;         \
        x = (x >> 2 & UINT32_C(0x33333333)) | (x & UINT32_C(0x33333333)) << 2;         \
        x = (x >> 4 & UINT32_C(0x0f0f0f0f)) | (x & UINT32_C(0x0f0f0f0f)) << 4;         \
    } while (0)

#define OWEN_SCRAMBLE_REVERSED(x, seed)                                                \
    do {                                                                               \
        x ^= x * UINT32_C(0x3d20adea);                                                 \
        x += (seed);                                                                   \
        x *= (seed) >> 16 | 1;                                                         \
        x ^= x * UINT32_C(0x05526c56);                                                 \
        x ^= x * UINT32_C(0x53a22864);                                                 \
    } while (0)

/* Static, so that the compiler may inline it. */
static uint32_t reverse_bits(uint32_t x)
{
    REVERSE_IN_BYTES(x);
    return __builtin_bswap32(x);
}

static uint32_t owen_scramble_reversed(uint32_t reversed, uint32_t seed)
{
    OWEN_SCRAMBLE_REVERSED(reversed, seed);
    return reversed;
}

uint32_t pp_sobol_owen_scramble_reversed(uint32_t reversed, uint32_t seed)
{
    return owen_scramble_reversed(reversed, seed);
}

/* The 32 direction numbers of a dimension, with the first binary digit in the highest
 * bit. */
static void direction_numbers(int dimension, uint32_t v[32])
{
    if (dimension == 0) {
        for (int i = 0; i < 32; i++)
            v[i] = UINT32_C(1) << (31 - i);
        return;
    }
    const struct joe_kuo *p = &joe_kuo[dimension - 1];
    for (int i = 0; i < p->degree; i++)
        v[i] = p->m[i] << (31 - i);
    for (int i = p->degree; i < 32; i++) {
        v[i] = v[i - p->degree] ^ v[i - p->degree] >> p->degree;
        for (int k = 1; k < p->degree; k++)
            if (p->coefficients >> (p->degree - 1 - k) & 1)
                v[i] ^= v[i - k];
    }
}

void pp_sobol_init(struct pp_sobol *sobol)
{
    for (int dimension = 0; dimension < PP_SOBOL_DIMENSIONS; dimension++) {
        uint32_t v[32];
        direction_numbers(dimension, v);
        for (int byte = 0; byte < 4; byte++)
            for (int value = 0; value < 256; value++) {
                uint32_t sum = 0;
                for (int bit = 0; bit < 8; bit++)
                    if (value >> bit & 1)
                        sum ^= v[31 - (8 * byte + bit)];
                sobol->table[dimension][byte][value] = reverse_bits(sum);
            }
    }
}

/* Seeds of vertices from `first`, one vertex per row: first the seed of the shuffle,
 * then of each dimension's scramble. */
PP_LANES_BODY void vertex_seeds(uint64_t seed, int first, int count,
                                uint32_t seeds[][PP_INT_LANES])
{
    const pp_int_lanes number = {0, 1, 2, 3, 4, 5, 6, 7};
    for (int i = 0; i < count; i++) {
        uint64_t mixed = pp_hash(seed, (uint64_t)(first + i));
        uint32_t low = (uint32_t)mixed, step = (uint32_t)(mixed >> 32) | 1;
        pp_int_lanes x = low + number * step;
        PP_HASH_MIX32(x);
        memcpy(seeds[i], &x, sizeof x);
    }
}

static void vertex_seeds_plain(uint64_t seed, int first, int count,
                               uint32_t seeds[][PP_INT_LANES])
{
    vertex_seeds(seed, first, count, seeds);
}

PP_LANES_WIDE static void vertex_seeds_wide(uint64_t seed, int first, int count,
                                            uint32_t seeds[][PP_INT_LANES])
{
    vertex_seeds(seed, first, count, seeds);
}

static void make_seeds(uint64_t seed, int first, int count,
                       uint32_t seeds[][PP_INT_LANES])
{
    (pp_lanes_are_wide() ? vertex_seeds_wide : vertex_seeds_plain)(seed, first, count,
                                                                   seeds);
}

void pp_sobol_sequence_init(struct pp_sobol_sequence *sequence,
                            const struct pp_sobol *sobol, uint64_t seed)
{
    sequence->sobol = sobol;
    sequence->seed = seed;
    make_seeds(seed, 0, PP_SOBOL_KEPT, sequence->kept);
}

/* Seeds of a vertex: stored ones, or seeds calculated in `deep`. */
static const uint32_t *seeds_of(const struct pp_sobol_sequence *sequence, int vertex,
                                uint32_t deep[1][PP_INT_LANES])
{
    if (vertex < PP_SOBOL_KEPT)
        return sequence->kept[vertex];
    make_seeds(sequence->seed, vertex, 1, deep);
    return deep[0];
}

void pp_sobol_sequence_draw(const struct pp_sobol_sequence *sequence, uint32_t index,
                            int vertex, int count, double u[])
{
    uint32_t deep[1][PP_INT_LANES];
    const uint32_t *seeds = seeds_of(sequence, vertex, deep);
    uint32_t i = owen_scramble_reversed(reverse_bits(index), seeds[0]);
    for (int k = 0; k < count; k++) {
        const uint32_t(*table)[256] = sequence->sobol->table[k];
        uint32_t x = table[0][i & 255] ^ table[1][i >> 8 & 255]
                     ^ table[2][i >> 16 & 255] ^ table[3][i >> 24];
        x = reverse_bits(owen_scramble_reversed(x, seeds[k + 1]));
        u[k] = (x + 0.5) * 0x1p-32;
    }
}

/* ---- runs ---- */

/* The bits of 0 to 7, reversed. */
static const pp_int_lanes steps = {0,
                                   UINT32_C(1) << 31,
                                   UINT32_C(1) << 30,
                                   UINT32_C(3) << 30,
                                   UINT32_C(1) << 29,
                                   UINT32_C(5) << 29,
                                   UINT32_C(3) << 29,
                                   UINT32_C(7) << 29};

/* Vectorised draw of PP_INT_LANES points. Their indices differ in the last three bits
 * only. After shuffling and reversal they differ in the highest byte only, because in a
 * scramble the change of a bit depends on lower bits only. */
PP_LANES_BODY void draw_lanes(const struct pp_sobol *sobol, const uint32_t *seeds,
                              uint32_t first, int dimensions, int at,
                              double u[][PP_RUN_MOST])
{
    pp_int_lanes i = steps | reverse_bits(first);
    OWEN_SCRAMBLE_REVERSED(i, seeds[0]);
    pp_int_lanes high = i >> 24;
    for (int k = 0; k < dimensions; k++) {
        const uint32_t(*table)[256] = sobol->table[k];
        pp_int_lanes x;
        for (int lane = 0; lane < PP_INT_LANES; lane++)
            x[lane] = table[3][high[lane]];
        x ^= table[0][i[0] & 255] ^ table[1][i[0] >> 8 & 255]
             ^ table[2][i[0] >> 16 & 255];
        OWEN_SCRAMBLE_REVERSED(x, seeds[k + 1]);
        REVERSE_IN_BYTES(x);
        x = (x >> 8 & UINT32_C(0x00ff00ff)) | (x & UINT32_C(0x00ff00ff)) << 8;
        x = x >> 16 | x << 16;
        /* Computes x + 0.5 exactly, by signed integers, which can be converted to
         * doubles in lanes. */
        typedef int32_t half __attribute__((vector_size(16)));
        half part[2];
        x ^= UINT32_C(0x80000000);
        memcpy(part, &x, sizeof part);
        for (int p = 0; p < 2; p++) {
            pp_lanes drawn =
                (__builtin_convertvector(part[p], pp_lanes) + 2147483648.5) * 0x1p-32;
            memcpy(&u[k][at + p * PP_LANES], &drawn, sizeof drawn);
        }
    }
}

PP_LANES_BODY void draw_run(const struct pp_sobol *sobol, const uint32_t *seeds,
                            uint32_t first, int count, int dimensions,
                            double u[][PP_RUN_MOST])
{
    for (int at = 0; at < count; at += PP_INT_LANES)
        draw_lanes(sobol, seeds, first + (uint32_t)at, dimensions, at, u);
}

static void draw_run_plain(const struct pp_sobol *sobol, const uint32_t *seeds,
                           uint32_t first, int count, int dimensions,
                           double u[][PP_RUN_MOST])
{
    draw_run(sobol, seeds, first, count, dimensions, u);
}

PP_LANES_WIDE static void draw_run_wide(const struct pp_sobol *sobol,
                                        const uint32_t *seeds, uint32_t first,
                                        int count, int dimensions,
                                        double u[][PP_RUN_MOST])
{
    draw_run(sobol, seeds, first, count, dimensions, u);
}

void pp_sobol_sequence_draw_run(const struct pp_sobol_sequence *sequence,
                                uint32_t first, int count, int vertex, int dimensions,
                                double u[][PP_RUN_MOST])
{
    uint32_t deep[1][PP_INT_LANES];
    const uint32_t *seeds = seeds_of(sequence, vertex, deep);
    (pp_lanes_are_wide() ? draw_run_wide : draw_run_plain)(sequence->sobol, seeds,
                                                           first, count, dimensions, u);
}
