/* overlay_chart.h - sun paths and the sky in equal parts, to lay on a fisheye photograph that
 * was taken looking up. */
#ifndef PP_CHARTS_SKY_OVERLAY_CHART_H
#define PP_CHARTS_SKY_OVERLAY_CHART_H

#include "charts/sheet/canvas.h"
#include "model/geometry/lens.h"
#include "model/light/sky_cells.h"
#include "model/results/sheets/sky_mask.h"

/* Position of the sun in an hour with sunshine. */
struct pp_overlay_sun {
    double altitude_rad, bearing_rad;
    bool visible; /* not hidden by an obstruction */
};

struct pp_overlay {
    enum pp_lens lens;
    double diameter_mm; /* diameter of the horizon circle; 0: the largest possible in
                         * whole centimetres */
    struct pp_sky sky;
    const struct pp_sky_cell *dots; /* a dot in the middle of each; NULL: none */
    int dot_count;
    const struct pp_sky_cell *cells; /* cells drawn in outline; NULL: none */
    int cell_count;
    bool sun; /* draw the sun's paths */
    double latitude_rad;

    /* Sheet instead of an overlay: seen from above, east on the right, with the
     * obstructions of a window. */
    const char *title, *subtitle, *foot; /* title NULL: an overlay */
    const struct pp_sky_mask *now;       /* NULL: no obstruction */
    const struct pp_sky_mask *before;    /* NULL: not known */
    const struct pp_overlay_sun *suns;   /* hours with sunshine; NULL: none */
    int sun_count;
};

/* North is up and east on the left, as seen looking up; on a sheet, as from above.
 * PP_BAD_INPUT if the circle is too large for the sheet. */
enum pp_status pp_overlay_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_overlay *overlay,
                                     struct pp_error *err);

#endif
