/* set_effects.h - effects of sets of causes: simulated, or predicted from their parts.
 *
 * No set here contains a common factor. A set is specified by its causes, in ascending
 * order, and a fitted value by its level, 0 to 1 over its range.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_SET_EFFECTS_H
#define PP_STUDIES_RESEARCH_COMPARE_SET_EFFECTS_H

#include "studies/research/compare/cause_search.h"

struct pp_known_set;

struct pp_set_effects {
    const struct pp_cause_search_question *question; /* not owned */
    struct pp_known_set *known;                      /* the simulated sets */
    int known_count;
    double *effect, *variance, *slack; /* last prediction, one value for each point;
                                        * slack: its uncertainty */
};

enum pp_status pp_set_effects_init(struct pp_set_effects *effects,
                                   const struct pp_cause_search_question *question,
                                   struct pp_error *err);
void pp_set_effects_clear(struct pp_set_effects *effects);

/* Simulates a set. A set that is not possible is stored as impossible, and PP_OK is
 * returned. */
enum pp_status pp_set_effects_trace(struct pp_set_effects *effects, const int *causes,
                                    int count, struct pp_error *err);

bool pp_set_effects_are_known(const struct pp_set_effects *effects, const int *causes,
                              int count);

/* True if the set has a cause whose value is fitted. */
bool pp_set_effects_has_fitted(const struct pp_set_effects *effects, const int *causes,
                               int count);

/* Sets effect and variance to the effect of the set. If the set is not simulated, its
 * effect is predicted from its parts. The effects of its pairs are then assumed to
 * deviate from the sums of single effects by `off` (-1 to 1) times the greatest
 * deviation, and slack is the uncertainty. False if the set is not possible. */
bool pp_set_effects_predict(struct pp_set_effects *effects, const int *causes,
                            int count, double off, double level);

/* Moves the prediction towards the gap, by at most its uncertainty. */
void pp_set_effects_lean(struct pp_set_effects *effects);

/* Sum of squares of the gap that remains after the set; with a common factor, relative
 * to the mean of this remainder. */
double pp_set_effects_left(struct pp_set_effects *effects, const int *causes, int count,
                           bool has_factor, double level);

/* Level with the least sum of squares. *width: width of the likelihood around this
 * level, relative to the range, at most 1. */
double pp_set_effects_fit(struct pp_set_effects *effects, const int *causes, int count,
                          bool has_factor, double *width);

/* Greatest possible deviation of a pair's effect from the sum of both effects, in
 * proportion to the smaller effect at each point. 0 if the pair is simulated. */
double pp_set_effects_unknown(const struct pp_set_effects *effects, const int pair[2],
                              double level);

#endif
