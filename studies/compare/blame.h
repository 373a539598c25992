/* blame.h - which suspects together explain a difference: the search over their sets.
 *
 * Of all sets of up to three suspects, no two of a kind, each has the probability
 *
 *     P(set) ~ density of the gap by (1) of likelihood.h x product over kinds
 *
 * where a kind is at work with a probability of 0.12 beforehand (a common factor of 0.4),
 * each of its suspects as likely as the next: of two sets that explain as much the
 * smaller is the likelier, by seven times and more.
 *
 * What a set does is traced; but not of all. Suspects are traced one by one; what several
 * do together is at first taken as the sum, in logarithms, of what they do alone and, where
 * pairs have been traced, of what these do beyond that. A set that may be among the likely
 * ones is traced before it is believed; those that never were are left out.
 *
 * A set with a suspect whose value is fitted, of which there is one, is traced with both
 * ends of the range and its middle; a parabola through these has the values between. The
 * value is the one that leaves least squares; its
 * prior is even over the range, by Laplace's approximation: sqrt(2 pi) times the value's
 * standard error, over the range.
 */
#ifndef PP_STUDIES_COMPARE_BLAME_H
#define PP_STUDIES_COMPARE_BLAME_H

#include <stdbool.h>

#include "studies/compare/likelihood.h"
#include "studies/compare/suspects.h"

enum { PP_BLAME_MOST = 3 };

struct pp_blame_set {
    int suspects[PP_BLAME_MOST]; /* by their place in the list, ascending */
    int count;
    double value; /* of its fitted suspect */
    double probability;
    struct pp_likelihood likelihood; /* of what it leaves */
};

struct pp_blame_question {
    struct pp_likelihood_data data;
    const struct pp_suspect *const *suspects;
    int suspect_count;

    /* What a set without a common factor does: effect[i] and variance[i] of a
     * pp_supposition. value: of its fitted suspect. PP_BAD_INPUT: it makes no sense
     * there. */
    enum pp_status (*trace)(void *tracer, const int *suspects, int count, double value,
                            double *effect, double *variance, struct pp_error *err);
    void *tracer;
    int traced_most; /* sets of several that are traced, at most */
};

struct pp_blame {
    struct pp_blame_set *sets; /* the likeliest first */
    int count;
    double probability[PP_SUSPECTS_MOST]; /* that a suspect is at work */
    /* Least root mean square (logarithm) that a traced set without the suspect leaves. */
    double without[PP_SUSPECTS_MOST];
    bool is_cut; /* there were more sets to be traced than traced_most */
};

/* sets: those with a probability of at least 0.001. */
enum pp_status pp_blame_find(struct pp_blame *blame,
                             const struct pp_blame_question *question,
                             struct pp_error *err);
void pp_blame_clear(struct pp_blame *blame);

#endif
