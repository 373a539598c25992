/* waldram_droop_lines.c - see waldram_droop_lines.h. */
#include "methods/waldram/waldram_droop_lines.h"

#include <math.h>
#include <stdlib.h>

enum { DROOP_STEP_DEG = 10, DROOP_LINES = 8, DROOP_POINTS = 181 };

static double azimuth_of(int point)
{
    return (point - (DROOP_POINTS - 1) / 2) * PP_RAD;
}

bool pp_waldram_droop_lines(struct pp_curve_list *curves,
                            const struct pp_waldram *waldram, double nearest,
                            double width, double height)
{
    curves->list = calloc(DROOP_LINES, sizeof *curves->list);
    if (!curves->list)
        return false;
    curves->count = DROOP_LINES;
    for (int i = 0; i < DROOP_LINES; i++) {
        struct pp_curve *curve = &curves->list[i];
        curve->level = (i + 1) * DROOP_STEP_DEG * PP_RAD;
        curve->xy = malloc(DROOP_POINTS * sizeof *curve->xy);
        if (!curve->xy)
            return false;
        curve->count = DROOP_POINTS;
        for (int k = 0; k < DROOP_POINTS; k++) {
            double phi = azimuth_of(k);
            double way = isnan(nearest) ? fabs(sin(phi)) : cos(phi - nearest);
            curve->xy[k][0] = pp_waldram_scale_x(waldram, phi) / width;
            curve->xy[k][1] =
                pp_waldram_scale_y(waldram, atan(tan(curve->level) * fmax(way, 0.0)))
                / height;
        }
    }
    return true;
}
