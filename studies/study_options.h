/* study_options.h - options of a study: methods, points, sky, simulation. */
#ifndef PP_STUDIES_STUDY_OPTIONS_H
#define PP_STUDIES_STUDY_OPTIONS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "methods/method.h"
#include "model/room/world.h"

/* Reference points used instead of those in the file. z is NAN for the working
 * plane. */
struct pp_point_list {
    struct pp_vec3 *list;
    int count;
};

/* Callbacks for a caller that watches a simulation, to show progress or to request a
 * stop. All NULL: no watch. The callbacks are called from one thread, between two
 * slices of work. */
struct pp_watch {
    /* Called when work begins. name: subject of the progress display, usually the room;
     * NULL: a room without a name. Returns true if progress is shown. */
    bool (*begin)(void *data, const char *name);
    /* Reports progress. done: 0 to 1; error: largest standard error divided by daylight
     * factor so far, NAN if there is none. Both take time to compute, and are 0 and NAN
     * if progress is not shown. Returns false to stop; the results so far are then
     * valid. */
    bool (*look)(void *data, double done, double error);
    void (*end)(void *data);
    void *data;
};

/* Calls begin, if there is one. Returns true if progress is shown. */
static inline bool pp_watch_begin(const struct pp_watch *watch, const char *name)
{
    return watch->begin && watch->begin(watch->data, name);
}

/* Reports the fraction `done` of work that cannot be stopped. shown: as pp_watch_begin
 * returned it. */
static inline void pp_watch_show(const struct pp_watch *watch, bool shown, double done)
{
    if (shown && watch->look)
        watch->look(watch->data, done, NAN);
}

static inline void pp_watch_end(const struct pp_watch *watch, bool shown)
{
    if (shown && watch->end)
        watch->end(watch->data);
}

struct pp_study_options {
    const char *methods; /* a selection of methods (methods/selection.h); NULL: default
                          * methods */
    struct pp_point_list points;
    const char *sky; /* sky in the form used in a room file; NULL: sky of the file */

    bool simulate;
    double error;   /* target standard error divided by daylight factor; 0: not given */
    long samples;   /* paths per point in each randomisation; 0: not given */
    double seconds; /* time limit; 0: not given */
    uint64_t seed;
    int threads; /* 0: one for each processor */
    bool strict; /* treat doubtful input as an error */
    bool alone;  /* simulate points independently, which is faster for few points */
    struct pp_watch watch;

    bool explain; /* methods record the steps of the calculation, for the only point */
    struct pp_method_options method_options;

    double external_lux; /* illuminance of the horizontal plane under the open sky; 0:
                          * not given */
};

/* Default options: seed 1; all other options are empty. */
#define PP_STUDY_OPTIONS_NONE ((struct pp_study_options){.seed = 1})

#endif
