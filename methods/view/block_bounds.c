/* block_bounds.c - bounds each block by its eight corners, and sorts the bounds by a
 * counting sort. */
#include "methods/view/block_bounds.h"

#include <math.h>
#include <stdlib.h>

#include "model/geometry/min_max.h"
#include "model/geometry/tolerance.h"

/* Calculates the bound of a block. Returns false if the block is certainly not
 * visible. */
static bool bound_block(struct pp_block_bound *bound, const struct pp_block_view *view,
                        const struct pp_block *block)
{
    struct pp_vec3 corner =
        pp_frame_in(&view->axes, pp_vec_sub(block->corner, view->point));
    struct pp_vec3 edges[3] = {
        pp_frame_in(&view->axes, block->along), pp_frame_in(&view->axes, block->across),
        pp_frame_in(&view->axes, pp_vec(0.0, 0.0, block->height_m))};
    double near = INFINITY, far = -INFINITY, square = INFINITY;
    bound->left = INFINITY;
    bound->right = bound->high = -INFINITY;
    for (int k = 0; k < 8; k++) {
        struct pp_vec3 p = corner;
        for (int e = 0; e < 3; e++)
            if (k >> e & 1)
                p = pp_vec_add(p, edges[e]);
        double x = p.x / p.y, z = p.z / p.y, from = pp_vec_dot(p, p);
        near = pp_min(p.y, near);
        far = pp_max(p.y, far);
        square = pp_min(from, square);
        bound->left = pp_min(x, bound->left);
        bound->right = pp_max(x, bound->right);
        bound->high = pp_max(z, bound->high);
    }
    /* Blocks flush with the room's faces are moved by PP_SET_OFF_M; the bound allows
     * for this shift. */
    bound->distance_m = sqrt(square) - 2.0 * PP_SET_OFF_M;
    if (near <= view->glass_m) { /* the block reaches to the glass or nearer, so its
                                  * directions are not bounded */
        bound->left = -INFINITY;
        bound->right = bound->high = INFINITY;
        return far >= view->glass_m;
    }
    return bound->left < view->right && bound->right > view->left
           && bound->high > view->low;
}

/* Sorts by distance, to within the width of a bin. */
enum { BINS = 128 };

static int bin_of(const struct pp_block_bound *bound, double nearest_m)
{
    double share = nearest_m > 0.0 ? nearest_m / bound->distance_m : 1.0;
    return (int)((BINS - 1) * (1.0 - fmin(fmax(share, 0.0), 1.0)));
}

static void sort_about(struct pp_block_bound *sorted, const struct pp_block_bound *list,
                       int count)
{
    double nearest_m = INFINITY;
    int begin[BINS + 1] = {0};
    for (int i = 0; i < count; i++)
        nearest_m = fmin(nearest_m, list[i].distance_m);
    for (int i = 0; i < count; i++)
        begin[bin_of(&list[i], nearest_m) + 1]++;
    for (int b = 0; b < BINS; b++)
        begin[b + 1] += begin[b];
    for (int i = 0; i < count; i++)
        sorted[begin[bin_of(&list[i], nearest_m)]++] = list[i];
}

enum pp_status pp_block_bounds_find(struct pp_block_bounds *bounds,
                                    const struct pp_world *world,
                                    const struct pp_block_view *view,
                                    struct pp_error *err)
{
    size_t most = (size_t)world->block_count;
    if (most == 0)
        return PP_OK;
    struct pp_block_bound *found = malloc(2 * most * sizeof *found);
    if (!found)
        return pp_fail_memory(err);
    for (int b = 0; b < world->block_count; b++) {
        struct pp_block_bound *bound = &found[most + (size_t)bounds->count];
        bound->block = b;
        bounds->count += bound_block(bound, view, &world->blocks[b]);
    }
    sort_about(found, found + most, bounds->count);
    bounds->list = found;
    return PP_OK;
}

void pp_block_bounds_clear(struct pp_block_bounds *bounds)
{
    free(bounds->list);
    *bounds = (struct pp_block_bounds){0};
}
