/* draw_plan.c - plan of a room with contours of the daylight factor and the no-sky
 * line, or with its present and former lit area, or with its illuminances at one
 * moment. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "api/chart_kind.h"
#include "api/draw_moment.h"
#include "charts/room/lit_area_chart.h"
#include "charts/room/plan_chart.h"
#include "charts/section/section_cut.h"
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

/* Finds the ends of the section that `chart section` draws. *found is false if no
 * section of the room can be found. */
static enum pp_status find_mark(struct pp_plan_mark *mark, bool *found,
                                const struct pp_study_room *room,
                                const struct pp_chart_choice *choice,
                                struct pp_error *err)
{
    struct pp_study_room copy = *room;
    struct pp_section_cut cut;
    enum pp_status status = PP_OK;
    copy.receivers = room->world->receivers;
    copy.receiver_count = room->world->receiver_count;
    *found = false;
    if (choice->cut.kind != PP_SECTION_OF_ROOM
        || !pp_section_line_is_straight(copy.receivers, copy.receiver_count))
        status = pp_section_line(&copy, &choice->cut, err);
    if (status == PP_BAD_INPUT && choice->cut.kind == PP_SECTION_OF_ROOM)
        return PP_OK;
    if (status == PP_OK)
        status = pp_section_cut_init(&cut, room->world, copy.receivers,
                                     copy.receiver_count, err);
    if (status == PP_OK) {
        *found = true;
        for (int k = 0; k < 2; k++) {
            mark->from[k] = cut.origin[k];
            mark->to[k] = cut.origin[k] + cut.length_m * cut.along[k];
        }
        pp_section_cut_clear(&cut);
    }
    if (copy.receivers != room->world->receivers)
        free(copy.receivers);
    return status;
}

/* Replaces the average by the average of the same column of the report `known`, if any,
 * so that plan and report agree. */
static void take_average(struct pp_column *figures, const struct pp_report *known)
{
    for (int i = 0; known && i < known->column_count; i++) {
        const struct pp_column *column = &known->columns[i];
        if (column->component == PP_DF && isfinite(column->average.value)
            && strcmp(column->name, figures->name) == 0)
            figures->average = column->average;
    }
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
    if (choice->moment)
        return pp_draw_moment_plan(canvas, room, study, choice, err);
    struct pp_plan_study made;
    struct pp_plan_mark mark;
    bool by_clock = false, marked;
    enum pp_status status = find_mark(&mark, &marked, room, choice, err);
    if (status == PP_OK)
        status = pp_plan_study_make(&made, room, study, &by_clock, err);
    if (status != PP_OK)
        return status;
    take_average(&made.figures, choice->known);
    enum { NOTE_BYTES = 640 };
    char doubts[NOTE_BYTES];
    const char *notes[] = {made.note, doubts};
    pp_reliability_note(&made.report, doubts, sizeof doubts);
    const struct pp_plan_chart chart = {.world = room->world,
                                        .light = &room->light,
                                        .plan = &made.plan,
                                        .report = &made.report,
                                        .figures = &made.figures,
                                        .mark = marked ? &mark : NULL,
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
