/* cause_search.h - searches for the sets of causes that together explain a difference.
 *
 * The search covers all sets of up to three causes, no two of a kind. A set's
 * probability is
 *
 *     P(set) ~ density of the gap by (1) of likelihood.h x priors of its kinds
 *
 * The prior probability of a kind is 0.12 (0.4 for a common factor), shared equally by
 * its causes. If two sets explain the difference equally well, the smaller one is at
 * least seven times as likely, or 1.5 times if the larger one adds only a common
 * factor.
 *
 * The effect of each single cause is simulated. The effect of a set is first estimated
 * as the sum, in logarithms, of its single effects and of the extra effects of its
 * pairs that have been simulated. A set that may be among the likely ones is then
 * simulated itself. Sets that are never simulated are left out.
 *
 * One cause has a fitted value. A set with this cause is traced with both ends and the
 * middle of the value's range; values between are interpolated by a parabola. The value
 * with the least sum of squares is used. Its prior is uniform over the range. The
 * evidence follows from Laplace's approximation: sqrt(2 pi) times the value's standard
 * error, divided by the range.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_CAUSE_SEARCH_H
#define PP_STUDIES_RESEARCH_COMPARE_CAUSE_SEARCH_H

#include <stdbool.h>

#include "studies/research/compare/causes.h"
#include "studies/research/compare/likelihood.h"

enum { PP_CAUSE_SEARCH_MOST = 3 };

struct pp_cause_set {
    int causes[PP_CAUSE_SEARCH_MOST]; /* indices in the list of causes, ascending */
    int count;
    double value; /* value of the fitted cause of the set */
    double probability;
    struct pp_likelihood likelihood; /* likelihood of the remainder after the set */
};

struct pp_cause_search_question {
    struct pp_likelihood_data data;
    const struct pp_cause *const *causes;
    int cause_count;

    /* Simulates the effect of a set without a common factor: effect[i] and variance[i]
     * of a pp_supposition. value: value of the set's fitted cause. PP_BAD_INPUT if the
     * set is not possible in this room or scene. */
    enum pp_status (*trace)(void *tracer, const int *causes, int count, double value,
                            double *effect, double *variance, struct pp_error *err);
    void *tracer;
    int traced_most; /* most sets of several causes to simulate */
};

struct pp_cause_search {
    struct pp_cause_set *sets; /* the most likely first */
    int count;
    double probability[PP_CAUSES_MOST]; /* probability that each cause is present */
    /* Least root mean square (logarithm) of the remainder after any simulated set
     * without the cause. */
    double without[PP_CAUSES_MOST];
    bool is_cut; /* more than traced_most sets should have been simulated */
};

/* Finds the likely sets. sets: those with a probability of at least 0.001. */
enum pp_status pp_cause_search_find(struct pp_cause_search *found,
                                    const struct pp_cause_search_question *question,
                                    struct pp_error *err);
void pp_cause_search_clear(struct pp_cause_search *found);

#endif
