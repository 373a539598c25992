/* moment_chart.h - plan of a room, to scale, with the illuminances on its working plane
 * at one moment: colours for classes of illuminance, hatching for direct sunlight, and
 * values at the points. */
#ifndef PP_CHARTS_YEAR_MOMENT_CHART_H
#define PP_CHARTS_YEAR_MOMENT_CHART_H

#include "charts/sheet/canvas.h"
#include "model/light/outside_light.h"
#include "model/results/sheets/moment_plan.h"

enum pp_status pp_moment_chart_draw(struct pp_canvas *canvas,
                                    const struct pp_moment_plan *plan,
                                    const struct pp_outside_light *light,
                                    struct pp_error *err);

#endif
