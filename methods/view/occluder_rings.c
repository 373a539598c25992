/* occluder_rings.c - see occluder_rings.h. */
#include "methods/view/occluder_rings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "methods/view/ring_cells.h"
#include "model/geometry/min_max.h"

enum { MOST = PP_FRAGMENT_CORNERS };

/* Number of parts in a fan over a ring of `count` corners. */
static int fan_parts(int count)
{
    enum { STEP = MOST - 2 };
    return count < 3 ? 0 : (count - 2 + STEP - 1) / STEP;
}

enum pp_status pp_occluder_rings_find(struct pp_occluder_rings *rings,
                                      const struct pp_occluders *pieces,
                                      double distance_m, struct pp_error *err)
{
    size_t most = 0;
    for (int i = 0; i < pieces->count; i++)
        most += (size_t)fan_parts(pieces->list[i].count);
    if (most == 0)
        return PP_OK;
    *rings = (struct pp_occluder_rings){.rings = malloc(most * sizeof *rings->rings),
                                        .of = malloc(most * sizeof *rings->of),
                                        .xy = malloc(most * MOST * sizeof *rings->xy)};
    if (!rings->rings || !rings->of || !rings->xy)
        return pp_fail_memory(err);
    for (int i = 0; i < pieces->count; i++) {
        const struct pp_occluder *piece = &pieces->list[i];
        for (int from = 1; from + 1 < piece->count; from += MOST - 2) {
            double(*xy)[2] = rings->xy + rings->count * MOST;
            int count = 0;
            memcpy(xy[count++], piece->xy[0], sizeof *xy);
            for (int k = from; k < piece->count && count < MOST; k++)
                memcpy(xy[count++], piece->xy[k], sizeof *xy);
            struct pp_fragment_ring *ring = &rings->rings[rings->count];
            rings->of[rings->count++] = i;
            pp_fragments_close_ring(ring, xy, count);
            ring->depth[0] = -piece->nearness.z * distance_m;
            ring->depth[1] = -piece->nearness.x;
            ring->depth[2] = -piece->nearness.y;
        }
    }
    return PP_OK;
}

void pp_occluder_rings_clear(struct pp_occluder_rings *rings)
{
    free(rings->rings);
    free(rings->of);
    free(rings->xy);
    *rings = (struct pp_occluder_rings){0};
}

/* ---- Sorting ---- */

/* A ring with the value by which it is sorted, greatest first. */
struct sorted_ring {
    double value;
    int place, of;
    struct pp_fragment_ring ring;
};

static int by_value(const void *a, const void *b)
{
    const struct sorted_ring *x = a, *y = b;
    if (x->value != y->value)
        return x->value > y->value ? -1 : 1;
    return (x->place > y->place) - (x->place < y->place);
}

/* Area of the ring's extent. */
static double ring_size(const struct pp_fragment_ring *ring)
{
    return (ring->high[0] - ring->low[0]) * (ring->high[1] - ring->low[1]);
}

/* Minus the depth of the ring's nearest corner: nearer rings have greater values. */
static double ring_nearness(const struct pp_fragment_ring *ring)
{
    double depth = INFINITY;
    for (int i = 0; i < ring->count; i++)
        depth = pp_min(ring->depth[0] + ring->depth[1] * ring->xy[i][0]
                           + ring->depth[2] * ring->xy[i][1],
                       depth);
    return -depth;
}

/* Sorts the rings by a value, greatest first. */
static enum pp_status sort_rings(struct pp_occluder_rings *rings,
                                 double value(const struct pp_fragment_ring *),
                                 struct pp_error *err)
{
    enum { FEW = 24 };
    struct sorted_ring few[FEW], *sorted = few;
    if (rings->count < 2)
        return PP_OK;
    if (rings->count > FEW)
        sorted = malloc((size_t)rings->count * sizeof *sorted);
    if (!sorted)
        return pp_fail_memory(err);
    for (int i = 0; i < rings->count; i++)
        sorted[i] = (struct sorted_ring){value(&rings->rings[i]), i, rings->of[i],
                                         rings->rings[i]};
    qsort(sorted, (size_t)rings->count, sizeof *sorted, by_value);
    for (int i = 0; i < rings->count; i++) {
        rings->rings[i] = sorted[i].ring;
        rings->of[i] = sorted[i].of;
    }
    if (sorted != few)
        free(sorted);
    return PP_OK;
}

enum pp_status pp_occluder_rings_sort(struct pp_occluder_rings *rings,
                                      struct pp_error *err)
{
    return sort_rings(rings, ring_size, err);
}

/* ---- pieces that are visible ---- */

struct marking {
    bool *is_seen; /* for each piece: true if it is visible */
    const struct pp_occluder_rings *rings;
};

/* Callback (pp_ring_cells_do): marks the pieces that hide something in one cell. */
static enum pp_status mark_cell(void *data, struct pp_fragments *open, const int *rings,
                                int count, struct pp_error *err)
{
    const struct marking *marking = data;
    struct pp_fragments taken = {0};
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && open->count > 0 && status == PP_OK; i++) {
        taken.count = 0;
        status = pp_fragments_move(&taken, open, &marking->rings->rings[rings[i]], err);
        marking->is_seen[marking->rings->of[rings[i]]] |= taken.count > 0;
    }
    pp_fragments_clear(&taken);
    return status;
}

/* Marks the pieces that hide a part of the open fragments not hidden by a larger
 * piece. */
static enum pp_status mark_in_union(bool *is_seen, struct pp_fragments *open,
                                    struct pp_occluder_rings *rings,
                                    struct pp_error *err)
{
    struct marking marking = {is_seen, rings};
    enum pp_status status = pp_occluder_rings_sort(rings, err);
    return status == PP_OK ? pp_ring_cells(open, rings->rings, rings->count, mark_cell,
                                           &marking, err)
                           : status;
}

/* Callback (pp_ring_cells_do): assigns the fragments of one cell to the nearest
 * rings. */
static enum pp_status cover_cell(void *data, struct pp_fragments *open,
                                 const int *rings, int count, struct pp_error *err)
{
    const struct pp_occluder_rings *all = data;
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++)
        status = pp_fragments_cover(open, all->rings, rings[i], err);
    return status;
}

enum pp_status pp_occluder_rings_cover(struct pp_fragments *open,
                                       struct pp_occluder_rings *rings,
                                       struct pp_error *err)
{
    enum pp_status status = sort_rings(rings, ring_nearness, err);
    return status == PP_OK
               ? pp_ring_cells(open, rings->rings, rings->count, cover_cell, rings, err)
               : status;
}

/* Marks the pieces that are in front of all others in a part of the open fragments. */
static enum pp_status mark_in_front(bool *is_seen, struct pp_fragments *open,
                                    struct pp_occluder_rings *rings,
                                    struct pp_error *err)
{
    enum pp_status status = pp_occluder_rings_cover(open, rings, err);
    for (int i = 0; i < open->count && status == PP_OK; i++)
        if (open->list[i].owner != PP_FRAGMENT_FREE)
            is_seen[rings->of[open->list[i].owner]] = true;
    return status;
}

static void keep_seen_pieces(struct pp_occluders *pieces, const bool *is_seen)
{
    int kept = 0;
    for (int i = 0; i < pieces->count; i++) {
        if (is_seen[i])
            pieces->list[kept++] = pieces->list[i];
        else
            free(pieces->list[i].xy);
    }
    pieces->count = kept;
}

enum pp_status pp_occluder_rings_drop_hidden(struct pp_occluders *pieces,
                                             const struct pp_occluders_scene *scene,
                                             bool one_light, struct pp_error *err)
{
    const double *low = scene->low, *high = scene->high;
    const double extent[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    struct pp_occluder_rings rings = {0};
    struct pp_fragments open = {0};
    bool *is_seen = calloc((size_t)pieces->count + 1, sizeof *is_seen);
    enum pp_status status =
        is_seen ? pp_occluder_rings_find(&rings, pieces, scene->view->distance_m, err)
                : pp_fail_memory(err);
    if (status == PP_OK)
        status = pp_fragments_add(&open, extent, 4, err);
    if (status == PP_OK)
        status = one_light ? mark_in_union(is_seen, &open, &rings, err)
                           : mark_in_front(is_seen, &open, &rings, err);
    if (status == PP_OK)
        keep_seen_pieces(pieces, is_seen);
    free(is_seen);
    pp_occluder_rings_clear(&rings);
    pp_fragments_clear(&open);
    return status;
}
