/* overlay_chart.h - sun paths and equal parts of the sky, to be laid on a fisheye
 * photograph taken upwards. */
#ifndef PP_CHARTS_SKY_OVERLAY_CHART_H
#define PP_CHARTS_SKY_OVERLAY_CHART_H

#include "charts/sheet/canvas.h"
#include "model/geometry/lens.h"
#include "model/light/sky_cells.h"
#include "model/results/sheets/sky_mask.h"

/* Position of the sun in one hour with sunshine. */
struct pp_overlay_sun {
    double altitude_rad, bearing_rad;
    bool visible; /* true if no obstruction hides the sun */
};

struct pp_overlay {
    enum pp_lens lens;
    double diameter_mm; /* diameter of the horizon circle; 0: the largest possible in
                         * whole centimetres */
    struct pp_sky sky;
    const struct pp_sky_cell *dots; /* cells with a cross in the middle of each; NULL:
                                     * none */
    int dot_count;
    const struct pp_sky_cell *cells; /* cells drawn in outline; NULL: none */
    int cell_count;
    bool sun; /* draw sun paths */
    double latitude_rad;

    /* For a sheet instead of an overlay. A sheet is seen from above, with east on the
     * right, and shows the obstructions of a window. */
    const char *title, *subtitle, *foot; /* title NULL: the chart is an overlay */
    const struct pp_sky_mask *now;       /* NULL: no obstruction */
    const struct pp_sky_mask *before;    /* former obstruction; NULL: not known */
    const struct pp_overlay_sun *suns;   /* sunshine hours; NULL: none */
    int sun_count;
};

/* Draws the overlay, with north up and east on the left, as seen looking up, or the
 * sheet, as seen from above. PP_BAD_INPUT if the circle is too large for the paper. */
enum pp_status pp_overlay_chart_draw(struct pp_canvas *canvas,
                                     const struct pp_overlay *overlay,
                                     struct pp_error *err);

#endif
