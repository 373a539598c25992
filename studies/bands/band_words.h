/* band_words.h - features and regimes in words. */
#ifndef PP_STUDIES_BANDS_BAND_WORDS_H
#define PP_STUDIES_BANDS_BAND_WORDS_H

#include <stddef.h>

#include "studies/bands/band_features.h"
#include "studies/bands/band_regime.h"

/* Name of a feature for readers, such as "ratio of room depth to window head height".
 * Static string. */
const char *pp_band_words_feature(int feature);

/* Writes the conditions of a regime, such as "mean reflectance 0.3 to 0.5, share of the
 * sky component under 0.3"; "all" for a regime without conditions. */
void pp_band_words_regime(char *text, size_t size, const struct pp_band_regime *regime);

#endif
