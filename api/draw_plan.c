/* draw_plan.c - contours of the daylight factor and the no-sky line on the room's plan. */
#include <math.h>
#include <string.h>

#include "api/chart_kind.h"
#include "charts/room/plan_chart.h"
#include "methods/daylight_curves.h"
#include "studies/study_report.h"

/* What a method that gives the internally reflected component adds at every point: the
 * room's average, or its minimum where that is all it gives; NAN where it gives none.
 */
static double everywhere(const struct pp_report *report, const struct pp_column *column)
{
    if (isfinite(column->average.value) || !column->points
        || report->receiver_count == 0)
        return column->average.value;
    return column->points[0].value;
}

/* The internally reflected component that the first pair "exact+B" of the report adds
 * to `exact`; NULL where there is none. */
static const struct pp_column *reflected(const struct pp_report *report)
{
    static const char exact[] = "exact+";
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *pair = &report->columns[i];
        if (pair->component != PP_DF || strncmp(pair->name, exact, strlen(exact)) != 0)
            continue;
        const struct pp_column *column =
            pp_report_find(report, PP_IRC, pair->name + strlen(exact));
        if (column && isfinite(everywhere(report, column)))
            return column;
    }
    return NULL;
}

static enum pp_status draw_report(struct pp_canvas *canvas,
                                  const struct pp_report *report, struct pp_error *err)
{
    const struct pp_column *irc = reflected(report);
    struct pp_daylight_plan plan = {0};
    enum pp_status status =
        pp_daylight_curves(&plan, report->world, irc ? everywhere(report, irc) : 0.0,
                           irc ? irc->name : NULL, NULL, 0, err);
    if (status == PP_OK) {
        const struct pp_plan_chart chart = {
            .world = report->world, .plan = &plan, .report = report};
        status = pp_plan_chart_draw(canvas, &chart, err);
    }
    pp_daylight_plan_clear(&plan);
    return status;
}

static enum pp_status draw(struct pp_canvas *canvas, struct pp_study_room *room,
                           const struct pp_study_options *study,
                           const struct pp_chart_choice *choice, bool *finished,
                           struct pp_error *err)
{
    struct pp_report report;
    bool by_clock = false;
    (void)choice;
    enum pp_status status = pp_study_report_methods(&report, room, study, err);
    if (status == PP_OK && study->simulate)
        status = pp_study_report_traced(&report, study, &by_clock, err);
    if (status == PP_OK)
        status = draw_report(canvas, &report, err);
    *finished &= report.finished;
    pp_report_clear(&report);
    return status;
}

const struct pp_chart_kind pp_draw_plan = {
    .name = "plan",
    .summary = "daylight factor contours and no-sky line, on the plan",
    .landscape_for = pp_plan_chart_landscape,
    .draw = draw,
};
