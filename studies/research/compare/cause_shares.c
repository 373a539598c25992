/* cause_shares.c - Shapley values, as sums over the subsets without a given member. A
 * subset of s other members has the weight s! (n - s - 1)! / n!. This is the fraction
 * of all orders of n members in which exactly this subset precedes the given member. */
#include "studies/research/compare/cause_shares.h"

static double weight(int before, int count)
{
    double weight = 1.0 / count; /* to be divided by binomial(count - 1, number of
                                  * members before) */
    for (int i = 0; i < before; i++)
        weight *= (i + 1.0) / (count - 1.0 - i);
    return weight;
}

void pp_cause_shares(double *shares, const double *done, int count)
{
    for (int member = 0; member < count; member++) {
        shares[member] = 0.0;
        for (int subset = 0; subset < 1 << count; subset++) {
            int before = 0;
            if (subset >> member & 1)
                continue;
            for (int i = 0; i < count; i++)
                before += subset >> i & 1;
            shares[member] +=
                weight(before, count) * (done[subset | 1 << member] - done[subset]);
        }
    }
}
