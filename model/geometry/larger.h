/* larger.h - the larger and the smaller of two numbers where they are asked for millions of
 * times: instructions in place of the calls of fmax and fmin, which leave out what is no
 * number, as these do not. */
#ifndef PP_MODEL_GEOMETRY_LARGER_H
#define PP_MODEL_GEOMETRY_LARGER_H

static inline double pp_larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double pp_smaller(double a, double b)
{
    return a < b ? a : b;
}

/* The nearest to x from `low` to `high`. */
static inline double pp_within(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

#endif
