/* lit_area_chart.h - the room's plan with the sufficiently lit part, now and before,
 * and the lost part hatched; to a true scale. */
#ifndef PP_CHARTS_ROOM_LIT_AREA_CHART_H
#define PP_CHARTS_ROOM_LIT_AREA_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/lit_area.h"
#include "model/room/world.h"

struct pp_lit_area_chart {
    const struct pp_world *world;
    enum pp_lit_line line;
    const struct pp_lit_area *now;
    const struct pp_lit_area *before; /* NULL: no comparison */
};

enum pp_status pp_lit_area_chart_draw(struct pp_canvas *canvas,
                                      const struct pp_lit_area_chart *chart,
                                      struct pp_error *err);

#endif
