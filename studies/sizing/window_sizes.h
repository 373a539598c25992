/* window_sizes.h - the sizes that some windows of a room can have by one kind of
 * change, step by step from the smallest to the largest; each size encloses the one
 * before.
 *
 * The windows change together. Widths change in proportion, about the middle of each
 * window; an edge that meets the end of its wall or another opening stays there while
 * the other edges continue. Heads are raised and sills lowered by equal lengths, each
 * until it is blocked; a height changes by the head first and then by the sill. A size
 * is possible if pp_world_create accepts the room. Edges that move are on a grid (a
 * millimetre, or finer; half of that if both edges move), and are rounded towards the
 * inside of the window.
 *
 * The number of windows can be changed for equal windows in one wall, each in the
 * middle of its share of the wall's length; at the room's own number the windows keep
 * their positions.
 */
#ifndef PP_STUDIES_SIZING_WINDOW_SIZES_H
#define PP_STUDIES_SIZING_WINDOW_SIZES_H

#include <stdbool.h>

#include "pepperpot.h"
#include "model/base/error.h"
#include "model/room/room.h"

#define PP_SIZE_LEAST_M 0.01 /* least size of a window along the change */
#define PP_SIZE_GRID_M 0.001

struct pp_window_sizes;

/* openings: indices of the openings that change, windows or rooflights; for
 * PP_CHANGE_NUMBER windows of one size in one wall. PP_BAD_INPUT if these openings do
 * not allow the change. Copies the needed data of `room`, which must be valid. */
enum pp_status pp_window_sizes_create(struct pp_window_sizes **sizes,
                                      const struct pp_room *room,
                                      enum pp_size_change change, const int *openings,
                                      int opening_count, struct pp_error *err);
void pp_window_sizes_destroy(struct pp_window_sizes *sizes); /* NULL is allowed */

/* Steps are 0 to count - 1. From one step to the next no window grows by more than the
 * width of the grid. Step `now` is the present room, bit for bit. */
int pp_window_sizes_count(const struct pp_window_sizes *sizes);
int pp_window_sizes_now(const struct pp_window_sizes *sizes);

/* Makes each step ten times as fine: step k becomes step 10 k. Steps in the number of
 * windows stay as they are. */
void pp_window_sizes_refine(struct pp_window_sizes *sizes);

/* Makes the room at that step, owned by the caller (pp_room_destroy). New openings come
 * last in the room's list and equal the last of those that change. If the number is
 * smaller than the room's own, the last openings are removed. */
enum pp_status pp_window_sizes_room(struct pp_room **room,
                                    const struct pp_window_sizes *sizes, int step,
                                    struct pp_error *err);

#endif
