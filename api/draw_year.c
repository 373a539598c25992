/* draw_year.c - chart of the daylight in a room over a year. */
#include <math.h>

#include "api/chart_kind.h"
#include "charts/year/year_chart.h"
#include "model/base/read_file.h"
#include "studies/year/annual.h"

static enum pp_status draw_year(struct pp_canvas *canvas, struct pp_study_room *room,
                                const struct pp_study_options *study,
                                const struct pp_chart_choice *choice, bool *finished,
                                struct pp_error *err)
{
    (void)finished;
    const struct pp_year_options *year_options = &choice->availability;
    struct pp_weather_year year;
    struct pp_annual_sheet sheet = {.points = NULL};
    if (!year_options->epw)
        return pp_fail(
            err, PP_BAD_INPUT,
            "a chart of the year needs a weather file; expected --weather FILE.epw");
    const struct pp_weather_options weather = {.sun_shift_h = NAN};
    struct pp_annual_options options = pp_annual_options_lm83;
    options.hours = year_options->hours.list[0];
    options.summer = year_options->summer.of_file
                         ? (struct pp_summer_time){year_options->epw->summer_from,
                                                   year_options->epw->summer_to}
                         : year_options->summer.time;
    options.samples = (int)study->samples;
    options.error = study->error;
    options.seed = study->seed;
    options.threads = study->threads;
    options.strict = study->strict;
    options.watch = study->watch;
    options.hours.days = year_options->days;
    enum pp_status status =
        pp_weather_year_of_epw(&year, year_options->epw, &weather,
                               pp_read_file_title(year_options->weather), err);
    if (status != PP_OK)
        return status;
    status = pp_annual_of_study_room(&sheet, room, &year, &options, err);
    if (status == PP_OK && !sheet.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted");
    if (status == PP_OK)
        status = pp_year_chart_draw(canvas, &sheet, err);
    pp_annual_sheet_clear(&sheet);
    pp_weather_year_clear(&year);
    return status;
}

const struct pp_chart_kind pp_draw_year = {
    .name = "year",
    .summary =
        "daylight in every hour of a year: a map by day and hour, plans and a curve",
    .of_year = true,
    .landscape = true,
    .draw = draw_year,
};
