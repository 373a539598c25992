/* own_world.h - the worlds that hand methods assume, if they differ from the room's
 * world.
 *
 * A method's error is the sum of two parts, due to its assumption and to its formula:
 *
 *     method - room = (own - room) + (method - own)
 *
 * `room` is simulated in the room as it is, `own` in the world that the method assumes:
 *
 *     direct methods       ground lit by the whole sky everywhere; otherwise as in
 *                          the room
 *     other methods        the same ground, with the reflectance built into the method
 *                          (pp_method.own_ground), or else of the room; skylines by
 *                          own_skylines.h instead of the surroundings
 *     of_real_room         the room as it is, for methods fitted to real rooms
 *     a pair A+B           SC and ERC from A's world, IRC from B's world
 *
 * The sky component depends only on the surroundings, so a world that differs only in
 * its ground has the room's sky component. Equal worlds are made only once; a world
 * equal to the room's world is not made. All worlds are simulated with one seed, so
 * light paths that meet no difference are the same in both worlds. The difference own -
 * room is therefore less noisy than its standard error, which assumes independent
 * values.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_OWN_WORLD_H
#define PP_STUDIES_RESEARCH_VALIDATION_OWN_WORLD_H

#include "model/results/report.h"
#include "model/room/building.h"
#include "studies/study_options.h"

/* Worlds of all columns of a report. */
struct pp_own_worlds;

/* Makes the worlds of the report's columns. room: the description of the report's
 * world. The report must outlive the worlds. */
enum pp_status pp_own_world_list(struct pp_own_worlds **worlds,
                                 const struct pp_room *room,
                                 const struct pp_report *report, struct pp_error *err);
void pp_own_world_destroy(struct pp_own_worlds *worlds); /* NULL is allowed */

int pp_own_world_count(const struct pp_own_worlds *worlds);

/* Simulates world `index` at the points of the room's report, as pp_study_report_traced
 * does for the room. The result is stored in `report`, the report of this world or of
 * an equal one. Only direct light is simulated if no column has its internally
 * reflected component from this world. */
enum pp_status pp_own_world_trace_one(const struct pp_own_worlds *worlds, int index,
                                      struct pp_report *report,
                                      const struct pp_study_options *options,
                                      bool *by_clock, struct pp_error *err);

/* Simulates all worlds. *finished, true at first, becomes false if a watch has stopped
 * the simulation. The remaining worlds then have no readings. */
enum pp_status pp_own_world_trace(struct pp_own_worlds *worlds,
                                  const struct pp_study_options *options,
                                  bool *finished, bool *by_clock, struct pp_error *err);

/* The report of world `index`. */
struct pp_report *pp_own_world_report(struct pp_own_worlds *worlds, int index);

/* Report of the world from which a column of the room's report has the component PP_SC,
 * PP_ERC or PP_IRC: a report with the column "traced" alone, or the room's own
 * report. */
const struct pp_report *pp_own_world_of(const struct pp_own_worlds *worlds,
                                        const struct pp_column *column,
                                        enum pp_component component);

#endif
