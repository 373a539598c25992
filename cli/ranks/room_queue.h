/* room_queue.h - simulates many rooms, one after the other in this process, or shared
 * among ranks. */
#ifndef PP_CLI_RANKS_ROOM_QUEUE_H
#define PP_CLI_RANKS_ROOM_QUEUE_H

#include "model/base/ranks.h"
#include "model/results/report.h"

/* Results of a room's simulation: the report, and whether the time limit stopped the
 * simulation. */
struct pp_room_figures {
    struct pp_report *report;
    bool *by_clock;
};

struct pp_room_queue {
    int count;                    /* number of rooms; 0: nothing is simulated */
    const struct pp_ranks *ranks; /* NULL: this process alone */

    /* The report of a room, with the columns of the hand methods. */
    struct pp_room_figures (*figures)(void *data, int room);

    /* Adds the simulation's columns to the report, which may be a copy without any
     * columns. Changes nothing else. */
    enum pp_status (*simulate)(const void *data, int room, struct pp_report *report,
                               bool *by_clock, struct pp_error *err);
    void *data;
};

/* Simulates all rooms. A single room is simulated on rank 0, with the number of threads
 * in its options. With ranks (work_queue.h) the function returns PP_INTERRUPTED on all
 * ranks except rank 0, which has the columns of all rooms, equal to those of a single
 * process. */
enum pp_status pp_room_queue_run(const struct pp_room_queue *queue,
                                 struct pp_error *err);

#endif
