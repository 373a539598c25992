/* sobol.c - direction numbers, tables by byte, and the scramble. */
#include "simulate/sampling/sobol.h"

#include "simulate/sampling/hash.h"

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

/* Within the file, so that the compiler may inline them. */
static uint32_t reverse_bits(uint32_t x)
{
    x = (x >> 1 & UINT32_C(0x55555555)) | (x & UINT32_C(0x55555555)) << 1;
    x = (x >> 2 & UINT32_C(0x33333333)) | (x & UINT32_C(0x33333333)) << 2;
    x = (x >> 4 & UINT32_C(0x0f0f0f0f)) | (x & UINT32_C(0x0f0f0f0f)) << 4;
    return __builtin_bswap32(x);
}

static uint32_t owen_scramble_reversed(uint32_t reversed, uint32_t seed)
{
    uint32_t x = reversed;
    x ^= x * UINT32_C(0x3d20adea);
    x += seed;
    x *= seed >> 16 | 1;
    x ^= x * UINT32_C(0x05526c56);
    x ^= x * UINT32_C(0x53a22864);
    return x;
}

uint32_t pp_sobol_owen_scramble_reversed(uint32_t reversed, uint32_t seed)
{
    return owen_scramble_reversed(reversed, seed);
}

/* The 32 direction numbers of a dimension, the first binary digit highest. */
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

/* Seeds of a vertex: of the shuffle, then of each dimension's scramble. */
static void vertex_seeds(uint64_t seed, int vertex, int count, uint32_t seeds[])
{
    uint64_t mixed = pp_hash(seed, (uint64_t)vertex);
    uint32_t low = (uint32_t)mixed, step = (uint32_t)(mixed >> 32) | 1;
    for (int i = 0; i <= count; i++)
        seeds[i] = pp_hash_mix32(low + (uint32_t)i * step);
}

void pp_sobol_sequence_init(struct pp_sobol_sequence *sequence,
                            const struct pp_sobol *sobol, uint64_t seed)
{
    sequence->sobol = sobol;
    sequence->seed = seed;
    for (int vertex = 0; vertex < PP_SOBOL_KEPT; vertex++)
        vertex_seeds(seed, vertex, PP_SOBOL_DIMENSIONS, sequence->kept[vertex]);
}

void pp_sobol_sequence_draw(const struct pp_sobol_sequence *sequence, uint32_t index,
                            int vertex, int count, double u[])
{
    uint32_t deep[PP_SOBOL_DIMENSIONS + 1];
    const uint32_t *seeds = deep;
    if (vertex < PP_SOBOL_KEPT)
        seeds = sequence->kept[vertex];
    else
        vertex_seeds(sequence->seed, vertex, count, deep);

    uint32_t i = owen_scramble_reversed(reverse_bits(index), seeds[0]);
    for (int k = 0; k < count; k++) {
        const uint32_t(*table)[256] = sequence->sobol->table[k];
        uint32_t x = table[0][i & 255] ^ table[1][i >> 8 & 255]
                     ^ table[2][i >> 16 & 255] ^ table[3][i >> 24];
        x = reverse_bits(owen_scramble_reversed(x, seeds[k + 1]));
        u[k] = (x + 0.5) * 0x1p-32;
    }
}
