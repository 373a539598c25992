#include "cli/availability/draw_availability.h"

#include "charts/availability_chart.h"
#include "studies/study_report.h"

enum pp_status pp_draw_availability(struct pp_canvas *canvas,
                                    const struct pp_study_room *room,
                                    const struct pp_room_options *room_options,
                                    const struct pp_availability_options *options,
                                    bool *finished, struct pp_error *err)
{
    struct pp_report report = {0};
    struct pp_environment_light outside;
    struct pp_availability_sheet sheet = {0};
    bool by_clock = false;
    enum pp_status status = pp_availability_options_light(
        &outside, options, room ? room->world : NULL, err);
    if (status == PP_OK && room)
        status = pp_study_report_methods(&report, room, &room_options->study, err);
    if (status == PP_OK && room && room_options->study.simulate)
        status = pp_study_report_traced(&report, &room_options->study, &by_clock, err);
    if (status == PP_OK) {
        struct pp_availability_question question =
            pp_availability_options_question(options, &outside);
        status = pp_availability_fill(&sheet, &question, room ? &report : NULL, err);
    }
    if (status == PP_OK)
        status = pp_availability_chart_draw(canvas, &sheet, err);
    if (room)
        *finished &= report.finished;
    pp_availability_sheet_clear(&sheet);
    pp_report_clear(&report);
    pp_availability_options_light_clear(&outside);
    return status;
}
