/* sun_sums.c - adds entries of one group in registers. */
#include "simulate/year/sun_sums.h"

#include "simulate/sampling/lanes.h"
#include "simulate/year/year_batch.h"

typedef float float_lanes __attribute__((vector_size(32)));

enum { LANES = PP_INT_LANES, HALVES = PP_YEAR_BLOCK / LANES };

/* Sums for one group while entries of the group follow each other. */
struct block_sums {
    float_lanes of[HALVES];
};

/* halves: 1 for a block of up to LANES receivers, else HALVES. */
PP_LANES_BODY void add_entry(struct block_sums *sums,
                             const struct pp_sun_weights *weights, float lx, int halves)
{
    for (int i = 0; i < halves; i++) {
        float_lanes w;
        __builtin_memcpy(&w, weights->of + i * LANES, sizeof w);
        sums->of[i] += w * lx;
    }
}

/* Sums of each hour: out[hour][group]. */
PP_LANES_BODY void sum_suns(struct pp_sun_weights *out, const struct pp_sun_sums *block,
                            int halves)
{
    for (int t = 0; t < block->hours; t++) {
        struct block_sums sums[PP_YEAR_GROUPS_MOST] = {{{{0.0f}}}};
        int end = block->list->first[t + 1], k = block->list->first[t];
        while (k < end && block->list->entries[k].group >= 0) {
            int group = block->list->entries[k].group;
            struct block_sums own = sums[group];
            for (; k < end && block->list->entries[k].group == group; k++)
                add_entry(&own, &block->inside[block->list->entries[k].cell],
                          block->list->entries[k].lx, halves);
            sums[group] = own;
        }
        for (int g = 0; g < block->groups; g++) {
            struct block_sums own = sums[g];
            for (int i = k; i < end; i++)
                add_entry(&own,
                          &block->outdoor[g * PP_YEAR_OUTDOOR_CELLS
                                          + block->list->entries[i].cell],
                          block->list->entries[i].lx, halves);
            __builtin_memcpy(out[t * block->groups + g].of, &own, sizeof own);
        }
    }
}

PP_LANES_BODY void sum_block(struct pp_sun_weights *out,
                             const struct pp_sun_sums *block)
{
    if (block->receivers <= LANES)
        sum_suns(out, block, 1);
    else
        sum_suns(out, block, HALVES);
}

static void narrow_suns(struct pp_sun_weights *out, const struct pp_sun_sums *block)
{
    sum_block(out, block);
}

PP_LANES_WIDE static void wide_suns(struct pp_sun_weights *out,
                                    const struct pp_sun_sums *block)
{
    sum_block(out, block);
}

void pp_sun_sums_find(struct pp_sun_weights *out, const struct pp_sun_sums *of)
{
    if (pp_lanes_are_wide())
        wide_suns(out, of);
    else
        narrow_suns(out, of);
}
