/* room_cases.h - the results for a user's room as cases: each method compared with the
 * simulation, and the simulation compared with Radiance. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_ROOM_CASES_H
#define PP_STUDIES_RESEARCH_VALIDATION_ROOM_CASES_H

#include "studies/research/validation/known_case.h"
#include "studies/research/validation/own_world.h"

/* Adds a case for every result of the report's hand methods, at points and for the
 * average, for which the report has a simulated value of the component. The limit is
 * the result's band in the report, widened by three standard errors of the simulated
 * value. For a result h with the band from a to b, and the standard error s:
 *
 *     h - b - 3 s  <=  h - traced  <=  h - a + 3 s
 *
 * Without a band there is no verdict. The cases refer to names and sentences of the
 * report; the report and `file` must outlive them. */
void pp_room_cases_of_methods(struct pp_known_cases *cases, const char *file,
                              const struct pp_report *report,
                              const struct pp_own_worlds *worlds);

/* Adds a case for every daylight factor by an engine, at points and for the average,
 * compared with the first engine that is a reference (engine.h). The limit is three
 * standard errors of the difference, plus 2 % of the reference if the engine itself is
 * not a reference. An interpolated value, whose error is unknown, is left out. */
void pp_room_cases_of_engines(struct pp_known_cases *cases, const char *file,
                              const struct pp_report *report);

/* Adds the daylight factors at one point, in the room's group. The limit is three
 * standard errors of the difference or 1 % of Radiance's result, whichever is larger.
 * `world` and `file` must outlive the case. */
void pp_room_cases_of_radiance(struct pp_known_cases *cases, const char *file,
                               const struct pp_world *world, struct pp_vec3 position,
                               struct pp_reading traced, struct pp_reading radiance);

#endif
