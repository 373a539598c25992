/* ring_cells.c - halves the extent of the fragments repeatedly, and joins the parts
 * that remain in the cells. */
#include "methods/view/ring_cells.h"

#include <stdlib.h>
#include <string.h>

/* Number of rings up to which no cells are used (with 24 to 384 the time for a tree's
 * leaves changes by less than a quarter), and the greatest depth of subdivision. */
enum { FEW = 192, DEEPEST = 24 };

struct ring_cells {
    const struct pp_fragment_ring *rings;
    pp_ring_cells_do *act;
    void *data;
};

struct extent {
    double low[2], high[2];
};

static struct extent fragments_extent(const struct pp_fragments *fragments)
{
    const struct pp_fragment *first = &fragments->list[0];
    struct extent all = {{first->low[0], first->low[1]},
                         {first->high[0], first->high[1]}};
    for (int i = 1; i < fragments->count; i++)
        for (int k = 0; k < 2; k++) {
            const struct pp_fragment *one = &fragments->list[i];
            all.low[k] = one->low[k] < all.low[k] ? one->low[k] : all.low[k];
            all.high[k] = one->high[k] > all.high[k] ? one->high[k] : all.high[k];
        }
    return all;
}

/* The lower and the upper half of an extent, along its longer side. */
static void halve(struct extent halves[2], const struct extent *all)
{
    int axis = all->high[1] - all->low[1] > all->high[0] - all->low[0];
    halves[0] = halves[1] = *all;
    halves[0].high[axis] = halves[1].low[axis] =
        all->low[axis] + 0.5 * (all->high[axis] - all->low[axis]);
}

/* Finds the rings that reach into an extent; returns their number. */
static int reaching(int *to, const struct ring_cells *cells, const int *rings,
                    int count, const struct extent *in)
{
    int found = 0;
    for (int i = 0; i < count; i++) {
        const struct pp_fragment_ring *ring = &cells->rings[rings[i]];
        if (ring->low[0] < in->high[0] && ring->high[0] > in->low[0]
            && ring->low[1] < in->high[1] && ring->high[1] > in->low[1])
            to[found++] = rings[i];
    }
    return found;
}

static enum pp_status in_cells(const struct ring_cells *cells,
                               struct pp_fragments *open, const int *rings, int count,
                               int depth, struct pp_error *err);

/* Processes one half of an extent: the parts of the fragments within it, with the rings
 * that overlap it. The remaining fragments are added to `left`. */
static enum pp_status in_half(const struct ring_cells *cells, struct pp_fragments *left,
                              const struct pp_fragments *open,
                              const struct extent *half, const int *rings, int count,
                              int depth, struct pp_error *err)
{
    const double *low = half->low, *high = half->high;
    double corners[4][2] = {
        {low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    struct pp_fragment_ring outline;
    struct pp_fragments part = {0};
    pp_fragments_close_ring(&outline, corners, 4);
    enum pp_status status = pp_fragments_intersect(&part, open, &outline, err);
    if (status == PP_OK)
        status = in_cells(cells, &part, rings, count, depth, err);
    if (status == PP_OK)
        status = pp_fragments_append(left, &part, err);
    pp_fragments_clear(&part);
    return status;
}

static enum pp_status in_cells(const struct ring_cells *cells,
                               struct pp_fragments *open, const int *rings, int count,
                               int depth, struct pp_error *err)
{
    if (open->count == 0)
        return PP_OK;
    if (count <= FEW || depth == 0)
        return cells->act(cells->data, open, rings, count, err);
    struct extent all = fragments_extent(open), halves[2];
    struct pp_fragments left = {0};
    int *reach[2] = {malloc((size_t)count * sizeof **reach),
                     malloc((size_t)count * sizeof **reach)};
    int counts[2] = {0, 0};
    enum pp_status status = reach[0] && reach[1] ? PP_OK : pp_fail_memory(err);
    halve(halves, &all);
    for (int i = 0; i < 2 && status == PP_OK; i++)
        counts[i] = reaching(reach[i], cells, rings, count, &halves[i]);
    bool parted = status == PP_OK && counts[0] + counts[1] < count + count / 2;
    if (status == PP_OK && !parted)
        status = cells->act(cells->data, open, rings, count, err);
    for (int i = 0; i < 2 && status == PP_OK && parted; i++)
        status = in_half(cells, &left, open, &halves[i], reach[i], counts[i], depth - 1,
                         err);
    if (parted) {
        pp_fragments_clear(open);
        *open = left;
    }
    free(reach[0]);
    free(reach[1]);
    return status;
}

enum pp_status pp_ring_cells(struct pp_fragments *open,
                             const struct pp_fragment_ring *rings, int count,
                             pp_ring_cells_do *act, void *data, struct pp_error *err)
{
    const struct ring_cells cells = {rings, act, data};
    int *all = malloc(((size_t)count + 1) * sizeof *all);
    if (!all)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        all[i] = i;
    enum pp_status status = in_cells(&cells, open, all, count, DEEPEST, err);
    free(all);
    return status;
}
