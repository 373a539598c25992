/* engine.h - list of simulation engines. Each is a file that adapts one of simulate/'s
 * solvers to a common set of functions.
 *
 * The scene has no light from outside: made once from a world, it serves any number of
 * runs of any engine, under one environment after another. The caller runs the loop
 * (studies/simulation.h): create, advance until done, read, destroy. A new engine is a
 * file like engine_path.c, and a line in engine.c.
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

/* Options of any engine; each uses those that apply to it. */
struct pp_engine_options {
    double error; /* target standard error over daylight factor; 0: use samples or
                   * seconds */
    long samples; /* paths per point in each randomisation instead; 0: not given */
    uint64_t seed;
    int threads; /* 0: one for each processor */

    bool plain;  /* use the engine's plain implementation, if it has one */
    bool alone;  /* path engine: each point is simulated independently */
    bool direct; /* path engine: sky and externally reflected component only, with the
                  * error over their sum */

    double sensor_m; /* photon engine: photons are counted on discs of this radius round
                      * the receivers; 0: the receivers are points */

    struct pp_cache_options cache; /* options of the cache, with seed and threads as
                                    * above */
    bool interpolate;              /* cache engine: interpolates reflected light at the
                                    * points */
    const char *cache_file; /* cache engine: file of initial records, used if it exists;
                             * NULL: none */
};

struct pp_engine {
    const char *name;   /* as typed: "path" */
    const char *column; /* name of its columns of results: "traced" */
    const char *summary;
    const char *said;      /* description of its figures below a table: "by
                            * simulation" */
    const char *deviation; /* name of the error beside a figure: "one standard error" */
    const char *from;      /* heading for deviations from its results: "from traced,
                            * %"; NULL: the engine is not a reference */
    bool is_truth;         /* true if hand figures can be compared with it */
    bool is_sampled;       /* figures depend on the seed */
    const struct pp_engine
        *plain; /* engine with the same results by a plain implementation; NULL: none */

    /* Creates a run at the report's receivers and over its working plane, in the
     * world's diffuse scene under this environment. *run is set only on success; scene,
     * environment and receivers must outlive it. */
    enum pp_status (*create)(void **run, const struct pp_light_scene *scene,
                             const struct pp_environment *environment,
                             const struct pp_report *report,
                             const struct pp_engine_options *options,
                             struct pp_error *err);
    enum pp_status (*advance)(void *run, double seconds, struct pp_error *err);
    bool (*done)(const void *run);
    double (*progress)(const void *run); /* 0 to 1 */
    double (*error)(const void *run); /* largest standard error over daylight factor */

    /* readings[PP_SC] ... readings[PP_DF] of receiver `index`; of the average for -1. */
    void (*read)(const void *run, int index,
                 struct pp_reading readings[PP_COMPONENT_COUNT]);

    /* Correlated share of the variance of the receivers' daylight factors
     * (common_error.h): among all receivers, and among neighbours; NULL: none. */
    double (*common)(const void *run);
    double (*common_near)(const void *run);

    /* Data with which a later run may begin, as the content of a file; NULL: there are
     * none. The caller frees it. */
    enum pp_status (*keep)(const void *run, char **bytes, size_t *length,
                           struct pp_error *err);
    void (*destroy)(void *run); /* NULL is allowed */
};

extern const struct pp_engine pp_engine_path, pp_engine_cache, pp_engine_photons,
    pp_engine_radiosity, pp_engine_plain;

const struct pp_engine *pp_engine_at(int index);          /* NULL after the last */
const struct pp_engine *pp_engine_find(const char *name); /* NULL: there is none */

/* Engine whose columns have this name; NULL: the name of a method. */
const struct pp_engine *pp_engine_of_column(const char *column);

/* The reference column of daylight factors: that of the first engine of the list that
 * is a reference and is in the report; NULL: none. */
const struct pp_column *pp_engine_truth(const struct pp_report *report);

#endif
