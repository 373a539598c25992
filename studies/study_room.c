/* study_room.c - creates and clears study rooms. */
#include "studies/study_room.h"

#include <stdlib.h>

void pp_study_room_init(struct pp_study_room *room, const char *file,
                        struct pp_building *building, int index,
                        const struct pp_room *description, struct pp_world *world,
                        const struct pp_outside_light *light)
{
    *room = (struct pp_study_room){.file = file,
                                   .building = building,
                                   .index = index,
                                   .room = description,
                                   .world = world,
                                   .light = *light,
                                   .receivers = world->receivers,
                                   .receiver_count = world->receiver_count};
}

static void free_points(struct pp_study_room *room)
{
    if (room->world && room->receivers != room->world->receivers)
        free(room->receivers);
}

void pp_study_room_set_points(struct pp_study_room *room, struct pp_receiver *receivers,
                              int count)
{
    free_points(room);
    room->receivers = receivers;
    room->receiver_count = count;
}

void pp_study_room_clear(struct pp_study_room *room)
{
    free_points(room);
    pp_world_destroy(room->world);
    *room = (struct pp_study_room){0};
}

const char *pp_study_room_title(const struct pp_study_room *room)
{
    const char *building = pp_building_name(room->building);
    return building ? building : room->world->name ? room->world->name : room->file;
}
