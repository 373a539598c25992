/* criterion_margin.h - margin by which a room meets a criterion: the least ratio of its
 * findings' figures to their bounds, or of the bounds to the figures for upper ones. 1
 * or more: all are met. Of a sampled figure its limit of 95 % counts. */
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

/* Margin of `world`, which is the room or a changed one, on the grid that assess would
 * judge it by. With `traced`, by its options
 * and by simulated daylight factors; else (NULL) by hand. No value, with the reason in
 * `why`, where a finding is not judged or none has a bound; and where daylight factors
 * have no part in it, and it was to be traced. */
enum pp_status pp_criterion_margin(struct pp_reading *reading, char *why,
                                   size_t why_bytes, const char *words,
                                   const struct pp_study_room *room,
                                   const struct pp_world *world,
                                   const struct pp_grid_choice *grid,
                                   const struct pp_study_options *traced,
                                   struct pp_error *err);

#endif
