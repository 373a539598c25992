/* size.h - the smallest window with which a daylight factor reaches a target.
 *
 * The daylight factor is any value of a room that the caller computes: an average, or
 * the lowest of points, by a hand method or simulated. The sizes of one kind of change
 * (window_sizes.h) are searched for the smallest whose value is not below the target. A
 * scan over the whole range finds the two neighbours between which the value first
 * passes the target (it need not rise throughout); bisection follows. The search for a
 * value with a standard error ends when the value is within half a standard error of
 * the target.
 */
#ifndef PP_STUDIES_SIZING_SIZE_H
#define PP_STUDIES_SIZING_SIZE_H

#include <stdbool.h>

#include "pepperpot.h"
#include "studies/sizing/window_sizes.h"
#include "model/results/reading.h"
#include "model/room/world.h"

/* Computes the value of the room from which `world` was made. A reading without a value
 * ends the search: its reason must apply at every size. */
typedef enum pp_status pp_size_value(void *data, const struct pp_world *world,
                                     struct pp_reading *reading, struct pp_error *err);

struct pp_size_task {
    const struct pp_room *room;
    enum pp_size_change change;
    const int *openings; /* indices of the openings that change, as for
                          * pp_window_sizes_create */
    int opening_count;
    double target;  /* a fraction, as the value is */
    bool by_counts; /* the value is a count (for example of dots) and rises in steps,
                     * so that finer sizes do not come closer to the target */
    bool sampled;   /* the value is the lower limit of a sampled figure and must itself
                     * reach the target: a search may end within 1 % above it */
    pp_size_value *value;
    void *data; /* passed on to `value` */
};

struct pp_size_answer {
    enum pp_size_verdict verdict;
    struct pp_reading now;      /* value of the present room */
    struct pp_reading smallest; /* value of the smallest size */
    struct pp_reading largest;  /* value of the largest size */
    struct pp_reading reading;  /* at step `step` */
    struct pp_room *room;       /* room with the size found, owned; NULL: there is no
                                 * value */
    struct pp_room
        *largest_room; /* room with the largest size, owned; NULL: there is no value */
    bool is_largest;   /* the size given is the largest */
    int evaluations;   /* number of sizes that were evaluated */
};

/* Finds the size. On success the caller clears the answer. */
enum pp_status pp_size_find(struct pp_size_answer *answer,
                            const struct pp_size_task *task, struct pp_error *err);
void pp_size_answer_clear(struct pp_size_answer *answer);

#endif
