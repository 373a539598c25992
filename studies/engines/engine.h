/* engine.h - list of simulation engines. Each engine is a file that adapts a solver in
 * simulate/ to a common set of functions.
 *
 * The scene does not include light from outside. A scene is made once from a world, and
 * can be used for any number of runs of any engine under different environments. The
 * caller (studies/simulation.h) calls create, advance until the run is done, read, and
 * destroy. To add an engine, write a file like engine_path.c and add a line to
 * engine.c.
 */
#ifndef PP_STUDIES_ENGINES_ENGINE_H
#define PP_STUDIES_ENGINES_ENGINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/results/report.h"
#include "simulate/cache/irradiance_cache.h"
#include "simulate/scene/environment.h"

/* Options of all engines. Each engine uses the options that apply to it. */
struct pp_engine_options {
    double error; /* target standard error divided by daylight factor; 0: use samples or
                   * time */
    long samples; /* paths per point in each randomisation, instead of `error`; 0: not
                   * given */
    uint64_t seed;
    int threads; /* 0: one for each processor */

    bool plain;  /* use the engine's plain implementation, if it has one */
    bool alone;  /* path engine: simulate each point independently */
    bool direct; /* path engine: only the sky component and the externally reflected
                  * component; the error is relative to their sum */

    double sensor_m; /* photon engine: count photons on discs of this radius around the
                      * receivers; 0: the receivers are points */

    struct pp_cache_options cache; /* options of the cache; seed and threads are those
                                    * above */
    bool interpolate;              /* cache engine: interpolate reflected light at the
                                    * points */
    const char *cache_file; /* cache engine: file with initial records, used if it
                             * exists; NULL: none */
};

struct pp_engine {
    const char *name;   /* as typed, such as "path" */
    const char *column; /* name of its columns in reports, such as "traced" */
    const char *summary;
    const char *said;      /* description below a table, such as "by simulation" */
    const char *deviation; /* name of the error beside a value, such as "one standard
                            * error" */
    const char *from;      /* heading for deviations from this engine, such as "from
                            * traced, %"; NULL: the engine is not a reference */
    bool is_truth;         /* true if hand methods can be compared with this engine */
    bool is_sampled;       /* true if results depend on the seed */
    const struct pp_engine
        *plain; /* plain implementation that gives the same results; NULL: none */

    /* Creates a run for the report's receivers and working plane, in the grey scene of
     * the world under this environment. On failure *run is NULL or unchanged. Scene,
     * environment and receivers must exist as long as the run. */
    enum pp_status (*create)(void **run, const struct pp_light_scene *scene,
                             const struct pp_environment *environment,
                             const struct pp_report *report,
                             const struct pp_engine_options *options,
                             struct pp_error *err);
    enum pp_status (*advance)(void *run, double seconds, struct pp_error *err);
    bool (*done)(const void *run);
    double (*progress)(const void *run); /* fraction done, 0 to 1 */
    double (*error)(const void *run);    /* largest standard error divided by daylight
                                       * factor */

    /* Reads readings[PP_SC] ... readings[PP_DF] of receiver `index`; index -1: the
     * average. */
    void (*read)(const void *run, int index,
                 struct pp_reading readings[PP_COMPONENT_COUNT]);

    /* Correlated fraction of the variance of the receivers' daylight factors
     * (common_error.h). The first function is for all receivers, the second for
     * neighbours. NULL: no such data. */
    double (*common)(const void *run);
    double (*common_near)(const void *run);

    /* Stores data with which a later run can begin, as the content of a file. The
     * caller frees *bytes. NULL: the engine has no such data. */
    enum pp_status (*keep)(const void *run, char **bytes, size_t *length,
                           struct pp_error *err);
    void (*destroy)(void *run); /* NULL is allowed */
};

extern const struct pp_engine pp_engine_path, pp_engine_cache, pp_engine_photons,
    pp_engine_radiosity, pp_engine_plain;

const struct pp_engine *pp_engine_at(int index);          /* NULL after the last */
const struct pp_engine *pp_engine_find(const char *name); /* NULL: there is none */

/* Engine whose columns have this name; NULL: the name belongs to a method. */
const struct pp_engine *pp_engine_of_column(const char *column);

/* Finds the reference column of daylight factors: the column of the first engine in the
 * list that is a reference and has a column in the report. NULL: none. */
const struct pp_column *pp_engine_truth(const struct pp_report *report);

#endif
