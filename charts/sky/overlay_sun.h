/* overlay_sun.h - the sun's paths on an overlay. Inside charts/sky/ only. */
#ifndef PP_CHARTS_SKY_OVERLAY_SUN_H
#define PP_CHARTS_SKY_OVERLAY_SUN_H

#include "charts/sky/overlay_plot.h"

/* Paths of the 21st of each month and lines of whole hours of solar time, with their
 * names where there is room. */
void pp_overlay_sun_draw(const struct pp_overlay_plot *plot);

#endif
