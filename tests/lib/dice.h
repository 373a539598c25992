/* dice.h - random numbers for tests with random cases: one seed per case, so that a
 * single case can be repeated. */
#ifndef PP_TESTS_LIB_DICE_H
#define PP_TESTS_LIB_DICE_H

#include <stdbool.h>
#include <stdint.h>

struct dice {
    uint64_t state;
};

static inline double between(struct dice *dice, double low, double high)
{
    uint64_t x = (dice->state += 0x9e3779b97f4a7c15u);
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * (double)((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

static inline bool one_in(struct dice *dice, int n)
{
    return between(dice, 0.0, n) < 1.0;
}

#endif
