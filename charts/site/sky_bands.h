/* sky_bands.h - four classes of the vertical sky component in drawings. Each class has
 * a colour, darker for less sky, so that the order is also visible in grey. */
#ifndef PP_CHARTS_SITE_SKY_BANDS_H
#define PP_CHARTS_SITE_SKY_BANDS_H

#include "charts/sheet/legend.h"
#include "model/results/sheets/site_sheet.h"

enum { PP_SKY_BANDS = PP_SITE_LEVELS + 1 };

/* Index of the class of a sky component; 0: the least sky. */
int pp_sky_bands_of(double component);

/* Sets the colour of a class. pale: for walls, as the background of windows. */
void pp_sky_bands_colour(cairo_t *cr, int band, bool pale);

/* True if text on this colour must be white. */
bool pp_sky_bands_is_dark(int band);

/* Fills PP_SKY_BANDS keys, beginning with the most sky: "27 % or more", ... */
void pp_sky_bands_keys(struct pp_key *keys);

/* True if the loss exceeds the guideline of [BR209]: the proposed value is under 27 %
 * and less than 0.8 of the existing value. */
bool pp_sky_bands_is_lost(const struct pp_site_window *window);

#endif
