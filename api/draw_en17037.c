/* draw_en17037.c - the four parts of EN 17037 on one page. The room is assessed by a
 * simulation and a simulated year; the findings are put into words. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api/chart_kind.h"
#include "charts/room/room_words.h"
#include "charts/sheet/page.h"
#include "charts/year/en17037_chart.h"
#include "model/base/read_file.h"
#include "model/base/text.h"
#include "reports/assess/finding_cells.h"
#include "studies/climate/diffuse_light.h"
#include "studies/criteria/assessment.h"
#include "studies/criteria/en17037/en17037_level.h"
#include "studies/criteria/facade_sensitivity.h"
#include "studies/criteria/grid/plane_trace.h"

/* Target relative error of the simulation if none of --error, --samples and --time is
 * given. */
static const double usual_error = 0.02;

/* Probability at or above which a verdict is printed as certain, as in the output of
 * assess. */
static const double certain = 0.99995;

enum { PART_OF_HOURS = 1 }; /* index in page_parts of "every hour" */

/* Parts of the page in order; `none`: text if the criterion has no finding. */
static const struct {
    const char *criterion, *title, *none;
} page_parts[PP_EN17037_PARTS] = {
    {"en17037", "Daylight provision 1: daylight factor",
     "Rooms of this use need no daylight."},
    {"en17037-hours", "Daylight provision 2: every hour",
     "Rooms of this use need no daylight."},
    {"view-out", "View out", "Rooms of this use need no view."},
    {"sun-exposure", "Exposure to sunlight",
     "Not required for the use of this room: it is recommended for dwellings, wards "
     "and "
     "play rooms."},
    {"glare", "Protection from glare", "The room file has no view."},
};

/* ---- findings in words ---- */

static void fill_row(struct pp_en17037_row *row, const struct pp_finding *finding)
{
    const char *verdict = pp_finding_own_word(finding);
    snprintf(row->what, sizeof row->what, "%s", finding->what);
    pp_finding_cells_figure(row->figure, finding, true);
    pp_finding_cells_wanted(row->wanted, finding, true);
    row->over[0] = '\0';
    if (isfinite(finding->reached_over))
        snprintf(row->over, sizeof row->over, "over %.0f %%",
                 100.0 * finding->reached_over);
    snprintf(row->verdict, sizeof row->verdict, "%s", verdict ? verdict : "");
    if (finding->confidence > certain)
        pp_text_append(row->verdict, sizeof row->verdict, ": certain");
    else if (isfinite(finding->confidence))
        pp_text_append(row->verdict, sizeof row->verdict, ": %s%.0f %%",
                       finding->verdict == PP_UNDECIDED ? "met " : "",
                       floor(100.0 * finding->confidence));
    row->decides = verdict && !finding->is_optional;
}

/* Makes a row of each finding. If there are too many for the page, findings on the
 * optional levels are omitted. Returns the number of other findings that do not fit. */
static int fill_rows(struct pp_en17037_part *part,
                     const struct pp_finding_list *findings)
{
    bool all = findings->count <= PP_EN17037_ROWS;
    int left_out = 0;
    for (int i = 0; i < findings->count; i++) {
        if (!all && findings->list[i].is_optional)
            continue;
        if (part->row_count < PP_EN17037_ROWS)
            fill_row(&part->rows[part->row_count++], &findings->list[i]);
        else
            left_out++;
    }
    return left_out;
}

__attribute__((format(printf, 2, 3))) static void add_basis(
    struct pp_en17037_part *part, const char *format, ...)
{
    va_list arguments;
    pp_text_append(part->basis, sizeof part->basis, "%s", part->basis[0] ? "; " : "");
    va_start(arguments, format);
    pp_text_append_v(part->basis, sizeof part->basis, format, arguments);
    va_end(arguments);
}

/* Adds the basis of the findings, and each different note once. */
static void fill_basis(struct pp_en17037_part *part,
                       const struct pp_finding_list *findings)
{
    snprintf(part->basis, sizeof part->basis, "%s", findings->basis);
    for (int i = 0; i < findings->count; i++) {
        const char *note = findings->list[i].note;
        if (note[0] && !strstr(part->basis, note))
            add_basis(part, "%s", note);
    }
}

static void fill_part(struct pp_en17037_part *part, int index,
                      const struct pp_answer_list *answers)
{
    const struct pp_finding_list *findings = NULL;
    int left_out = 0;
    part->title = page_parts[index].title;
    part->reached = -1;
    snprintf(part->level, sizeof part->level, "not assessed");
    for (int i = 0; i < answers->count; i++)
        if (strcmp(answers->list[i].criterion->name, page_parts[index].criterion) == 0)
            findings = &answers->list[i].findings;
    if (!findings) {
        snprintf(part->basis, sizeof part->basis, "%s", page_parts[index].none);
        return;
    }
    struct pp_en17037_level level = pp_en17037_level_of(findings);
    if (level.judged) {
        part->reached = level.reached;
        pp_en17037_level_words(part->level, findings);
        left_out = fill_rows(part, findings);
    }
    fill_basis(part, findings);
    if (left_out > 0)
        add_basis(part, "%d more rows: see assess -c %s", left_out,
                  page_parts[index].criterion);
}

/* ---- maps ---- */

/* Fills both maps: illuminances from the daylight factor and from the year, each at its
 * own points. */
static enum pp_status fill_maps(struct pp_en17037_sheet *sheet,
                                const struct pp_assessment *assessment,
                                struct pp_error *err)
{
    const struct pp_report *report = &assessment->report;
    const struct pp_annual_sheet *year = &assessment->year;
    const struct pp_column *traced = pp_report_find(report, PP_DF, "traced");
    struct pp_en17037_map *maps = sheet->maps;
    maps[0] = (struct pp_en17037_map){
        .title = "Daylight factor × median external diffuse illuminance",
        .receivers = report->receivers,
        .count =
            traced && isfinite(assessment->median.lux) ? report->receiver_count : 0};
    maps[1] = (struct pp_en17037_map){
        .title = "Illuminance in half of the daylight hours",
        .receivers = year->receivers,
        .count = assessment->has_year && year->finished ? year->receiver_count : 0};
    for (int m = 0; m < PP_EN17037_MAPS; m++) {
        maps[m].lux = calloc((size_t)maps[m].count + 1, sizeof *maps[m].lux);
        if (!maps[m].lux)
            return pp_fail_memory(err);
    }
    for (int i = 0; i < maps[0].count; i++)
        maps[0].lux[i] = assessment->median.lux * traced->points[i].value;
    for (int i = 0; i < maps[1].count; i++)
        maps[1].lux[i] = year->points[i].median_lx.value;
    return PP_OK;
}

static enum pp_status draw_page(struct pp_canvas *canvas,
                                const struct pp_assessment *assessment,
                                struct pp_error *err)
{
    const struct pp_world *world = assessment->room->world;
    const char *weather = assessment->has_year ? assessment->year.weather : "";
    char place[256];
    struct pp_en17037_sheet *sheet = calloc(1, sizeof *sheet);
    if (!sheet)
        return pp_fail_memory(err);
    snprintf(place, sizeof place, "%.*s", (int)strcspn(weather, ";"), weather);
    if (world->use)
        pp_text_append(place, sizeof place, "%suse: %s", place[0] ? "; " : "",
                       pp_room_use_words[world->use]);
    sheet->world = world;
    sheet->place = place;
    sheet->part_count = PP_EN17037_PARTS;
    for (int i = 0; i < PP_EN17037_PARTS; i++)
        fill_part(&sheet->parts[i], i, &assessment->answers);
    for (int i = 0; assessment->has_year && i < assessment->year.warning_count; i++)
        add_basis(&sheet->parts[PART_OF_HOURS], "%s", assessment->year.warnings[i]);
    pp_room_words_size(sheet->room, sizeof sheet->room, world);
    pp_page_assumptions(sheet->room, sizeof sheet->room, world,
                        &assessment->room->light);
    pp_room_words_outside(sheet->room, sizeof sheet->room, world);
    enum pp_status status = fill_maps(sheet, assessment, err);
    if (status == PP_OK)
        status = pp_en17037_chart_draw(canvas, sheet, err);
    for (int m = 0; m < PP_EN17037_MAPS; m++)
        free(sheet->maps[m].lux);
    free(sheet);
    return status;
}

/* ---- the assessment ---- */

/* Finds the median diffuse illuminance of the weather file (lx). */
static enum pp_status find_weather_median(double *median_lux,
                                          const struct pp_year_options *options,
                                          struct pp_error *err)
{
    const char *file = pp_read_file_title(options->weather);
    struct pp_diffuse_light light;
    enum pp_status status = pp_diffuse_light_of_epw(&light, options->epw, file, err);
    if (status != PP_OK)
        return status;
    status = pp_diffuse_light_median(median_lux, &light, err);
    pp_diffuse_light_clear(&light);
    if (status == PP_OK && !(*median_lux > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: the file has no usable median illuminance for a year",
                       file);
    return status;
}

/* Assesses the room as assess --for en17037 does. */
static enum pp_status assess_parts(struct pp_assessment *assessment,
                                   const struct pp_study_room *room,
                                   const struct pp_assess_options *options,
                                   struct pp_error *err)
{
    struct pp_study_options own = *options->study;
    own.seconds *= 1.0 - PP_FACADE_SENSITIVITY_SHARE;
    enum pp_status status =
        pp_assessment_begin(assessment, room, 1, NULL, options, err);
    if (status == PP_OK && assessment->has_factors)
        status = pp_plane_trace(&assessment->report, &own, false, &assessment->by_clock,
                                err);
    if (status == PP_OK)
        status = pp_assessment_judge(assessment, options, err);
    return status == PP_OK ? pp_facade_sensitivity_check(assessment, options, err)
                           : status;
}

static enum pp_status draw_en17037(struct pp_canvas *canvas, struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice, bool *finished,
                                   struct pp_error *err)
{
    const struct pp_year_options *light = &choice->availability;
    const struct pp_weather_options weather = {.sun_shift_h = NAN};
    struct pp_study_options own = *study;
    struct pp_weather_year year;
    struct pp_assessment assessment;
    double median_lux;
    own.simulate = true;
    if (!(own.error > 0.0) && own.samples == 0 && !(own.seconds > 0.0))
        own.error = usual_error;
    if (!light->epw)
        return pp_fail(err, PP_BAD_INPUT,
                       "the page of EN 17037 needs a weather file; expected --weather "
                       "FILE.epw");
    enum pp_status status = find_weather_median(&median_lux, light, err);
    if (status == PP_OK)
        status = pp_weather_year_of_epw(&year, light->epw, &weather,
                                        pp_read_file_title(light->weather), err);
    if (status != PP_OK)
        return status;
    const struct pp_assess_options options = {.study = &own,
                                              .profile =
                                                  pp_profile_find("en17037", err),
                                              .median_lux = median_lux,
                                              .of_weather = true,
                                              .year = &year,
                                              .trace_again = true};
    status = assess_parts(&assessment, room, &options, err);
    if (status == PP_OK && !assessment.report.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted");
    if (status == PP_OK)
        status = draw_page(canvas, &assessment, err);
    *finished &= assessment.report.finished;
    pp_assessment_clear(&assessment);
    pp_weather_year_clear(&year);
    return status;
}

static enum pp_status check_en17037(const char *methods, bool simulate,
                                    struct pp_error *err)
{
    (void)simulate;
    return methods ? pp_fail(err, PP_BAD_INPUT,
                             "the page of EN 17037 is always simulated; expected no "
                             "--methods")
                   : PP_OK;
}

const struct pp_chart_kind pp_draw_en17037 = {
    .name = "en17037",
    .summary = "the four parts of EN 17037 on one page: levels, plans, figures",
    .of_year = true,
    .check = check_en17037,
    .draw = draw_en17037,
};
