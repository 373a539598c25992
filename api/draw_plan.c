/* draw_plan.c - contours of the daylight factor and the no-sky line on the room's plan. */
#include "api/chart_kind.h"
#include "charts/room/plan_chart.h"
#include "studies/plan_study.h"

static enum pp_status draw(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_choice *choice, bool *finished,
                           struct pp_error *err)
{
    struct pp_plan_study made;
    bool by_clock = false;
    enum pp_status status = pp_plan_study_make(&made, room, study, &by_clock, err);
    if (status != PP_OK)
        return status;
    const char *notes[] = {made.note};
    const struct pp_plan_chart chart = {.world = room->world,
                                        .light = &room->light,
                                        .plan = &made.plan,
                                        .report = &made.report,
                                        .figures = &made.figures,
                                        .fill = choice->fill,
                                        .notes = notes,
                                        .note_count = made.note[0] ? 1 : 0};
    status = pp_plan_chart_draw(canvas, &chart, err);
    *finished &= made.report.finished;
    pp_plan_study_clear(&made);
    return status;
}

const struct pp_chart_kind pp_draw_plan = {
    .name = "plan",
    .summary = "daylight factor contours and no-sky line, on the plan",
    .landscape_for = pp_plan_chart_landscape,
    .check = pp_plan_study_check,
    .draw = draw,
};
