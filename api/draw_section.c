/* draw_section.c - daylight factors along a line of points, drawn over a section of the
 * room. For a room without a line of points, studies/section_line.h makes one. */
#include <math.h>
#include <string.h>

#include "api/chart_kind.h"
#include "charts/section/section_chart.h"
#include "methods/reflected/obstruction.h"
#include "model/base/text.h"
#include "studies/reliability.h"
#include "studies/section_line.h"
#include "studies/study_report.h"

enum { NOTE_BYTES = 640 };

/* Returns PP_BAD_INPUT, with the reason, if there are no values to show. */
static enum pp_status check_values(const struct pp_report *report, struct pp_error *err)
{
    const char *why = "these methods give only part of the daylight factor; expected a "
                      "pair, such as exact+bre";
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != PP_DF)
            continue;
        if (isfinite(column->average.value))
            return PP_OK;
        for (int k = 0; k < report->receiver_count && column->points; k++)
            if (isfinite(column->points[k].value))
                return PP_OK;
        why = column->average.why ? column->average.why : why;
    }
    return pp_fail(err, PP_BAD_INPUT, "%s: there is no daylight factor to draw: %s",
                   report->world->name, why);
}

/* Prints the obstruction angle that the formulae use, if there are obstructions. The
 * angle is that of an infinitely long skyline that leaves the window the same amount of
 * sky. It may differ from the line of sight in the section. */
static enum pp_status say_obstructions(char note[NOTE_BYTES],
                                       const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       struct pp_error *err)
{
    int said = 0;
    note[0] = '\0';
    for (int i = 0; i < world->opening_count; i++) {
        double angle_rad;
        enum pp_status status =
            pp_obstruction_angle(&angle_rad, world, light, &world->openings[i], err);
        if (status != PP_OK)
            return status;
        if (angle_rad < 0.05 * PP_RAD)
            continue;
        pp_text_append(note, NOTE_BYTES, "%s%s %.1f\u00b0",
                       said++ ? ", "
                              : "Obstruction angle in the formulae (the angle of an "
                                "endless skyline that hides the same amount "
                                "of sky): ",
                       world->openings[i].label, angle_rad / PP_RAD);
    }
    if (said)
        pp_text_append(note, NOTE_BYTES, ".");
    return PP_OK;
}

static enum pp_status draw_section_chart(struct pp_canvas *canvas,
                                         struct pp_study_room *room,
                                         const struct pp_study_options *study,
                                         const struct pp_chart_choice *choice,
                                         bool *finished, struct pp_error *err)
{
    struct pp_report report = {.finished = true};
    bool by_clock = false;
    enum pp_status status = PP_OK;
    char obstructions[NOTE_BYTES], stand_in[NOTE_BYTES] = "", doubts[NOTE_BYTES];
    const char *notes[] = {stand_in, obstructions, doubts};
    if (choice->cut.kind != PP_SECTION_OF_ROOM
        || (study->points.count == 0
            && !pp_section_line_is_straight(room->receivers, room->receiver_count)))
        status = pp_section_line(room, &choice->cut, err);
    if (status != PP_OK)
        return status;
    status = pp_study_report_methods(&report, room, study, err);
    if (status == PP_OK && study->simulate)
        status = pp_study_report_traced(&report, study, &by_clock, err);
    if (status == PP_OK)
        status = check_values(&report, err);
    if (status == PP_OK)
        status = say_obstructions(obstructions, room->world, &room->light, err);
    if (report.stand_in)
        pp_text_append(stand_in, sizeof stand_in, "%s.", report.stand_in);
    if (status == PP_OK)
        pp_reliability_note(&report, doubts, sizeof doubts);
    const struct pp_section_chart chart = {
        .report = &report, .scale = choice->scale, .notes = notes, .note_count = 3};
    if (status == PP_OK)
        status = pp_section_chart_draw(canvas, &chart, err);
    *finished &= report.finished;
    pp_report_clear(&report);
    return status;
}

const struct pp_chart_kind pp_draw_section = {
    .name = "section",
    .summary = "daylight factor against distance, above a section",
    .draw = draw_section_chart,
};
