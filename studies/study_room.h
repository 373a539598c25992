/* study_room.h - one room of a study: file, description, world, light outside, and
 * points. */
#ifndef PP_STUDIES_STUDY_ROOM_H
#define PP_STUDIES_STUDY_ROOM_H

#include "model/light/outside_light.h"
#include "model/room/building.h"
#include "model/room/world.h"

struct pp_study_room {
    const char *file;             /* name given by the user; not owned */
    const struct pp_room *room;   /* as in the file, but with the sky of the options;
                                   * not owned */
    struct pp_building *building; /* building of the room; not owned */
    int index;                    /* index of the room in its building */
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_receiver *receivers; /* receivers of the world, or the points that replace
                                    * them */
    int receiver_count;
    const struct pp_mistakes *doubts; /* warnings about the file; NULL: not checked; not
                                       * owned */
};

/* Initialises a study room. Takes ownership of `world`, whose receivers become the
 * points. description: room `index` of the building, or a changed copy of it; light:
 * light outside under the room's own sky or another sky. */
void pp_study_room_init(struct pp_study_room *room, const char *file,
                        struct pp_building *building, int index,
                        const struct pp_room *description, struct pp_world *world,
                        const struct pp_outside_light *light);

/* Replaces the points. Takes ownership of the list, which was allocated by malloc. */
void pp_study_room_set_points(struct pp_study_room *room, struct pp_receiver *receivers,
                              int count);

void pp_study_room_clear(struct pp_study_room *room);

/* Title for documents: name of the building, or else of the room, or else of the file.
 * Not owned. */
const char *pp_study_room_title(const struct pp_study_room *room);

#endif
