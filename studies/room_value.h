/* room_value.h - one figure of a room by one hand method: what a design is judged by.
 */
#ifndef PP_STUDIES_ROOM_VALUE_H
#define PP_STUDIES_ROOM_VALUE_H

#include "model/base/error.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_room_value {
    const char *method; /* "exact+bre", "average-df"; of a method that gives a component
                         * only, its component: direct, or internally reflected */
    const struct pp_receiver *points; /* the lowest of these; not owned */
    int point_count;                  /* 0: the average over the working plane */
    char why[512];                    /* what readings' why points to */
};

/* The value in that world; a reading that is none says why. */
enum pp_status pp_room_value(struct pp_room_value *value, const struct pp_world *world,
                             struct pp_reading *reading, struct pp_error *err);

#endif
