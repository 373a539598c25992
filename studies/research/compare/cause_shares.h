/* cause_shares.h - each one's share of what several do together, where they interact. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_CAUSE_SHARES_H
#define PP_STUDIES_RESEARCH_COMPARE_CAUSE_SHARES_H

/* Shapley's value: what each adds, averaged over all orders in which they may come.
 * done[subset]: what a subset does, by the bits of its members, 2^count of them; count up
 * to 16. The shares' sum is what all do less what none does. */
void pp_cause_shares(double *shares, const double *done, int count);

#endif
