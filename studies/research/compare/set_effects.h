/* set_effects.h - what sets of causes do: traced, or predicted from their parts.
 *
 * All sets here are without common factors. A set is given by its causes, ascending. A
 * fitted value is given by its level, 0 to 1 over its range.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_SET_EFFECTS_H
#define PP_STUDIES_RESEARCH_COMPARE_SET_EFFECTS_H

#include "studies/research/compare/cause_search.h"

struct pp_known_set;

struct pp_set_effects {
    const struct pp_cause_search_question *question; /* not owned */
    struct pp_known_set *known;                      /* the sets that are traced */
    int known_count;
    double *effect, *variance, *slack; /* the last prediction, one a point */
};

enum pp_status pp_set_effects_init(struct pp_set_effects *effects,
                                   const struct pp_cause_search_question *question,
                                   struct pp_error *err);
void pp_set_effects_clear(struct pp_set_effects *effects);

/* Traces a set. PP_OK for one that makes no sense, too, which is then known as such. */
enum pp_status pp_set_effects_trace(struct pp_set_effects *effects, const int *causes,
                                    int count, struct pp_error *err);

bool pp_set_effects_are_known(const struct pp_set_effects *effects, const int *causes,
                              int count);

/* True if the set has a cause whose value is fitted. */
bool pp_set_effects_has_fitted(const struct pp_set_effects *effects, const int *causes,
                               int count);

/* Fills effect and variance with the effect of the set. If it is not simulated, it is
 * predicted from its parts, with its pairs off from their sums by the share `off` of
 * the greatest deviation, -1 to 1; slack is the uncertainty. False if the set makes no
 * sense. */
bool pp_set_effects_predict(struct pp_set_effects *effects, const int *causes,
                            int count, double off, double level);

/* Moves the prediction as near to the gap as it may be wrong. */
void pp_set_effects_lean(struct pp_set_effects *effects);

/* Sum of squares of the gap that the set leaves, about the mean if there is a common
 * factor. */
double pp_set_effects_left(struct pp_set_effects *effects, const int *causes, int count,
                           bool has_factor, double level);

/* The level of least squares; *width: of its likelihood, over the range, at most 1. */
double pp_set_effects_fit(struct pp_set_effects *effects, const int *causes, int count,
                          bool has_factor, double *width);

/* Greatest possible deviation of a pair from the sum of both: in proportion to the
 * smaller at each point. 0: it is simulated. */
double pp_set_effects_unknown(const struct pp_set_effects *effects, const int pair[2],
                              double level);

#endif
