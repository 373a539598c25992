/* sky_bands.c - see sky_bands.h. */
#include "charts/site/sky_bands.h"

#include <math.h>
#include <stdio.h>

static const double colours[PP_SKY_BANDS][3] = {
    {0.36, 0.25, 0.52}, {0.80, 0.42, 0.45}, {0.97, 0.72, 0.42}, {1.00, 0.94, 0.68}};

int pp_sky_bands_of(double component)
{
    int band = 0;
    while (band < PP_SITE_LEVELS && component >= pp_site_sheet_levels[band])
        band++;
    return band;
}

void pp_sky_bands_colour(cairo_t *cr, int band, bool pale)
{
    double white = pale ? 0.6 : 0.0, rgb[3];
    for (int k = 0; k < 3; k++)
        rgb[k] = white + (1.0 - white) * colours[band][k];
    cairo_set_source_rgb(cr, rgb[0], rgb[1], rgb[2]);
}

bool pp_sky_bands_is_dark(int band)
{
    return band == 0;
}

void pp_sky_bands_keys(struct pp_key *keys)
{
    for (int i = 0; i < PP_SKY_BANDS; i++) {
        int band = PP_SKY_BANDS - 1 - i;
        struct pp_key *key = &keys[i];
        *key = (struct pp_key){.kind = PP_KEY_COLOUR};
        for (int k = 0; k < 3; k++)
            key->colour[k] = colours[band][k];
        if (band == PP_SITE_LEVELS)
            snprintf(key->words, sizeof key->words, "%g\u00a0%% or more",
                     100.0 * pp_site_sheet_levels[band - 1]);
        else if (band == 0)
            snprintf(key->words, sizeof key->words, "under %g\u00a0%%",
                     100.0 * pp_site_sheet_levels[0]);
        else
            snprintf(key->words, sizeof key->words, "%g to %g\u00a0%%",
                     100.0 * pp_site_sheet_levels[band - 1],
                     100.0 * pp_site_sheet_levels[band]);
    }
}

bool pp_sky_bands_is_lost(const struct pp_site_window *window)
{
    return isfinite(window->before)
           && window->component < pp_site_sheet_levels[PP_SITE_LEVELS - 1]
           && window->component < 0.8 * window->before;
}
