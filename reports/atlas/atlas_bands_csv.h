/* atlas_bands_csv.h - the bands of an atlas in the format of tables/atlas_bands.csv,
 * which is compiled into the program. */
#ifndef PP_REPORTS_ATLAS_ATLAS_BANDS_CSV_H
#define PP_REPORTS_ATLAS_ATLAS_BANDS_CSV_H

#include <stdio.h>

#include "studies/bands/atlas_bands.h"

/* Writes one line for the span of each feature, then one line for each regime of each
 * column. */
void pp_atlas_bands_csv(const struct pp_atlas_bands *bands, FILE *out);

#endif
