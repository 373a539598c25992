/* band.h - a range of daylight factors within which the true one lies in 95 of 100 rooms.
 */
#ifndef PP_MODEL_RESULTS_BAND_H
#define PP_MODEL_RESULTS_BAND_H

#include <math.h>
#include <stdbool.h>

/* Fractions of the open-sky horizontal illuminance; NAN where nothing is known. */
struct pp_band_ends {
    double low, high;
};

static inline struct pp_band_ends pp_band_none(void)
{
    return (struct pp_band_ends){NAN, NAN};
}

static inline bool pp_band_is_known(struct pp_band_ends band)
{
    return isfinite(band.low) && isfinite(band.high);
}

#endif
