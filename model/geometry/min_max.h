/* min_max.h - maximum, minimum and clamp of numbers, inline. If an argument is NaN,
 * pp_max and pp_min return the second one, unlike fmax and fmin. */
#ifndef PP_MODEL_GEOMETRY_MIN_MAX_H
#define PP_MODEL_GEOMETRY_MIN_MAX_H

static inline double pp_max(double a, double b)
{
    return a > b ? a : b;
}

static inline double pp_min(double a, double b)
{
    return a < b ? a : b;
}

/* Limits x to the range from low to high. */
static inline double pp_clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

#endif
