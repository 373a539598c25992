/* band_regime.h - a regime of rooms and points, and the band of the ratio of
 * simulated to hand figures in it.
 *
 * A regime is defined by conditions on features, numbers that are known of a
 * room and a point without simulation. The ratio has an offset a: for large
 * figures it is their ratio, for figures small against a their difference over
 * a:
 *
 *     q = (truth + a) / (hand + a)                                               (1)
 */
#ifndef PP_STUDIES_BANDS_BAND_REGIME_H
#define PP_STUDIES_BANDS_BAND_REGIME_H

#include <stdbool.h>

enum { PP_BAND_CONDITIONS = 5 };

/* from <= feature < to; the ends may be infinite. A feature that is NAN is below every
 * bound. */
struct pp_band_condition {
    int feature; /* number of the feature */
    double from, to;
};

/* Quantiles of a ratio: of 2.5 %, 50 % and 97.5 %. */
struct pp_band_quantiles {
    double low, median, high;
};

struct pp_band_regime {
    struct pp_band_condition conditions[PP_BAND_CONDITIONS];
    int condition_count; /* 0: all rooms and points */
    struct pp_band_quantiles ratio;
    int rooms; /* number of rooms that it was fitted to */
};

/* True if a point's features fit the regime. */
bool pp_band_regime_holds(const struct pp_band_regime *regime, const double *features);

/* True value that a hand figure and a ratio (1) give, at least 0; both fractions. */
double pp_band_regime_truth(double hand, double ratio, double offset);

/* The ratio (1). */
double pp_band_regime_ratio(double truth, double hand, double offset);

#endif
