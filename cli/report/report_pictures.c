/* report_pictures.c - see report_pictures.h. */
#include "cli/report/report_pictures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api/chart_kind.h"
#include "charts/document/document_sheets.h"
#include "charts/year/year_chart.h"
#include "model/base/array.h"

struct drawing_task {
    struct pp_report_pictures *pictures;
    const struct pp_assess_run *run;
    bool to_place;
    const struct pp_study_room **before; /* former state of each room; NULL entry:
                                          * none */
};

/* ---- one picture ---- */

static struct pp_sheet picture_sheet(const struct pp_study_room *room,
                                     const struct pp_chart_kind *kind, bool to_place)
{
    struct pp_sheet sheet = pp_document_sheets_picture();
    sheet.format = PP_CHART_SVG;
    sheet.to_place = to_place;
    sheet.title = room->world->name ? room->world->name : kind->name;
    sheet.description = kind->summary;
    return sheet;
}

/* Draws a chart of a room, or of a site whose first room is this one. *canvas is set to
 * NULL if there is nothing to draw. */
static enum pp_status draw_chart(struct pp_canvas **canvas, const char *name,
                                 const struct pp_study_room *room,
                                 const struct pp_study_options *options,
                                 const struct pp_chart_choice *choice, bool to_place,
                                 struct pp_error *err)
{
    const struct pp_chart_kind *kind = pp_chart_kind_find(name);
    const struct pp_sheet sheet = picture_sheet(room, kind, to_place);
    struct pp_study_room drawn = *room;
    bool finished = true;
    enum pp_status status = pp_canvas_create(canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    /* Copies the points, because a section may replace the points of the room. */
    drawn.receivers =
        malloc(((size_t)room->receiver_count + 1) * sizeof *room->receivers);
    if (drawn.receivers) {
        memcpy(drawn.receivers, room->receivers,
               (size_t)room->receiver_count * sizeof *room->receivers);
        status = kind->draw(*canvas, &drawn, options, choice, &finished, err);
    } else {
        status = pp_fail_memory(err);
    }
    free(drawn.receivers);
    if (status != PP_OK) {
        pp_canvas_destroy(*canvas);
        *canvas = NULL;
    }
    return status == PP_BAD_INPUT ? PP_OK : status;
}

static enum pp_status grow_pictures(struct pp_report_pictures *pictures,
                                    struct pp_error *err)
{
    enum pp_status status =
        pp_array_append(&pictures->list, pictures->count, sizeof *pictures->list, err);
    return status == PP_OK ? pp_array_append(&pictures->canvases, pictures->count,
                                             sizeof *pictures->canvases, err)
                           : status;
}

/* Options for the drawings of a room. Drawings are simulated if the results of the room
 * are simulated, with twice the standard error and a tenth of the time limit. Drawings
 * of a whole site are not simulated. */
static struct pp_study_options drawing_options(const struct drawing_task *task,
                                               int room)
{
    const struct pp_study_options *study = &task->run->words->room.study;
    struct pp_study_options options = PP_STUDY_OPTIONS_NONE;
    options.simulate = study->simulate && room != PP_SITE_WHOLE;
    options.error = 2.0 * study->error;
    options.samples = study->samples;
    options.seconds = 0.1 * study->seconds;
    options.seed = study->seed;
    options.threads = study->threads;
    return options;
}

/* Adds a chart of the given kind. first: first room of the chart; room: index of the
 * room for which the picture is listed; PP_SITE_WHOLE: the whole site. */
static enum pp_status add_drawing(struct drawing_task *task, int room, int first,
                                  const char *kind, const char *title,
                                  struct pp_chart_choice choice, struct pp_error *err)
{
    struct pp_report_pictures *pictures = task->pictures;
    struct pp_canvas *canvas;
    const struct pp_study_options options = drawing_options(task, room);
    choice.board.sky = pp_sky_overcast();
    choice.availability = pp_year_options_default;
    enum pp_status status = grow_pictures(pictures, err);
    if (status == PP_OK)
        status = draw_chart(&canvas, kind, &task->run->rooms->list[first], &options,
                            &choice, task->to_place, err);
    if (status != PP_OK || !canvas)
        return status;
    pictures->canvases[pictures->count] = canvas;
    pictures->list[pictures->count++] = (struct pp_site_picture){room, title};
    return PP_OK;
}

/* ---- drawings of a site ---- */

/* Number of rooms that belong to the same file as room `first`. */
static int rooms_of_site(const struct pp_rooms *rooms, int first)
{
    int count = 1;
    while (first + count < rooms->count
           && rooms->list[first + count].building == rooms->list[first].building)
        count++;
    return count;
}

/* True if the site has several rooms, a former state, or blocks. */
static bool is_site(const struct drawing_task *task, int first, int count)
{
    bool outside = count > 1;
    for (int i = first; i < first + count; i++)
        outside |= task->before[i] || task->run->rooms->list[i].world->block_count > 0;
    return outside;
}

static enum pp_status draw_site(struct drawing_task *task, int first, int count,
                                struct pp_error *err)
{
    const struct pp_chart_choice choice = {.site = {&task->run->rooms->list[first],
                                                    &task->before[first], count,
                                                    task->run->words->french_m}};
    enum pp_status status = add_drawing(
        task, PP_SITE_WHOLE, first, "site",
        "Site plan, with the vertical sky component of windows", choice, err);
    return status == PP_OK
               ? add_drawing(task, PP_SITE_WHOLE, first, "elevation",
                             "External walls, with the vertical sky component on them",
                             choice, err)
               : status;
}

/* ---- drawings of a room ---- */

/* Line in the room file of the window with the least sun, relative to the requirement
 * of a criterion if there is one. 0: the criterion applies to the whole room; -1:
 * sunlight is not assessed. */
static int least_sunny(const struct pp_assessment *room)
{
    int line = -1;
    double least = INFINITY;
    for (int i = 0; i < room->answers.count; i++) {
        const char *name = room->answers.list[i].criterion->name;
        const struct pp_finding_list *findings = &room->answers.list[i].findings;
        if (strcmp(name, "sunlight") != 0 && strcmp(name, "sun-exposure") != 0)
            continue;
        for (int k = 0; k < findings->count; k++) {
            const struct pp_finding *finding = &findings->list[k];
            double share =
                finding->figure / (isnan(finding->wanted) ? 1.0 : finding->wanted);
            if (!isfinite(share) || share >= least)
                continue;
            least = share;
            line = finding->line;
        }
    }
    return line;
}

static enum pp_status draw_sun(struct drawing_task *task, int room,
                               struct pp_chart_choice choice, struct pp_error *err)
{
    char words[16];
    int line = task->run->words->profile ? least_sunny(&task->run->all.list[room]) : -1;
    if (line < 0)
        return PP_OK;
    snprintf(words, sizeof words, "%d", line);
    choice.board.window = line > 0 ? words : NULL;
    return add_drawing(task, room, room, "sun-path",
                       "Sun paths and obstructions at the window with the least sun",
                       choice, err);
}

/* Draws the chart of the simulated year of a room, if there is one. */
static enum pp_status draw_room_year(struct drawing_task *task, int room,
                                     struct pp_error *err)
{
    const struct pp_assessment *one = &task->run->all.list[room];
    struct pp_report_pictures *pictures = task->pictures;
    const struct pp_sheet sheet =
        picture_sheet(one->room, &pp_draw_year, task->to_place);
    if (!one->has_year || !one->year.finished)
        return PP_OK;
    enum pp_status status = grow_pictures(pictures, err);
    if (status == PP_OK)
        status = pp_canvas_create(&pictures->canvases[pictures->count], &sheet, err);
    if (status != PP_OK)
        return status;
    pictures->list[pictures->count] = (struct pp_site_picture){
        room, "Illuminance by day and hour, plans of annual figures, frequency of "
              "illuminances"};
    return pp_year_chart_draw(pictures->canvases[pictures->count++], &one->year, err);
}

/* Checks the position of the section: PP_BAD_INPUT if the room cannot be cut there. */
static enum pp_status check_cut(const struct drawing_task *task, int room,
                                struct pp_error *err)
{
    const struct pp_section_place *cut = &task->run->words->cut;
    struct pp_study_room copy = task->run->rooms->list[room];
    if (cut->kind == PP_SECTION_OF_ROOM)
        return PP_OK;
    copy.receivers = copy.world->receivers;
    enum pp_status status = pp_section_line(&copy, cut, err);
    if (copy.receivers != copy.world->receivers)
        free(copy.receivers);
    return status;
}

static enum pp_status draw_room(struct drawing_task *task, int room,
                                struct pp_error *err)
{
    const struct pp_chart_choice alone = {.cut = task->run->words->cut,
                                          .known = &task->run->all.list[room].report},
                                 compared = {.site = {&task->run->rooms->list[room],
                                                      &task->before[room], 1,
                                                      task->run->words->french_m}};
    bool simulated = task->run->words->room.study.simulate;
    enum pp_status status = check_cut(task, room, err);
    if (status == PP_OK)
        status = add_drawing(
            task, room, room, "plan",
            simulated ? "Plan, with contours of the simulated daylight factor"
                      : "Plan, with contours of the daylight factor by hand",
            alone, err);
    if (status == PP_OK)
        status = add_drawing(
            task, room, room, "section",
            simulated ? "Section, with simulated daylight factors along the room; hand "
                        "figures dashed"
                      : "Section, with daylight factors by hand along the room",
            alone, err);
    if (status == PP_OK && task->before[room])
        status = add_drawing(task, room, room, "plan",
                             "View of the sky, existing and proposed", compared, err);
    if (status == PP_OK)
        status = draw_sun(task, room, compared, err);
    return status == PP_OK ? draw_room_year(task, room, err) : status;
}

enum pp_status pp_report_pictures_draw(struct pp_report_pictures *pictures,
                                       const struct pp_assess_run *run, bool full,
                                       bool to_place, struct pp_error *err)
{
    const struct pp_rooms *rooms = run->rooms;
    enum pp_status status = PP_OK;
    *pictures = (struct pp_report_pictures){0};
    struct drawing_task task = {
        pictures, run, to_place,
        calloc((size_t)rooms->count + 1, sizeof(struct pp_study_room *))};
    if (!task.before)
        return pp_fail_memory(err);
    for (int i = 0; i < rooms->count; i++)
        task.before[i] = run->all.list[i].before;
    for (int i = 0, count; i < rooms->count && status == PP_OK; i += count) {
        count = rooms_of_site(rooms, i);
        if (is_site(&task, i, count))
            status = draw_site(&task, i, count, err);
    }
    for (int i = 0; i < rooms->count && full && status == PP_OK; i++)
        status = draw_room(&task, i, err);
    free(task.before);
    return status;
}

void pp_report_pictures_clear(struct pp_report_pictures *pictures)
{
    for (int i = 0; i < pictures->count; i++)
        pp_canvas_destroy(pictures->canvases[i]);
    free(pictures->canvases);
    free(pictures->list);
}
