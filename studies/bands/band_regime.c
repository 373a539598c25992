/* band_regime.c - tests the conditions of a regime, and converts values to ratios and
 * back. */
#include "studies/bands/band_regime.h"

#include <math.h>

bool pp_band_regime_holds(const struct pp_band_regime *regime, const double *features)
{
    for (int i = 0; i < regime->condition_count; i++) {
        const struct pp_band_condition *condition = &regime->conditions[i];
        double value = features[condition->feature];
        bool from = condition->from == -INFINITY || value >= condition->from;
        bool to = condition->to == INFINITY || !(value >= condition->to);
        if (!from || !to)
            return false;
    }
    return true;
}

double pp_band_regime_truth(double hand, double ratio, double offset)
{
    return fmax((hand + offset) * ratio - offset, 0.0);
}

double pp_band_regime_ratio(double truth, double hand, double offset)
{
    return (truth + offset) / (hand + offset);
}
