/* exercise_chart.h - an exercise sheet: section, plan and elevations of the room to
 * scale with the point, the given data in words, and lines for the answers. */
#ifndef PP_CHARTS_ROOM_EXERCISE_CHART_H
#define PP_CHARTS_ROOM_EXERCISE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_exercise {
    const struct pp_world *world;
    const struct pp_outside_light *light;
    struct pp_receiver receiver;
    const char *tool; /* name of the tool, such as "the pepper-pot diagram" */
    const char *unit; /* unit of counts: "dots \u00d7 0.1 %"; NULL: no counts */
    double
        viewing_mm; /* viewing distance (mm) of a diagram to be laid on the elevations,
                     * which determines their scale; 0: all drawings have the same
                     * scale */
};

/* Draws the sheet. PP_BAD_INPUT if no opening of the room faces the point. */
enum pp_status pp_exercise_chart_draw(struct pp_canvas *canvas,
                                      const struct pp_exercise *exercise,
                                      struct pp_error *err);

#endif
