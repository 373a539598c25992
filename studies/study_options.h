/* study_options.h - options of a study: methods, points, sky, simulation. */
#ifndef PP_STUDIES_STUDY_OPTIONS_H
#define PP_STUDIES_STUDY_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "methods/method.h"
#include "model/room/world.h"

/* Reference points used instead of the file's; z is NAN for the working plane. */
struct pp_point_list {
    struct pp_vec3 *list;
    int count;
};

/* Callbacks of a caller who watches a simulation: a progress bar, a request to stop.
 * All NULL: no watch. Called from one thread, between two slices of work. */
struct pp_watch {
    /* Called when work begins. name: subject shown with the progress, usually the room.
     * Returns true if progress is shown. */
    bool (*begin)(void *data, const char *name);
    /* Reports progress. done: 0 to 1; error: the largest standard error over daylight
     * factor so far, NAN if there is none. They take time, and are 0 and NAN if
     * progress is not shown. Returns false to stop; the results so far are then
     * valid. */
    bool (*look)(void *data, double done, double error);
    void (*end)(void *data);
    void *data;
};

struct pp_study_options {
    const char *methods; /* a selection (methods/selection.h); NULL: the default ones */
    struct pp_point_list points;
    const char *sky; /* as in a room file; NULL: the file's */

    bool simulate;
    double error;   /* target standard error over daylight factor; 0: not given */
    long samples;   /* paths per point in each randomisation; 0: not given */
    double seconds; /* 0: not given */
    uint64_t seed;
    int threads; /* 0: one for each processor */
    bool strict; /* doubtful input is an error */
    bool alone;  /* points are simulated independently: faster for few points */
    struct pp_watch watch;

    bool explain; /* methods record the steps of the calculation at the only point */
    struct pp_method_options method_options;

    double external_lux; /* illuminance of the open horizontal plane; 0: not given */
};

/* Default options: seed 1, all else empty. */
#define PP_STUDY_OPTIONS_NONE ((struct pp_study_options){.seed = 1})

#endif
