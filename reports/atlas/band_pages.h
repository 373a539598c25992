/* band_pages.h - prints the compiled-in bands as Markdown. */
#ifndef PP_REPORTS_ATLAS_BAND_PAGES_H
#define PP_REPORTS_ATLAS_BAND_PAGES_H

#include <stdio.h>

/* Prints one section per method or pair of methods, with tables of regimes at points
 * and for the average. Daylight factors come first, then components. */
void pp_band_pages(FILE *out);

#endif
