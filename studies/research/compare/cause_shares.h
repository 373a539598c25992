/* cause_shares.h - share of each cause in the effect of several that interact. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_CAUSE_SHARES_H
#define PP_STUDIES_RESEARCH_COMPARE_CAUSE_SHARES_H

/* Shapley value: the mean contribution of each cause over all orders in which causes
 * can be added. done[subset]: effect of the subset whose members are the bits of the
 * index, 2^count values; count up to 16. The shares sum to the effect of all causes
 * less that of none. */
void pp_cause_shares(double *shares, const double *done, int count);

#endif
