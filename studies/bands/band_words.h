/* band_words.h - features and regimes in words. */
#ifndef PP_STUDIES_BANDS_BAND_WORDS_H
#define PP_STUDIES_BANDS_BAND_WORDS_H

#include <stddef.h>

#include "studies/bands/band_features.h"
#include "studies/bands/band_regime.h"

/* "the depth of the room over the head of its window"; static. */
const char *pp_band_words_feature(int feature);

/* "the point's depth over the head 1.2 to 2.4, the sky's share under 0.3"; "all" of a
 * regime without conditions. */
void pp_band_words_regime(char *text, size_t size, const struct pp_band_regime *regime);

#endif
