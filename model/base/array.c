/* array.c - grows memory to powers of two, so that filling a list of n items copies
 * fewer than 2 n of them. */
#include "model/base/array.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Reads and writes the pointer as bytes, since a T ** must not be accessed as a void
 * **. */
static enum pp_status resize(void *list, size_t count, size_t size,
                             struct pp_error *err)
{
    void *items;
    if (count > SIZE_MAX / size)
        return pp_fail_memory(err);
    memcpy(&items, list, sizeof items);
    items = realloc(items, count * size);
    if (!items)
        return pp_fail_memory(err);
    memcpy(list, &items, sizeof items);
    return PP_OK;
}

enum pp_status pp_array_reserve(void *list, int *capacity, int wanted, size_t size,
                                struct pp_error *err)
{
    if (wanted <= *capacity)
        return PP_OK;
    int room = *capacity > 0 ? *capacity : 1;
    while (room < wanted)
        room = room > INT_MAX / 2 ? wanted : 2 * room;
    enum pp_status status = resize(list, (size_t)room, size, err);
    if (status == PP_OK)
        *capacity = room;
    return status;
}

enum pp_status pp_array_append(void *list, int count, size_t size, struct pp_error *err)
{
    if (count == INT_MAX)
        return pp_fail_memory(err);
    if ((count & (count - 1)) != 0)
        return PP_OK; /* capacity is the next power of two */
    return resize(list, count > 0 ? 2 * (size_t)count : 1, size, err);
}
