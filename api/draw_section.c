/* draw_section.c - the daylight factors along a line of points, over the room's section.
 * A room without such a line gets one of its own (studies/section_line.h). */
#include "api/chart_kind.h"
#include "charts/room/section_chart.h"
#include "studies/section_line.h"
#include "studies/study_report.h"

static enum pp_status draw(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_choice *choice, bool *finished,
                           struct pp_error *err)
{
    struct pp_report report = {.finished = true};
    bool by_clock = false;
    enum pp_status status = PP_OK;
    if (study->points.count == 0
        && !pp_section_line_is_straight(room->receivers, room->receiver_count))
        status = pp_section_line(room, err);
    if (status != PP_OK)
        return status;
    status = pp_study_report_methods(&report, room, study, err);
    if (status == PP_OK && study->simulate)
        status = pp_study_report_traced(&report, study, &by_clock, err);
    const struct pp_section_chart chart = {.report = &report,
                                           .logarithmic = choice->logarithmic};
    if (status == PP_OK)
        status = pp_section_chart_draw(canvas, &chart, err);
    *finished &= report.finished;
    pp_report_clear(&report);
    return status;
}

const struct pp_chart_kind pp_draw_section = {
    .name = "section",
    .summary = "daylight factor against distance, over the section",
    .draw = draw,
};
