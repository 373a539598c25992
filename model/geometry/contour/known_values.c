/* known_values.c - a list of values, and a hash table of their points, which are
 * compared exactly. */
#include "model/geometry/contour/known_values.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* Slot that holds the point, or the free slot for it. */
static int *known_value_slot(const struct pp_known_values *known, const double xy[2])
{
    uint64_t bits[2];
    memcpy(bits, xy, sizeof bits);
    uint64_t key = (bits[0] * 0x9e3779b97f4a7c15u ^ bits[1]) * 0xbf58476d1ce4e5b9u;
    int mask = known->room - 1, slot = (int)(key >> 40) & mask;
    while (known->slots[slot] >= 0
           && memcmp(known->list[known->slots[slot]].xy, xy, sizeof(double[2])) != 0)
        slot = (slot + 1) & mask;
    return &known->slots[slot];
}

void pp_known_values_clear(struct pp_known_values *known)
{
    free(known->list);
    free(known->slots);
    *known = (struct pp_known_values){0};
}

bool pp_known_values_find(const struct pp_known_values *known, const double xy[2],
                          double *value)
{
    int found = known->room > 0 ? *known_value_slot(known, xy) : -1;
    if (found >= 0)
        *value = known->list[found].value;
    return found >= 0;
}

static enum pp_status grow_table(struct pp_known_values *known, struct pp_error *err)
{
    int room = known->room > 0 ? 2 * known->room : 1024;
    int *slots = malloc((size_t)room * sizeof *slots);
    if (!slots)
        return pp_fail_memory(err);
    for (int i = 0; i < room; i++)
        slots[i] = -1;
    free(known->slots);
    known->slots = slots;
    known->room = room;
    for (int i = 0; i < known->count; i++)
        *known_value_slot(known, known->list[i].xy) = i;
    return PP_OK;
}

enum pp_status pp_known_values_add(struct pp_known_values *known, const double xy[2],
                                   double value, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (2 * (known->count + 1) > known->room)
        status = grow_table(known, err);
    if (status == PP_OK)
        status = pp_array_reserve(&known->list, &known->capacity, known->count + 1,
                                  sizeof *known->list, err);
    if (status != PP_OK)
        return status;
    *known_value_slot(known, xy) = known->count;
    known->list[known->count++] =
        (struct pp_known_value){.xy = {xy[0], xy[1]}, .value = value};
    return PP_OK;
}
