/* lit_area_chart.h - plan of the room, to scale, with the sufficiently lit area of the
 * proposed state and, for comparison, of the existing state. Lost and gained areas are
 * hatched. */
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
