/* room_value.h - one daylight factor of a room by one hand method, for following a
 * design while the room is changed step by step. */
#ifndef PP_STUDIES_ROOM_VALUE_H
#define PP_STUDIES_ROOM_VALUE_H

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/room/world.h"

struct pp_room_value {
    const struct pp_outside_light *light; /* not owned */
    const char *method; /* in the form for pp_methods_evaluate: "exact+bre",
                         * "average-df" */
    const struct pp_receiver *points; /* the figure is the lowest at these; not owned */
    int point_count;                  /* 0: the figure is the working plane's average */
    int threads;                      /* 0: one for each processor */
    char why[512];                    /* text of the reading's reason; its `why`
                                       * points here */
};

/* The figure of that world, under the light of `value`. If the method gives no daylight
 * factor, the figure is the component that the method gives: the internally reflected
 * one, or the direct one (sky component plus externally reflected component). A reading
 * without a value has the reason. */
enum pp_status pp_room_value(struct pp_room_value *value, const struct pp_world *world,
                             struct pp_reading *reading, struct pp_error *err);

#endif
