/* size.h - the smallest window with which a daylight factor reaches a target.
 *
 * The daylight factor is any value of a room that the caller computes: an average, or
 * that of points, by a hand method or traced. The sizes of one kind of change
 * (window_sizes.h) are searched for the smallest whose value is not below the target. A
 * few sizes over the whole range show between which two neighbours the value first
 * passes the target (it need not grow all the way); bisection does the rest. The search
 * for a value with a standard error ends when the value is within half a standard error
 * of the target.
 */
#ifndef PP_STUDIES_SIZING_SIZE_H
#define PP_STUDIES_SIZING_SIZE_H

#include <stdbool.h>

#include "pepperpot.h"
#include "studies/sizing/window_sizes.h"
#include "model/results/reading.h"
#include "model/room/world.h"

/* Computes the value of the room that `world` was made of. A reading without a value ends
 * the search: its reason must be one that holds at every size. */
typedef enum pp_status pp_size_value(void *data, const struct pp_world *world,
                                     struct pp_reading *reading, struct pp_error *err);

struct pp_size_task {
    const struct pp_room *room;
    enum pp_size_change change;
    const int *openings; /* that change, as pp_window_sizes_create takes them */
    int opening_count;
    double target;  /* a fraction, as the value is */
    bool by_counts; /* the value is a count (of dots, say) and grows in jumps, so that
                     * finer sizes come no closer to the target */
    bool sampled; /* the value is the lower limit of a sampled figure, and has to reach
                   * the target itself: a search may end within 1 % above it */
    pp_size_value *value;
    void *data; /* handed to value */
};

struct pp_size_answer {
    enum pp_size_verdict verdict;
    struct pp_reading now;      /* of the room as it is */
    struct pp_reading smallest; /* of the smallest size */
    struct pp_reading largest;  /* of the largest size */
    struct pp_reading reading;  /* of the size given */
    struct pp_room *room;       /* at the size given, owned; NULL: there is no value */
    struct pp_room
        *largest_room; /* at the largest size, owned; NULL: there is no value */
    bool is_largest;   /* the size given is the largest */
    int evaluations;   /* number of sizes that were evaluated */
};

/* Finds the size. On success the caller clears the answer. */
enum pp_status pp_size_find(struct pp_size_answer *answer,
                            const struct pp_size_task *task, struct pp_error *err);
void pp_size_answer_clear(struct pp_size_answer *answer);

#endif
