/* choose.h - one of several at random, with probabilities in proportion to
 * importances. */
#ifndef PP_SIMULATE_SAMPLING_CHOOSE_H
#define PP_SIMULATE_SAMPLING_CHOOSE_H

/* The one of `count` weights that `left`, from 0 to below their sum, falls to; -1 where
 * none is above 0. */
static inline int pp_choose_by(const double *weights, int count, double left)
{
    int chosen = -1;
    for (int i = 0; i < count; i++) {
        if (!(weights[i] > 0.0))
            continue;
        chosen = i;
        if (left < weights[i])
            break;
        left -= weights[i];
    }
    return chosen;
}

/* The one that u in [0, 1) falls to, and its probability; -1 where none is above 0. */
static inline int pp_choose_weighted(const double *weights, int count, double u,
                                     double *probability)
{
    double total = 0.0;
    for (int i = 0; i < count; i++)
        total += weights[i];
    int chosen = pp_choose_by(weights, count, u * total);
    if (chosen >= 0)
        *probability = weights[chosen] / total;
    return chosen;
}

/* The same of any number, by an importance each, which is asked twice of each, with `of`
 * handed on. */
static inline int pp_choose(double (*importance)(const void *of, int i), const void *of,
                            int count, double u, double *probability)
{
    double total = 0.0;
    for (int i = 0; i < count; i++)
        total += importance(of, i);
    double left = u * total;
    int chosen = -1;
    for (int i = 0; i < count; i++) {
        double share = importance(of, i);
        if (!(share > 0.0))
            continue;
        chosen = i;
        *probability = share / total;
        if (left < share)
            break;
        left -= share;
    }
    return chosen;
}

#endif
