/* size.h - the smallest window with which a daylight factor reaches a target.
 *
 * The daylight factor is any value of a room that the caller computes, such as an
 * average or the lowest value at points, by a hand method or simulated. The search
 * finds the smallest size, for one kind of change (window_sizes.h), whose value is at
 * least the target. A scan over the whole range finds the two neighbouring sizes
 * between which the value first passes the target; the value need not increase over the
 * whole range. Bisection follows. If the value has a standard error, the search ends
 * when the value is within half a standard error of the target.
 */
#ifndef PP_STUDIES_SIZING_SIZE_H
#define PP_STUDIES_SIZING_SIZE_H

#include <stdbool.h>

#include "pepperpot.h"
#include "studies/sizing/window_sizes.h"
#include "model/results/reading.h"
#include "model/room/world.h"

/* Callback that computes the value of the room from which `world` was made. A reading
 * without a value ends the search, so its reason must apply to every size. */
typedef enum pp_status pp_size_value(void *data, const struct pp_world *world,
                                     struct pp_reading *reading, struct pp_error *err);

struct pp_size_task {
    const struct pp_room *room;
    enum pp_size_change change;
    const int *openings; /* indices of the openings that change, as in
                          * pp_window_sizes_create */
    int opening_count;
    double target;  /* target, in the unit of the value: a fraction */
    bool by_counts; /* the value is a count (for example of dots) that changes in steps,
                     * so that finer sizes do not give values closer to the target */
    bool sampled;   /* the value is the lower limit of a sampled figure and must reach
                     * the target; the search may end at a value up to 1 % above */
    pp_size_value *value;
    void *data; /* first argument of `value` */
};

struct pp_size_answer {
    enum pp_size_verdict verdict;
    struct pp_reading now;      /* value of the present room */
    struct pp_reading smallest; /* value for the smallest size */
    struct pp_reading largest;  /* value for the largest size; for PP_CHANGE_NUMBER, for
                                 * the largest number tried */
    struct pp_reading reading;  /* value for the size found */
    struct pp_room *room;       /* room with the size found, owned; NULL: there is no
                                 * value */
    struct pp_room
        *largest_room; /* room with the largest size, owned; NULL: there is no value */
    bool is_largest;   /* the size found is the largest size */
    int evaluations;   /* number of sizes evaluated */
};

/* Finds the size. On success the caller clears *answer. */
enum pp_status pp_size_find(struct pp_size_answer *answer,
                            const struct pp_size_task *task, struct pp_error *err);
void pp_size_answer_clear(struct pp_size_answer *answer);

#endif
