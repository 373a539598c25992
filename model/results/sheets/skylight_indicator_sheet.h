/* skylight_indicator_sheet.h - the data of a skylight indicator: marks of equal worth
 * on a plan about a window, and its obstructions.
 *
 * Places are over the height above the window's middle: (x, y) is x to the right of the
 * window as one looks out and y ahead of it, a building's edge at its distance over its
 * height. A method fills it (methods/waldram/skylight_indicator_fill.h); a chart draws
 * it (charts/drawing_board/skylight_indicator_chart.h). */
#ifndef PP_MODEL_RESULTS_SHEETS_SKYLIGHT_INDICATOR_SHEET_H
#define PP_MODEL_RESULTS_SHEETS_SKYLIGHT_INDICATOR_SHEET_H

#include <stdbool.h>

#include "model/geometry/region.h"
#include "model/geometry/vec.h"
#include "model/light/sky.h"

enum { PP_SKYLIGHT_RINGS = 8, PP_SKYLIGHT_RAYS = 10 };

struct pp_skylight_mark {
    double x, y;
    bool counted; /* on the sky */
};

struct pp_skylight_indicator_sheet {
    const char *name; /* the room's, or NULL; not owned */
    bool blank;
    const char *label;     /* of the window, not owned */
    struct pp_vec3 middle; /* of the window's outside */
    struct pp_sky sky;
    double whole; /* vertical sky component of the open sky, fraction of Eh */
    double worth; /* of a mark */
    double reach; /* how far the plan goes to either side and ahead */
    struct pp_skylight_mark marks[PP_SKYLIGHT_RINGS * PP_SKYLIGHT_RAYS];
    struct pp_region hidden; /* area of the plan covered by obstructions */
    int counted;             /* marks on the sky */
    double sky_component;    /* counted times worth */
};

void pp_skylight_indicator_sheet_clear(struct pp_skylight_indicator_sheet *sheet);

#endif
