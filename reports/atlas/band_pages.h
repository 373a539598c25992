/* band_pages.h - the compiled-in bands, as Markdown. */
#ifndef PP_REPORTS_ATLAS_BAND_PAGES_H
#define PP_REPORTS_ATLAS_BAND_PAGES_H

#include <stdio.h>

/* Prints Markdown: one section per method or pair, with tables of its regimes at points
 * and for the average; daylight factors first, then components. */
void pp_band_pages(FILE *out);

#endif
