/* atlas_run.h - many rooms of the atlas, dealt out to threads and handed over in order.
 */
#ifndef PP_STUDIES_ATLAS_ATLAS_RUN_H
#define PP_STUDIES_ATLAS_ATLAS_RUN_H

#include "studies/atlas/atlas_room.h"
#include "studies/study_options.h"

struct pp_atlas_run {
    const struct pp_atlas_design *design;
    const struct pp_atlas_columns *columns;
    struct pp_atlas_trace trace;
    int first, end;        /* rooms; end is not one of them */
    int threads;           /* 0: as many as there are processors */
    struct pp_watch watch; /* may stop the run between two rooms */

    /* Takes a room's rows: rooms in their order, by one thread at a time. */
    enum pp_status (*take)(void *data, const char *rows, size_t length,
                           struct pp_error *err);
    void *data;
};

/* Works the rooms out, a thread each. *next: the room after the last that was taken, also
 * where it fails or is stopped. */
enum pp_status pp_atlas_run(const struct pp_atlas_run *run, int *next,
                            struct pp_error *err);

#endif
