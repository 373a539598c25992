/* simulation.h - runs an engine on the points of a report.
 *
 * The caller has the loop:
 *
 *     pp_simulation_create(&simulation, pp_engine_find("path"), &report, &options,
 *     err);
 *     while (!pp_simulation_done(simulation))
 *         pp_simulation_advance(simulation, 0.1, err);
 *     pp_simulation_add_columns(simulation, &report, err);
 *
 * or calls pp_simulation_run, which checks the clock and the watch. For a run under
 * another sky the scene can be reused.
 */
#ifndef PP_STUDIES_SIMULATION_H
#define PP_STUDIES_SIMULATION_H

#include "studies/engines/engine.h"
#include "studies/study_options.h"

struct pp_simulation;

/* The report's world and receivers must outlive *simulation. */
enum pp_status pp_simulation_create(struct pp_simulation **simulation,
                                    const struct pp_engine *engine,
                                    const struct pp_report *report,
                                    const struct pp_engine_options *options,
                                    struct pp_error *err);

/* Does the same in the grey scene of the report's world; the scene must also outlive
 * *simulation. */
enum pp_status pp_simulation_create_in(struct pp_simulation **simulation,
                                       const struct pp_engine *engine,
                                       const struct pp_light_scene *scene,
                                       const struct pp_report *report,
                                       const struct pp_engine_options *options,
                                       struct pp_error *err);
void pp_simulation_destroy(struct pp_simulation *simulation); /* NULL is allowed */

/* Calculates for about `seconds` of real time. */
enum pp_status pp_simulation_advance(struct pp_simulation *simulation, double seconds,
                                     struct pp_error *err);
bool pp_simulation_done(const struct pp_simulation *simulation);

/* Progress, 0 to 1; and the largest standard error over daylight factor of any point so
 * far, NAN before there is any. */
double pp_simulation_progress(const struct pp_simulation *simulation);
double pp_simulation_error(const struct pp_simulation *simulation);

/* Reason for the end of a simulation. */
enum pp_simulation_end {
    PP_SIMULATION_DONE,
    PP_SIMULATION_BY_CLOCK,
    PP_SIMULATION_STOPPED
};

/* Advances until the engine is done, `seconds` (0: unlimited) are over, or the watch
 * requests a stop. name: of the room, for the watch; may be NULL. */
enum pp_status pp_simulation_run(struct pp_simulation *simulation, double seconds,
                                 const struct pp_watch *watch, const char *name,
                                 enum pp_simulation_end *end, struct pp_error *err);

/* Adds to the report a column with the engine's name for each component, with the
 * results so far; columns of an earlier call are filled again. */
enum pp_status pp_simulation_add_columns(const struct pp_simulation *simulation,
                                         struct pp_report *report,
                                         struct pp_error *err);

/* Data with which a later run may begin, as the content of a file, to be freed by the
 * caller; *bytes NULL: nothing to keep (yet). */
enum pp_status pp_simulation_keep(const struct pp_simulation *simulation, char **bytes,
                                  size_t *length, struct pp_error *err);

#endif
