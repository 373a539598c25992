/* compare.h - compares another program's values with ours, and finds the causes of the
 * difference.
 *
 * Our values are simulated once. Any number of other values at the same points can then
 * be explained. The effect of a cause is simulated when it is first needed, and stored.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_COMPARE_H
#define PP_STUDIES_RESEARCH_COMPARE_COMPARE_H

#include "studies/research/compare/cause_search.h"
#include "studies/research/compare/compare_subject.h"
#include "studies/research/compare/left_over.h"

enum { PP_COMPARE_POINTS_MOST = 48, PP_COMPARE_LISTED_MOST = 6 };

struct pp_compare_options {
    struct pp_room_variant
        variant; /* variant of the room from which the search starts */
    struct pp_variant_tracing tracing;
    double noise;    /* stated noise of the other program (logarithm); 0: not known */
    int traced_most; /* most sets of several causes to simulate for one explanation;
                      * 0: 40 */
};

/* Results of a comparison. Arrays have one value for each point; values are
 * fractions. */
struct pp_compared {
    int count;
    const double *ours, *errors; /* owned by the comparison */
    double *theirs;
    double *explained; /* our values with the most likely set */
    struct pp_cause_search search;

    /* Number of listed sets, search.sets[0] to search.sets[listed - 1]: the most likely
     * ones, up to a total probability of 98 % or as many as fit. */
    int listed;

    double gap;               /* mean of ln((their value + c)/(our value + c)), for c
                               * see likelihood.h */
    double gap_rms;           /* root mean square of these logarithms */
    double left, left_rms;    /* the same with `explained` in place of our values */
    struct pp_left_over over; /* test of the remainder against the other program's
                               * noise */
    /* Effects of the causes of the most likely set, averaged over the orders in which
     * causes can be added. effects: effect of each cause on the mean (logarithm).
     * shares: its share of the gap's sum of squares; the shares, including that of the
     * remainder, add up to 1. */
    double effects[PP_CAUSE_SEARCH_MOST], shares[PP_CAUSE_SEARCH_MOST];
    double factor; /* the common factor of the most likely set; 1 if it has none */
};

struct pp_compare;

/* The subject's pointers must outlive the comparison. PP_BAD_INPUT if there are more
 * points than PP_COMPARE_POINTS_MOST. */
enum pp_status pp_compare_create(struct pp_compare **compare,
                                 const struct pp_compare_subject *subject,
                                 const struct pp_compare_options *options,
                                 struct pp_error *err);
void pp_compare_destroy(struct pp_compare *compare); /* NULL is allowed */

int pp_compare_causes(const struct pp_compare *compare,
                      const struct pp_cause *const **list);

/* Our values, with their standard errors; owned by the comparison. */
const double *pp_compare_ours(const struct pp_compare *compare, const double **errors);

/* theirs: fractions, 0 or more, at least one above 0. */
enum pp_status pp_compare_explain(struct pp_compared *compared,
                                  struct pp_compare *compare, const double *theirs,
                                  struct pp_error *err);
void pp_compare_clear(struct pp_compared *compared);

/* Limit (logarithm) of the other program's noise. If the noise is larger, no cause is
 * certain. A cause is certain only if the remainder without it is larger than this
 * limit. Unlisted mistakes in reflectances or dimensions can be this large; smaller
 * differences between sets of causes therefore prove nothing. */
#define PP_COMPARE_HIDES 0.05

/* True if the cause (index in the list) is certain. Its probability is then at least 98
 * %. The other program's noise is below PP_COMPARE_HIDES and explains the remainder.
 * Every set without the cause leaves a remainder of more than PP_COMPARE_HIDES. */
bool pp_compare_is_sure(const struct pp_compared *compared, int cause);

#endif
