/* study_room.h - one room of a study: its file, its description, its world, the light
 * outside, and its points. */
#ifndef PP_STUDIES_STUDY_ROOM_H
#define PP_STUDIES_STUDY_ROOM_H

#include "model/light/outside_light.h"
#include "model/room/building.h"
#include "model/room/world.h"

struct pp_study_room {
    const char *file;             /* name given by the user; not owned */
    const struct pp_room *room;   /* as in the file, with the options' sky; not owned */
    struct pp_building *building; /* building of the room; not owned */
    int index;                    /* index of the room in its building */
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_receiver *receivers; /* the world's own, or their replacement */
    int receiver_count;
    const struct pp_mistakes *doubts; /* warnings about its file; NULL: not looked for;
                                       * not owned */
};

/* Takes ownership of `world`, whose receivers become the points. description: room
 * `index` of the building, or a changed copy of it; light: of the room's own sky, or
 * another. */
void pp_study_room_init(struct pp_study_room *room, const char *file,
                        struct pp_building *building, int index,
                        const struct pp_room *description, struct pp_world *world,
                        const struct pp_outside_light *light);

/* Replaces the points; takes ownership of the list (malloc). */
void pp_study_room_set_points(struct pp_study_room *room, struct pp_receiver *receivers,
                              int count);

void pp_study_room_clear(struct pp_study_room *room);

/* Title for documents: the name of the building, else of the room, else the file. Not
 * owned. */
const char *pp_study_room_title(const struct pp_study_room *room);

#endif
