/* room_value.h - one daylight factor of a room by one hand method, for searches in
 * which the room is changed step by step. */
#ifndef PP_STUDIES_ROOM_VALUE_H
#define PP_STUDIES_ROOM_VALUE_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_room_value {
    const struct pp_outside_light *light; /* not owned */
    const char *method; /* in the form used by pp_methods_evaluate: "exact+bre",
                         * "average-df" */
    const struct pp_receiver *points; /* the value is the lowest at these points; not
                                       * owned */
    int point_count;                  /* 0: the value is the average over the working
                                       * plane */
    int threads;                      /* 0: one for each processor */
    char why[512];                    /* reason if there is no value; the `why` of the
                                       * reading points to it */
};

/* Calculates the value for a world, under the light in *value. If the method does not
 * give the daylight factor, the value is the component that it gives: the internally
 * reflected component, or the sum of sky and externally reflected component. A reading
 * without a value has a reason. */
enum pp_status pp_room_value(struct pp_room_value *value, const struct pp_world *world,
                             struct pp_reading *reading, struct pp_error *err);

#endif
