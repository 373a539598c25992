/* study_output.c - implementation of pepperpot.h: reports and charts of a study. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api/chart_kind.h"
#include "api/chart_sheet.h"
#include "api/study.h"
#include "reports/df_text.h"
#include "reports/df_json.h"
#include "reports/df_csv.h"

enum { REPORT_COLUMNS = 80 };

enum pp_status pp_study_report(const struct pp_study *study, enum pp_format format,
                               char **bytes, size_t *length, struct pp_error *err)
{
    struct pp_result result = {.report = study->report, .file = study->room.file};
    const struct pp_results results = {
        .list = &result, .count = 1, .options = &study->options};
    *bytes = NULL;
    *length = 0;
    FILE *out = open_memstream(bytes, length);
    if (!out)
        return pp_fail_memory(err);
    enum pp_status status = format == PP_FORMAT_JSON ? pp_df_json(&results, out, err)
                            : format == PP_FORMAT_CSV
                                ? pp_df_csv(&results, out, err)
                                : pp_df_text(&results, REPORT_COLUMNS, true, out, err);
    if (fclose(out) != 0 && status == PP_OK)
        status = pp_fail_memory(err);
    if (status != PP_OK) {
        free(*bytes);
        *bytes = NULL;
        *length = 0;
    }
    return status;
}

/* Copies the study's room with a separate list of points, because a section may replace
 * the points. */
static enum pp_status borrow_room(struct pp_study_room *room,
                                  const struct pp_study *study, struct pp_error *err)
{
    *room = study->room;
    size_t size = (size_t)room->receiver_count * sizeof *room->receivers;
    struct pp_receiver *copy = malloc(size + 1);
    if (!copy)
        return pp_fail_memory(err);
    memcpy(copy, room->receivers, size);
    room->receivers = copy;
    return PP_OK;
}

static enum pp_status check_kind(const struct pp_chart_kind *kind, const char *name,
                                 const struct pp_study *study, struct pp_error *err)
{
    if (!kind)
        return pp_fail(err, PP_BAD_INPUT, "there is no chart \"%.100s\"", name);
    if (!study && !kind->board)
        return pp_fail(err, PP_BAD_INPUT,
                       "the chart \"%s\" shows a room; expected a study with a room",
                       name);
    if (study && kind->from_point && study->room.receiver_count != 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "the chart \"%s\" shows one point, but there are %d", name,
                       study->room.receiver_count);
    return PP_OK;
}

/* Draws a chart on a new canvas, and copies the bytes of the file. */
static enum pp_status draw_on_own_canvas(const struct pp_chart_kind *kind,
                                         struct pp_study_room *room,
                                         const struct pp_chart_request *request,
                                         char **bytes, size_t *length,
                                         struct pp_error *err)
{
    const struct pp_world *world = room ? room->world : NULL;
    const struct pp_chart_choice choice = {
        .scale = request->logarithmic ? PP_SCALE_LOG : PP_SCALE_AS_FITS,
        .board = {.sky = pp_sky_overcast()},
        .availability = pp_year_options_default};
    struct pp_study_options options = PP_STUDY_OPTIONS_NONE;
    options.methods = request->methods;
    const struct pp_sheet sheet = {
        .format = request->format,
        .paper = request->paper,
        .landscape = request->orientation == PP_LANDSCAPE
                     || (request->orientation == PP_AS_FITS
                         && pp_chart_kind_landscape(kind, world)),
        .dpi = request->dpi,
        .transparent = kind->transparent,
        .title = world && world->name ? world->name : kind->name,
        .description = kind->summary};
    struct pp_canvas *canvas;
    const unsigned char *drawn;
    bool finished = true;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status = pp_chart_sheet_draw(kind, canvas, room, &options, &choice, &finished, err);
    if (status == PP_OK)
        status = pp_canvas_finish(canvas, &drawn, length, err);
    if (status == PP_OK) {
        *bytes = malloc(*length + 1);
        if (*bytes)
            memcpy(*bytes, drawn, *length);
        else
            status = pp_fail_memory(err);
    }
    pp_canvas_destroy(canvas);
    return status;
}

enum pp_status pp_study_chart(const struct pp_study *study, const char *kind,
                              const struct pp_chart_request *request, char **bytes,
                              size_t *length, struct pp_error *err)
{
    const struct pp_chart_request usual = {.format = PP_CHART_PDF};
    const struct pp_chart_kind *found = pp_chart_kind_find(kind);
    struct pp_study_room room;
    *bytes = NULL;
    *length = 0;
    enum pp_status status = check_kind(found, kind, study, err);
    if (status == PP_OK && study)
        status = borrow_room(&room, study, err);
    if (status != PP_OK)
        return status;
    status = draw_on_own_canvas(found, study ? &room : NULL, request ? request : &usual,
                                bytes, length, err);
    if (study)
        free(room.receivers);
    if (status != PP_OK)
        *length = 0;
    return status;
}
