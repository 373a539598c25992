/* compare.h - compares another program's values with ours, and finds the causes of the
 * difference.
 *
 * Our values are simulated once; then any number of other values at the same points can
 * be explained. Effects of causes are simulated when first needed, and kept.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_COMPARE_H
#define PP_STUDIES_RESEARCH_COMPARE_COMPARE_H

#include "studies/research/compare/cause_search.h"
#include "studies/research/compare/compare_subject.h"
#include "studies/research/compare/left_over.h"

enum { PP_COMPARE_POINTS_MOST = 48, PP_COMPARE_LISTED_MOST = 6 };

struct pp_compare_options {
    struct pp_room_variant
        variant; /* variant of our values before causes are searched */
    struct pp_variant_tracing tracing;
    double noise;    /* stated noise of the other program (logarithm); 0: not known */
    int traced_most; /* most sets of several causes to simulate for one explanation;
                      * 0: 40 */
};

/* Results of a comparison. Arrays have a value a point, fractions. */
struct pp_compared {
    int count;
    const double *ours, *errors; /* not owned: the comparison's */
    double *theirs;
    double *explained; /* our values with the likeliest set */
    struct pp_cause_search search;

    /* Number of listed sets, search.sets[0] to search.sets[listed - 1]: the likeliest
     * ones, up to a total probability of 98 % or as many as fit. */
    int listed;

    double gap;               /* mean of theirs over ours, less 1; logarithmic mean */
    double gap_rms;           /* root mean square of the gap, logarithms */
    double left, left_rms;    /* gap and gap_rms with the likeliest set included */
    struct pp_left_over over; /* test of the remainder against the other program's
                               * noise */
    /* Effects of the causes of the most likely set, averaged over orders: the effect of
     * each on the mean (logarithm), and its share of the sum of squares of the gap,
     * which total 1. */
    double effects[PP_CAUSE_SEARCH_MOST], shares[PP_CAUSE_SEARCH_MOST];
    double factor; /* the common factor, if the likeliest set has it; else 1 */
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

/* Noise (logarithm) from which no cause is certain. The remainder without a certain
 * cause must be at least as large. Unlisted mistakes in reflectances or dimensions can
 * be of this size, and so decide between sets whose remainders differ by less. */
#define PP_COMPARE_HIDES 0.05

/* True if the cause (index in the list) is certain: its probability is at least 98 %,
 * the remainder is explained by the other program's noise, this noise is below
 * PP_COMPARE_HIDES, and all sets without the cause leave more than that. */
bool pp_compare_is_sure(const struct pp_compared *compared, int cause);

#endif
