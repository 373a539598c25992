/* net_chart.h - a room as a scale model to be cut out and folded: panels, openings,
 * tabs, numbers of matching edges, and surfaces to be painted. The sheet also gives
 * corrections for measurements in a mirror-box artificial sky. */
#ifndef PP_CHARTS_NET_NET_CHART_H
#define PP_CHARTS_NET_NET_CHART_H

#include "charts/sheet/canvas.h"
#include "model/light/mirror_box.h"
#include "model/room/world.h"

struct pp_model_net {
    const struct pp_world *world;
    double scale;             /* denominator of the scale: 20 for 1:20 */
    struct pp_mirror_box box; /* mirror box whose corrections are printed */
};

/* Draws on as many sheets as needed. PP_BAD_INPUT if the format has a single sheet
 * only. */
enum pp_status pp_net_chart_draw(struct pp_canvas *canvas,
                                 const struct pp_model_net *net, struct pp_error *err);

#endif
