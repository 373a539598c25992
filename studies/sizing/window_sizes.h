/* window_sizes.h - the possible sizes of some windows of a room for one kind of change,
 * in steps from the smallest to the largest. Each size encloses the previous one.
 *
 * The windows change together. Widths change in proportion, about the middle of each
 * window. An edge that meets the end of its wall or another opening stops there, and
 * the other edges continue. Heads are raised and sills are lowered by equal lengths,
 * each until it is blocked. A change of height moves first the heads, then the sills. A
 * size is possible if pp_world_create accepts the room. Edges that move are rounded to
 * a grid, towards the inside of the window. The grid spacing is 1 mm or finer; if both
 * edges of a window move, it is half of that.
 *
 * The number of windows can be changed if the windows are equal and in one wall. Each
 * window is then in the middle of an equal part of the wall's length. For the present
 * number, the windows keep their positions.
 */
#ifndef PP_STUDIES_SIZING_WINDOW_SIZES_H
#define PP_STUDIES_SIZING_WINDOW_SIZES_H

#include <stdbool.h>

#include "pepperpot.h"
#include "model/base/error.h"
#include "model/room/room.h"

#define PP_SIZE_LEAST_M 0.01 /* least size of a window in the direction of change, m */
#define PP_SIZE_GRID_M 0.001

struct pp_window_sizes;

/* Finds the possible sizes. openings: indices of the openings that change, windows or
 * rooflights; for PP_CHANGE_NUMBER, windows of one size in one wall. PP_BAD_INPUT if
 * the openings do not allow the change. The room must be valid; the necessary data are
 * copied. */
enum pp_status pp_window_sizes_create(struct pp_window_sizes **sizes,
                                      const struct pp_room *room,
                                      enum pp_size_change change, const int *openings,
                                      int opening_count, struct pp_error *err);
void pp_window_sizes_destroy(struct pp_window_sizes *sizes); /* NULL is allowed */

/* Number of steps, and index of the step that is the present room, bit for bit. From
 * one step to the next, no window grows by more than the grid spacing. */
int pp_window_sizes_count(const struct pp_window_sizes *sizes);
int pp_window_sizes_now(const struct pp_window_sizes *sizes);

/* Makes the steps ten times finer, so that step k becomes step 10 k. Steps in the
 * number of windows do not change. */
void pp_window_sizes_refine(struct pp_window_sizes *sizes);

/* Makes the room at that step; the caller destroys it with pp_room_destroy. Additional
 * openings are at the end of the room's list, and are equal to the last of the openings
 * that change. If the number is smaller than the present number, the last openings are
 * removed. */
enum pp_status pp_window_sizes_room(struct pp_room **room,
                                    const struct pp_window_sizes *sizes, int step,
                                    struct pp_error *err);

#endif
