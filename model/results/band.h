/* band.h - likely range of a daylight factor: it contains the true value in 95 of 100
 * similar rooms. */
#ifndef PP_MODEL_RESULTS_BAND_H
#define PP_MODEL_RESULTS_BAND_H

#include <math.h>
#include <stdbool.h>

/* Fractions of the open-sky horizontal illuminance; NAN: not known. */
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
