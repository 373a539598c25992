/* size.h - the window that just reaches a target.
 *
 * What is to reach it is any value of a room, worked out by the caller: an average or
 * a point's daylight factor, by a hand method or traced. The sizes of one kind of
 * change (studies/sizing/window_sizes.h) are searched for the smallest that is not below the
 * target: a few sizes over the whole range tell between which two the value passes it
 * (it need not grow all the way), and halving the steps between them does the rest. A
 * value with a standard error is done when it is within half of one of the target.
 */
#ifndef PP_STUDIES_SIZING_SIZE_H
#define PP_STUDIES_SIZING_SIZE_H

#include <stdbool.h>

#include "pepperpot.h"
#include "studies/sizing/window_sizes.h"
#include "model/results/reading.h"
#include "model/room/world.h"

/* The value of a room; the world is that of the room. A reading without a value says
 * why, of any room alike, and ends the search. */
typedef enum pp_status pp_size_value(void *data, const struct pp_world *world,
                                     struct pp_reading *reading, struct pp_error *err);

struct pp_size_task {
    const struct pp_room *room;
    enum pp_size_change change;
    const int *openings; /* that change, as of pp_window_sizes_create */
    int opening_count;
    double target;  /* a fraction, as the value is */
    bool by_counts; /* the value is counted, so that no size reaches the target closely
                     */
    pp_size_value *value;
    void *data;
};

struct pp_size_answer {
    enum pp_size_verdict verdict;
    struct pp_reading now;      /* of the room as it is */
    struct pp_reading smallest; /* of the smallest size */
    struct pp_reading largest;  /* of the largest size */
    struct pp_reading reading;  /* of the size given */
    struct pp_room *room;       /* at the size given; NULL where there is no value */
    bool is_largest;            /* the size given is the largest */
    int evaluations;            /* how many sizes were tried */
};

/* On success the answer is to be cleared by the caller. */
enum pp_status pp_size_find(struct pp_size_answer *answer,
                            const struct pp_size_task *task, struct pp_error *err);
void pp_size_answer_clear(struct pp_size_answer *answer);

#endif
