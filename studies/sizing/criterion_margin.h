/* criterion_margin.h - margin by which a room meets a criterion: the least ratio of its
 * findings' figures to their bounds (of the bounds to the figures, for upper bounds). 1
 * or more: all are met. A sampled figure counts with its 95 % limit. */
#ifndef PP_STUDIES_SIZING_CRITERION_MARGIN_H
#define PP_STUDIES_SIZING_CRITERION_MARGIN_H

#include <stdbool.h>

#include "model/results/reading.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Checks the words: a criterion's name, optionally followed by a colon and the
 * beginning of its findings that count: "en17037:minimum"; without a colon all count.
 * PP_BAD_INPUT, with the valid names, if they name no criterion. */
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
