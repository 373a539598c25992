/* block_bounds.h - bounds of the blocks in front of an opening, roughly in order of
 * distance. For elevation.c only.
 *
 * A room may have thousands of blocks outside, but few of them are visible. The bounds
 * find the visible blocks without testing the sides of each block.
 */
#ifndef PP_METHODS_VIEW_BLOCK_BOUNDS_H
#define PP_METHODS_VIEW_BLOCK_BOUNDS_H

#include "model/geometry/frame.h"
#include "model/room/world.h"

/* A point and its view of an opening: directions by x/y and z/y in axes whose y runs
 * out through the glass. */
struct pp_block_view {
    struct pp_vec3 point;
    struct pp_frame axes;
    double glass_m; /* nearer than this, along y, blocks hide nothing */
    double left, right, low;
};

/* A block appears between `left` and `right` and not above `high`; all its corners are
 * at least distance_m from the point. */
struct pp_block_bound {
    int block; /* index among the world's blocks */
    double left, right, high, distance_m;
};

struct pp_block_bounds {
    int count;
    struct pp_block_bound *list;
};

/* Fills empty bounds with the blocks that may be visible, roughly ordered by distance.
 * Two blocks in the wrong order differ by at most a hundredth of the range of
 * 1/distance. The caller clears the bounds, even after a failure. */
enum pp_status pp_block_bounds_find(struct pp_block_bounds *bounds,
                                    const struct pp_world *world,
                                    const struct pp_block_view *view,
                                    struct pp_error *err);
void pp_block_bounds_clear(struct pp_block_bounds *bounds);

#endif
