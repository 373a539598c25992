/* draw_availability.c - cumulative frequency of the illuminance outside and, if there
 * is a room, inside. */
#include "api/chart_kind.h"
#include "charts/availability_chart.h"
#include "studies/climate/availability.h"
#include "studies/study_report.h"

static enum pp_status draw_availability(struct pp_canvas *canvas,
                                        struct pp_study_room *room,
                                        const struct pp_study_options *study,
                                        const struct pp_chart_choice *choice,
                                        bool *finished, struct pp_error *err)
{
    struct pp_report report = {0};
    struct pp_year_light outside;
    struct pp_availability_sheet sheet = {0};
    bool by_clock = false;
    enum pp_status status = pp_year_light_of_room(&outside, &choice->availability,
                                                  room ? room->world : NULL, err);
    if (status == PP_OK && room)
        status = pp_study_report_methods(&report, room, study, err);
    if (status == PP_OK && room && study->simulate)
        status = pp_study_report_traced(&report, study, &by_clock, err);
    if (status == PP_OK) {
        struct pp_availability_question question =
            pp_year_light_question(&choice->availability, &outside);
        status = pp_availability_fill(&sheet, &question, room ? &report : NULL, err);
    }
    if (status == PP_OK)
        status = pp_availability_chart_draw(canvas, &sheet, err);
    if (room)
        *finished &= report.finished;
    pp_availability_sheet_clear(&sheet);
    pp_report_clear(&report);
    pp_year_light_clear(&outside);
    return status;
}

const struct pp_chart_kind pp_draw_availability = {
    .name = "availability",
    .summary =
        "share of working hours in which an illuminance is reached, outside and inside",
    .outside = true,
    .landscape = true,
    .draw = draw_availability,
};
