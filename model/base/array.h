/* array.h - arrays that grow. The one place where the library enlarges a list.
 *
 * `list` is the address of the pointer to the items (a struct item **); counts and
 * capacities are in items, `size` is one item's, in bytes. Functions that fail return
 * PP_SYSTEM and leave list and capacity unchanged.
 */
#ifndef PP_MODEL_BASE_ARRAY_H
#define PP_MODEL_BASE_ARRAY_H

#include <stddef.h>

#include "model/base/error.h"

/* Ensures space for `wanted` items (at least 0): doubles *capacity until it is
 * enough. */
enum pp_status pp_array_reserve(void *list, int *capacity, int wanted, size_t size,
                                struct pp_error *err);

/* Room for one item more than `count`, for lists that keep no capacity: such a list may
 * grow by this function only, which makes its capacity the next power of two. */
enum pp_status pp_array_append(void *list, int count, size_t size,
                               struct pp_error *err);

#endif
