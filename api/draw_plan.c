/* draw_plan.c - contours of the daylight factor and the no-sky line on the room's plan,
 * or its lit area at present and before. */
#include "api/chart_kind.h"
#include "charts/room/lit_area_chart.h"
#include "charts/room/plan_chart.h"
#include "studies/lit_line.h"
#include "studies/plan_study.h"
#include "studies/reliability.h"

static enum pp_status draw_lit_area(struct pp_canvas *canvas,
                                    const struct pp_world *world,
                                    const struct pp_world *before,
                                    enum pp_lit_line line, struct pp_error *err)
{
    struct pp_lit_area now, then = {0};
    enum pp_status status = pp_lit_line_find(&now, world, line, err);
    if (status == PP_OK && before)
        status = pp_lit_line_find(&then, before, line, err);
    if (status == PP_OK)
        status = pp_lit_area_chart_draw(
            canvas,
            &(struct pp_lit_area_chart){world, line, &now, before ? &then : NULL}, err);
    pp_lit_area_clear(&then);
    pp_lit_area_clear(&now);
    return status;
}

static enum pp_status draw_plan_chart(struct pp_canvas *canvas,
                                      struct pp_study_room *room,
                                      const struct pp_study_options *study,
                                      const struct pp_chart_choice *choice,
                                      bool *finished, struct pp_error *err)
{
    const struct pp_study_room *before =
        choice->site.before ? choice->site.before[0] : NULL;
    if (before || choice->line_said)
        return draw_lit_area(canvas, room->world, before ? before->world : NULL,
                             choice->line, err);
    struct pp_plan_study made;
    bool by_clock = false;
    enum pp_status status = pp_plan_study_make(&made, room, study, &by_clock, err);
    if (status != PP_OK)
        return status;
    enum { NOTE_BYTES = 640 };
    char doubts[NOTE_BYTES];
    const char *notes[] = {made.note, doubts};
    pp_reliability_note(&made.report, doubts, sizeof doubts);
    const struct pp_plan_chart chart = {.world = room->world,
                                        .light = &room->light,
                                        .plan = &made.plan,
                                        .report = &made.report,
                                        .figures = &made.figures,
                                        .fill = choice->fill,
                                        .notes = notes,
                                        .note_count = 2};
    status = pp_plan_chart_draw(canvas, &chart, err);
    *finished &= made.report.finished;
    pp_plan_study_clear(&made);
    return status;
}

const struct pp_chart_kind pp_draw_plan = {
    .name = "plan",
    .summary = "daylight factor contours and no-sky line on the plan",
    .landscape_for = pp_plan_chart_landscape,
    .compares = true,
    .check = pp_plan_study_check,
    .draw = draw_plan_chart,
};
