/* own_world.h - the worlds that hand methods have in mind, where these are not the room's.
 *
 * A method's error is the sum of two, the assumption's and the formula's:
 *
 *     method - room = (own - room) + (method - own)
 *
 * room is traced in the room as it is, own in the world that the method calculates in:
 *
 *     direct methods       the ground open, lit by the whole sky everywhere; all else as
 *                          the room has it
 *     others               the ground open, of the reflectance that is built into the
 *                          method (pp_method.own_ground), or of the room's; for what
 *                          stands outside, the skylines of own_skylines.h
 *     of_real_room         the room as it is, to which they were fitted
 *     a pair A+B           SC and ERC of A's world, IRC of B's
 *
 * The sky component depends on what stands outside alone, so that a world with another
 * ground has the room's. Worlds that come out alike are one, and one that is the room's
 * is not made. All are traced with one seed, so that light paths that meet nothing of the
 * difference are the same in both, and own - room is less noisy than its standard error,
 * which is that of independent figures.
 */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_OWN_WORLD_H
#define PP_STUDIES_RESEARCH_VALIDATION_OWN_WORLD_H

#include "model/results/report.h"
#include "model/room/building.h"
#include "studies/study_options.h"

/* Worlds of all columns of a report. */
struct pp_own_worlds;

/* The worlds of the report's columns. room: the description of the report's world. The
 * report must outlive them. */
enum pp_status pp_own_world_list(struct pp_own_worlds **worlds,
                                 const struct pp_room *room,
                                 const struct pp_report *report, struct pp_error *err);
void pp_own_world_destroy(struct pp_own_worlds *worlds); /* NULL is allowed */

int pp_own_world_count(const struct pp_own_worlds *worlds);

/* Simulates one of them into its report, or into one of the same world, at the points
 * of the room's report, as pp_study_report_traced does for the room. Only direct light
 * is simulated if no column has its internally reflected component from that world. */
enum pp_status pp_own_world_trace_one(const struct pp_own_worlds *worlds, int index,
                                      struct pp_report *report,
                                      const struct pp_study_options *options,
                                      bool *by_clock, struct pp_error *err);

/* Simulates all of them. *finished, true at first, becomes false if a watch stopped it;
 * the rest then has no readings. */
enum pp_status pp_own_world_trace(struct pp_own_worlds *worlds,
                                  const struct pp_study_options *options,
                                  bool *finished, bool *by_clock, struct pp_error *err);

/* The report of world `index`. */
struct pp_report *pp_own_world_report(struct pp_own_worlds *worlds, int index);

/* Report of the world in which a column of the room's report has the component PP_SC,
 * PP_ERC or PP_IRC: with "traced" alone, or the room's own. */
const struct pp_report *pp_own_world_of(const struct pp_own_worlds *worlds,
                                        const struct pp_column *column,
                                        enum pp_component component);

#endif
