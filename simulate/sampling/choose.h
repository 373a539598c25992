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

/* The one that u in [0, 1) falls to, of any number, by an importance each, and its
 * probability; -1 where none is above 0. Each is asked twice, with `of` handed on; those above
 * 0 are raised by the share `evenly` of their sum, in equal parts. */
static inline int pp_choose(double (*importance)(const void *of, int i), const void *of,
                            int count, double evenly, double u, double *probability)
{
    double total = 0.0;
    int some = 0, chosen = -1;
    for (int i = 0; i < count; i++) {
        double share = importance(of, i);
        total += share;
        some += share > 0.0;
    }
    double raise = some > 0 ? evenly * total / some : 0.0;
    total += some * raise;
    double left = u * total;
    for (int i = 0; i < count; i++) {
        double share = importance(of, i);
        if (!(share > 0.0))
            continue;
        share += raise;
        chosen = i;
        *probability = share / total;
        if (left < share)
            break;
        left -= share;
    }
    return chosen;
}

/* Guesses may be wrong: they are raised by this share of their sum. By guesses alone a window
 * that brought 7 % of a point's light, under a clear sky, had half a per cent of the
 * directions; and of 6,400 values in 40 random rooms 14 were more than four of their standard
 * errors off, with this 3. */
#define PP_CHOOSE_EVENLY 0.1

static inline double pp_choose_guess(const void *guesses, int i)
{
    return ((const double *)guesses)[i];
}

/* The same by guesses that are known. */
static inline int pp_choose_guessed(const double *guesses, int count, double u,
                                    double *probability)
{
    return pp_choose(pp_choose_guess, guesses, count, PP_CHOOSE_EVENLY, u, probability);
}

#endif
