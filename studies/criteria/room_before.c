/* room_before.c - see room_before.h. */
#include "studies/criteria/room_before.h"

#include <string.h>

#include "studies/criteria/pair_rooms.h"

/* The same room of the same file in the other state; NULL: it does not exist there. */
static const struct pp_study_room *find_in_state(const struct pp_study_room *room,
                                                 const struct pp_rooms_before *before)
{
    for (int i = 0; i < before->count; i++) {
        const struct pp_study_room *other = &before->list[i];
        if (strcmp(other->file, room->file) == 0
            && pp_building_place(other->building, other->index)
                   == pp_building_place(room->building, room->index))
            return other;
    }
    return NULL;
}

/* Finds the room of the same name, or the only room if there is only one in both
 * states; NULL: none. */
static const struct pp_study_room *find_by_name(const struct pp_study_room *room,
                                                int room_count,
                                                const struct pp_rooms_before *before)
{
    for (int i = 0; i < before->count; i++) {
        const char *name = before->list[i].world->name, *wanted = room->world->name;
        bool only = before->count == 1 && room_count == 1;
        if (only || (name && wanted && strcmp(name, wanted) == 0))
            return &before->list[i];
    }
    return NULL;
}

enum pp_status pp_room_before_find(const struct pp_study_room **found, int **pairs,
                                   const struct pp_study_room *room, int room_count,
                                   const struct pp_rooms_before *before,
                                   struct pp_error *err)
{
    *pairs = NULL;
    *found = before->is_state ? find_in_state(room, before)
                              : find_by_name(room, room_count, before);
    if (!*found && (before->is_state || before->count == 0))
        return PP_OK;
    const char *file = before->list[0].file;
    if (!*found)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: there is no room named \"%.100s\" for the comparison", file,
                       room->world->name ? room->world->name : "");
    struct pp_error why;
    enum pp_status status = pp_pair_rooms(pairs, room->world, (*found)->world, &why);
    return status == PP_BAD_INPUT ? pp_fail(err, status, "%s: %s", file, why.message)
           : status != PP_OK      ? pp_fail(err, status, "%s", why.message)
                                  : PP_OK;
}
