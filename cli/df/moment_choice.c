/* moment_choice.c - see moment_choice.h. */
#include "cli/df/moment_choice.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/availability/availability_options.h"
#include "cli/job.h"
#include "cli/message.h"
#include "cli/terminal.h"
#include "model/base/read_file.h"
#include "reports/annual/moment_report.h"
#include "studies/year/moment.h"

/* ---- the options ---- */

static enum pp_status read_when(const char *text, void *place, struct pp_error *err)
{
    struct pp_moment_choice *choice = place;
    int year, month, day, hour, minute, used = 0;
    if (sscanf(text, "%4d-%2d-%2d %2d:%2d%n", &year, &month, &day, &hour, &minute,
               &used)
            != 5
        || text[used] != '\0' || month < 1 || month > 12 || day < 1
        || day > pp_month_day_days_of_month(month) || hour < 0 || hour > 23
        || minute < 0 || minute > 59)
        return pp_fail(err, PP_BAD_INPUT,
                       "a time as 'YYYY-MM-DD HH:MM', in standard time");
    choice->when = text;
    choice->date = (struct pp_month_day){month, day};
    choice->clock_h = hour + minute / 60.0;
    return PP_OK;
}

const struct pp_option pp_moment_options[] = {
    {"when", 0, "'YYYY-MM-DD HH:MM'",
     "Illuminances in lux at that time, of the record of --weather that holds it, with "
     "direct sunlight, in place of daylight factors.",
     read_when, 0},
    {"weather", 'w', "FILE.epw", "Weather file of --when.", pp_options_read_input,
     offsetof(struct pp_moment_choice, weather)},
    {0},
};

enum pp_status pp_moment_choice_settle(const struct pp_moment_choice *choice,
                                       const struct pp_room_options *room,
                                       struct pp_error *err)
{
    const struct pp_study_options *study = &room->study;
    if (!choice->when && !choice->weather)
        return PP_OK;
    if (!choice->when || !choice->weather)
        return pp_fail(
            err, PP_BAD_INPUT, "%s needs %s", choice->when ? "--when" : "--weather",
            choice->when ? "--weather FILE.epw" : "--when 'YYYY-MM-DD HH:MM'");
    if (study->methods || study->explain || study->sky || study->external_lux > 0.0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--when is simulated, with the sky of the weather file; expected "
            "it without %s",
            study->methods   ? "--methods"
            : study->explain ? "--explain"
            : study->sky     ? "--sky"
                             : "--external");
    if (study->samples > 0
        && (study->samples > 65536 || (study->samples & (study->samples - 1)) != 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--samples is %ld; expected a power of two up to 65536",
                       study->samples);
    return PP_OK;
}

/* ---- the run ---- */

struct moment_run {
    const struct pp_moment_choice *choice;
    const struct pp_room_options *room;
    enum pp_format format;
    const struct pp_rooms *rooms;
    const struct pp_epw *epw;
    struct pp_weather_year year;
    struct pp_annual_results results;
};

static enum pp_status compute_moment(void *data, struct pp_error *err)
{
    struct moment_run *run = data;
    const struct pp_study_options *study = &run->room->study;
    const struct pp_weather_options weather = {.sun_shift_h = NAN};
    const struct pp_annual_options options = {.samples = (int)study->samples,
                                              .error = study->error,
                                              .seed = study->seed,
                                              .threads = study->threads};
    enum pp_status status = pp_weather_year_of_epw(
        &run->year, run->epw, &weather, pp_read_file_title(run->choice->weather), err);
    run->results.list =
        calloc((size_t)run->rooms->count + 1, sizeof *run->results.list);
    if (status == PP_OK && !run->results.list)
        status = pp_fail_memory(err);
    for (int i = 0; i < run->rooms->count && status == PP_OK; i++) {
        const struct pp_study_room *room = &run->rooms->list[i];
        run->results.count = i + 1;
        run->results.list[i].file = room->file;
        status =
            pp_moment_of_room(&run->results.list[i].sheet, room->world, &room->light,
                              room->receivers, room->receiver_count, &run->year,
                              run->choice->date, run->choice->clock_h, &options, err);
    }
    return status;
}

static enum pp_status print_moment(const void *data, FILE *out, struct pp_error *err)
{
    const struct moment_run *run = data;
    const char *when = run->choice->when;
    switch (run->format) {
    case PP_FORMAT_JSON:
        return pp_moment_report_json(&run->results, when, out, err);
    case PP_FORMAT_CSV:
        return pp_moment_report_csv(&run->results, when, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return pp_moment_report_text(&run->results, when,
                                 pp_terminal_width(run->room->output), out, err);
}

enum pp_exit pp_moment_choice_run(const struct pp_moment_choice *choice,
                                  const struct pp_room_options *room,
                                  enum pp_format format, bool array,
                                  const struct pp_rooms *rooms)
{
    struct pp_year_options light = pp_year_options_default;
    light.weather = choice->weather;
    enum pp_exit result = pp_availability_options_load(&light);
    if (result == PP_EXIT_DONE) {
        struct moment_run run = {.choice = choice,
                                 .room = room,
                                 .format = format,
                                 .rooms = rooms,
                                 .epw = light.epw,
                                 .results = {.several = rooms->several || array}};
        result = pp_job_run(
            &(struct pp_job){room->output, compute_moment, print_moment, NULL, &run});
        for (int i = 0; i < run.results.count; i++)
            pp_annual_sheet_clear(&run.results.list[i].sheet);
        free(run.results.list);
        pp_weather_year_clear(&run.year);
    }
    pp_availability_options_clear(&light);
    return result;
}
