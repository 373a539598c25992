/* criterion_margin.h - how much a room has of what a criterion asks for: the least of its
 * findings' figures over their bounds, or of the bounds over the figures where they are upper
 * ones. 1 or more: each is met.
 */
#ifndef PP_STUDIES_SIZING_CRITERION_MARGIN_H
#define PP_STUDIES_SIZING_CRITERION_MARGIN_H

#include <stdbool.h>

#include "model/results/reading.h"
#include "studies/study_options.h"
#include "studies/study_room.h"

/* Words are a criterion's name, and behind a colon how those of its findings begin that
 * count: "en17037:minimum"; without a colon all. PP_BAD_INPUT, with what there is, where
 * they name no criterion. */
enum pp_status pp_criterion_margin_check(const char *words, struct pp_error *err);

/* Margin of `world`, which is the room or a changed one. With `traced`, by its options
 * and by simulated daylight factors; else (NULL) by hand. No value, with the reason in
 * `why`, where a finding is not judged or none has a bound; and where daylight factors
 * have no part in it, and it was to be traced. */
enum pp_status pp_criterion_margin(struct pp_reading *reading, char *why,
                                   size_t why_bytes, const char *words,
                                   const struct pp_study_room *room,
                                   const struct pp_world *world,
                                   const struct pp_study_options *traced,
                                   struct pp_error *err);

#endif
