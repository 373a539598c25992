/* draw_brs_table.c - the BRS simplified daylight table as a sheet: blank, or read for a
 * point of a room. */
#include "api/chart_kind.h"
#include "charts/drawing_board/brs_table_chart.h"
#include "methods/brs/brs_sheet_fill.h"

static enum pp_status draw(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_choice *choice, bool *finished,
                           struct pp_error *err)
{
    (void)study, (void)finished;
    struct pp_brs_sheet sheet = {0};
    enum pp_status status = PP_OK;
    if (!room && choice->board.sky.kind != PP_SKY_OVERCAST)
        return pp_fail(err, PP_BAD_INPUT,
                       "the BRS table is made for the overcast sky; expected no other "
                       "--sky");
    if (room)
        status = pp_brs_sheet_fill_room(&sheet, room->world, &room->light,
                                        room->receivers, err);
    else
        pp_brs_sheet_fill_blank(&sheet);
    if (status == PP_OK)
        status = pp_brs_table_chart_draw(canvas, &sheet, err);
    pp_brs_sheet_clear(&sheet);
    return status;
}

const struct pp_chart_kind pp_draw_brs_table = {
    .name = "brs-table",
    .summary = "BRS simplified daylight table, blank or with a room's readings",
    .board = true,
    .from_point = true,
    .draw = draw,
};
