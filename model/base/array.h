/* array.h - arrays that grow. All lists of the library grow here.
 *
 * `list` is the address of the pointer to the items (a struct item **). Counts and
 * capacities are in items; `size` is the size of one item, in bytes. Functions that
 * fail return PP_SYSTEM and leave list and capacity unchanged.
 */
#ifndef PP_MODEL_BASE_ARRAY_H
#define PP_MODEL_BASE_ARRAY_H

#include <stddef.h>

#include "model/base/error.h"

/* Ensures space for `wanted` items (0 or more); doubles *capacity until it is
 * enough. */
enum pp_status pp_array_reserve(void *list, int *capacity, int wanted, size_t size,
                                struct pp_error *err);

/* Ensures space for one more item than `count`, for lists without a capacity. Such a
 * list may grow by this function only, so that its capacity is always the next power of
 * two. */
enum pp_status pp_array_append(void *list, int count, size_t size,
                               struct pp_error *err);

#endif
