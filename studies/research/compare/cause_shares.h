/* cause_shares.h - share of each cause in the joint effect of causes that interact. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_CAUSE_SHARES_H
#define PP_STUDIES_RESEARCH_COMPARE_CAUSE_SHARES_H

/* Shapley values: the mean contribution of each cause over all orders in which the
 * causes can be added. done[subset]: effect of a subset of the causes; bit i of the
 * index is set if cause i is a member; 2^count values. count: up to 16. The shares add
 * up to the effect of all causes less the effect of none. */
void pp_cause_shares(double *shares, const double *done, int count);

#endif
