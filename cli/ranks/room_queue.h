/* room_queue.h - simulates many rooms, one after the other in this process, or
 * distributed over ranks. */
#ifndef PP_CLI_RANKS_ROOM_QUEUE_H
#define PP_CLI_RANKS_ROOM_QUEUE_H

#include "model/base/ranks.h"
#include "model/results/report.h"

/* Results of a room's simulation: the report, and whether the time limit ended the
 * simulation. */
struct pp_room_figures {
    struct pp_report *report;
    bool *by_clock;
};

struct pp_room_queue {
    int count;                    /* number of rooms; 0: no simulation */
    const struct pp_ranks *ranks; /* NULL: this process alone */

    /* Returns the report of a room, which contains the columns of hand methods. */
    struct pp_room_figures (*figures)(void *data, int room);

    /* Adds the simulated columns to the report, which may be a copy without any
     * columns. Does not change anything else. */
    enum pp_status (*simulate)(const void *data, int room, struct pp_report *report,
                               bool *by_clock, struct pp_error *err);
    void *data;
};

/* Simulates all rooms. A single room is simulated on rank 0, with the number of threads
 * in its options. With ranks (work_queue.h), the function returns PP_INTERRUPTED on all
 * ranks except rank 0. Rank 0 then has the columns of all rooms, which are the same as
 * in a single process. */
enum pp_status pp_room_queue_run(const struct pp_room_queue *queue,
                                 struct pp_error *err);

#endif
