/* atlas_run.h - many rooms of the atlas, dealt out to threads and handed over in order.
 */
#ifndef PP_STUDIES_ATLAS_ATLAS_RUN_H
#define PP_STUDIES_ATLAS_ATLAS_RUN_H

#include "model/base/error.h"
#include "studies/study_options.h"

struct pp_atlas_run {
    int first, end;        /* rooms; end is not one of them */
    int threads;           /* 0: as many as there are processors */
    struct pp_watch watch; /* may stop the run between two rooms */

    /* Works out the rows of a room, of which nothing may depend on who does it when;
     * *rows is to be freed. By several threads at a time. */
    enum pp_status (*rows_of)(const void *of, int room, char **rows, size_t *length,
                              struct pp_error *err);
    const void *of;

    /* Takes a room's rows: rooms in their order, by one thread at a time. */
    enum pp_status (*take)(void *to, const char *rows, size_t length,
                           struct pp_error *err);
    void *to;
};

/* Works the rooms out, a thread each. *next: the room after the last that was taken, also
 * where it fails or is stopped. */
enum pp_status pp_atlas_run(const struct pp_atlas_run *run, int *next,
                            struct pp_error *err);

#endif
