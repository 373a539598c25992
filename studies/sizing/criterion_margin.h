/* criterion_margin.h - margin by which a room meets a criterion. The margin is the
 * least ratio of figure to target over its findings; for upper limits the ratio is
 * target to figure. All findings are met if the margin is 1 or more. A sampled figure
 * is replaced by its one-sided 95 % limit. */
#ifndef PP_STUDIES_SIZING_CRITERION_MARGIN_H
#define PP_STUDIES_SIZING_CRITERION_MARGIN_H

#include <stdbool.h>

#include "model/results/reading.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Checks the words of a request: the name of a criterion, optionally followed by a
 * colon and the beginning of the names of findings to be considered
 * ("en17037:minimum"). Without a colon, all findings are considered. PP_BAD_INPUT if
 * there is no such criterion (the message lists the valid names), if it needs a
 * simulated year, or if the words contain a comma. */
enum pp_status pp_criterion_margin_check(const char *words, struct pp_error *err);

/* Calculates the margin of `world` (the room, or a changed copy of it) on the same grid
 * as assess. traced: options for simulated daylight factors; NULL: hand methods. The
 * reading has no value, and `why` is the reason, if a finding cannot be assessed or
 * none has a target. If simulation is requested for a criterion without daylight
 * factors, the reading has no value and `why` is empty. */
enum pp_status pp_criterion_margin(struct pp_reading *reading, char *why,
                                   size_t why_bytes, const char *words,
                                   const struct pp_study_room *room,
                                   const struct pp_world *world,
                                   const struct pp_grid_choice *grid,
                                   const struct pp_study_options *traced,
                                   struct pp_error *err);

#endif
