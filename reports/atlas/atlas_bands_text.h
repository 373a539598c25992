/* atlas_bands_text.h - test of an atlas's bands on rooms that were not used to fit
 * them. */
#ifndef PP_REPORTS_ATLAS_ATLAS_BANDS_TEXT_H
#define PP_REPORTS_ATLAS_ATLAS_BANDS_TEXT_H

#include <stdio.h>

#include "studies/bands/atlas_bands.h"

/* Prints a line for each column, and below it one for each regime: rooms fitted and
 * tested, the share of tested rooms in the band, its tolerated distance from 95 %, and
 * the verdict. */
void pp_atlas_bands_text(const struct pp_atlas_bands *bands, FILE *out);

#endif
