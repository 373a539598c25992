/* plan_strip.h - the strip below every plan: scale bar on the left, legend in the
 * middle, north arrow on the right. */
#ifndef PP_CHARTS_ROOM_PLAN_STRIP_H
#define PP_CHARTS_ROOM_PLAN_STRIP_H

#include "charts/sheet/legend.h"

/* Height of the strip with this many keys (mm). */
double pp_plan_strip_height(const struct pp_style *style, int key_count);

/* Draws the strip into the box, whose height is pp_plan_strip_height. scale: 50 for
 * 1:50; north_rad: bearing of the upward direction on paper; NAN: no arrow. */
void pp_plan_strip_draw(cairo_t *cr, const struct pp_style *style, struct pp_box strip,
                        double scale, double north_rad, const struct pp_key *keys,
                        int key_count);

#endif
