/* skylight_indicator_sheet.h - data of a skylight indicator: marks of equal value on a
 * plan around a window, and its obstructions.
 *
 * Positions are distances divided by the height above the window's centre. x is to the
 * right, seen from inside; y is the distance in front of the window. So an edge of a
 * building is drawn at its distance divided by its height. A method fills the sheet
 * (methods/waldram/skylight_indicator_fill.h); a chart draws it
 * (charts/drawing_board/skylight_indicator_chart.h).
 */
#ifndef PP_MODEL_RESULTS_SHEETS_SKYLIGHT_INDICATOR_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_SKYLIGHT_INDICATOR_SHEET_H

#include <stdbool.h>

#include "model/geometry/region.h"
#include "model/geometry/vec.h"
#include "model/light/sky.h"

enum { PP_SKYLIGHT_RINGS = 8, PP_SKYLIGHT_RAYS = 10 };

struct pp_skylight_mark {
    double x, y;
    bool counted; /* true on visible sky */
};

struct pp_skylight_indicator_sheet {
    const char *name; /* name of the room, or NULL; not owned */
    bool blank;
    const char *label;     /* label of the window, not owned */
    struct pp_vec3 middle; /* centre of the window, outer face */
    struct pp_sky sky;
    double whole; /* vertical sky component of an unobstructed sky, fraction of Eh */
    double worth; /* value of a mark */
    double reach; /* extent of the plan to each side and to the front */
    struct pp_skylight_mark marks[PP_SKYLIGHT_RINGS * PP_SKYLIGHT_RAYS];
    struct pp_region hidden; /* area of the plan covered by obstructions */
    int counted;             /* number of marks on visible sky */
    double sky_component;    /* counted x worth */
};

void pp_skylight_indicator_sheet_clear(struct pp_skylight_indicator_sheet *sheet);

#endif
