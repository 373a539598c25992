/* atlas_bands_text.h - results of testing the bands of an atlas on rooms that were not
 * used to fit them. */
#ifndef PP_REPORTS_ATLAS_ATLAS_BANDS_TEXT_H
#define PP_REPORTS_ATLAS_ATLAS_BANDS_TEXT_H

#include <stdio.h>

#include "studies/bands/atlas_bands.h"

/* Prints one line for each column and, below it, one for each regime. The line of a
 * regime states the numbers of rooms fitted and tested, and the fraction of tested
 * rooms inside the band. The permitted deviation of this fraction from 95 % and the
 * verdict follow. */
void pp_atlas_bands_text(const struct pp_atlas_bands *bands, FILE *out);

#endif
