/* draw_site.c - diagrams of the sky in front of a window, to read the vertical sky
 * component: blank, or with the obstructions of one window of a room. */
#include "api/chart_kind.h"
#include "api/choose_window.h"
#include "charts/drawing_board/skylight_indicator_chart.h"
#include "charts/drawing_board/waldram_chart.h"
#include "methods/waldram/skylight_indicator_fill.h"
#include "methods/waldram/waldram_sheet_fill.h"
#include "studies/criteria/windows/vertical_sky.h"

static enum pp_status draw_vertical_sky(struct pp_canvas *canvas,
                                        struct pp_study_room *room,
                                        const struct pp_study_options *study,
                                        const struct pp_chart_choice *choice,
                                        bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    int window;
    struct pp_waldram_sheet sheet = {0};
    enum pp_status status =
        room ? pp_choose_window(&window, room->world, choice->board.window, true, err)
             : PP_OK;
    if (status == PP_OK)
        status = room ? pp_waldram_sheet_fill_site(
                     &sheet, room->world, window,
                     pp_vertical_sky_point(&room->world->openings[window],
                                           choice->site.french_m),
                     err)
                      : pp_waldram_sheet_fill_upright(&sheet, &choice->board.sky, err);
    if (status == PP_OK && choice->board.inclined)
        status = pp_waldram_sheet_fill_inclined(
            &sheet, choice->board.inclined_deg * PP_RAD, err);
    if (status == PP_OK)
        status = pp_waldram_chart_draw(canvas, &sheet, err);
    pp_board_sheets_waldram_clear(&sheet);
    return status;
}

static enum pp_status draw_skylight_indicator(struct pp_canvas *canvas,
                                              struct pp_study_room *room,
                                              const struct pp_study_options *study,
                                              const struct pp_chart_choice *choice,
                                              bool *finished, struct pp_error *err)
{
    (void)study, (void)finished;
    int window;
    struct pp_skylight_indicator_sheet sheet = {0};
    enum pp_status status =
        room ? pp_choose_window(&window, room->world, choice->board.window, true, err)
             : PP_OK;
    if (status == PP_OK)
        status =
            room ? pp_skylight_indicator_fill_site(&sheet, room->world, window, err)
                 : pp_skylight_indicator_fill_blank(&sheet, &choice->board.sky, err);
    if (status == PP_OK)
        status = pp_skylight_indicator_chart_draw(canvas, &sheet, err);
    pp_skylight_indicator_sheet_clear(&sheet);
    return status;
}

const struct pp_chart_kind pp_draw_vertical_sky = {
    .name = "vertical-sky",
    .summary = "Waldram diagram of the vertical sky component, blank or for a window",
    .board = true,
    .of_window = true,
    .landscape = true,
    .draw = draw_vertical_sky,
};

const struct pp_chart_kind pp_draw_skylight_indicator = {
    .name = "skylight-indicator",
    .summary = "skylight indicator: an overlay for plans, whose marks have equal "
               "shares of the vertical sky component; blank or for a window",
    .board = true,
    .of_window = true,
    .landscape = true,
    .draw = draw_skylight_indicator,
};
