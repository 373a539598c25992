/* band_regime.h - a regime of rooms and points, and the band of the ratio of simulated
 * value to hand value in that regime.
 *
 * A regime is defined by conditions on features, which are properties of a room and a
 * point that are known without simulation. The ratio q has an offset a. For values much
 * greater than a, q is their ratio; for values much smaller than a, q - 1 is their
 * difference divided by a:
 *
 *     q = (truth + a) / (hand + a)                                               (1)
 */
#ifndef PP_STUDIES_BANDS_BAND_REGIME_H
#define PP_STUDIES_BANDS_BAND_REGIME_H

#include <stdbool.h>

enum { PP_BAND_CONDITIONS = 5 };

/* Condition from <= feature < to. The limits may be infinite. A feature that is NAN is
 * below every limit. */
struct pp_band_condition {
    int feature; /* index of the feature */
    double from, to;
};

/* The 2.5 %, 50 % and 97.5 % quantiles of a ratio. */
struct pp_band_quantiles {
    double low, median, high;
};

struct pp_band_regime {
    struct pp_band_condition conditions[PP_BAND_CONDITIONS];
    int condition_count; /* 0: the regime contains all rooms and points */
    struct pp_band_quantiles ratio;
    int rooms; /* number of rooms to which the band was fitted */
};

/* True if the features of a point satisfy the conditions of the regime. */
bool pp_band_regime_holds(const struct pp_band_regime *regime, const double *features);

/* True value from a hand value and the ratio (1), at least 0. Both values are
 * fractions. */
double pp_band_regime_truth(double hand, double ratio, double offset);

/* Ratio (1) of a true value and a hand value. */
double pp_band_regime_ratio(double truth, double hand, double offset);

#endif
