/* simulation.h - runs an engine on the points of a report.
 *
 * The caller runs a loop:
 *
 *     pp_simulation_create(&simulation, pp_engine_find("path"), &report, &options,
 *     err);
 *     while (!pp_simulation_done(simulation))
 *         pp_simulation_advance(simulation, 0.1, err);
 *     pp_simulation_add_columns(simulation, &report, err);
 *
 * or calls pp_simulation_run, which also checks the time limit and the watch. The scene
 * can be used again for a run under another sky.
 */
#ifndef PP_STUDIES_SIMULATION_H
#define PP_STUDIES_SIMULATION_H

#include "studies/engines/engine.h"
#include "studies/study_options.h"

struct pp_simulation;

/* Creates a simulation. World and receivers of the report must exist as long as the
 * simulation. */
enum pp_status pp_simulation_create(struct pp_simulation **simulation,
                                    const struct pp_engine *engine,
                                    const struct pp_report *report,
                                    const struct pp_engine_options *options,
                                    struct pp_error *err);

/* Creates a simulation in an existing grey scene of the report's world. The scene must
 * also exist as long as the simulation. */
enum pp_status pp_simulation_create_in(struct pp_simulation **simulation,
                                       const struct pp_engine *engine,
                                       const struct pp_light_scene *scene,
                                       const struct pp_report *report,
                                       const struct pp_engine_options *options,
                                       struct pp_error *err);
void pp_simulation_destroy(struct pp_simulation *simulation); /* NULL is allowed */

/* Calculates for about `seconds` of elapsed time. */
enum pp_status pp_simulation_advance(struct pp_simulation *simulation, double seconds,
                                     struct pp_error *err);
bool pp_simulation_done(const struct pp_simulation *simulation);

/* The first function returns the fraction done, 0 to 1. The second returns the largest
 * standard error divided by daylight factor of any point so far; NAN if there is no
 * result yet. */
double pp_simulation_progress(const struct pp_simulation *simulation);
double pp_simulation_error(const struct pp_simulation *simulation);

/* Reason for the end of a simulation. */
enum pp_simulation_end {
    PP_SIMULATION_DONE,
    PP_SIMULATION_BY_CLOCK,
    PP_SIMULATION_STOPPED
};

/* Advances until the engine is done, `seconds` (0: unlimited) have elapsed, or the
 * watch requests a stop. name: name of the room, for the watch; may be NULL. */
enum pp_status pp_simulation_run(struct pp_simulation *simulation, double seconds,
                                 const struct pp_watch *watch, const char *name,
                                 enum pp_simulation_end *end, struct pp_error *err);

/* Adds a column for each component to the report, with the engine's name and the
 * results so far. Columns added by an earlier call are updated. */
enum pp_status pp_simulation_add_columns(const struct pp_simulation *simulation,
                                         struct pp_report *report,
                                         struct pp_error *err);

/* Stores data with which a later run can begin, as the content of a file. The caller
 * frees *bytes; NULL: there are no data, or not yet. */
enum pp_status pp_simulation_keep(const struct pp_simulation *simulation, char **bytes,
                                  size_t *length, struct pp_error *err);

#endif
