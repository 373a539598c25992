#include "cli/chart/draw_chart.h"

#include <math.h>
#include <string.h>

#include "charts/room/plan_chart.h"
#include "charts/room/section_chart.h"
#include "cli/availability/draw_availability.h"
#include "cli/chart/draw_board.h"
#include "studies/study_report.h"
#include "studies/section_line.h"
#include "methods/daylight_curves.h"

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

static enum pp_status draw_section(struct pp_canvas *canvas,
                                   const struct pp_report *report,
                                   const struct pp_chart_options *options,
                                   struct pp_error *err)
{
    const struct pp_section_chart chart = {.report = report,
                                           .logarithmic = options->logarithmic};
    return pp_section_chart_draw(canvas, &chart, err);
}

static enum pp_status draw_plan(struct pp_canvas *canvas,
                                const struct pp_report *report,
                                const struct pp_chart_options *options,
                                struct pp_error *err)
{
    (void)options;
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

static bool never_landscape(const struct pp_world *world)
{
    (void)world;
    return false;
}

static bool always_landscape(const struct pp_world *world)
{
    (void)world;
    return true;
}

/* What is to be known of each kind in charts/chart_kind.h to draw it. */
struct drawer {
    const char *kind;
    bool on_a_line; /* of points, which is laid where the room file has none */
    bool (*landscape)(const struct pp_world *world);
    enum pp_status (*draw)(struct pp_canvas *canvas, const struct pp_report *report,
                           const struct pp_chart_options *options,
                           struct pp_error *err);
    pp_board_drawer *draw_board; /* of kinds worked at the drawing board, instead */
};

static const struct drawer drawers[] = {
    {"section", true, never_landscape, draw_section, NULL},
    {"plan", false, pp_plan_chart_landscape, draw_plan, NULL},
    {"waldram", false, always_landscape, NULL, pp_draw_board_waldram},
    {"pepper-pot", false, always_landscape, NULL, pp_draw_board_pepper_pot},
    {"protractor", false, never_landscape, NULL, pp_draw_board_protractor},
    {"nomogram", false, never_landscape, NULL, pp_draw_board_nomogram},
    {"availability", false, always_landscape, NULL, NULL},
};

static const struct drawer *drawer_of(const struct pp_chart_kind *kind)
{
    const struct drawer *drawer = drawers;
    while (strcmp(drawer->kind, kind->name) != 0)
        drawer++;
    return drawer;
}

bool pp_draw_chart_landscape(const struct pp_chart_kind *kind,
                             const struct pp_world *world)
{
    return drawer_of(kind)->landscape(world);
}

enum pp_status pp_draw_chart(const struct pp_chart_kind *kind, struct pp_canvas *canvas,
                             struct pp_study_room *room,
                             const struct pp_room_options *room_options,
                             const struct pp_chart_options *options, bool *finished,
                             struct pp_error *err)
{
    const struct drawer *drawer = drawer_of(kind);
    if (drawer->draw_board)
        return drawer->draw_board(canvas, room, &options->board, err);
    if (kind->outside)
        return pp_draw_availability(canvas, room, room_options, &options->availability,
                                    finished, err);
    if (drawer->on_a_line && room_options->study.points.count == 0
        && !pp_section_line_is_straight(room->receivers, room->receiver_count)) {
        enum pp_status status = pp_section_line(room, err);
        if (status != PP_OK)
            return status;
    }

    struct pp_report report;
    bool by_clock = false;
    enum pp_status status =
        pp_study_report_methods(&report, room, &room_options->study, err);
    if (status == PP_OK && room_options->study.simulate)
        status = pp_study_report_traced(&report, &room_options->study, &by_clock, err);
    if (status == PP_OK)
        status = drawer->draw(canvas, &report, options, err);
    *finished &= report.finished;
    pp_report_clear(&report);
    return status;
}
