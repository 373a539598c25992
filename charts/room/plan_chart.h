/* plan_chart.h - the room's plan with contours of the daylight factor and the no-sky
 * line, to scale.
 *
 * The scale is the largest usual scale (1:1, 2, 5, 10, 20, 25, 50, 75, 100 ...) that
 * fits the sheet, and is printed. Walls are cut at the working plane. Openings in
 * vertical faces are drawn as in architects' plans; other openings are outlines seen
 * from above.
 */
#ifndef PP_CHARTS_ROOM_PLAN_CHART_H
#define PP_CHARTS_ROOM_PLAN_CHART_H

#include "charts/room/plan_names.h"
#include "charts/sheet/canvas.h"
#include "model/light/outside_light.h"
#include "model/results/daylight_plan.h"
#include "model/results/report.h"

/* Fill between the contours. */
enum pp_plan_fill {
    PP_FILL_NONE,
    PP_FILL_COLOUR, /* blue to yellow, with increasing luminance */
    PP_FILL_GREY,   /* for black-and-white print: less light is darker */
};

struct pp_plan_chart {
    const struct pp_world *world;         /* not owned */
    const struct pp_outside_light *light; /* not owned */
    const struct pp_daylight_plan *plan;  /* not owned */
    const struct pp_report
        *report; /* report whose receivers are marked; NULL: none; not owned */
    const struct pp_column
        *figures; /* figures at the receivers and of the plane; NULL: none; not owned */
    const struct pp_plan_mark *mark; /* mark of the section; NULL: none; not owned */
    enum pp_plan_fill fill;
    const char *const *notes; /* further sentences for the foot of the sheet; not
                               * owned */
    int note_count;
};

/* True if a landscape sheet suits the room better. */
bool pp_plan_chart_landscape(const struct pp_world *world);

enum pp_status pp_plan_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_plan_chart *chart,
                                  struct pp_error *err);

#endif
