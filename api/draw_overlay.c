/* draw_overlay.c - overlays for fisheye photographs: points or cells of equal
 * illuminance, and sun paths. */
#include <math.h>
#include <stdlib.h>

#include "api/chart_kind.h"
#include "charts/sky/overlay_chart.h"

enum { DOTS = 1000, CELLS = 200 };

static enum pp_status draw_overlay(struct pp_canvas *canvas, struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice, bool *finished,
                                   struct pp_error *err)
{
    (void)study, (void)finished;
    const struct pp_overlay_options *options = &choice->board.overlay;
    double latitude_deg = choice->availability.latitude_deg;
    struct pp_sky_cell *dots = NULL, *cells = NULL;
    bool sun = options->sun || (!options->said && !isnan(latitude_deg));
    if (room)
        return pp_fail(
            err, PP_BAD_INPUT,
            "an overlay is for a photograph and needs no room; expected no room file");
    if (sun && isnan(latitude_deg))
        return pp_fail(err, PP_BAD_INPUT,
                       "sun paths need a location; expected --latitude DEG");
    enum pp_status status = PP_OK;
    if (options->dots || !options->said)
        status = pp_sky_cells(&dots, &choice->board.sky, DOTS, err);
    if (status == PP_OK && options->cells)
        status = pp_sky_cells(&cells, &choice->board.sky, CELLS, err);
    const struct pp_overlay overlay = {.lens = options->lens,
                                       .diameter_mm = options->diameter_mm,
                                       .sky = choice->board.sky,
                                       .dots = dots,
                                       .dot_count = dots ? DOTS : 0,
                                       .cells = cells,
                                       .cell_count = cells ? CELLS : 0,
                                       .sun = sun,
                                       .latitude_rad = latitude_deg * PP_RAD};
    if (status == PP_OK)
        status = pp_overlay_chart_draw(canvas, &overlay, err);
    free(dots);
    free(cells);
    return status;
}

const struct pp_chart_kind pp_draw_overlay = {
    .name = "overlay",
    .summary =
        "overlay for a fisheye photograph: equal parts of the sky, and sun paths",
    .board = true,
    .of_sun = true,
    .transparent = true,
    .draw = draw_overlay,
};
