/* sky_chart.h - how bright a sky is from horizon to horizon, through zenith and sun.
 *
 * Across is the angle from the horizon below the sun (of a sky without one, any) over
 * the zenith, at 90 degrees, to the horizon opposite; up is the luminance over that of
 * the uniform sky which lights the ground as much:
 *
 *     pi L / Eh
 *
 * An overcast sky rises from 3/7 at the horizon to 9/7 at the zenith        [MS42].
 */
#ifndef PP_CHARTS_SKY_CHART_H
#define PP_CHARTS_SKY_CHART_H

#include "charts/sheet/canvas.h"
#include "model/room/world.h"

enum { PP_SKY_SHEET_STEPS = 180 };

struct pp_sky_sheet {
    const struct pp_world *world;             /* whose sky it is; not owned */
    double luminance[PP_SKY_SHEET_STEPS + 1]; /* pi L / Eh, a value a degree */
};

enum pp_status pp_sky_chart_draw(struct pp_canvas *canvas,
                                 const struct pp_sky_sheet *sheet,
                                 struct pp_error *err);

#endif
