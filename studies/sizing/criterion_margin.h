/* criterion_margin.h - margin by which a room meets a criterion: the least ratio of the
 * figures of its findings to their bounds (for upper bounds, of the bounds to the
 * figures). 1 or more: all findings are met. A sampled figure is replaced by its
 * one-sided 95 % limit. */
#ifndef PP_STUDIES_SIZING_CRITERION_MARGIN_H
#define PP_STUDIES_SIZING_CRITERION_MARGIN_H

#include <stdbool.h>

#include "model/results/reading.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Checks the words of a request: the name of a criterion, optionally followed by a
 * colon and the beginning of the findings that count ("en17037:minimum"); without a
 * colon all findings count. PP_BAD_INPUT, with the valid names, if the words name no
 * criterion. */
enum pp_status pp_criterion_margin_check(const char *words, struct pp_error *err);

/* Margin of `world`, the room or a changed one, on the same grid as assess.
 * traced: options for simulated daylight factors; NULL: by hand methods. No
 * value, with the reason in `why`, if a finding is not judged or none has a
 * bound, or if simulation is requested for a criterion without daylight
 * factors. */
enum pp_status pp_criterion_margin(struct pp_reading *reading, char *why,
                                   size_t why_bytes, const char *words,
                                   const struct pp_study_room *room,
                                   const struct pp_world *world,
                                   const struct pp_grid_choice *grid,
                                   const struct pp_study_options *traced,
                                   struct pp_error *err);

#endif
