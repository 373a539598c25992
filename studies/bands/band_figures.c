/* band_figures.c - stores rows of values, and divides them into two halves by room. */
#include "studies/bands/band_figures.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "simulate/sampling/hash.h"

const char *const pp_band_figures_places[] = {"point", "average"};

void pp_band_figures_init(struct pp_band_figures *figures, int feature_count)
{
    *figures = (struct pp_band_figures){.feature_count = feature_count};
}

void pp_band_figures_clear(struct pp_band_figures *figures)
{
    free(figures->rooms);
    free(figures->hand);
    free(figures->own);
    free(figures->truth);
    free(figures->features);
    pp_band_figures_init(figures, figures->feature_count);
}

/* Makes space for one more row in all lists, which have equal length. */
static enum pp_status reserve(struct pp_band_figures *figures, struct pp_error *err)
{
    double **const lists[] = {&figures->hand, &figures->own, &figures->truth};
    int wanted = figures->count + 1, capacity = figures->capacity;
    enum pp_status status = pp_array_reserve(&figures->rooms, &capacity, wanted,
                                             sizeof *figures->rooms, err);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        capacity = figures->capacity;
        status = pp_array_reserve(lists[i], &capacity, wanted, sizeof **lists[i], err);
    }
    int all = figures->capacity;
    if (status == PP_OK)
        status = pp_array_reserve(
            &figures->features, &all, wanted,
            (size_t)(figures->feature_count + 1) * sizeof *figures->features, err);
    if (status == PP_OK)
        figures->capacity = capacity;
    return status;
}

enum pp_status pp_band_figures_add(struct pp_band_figures *figures,
                                   const struct pp_band_row *row, struct pp_error *err)
{
    enum pp_status status = reserve(figures, err);
    if (status != PP_OK)
        return status;
    int at = figures->count++;
    figures->rooms[at] = row->room;
    figures->hand[at] = row->hand;
    figures->own[at] = row->own;
    figures->truth[at] = row->truth;
    memcpy(figures->features + (size_t)at * figures->feature_count, row->features,
           (size_t)figures->feature_count * sizeof *figures->features);
    return PP_OK;
}

/* Uses the constant and the hash function of SplitMix64. */
int pp_band_figures_side(int room)
{
    return (int)(pp_hash_mix64(((uint64_t)room + 1) * UINT64_C(0x9e3779b97f4a7c15))
                 >> 63);
}

enum pp_status pp_band_figures_half(struct pp_band_figures *half,
                                    const struct pp_band_figures *figures, int side,
                                    struct pp_error *err)
{
    enum pp_status status = PP_OK;
    half->place = figures->place;
    memcpy(half->component, figures->component, sizeof half->component);
    memcpy(half->column, figures->column, sizeof half->column);
    for (int i = 0; i < figures->count && status == PP_OK; i++) {
        const struct pp_band_row row = {
            figures->rooms[i], figures->hand[i], figures->own[i], figures->truth[i],
            figures->features + (size_t)i * figures->feature_count};
        if (pp_band_figures_side(figures->rooms[i]) == side)
            status = pp_band_figures_add(half, &row, err);
    }
    return status;
}
