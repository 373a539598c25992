/* cmd_report.c - the command report: rooms, their drawings, figures and verdicts as one
 * page. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "config.h"

#include "api/chart_kind.h"
#include "api/chart_sheet.h"
#include "cli/assess/assess_run.h"
#include "cli/command.h"
#include "model/base/text.h"
#include "reports/page/site_page.h"

#define PLACE(member) offsetof(struct pp_assess_words, member)

static const char about[] =
    "Writes a report of all rooms of a file as one page of HTML that needs nothing "
    "else: "
    "what is known of each room, its plan and section, daylight factors by hand with "
    "their bands and traced with their standard errors, what they have to reach, and "
    "what would help. Of a site existing and proposed also every window's sky and "
    "every "
    "room's lit area before and after. FILE is a room file; - is standard input.";

/* The drawings of every room: contours in plan, factors along a section. */
static const struct {
    const char *kind, *title;
} drawings[] = {{"plan", "Plan, with contours of the daylight factor by hand"},
                {"section", "Daylight factors by hand along the room"}};

enum { DRAWINGS = sizeof drawings / sizeof *drawings };

/* The SVG of a room's chart; NULL in *svg where there is nothing to draw, such as the
 * plan of a room that no hand method covers. */
static enum pp_status draw(char **svg, size_t *length, const char *name,
                           const struct pp_study_room *room, struct pp_error *err)
{
    const struct pp_chart_kind *kind = pp_chart_kind_find(name);
    const struct pp_chart_choice choice = {.board = {.sky = pp_sky_overcast()},
                                           .availability = pp_year_options_default};
    const struct pp_study_options options = PP_STUDY_OPTIONS_NONE;
    const struct pp_sheet sheet = {.format = PP_CHART_SVG,
                                   .paper = PP_PAPER_A5,
                                   .title =
                                       room->world->name ? room->world->name : name,
                                   .description = kind->summary};
    struct pp_study_room drawn = *room;
    struct pp_canvas *canvas;
    const unsigned char *bytes;
    bool finished = true;
    *svg = NULL;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    /* A section may put points of its own in place of the room's. */
    drawn.receivers =
        malloc(((size_t)room->receiver_count + 1) * sizeof *room->receivers);
    if (!drawn.receivers) {
        pp_canvas_destroy(canvas);
        return pp_fail_memory(err);
    }
    memcpy(drawn.receivers, room->receivers,
           (size_t)room->receiver_count * sizeof *room->receivers);
    status =
        pp_chart_sheet_draw(kind, canvas, &drawn, &options, &choice, &finished, err);
    if (status == PP_OK)
        status = pp_canvas_finish(canvas, &bytes, length, err);
    if (status == PP_OK && (*svg = malloc(*length + 1)) != NULL) {
        memcpy(*svg, bytes, *length);
        (*svg)[*length] = '\0';
    } else if (status == PP_OK) {
        status = pp_fail_memory(err);
    }
    free(drawn.receivers);
    pp_canvas_destroy(canvas);
    return status == PP_BAD_INPUT ? PP_OK : status;
}

static enum pp_status draw_all(struct pp_site_picture *pictures, int *count,
                               const struct pp_rooms *rooms, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < rooms->count; i++)
        for (int k = 0; k < DRAWINGS && status == PP_OK; k++) {
            struct pp_site_picture *picture = &pictures[*count];
            *picture = (struct pp_site_picture){.room = i, .title = drawings[k].title};
            status = draw(&picture->svg, &picture->length, drawings[k].kind,
                          &rooms->list[i], err);
            *count += status == PP_OK && picture->svg;
        }
    return status;
}

/* The words that make the same report again. */
static void say_words(char *text, size_t size, const struct pp_assess_run *run)
{
    const struct pp_assess_words *words = run->words;
    const struct pp_study_options *study = &words->room.study;
    pp_text_append(text, size, "pepperpot report");
    if (words->criteria)
        pp_text_append(text, size, " --criteria %s", words->criteria);
    if (words->profile_name)
        pp_text_append(text, size, " --for %s", words->profile_name);
    if (words->before)
        pp_text_append(text, size, " --before %s", words->before);
    if (words->place)
        pp_text_append(text, size, " --place %s", words->place);
    if (words->room.state != PP_STATE_BOTH)
        pp_text_append(text, size, " --state %s",
                       words->room.state == PP_STATE_EXISTING ? "existing"
                                                              : "proposed");
    if (study->sky)
        pp_text_append(text, size, " --sky %s", study->sky);
    if (!study->simulate)
        pp_text_append(text, size, " --by-hand");
    else if (study->samples)
        pp_text_append(text, size, " --samples %ld --seed %llu", (long)study->samples,
                       (unsigned long long)study->seed);
    else
        pp_text_append(text, size, " --error %g%% --seed %llu", 100.0 * study->error,
                       (unsigned long long)study->seed);
    const char *last = "";
    for (int i = 0; i < run->rooms->count; i++) {
        if (strcmp(run->rooms->list[i].file, last) != 0)
            pp_text_append(text, size, " %s", run->rooms->list[i].file);
        last = run->rooms->list[i].file;
    }
}

static enum pp_status print(const void *data, FILE *out, struct pp_error *err)
{
    const struct pp_assess_run *run = data;
    const struct pp_study_room *first = &run->rooms->list[0];
    char made_by[1024] = "";
    say_words(made_by, sizeof made_by, run);
    const char *building = pp_building_name(first->building);
    struct pp_site_page page = {.all = &run->all,
                                .title = building             ? building
                                         : first->world->name ? first->world->name
                                                              : first->file,
                                .made_by = made_by,
                                .version = PACKAGE_VERSION};
    struct pp_site_picture *pictures =
        calloc((size_t)run->rooms->count * DRAWINGS + 1, sizeof *pictures);
    if (!pictures)
        return pp_fail_memory(err);
    enum pp_status status = draw_all(pictures, &page.picture_count, run->rooms, err);
    page.pictures = pictures;
    if (status == PP_OK)
        status = pp_site_page(&page, out, err);
    for (int i = 0; i < page.picture_count; i++)
        free(pictures[i].svg);
    free(pictures);
    return status;
}

/* A name that asks for another format than the one there is. */
static enum pp_status check(void *values, char **files, int file_count,
                            struct pp_error *err)
{
    const struct pp_assess_words *words = values;
    const char *path = words->room.output, *dot = path ? strrchr(path, '.') : NULL;
    if (dot
        && (strcasecmp(dot, ".pdf") == 0 || strcasecmp(dot, ".svg") == 0
            || strcasecmp(dot, ".png") == 0))
        return pp_fail(err, PP_BAD_INPUT,
                       "--output: a report is a page of HTML, which browsers print to "
                       "PDF; expected a name such as report.html");
    return pp_assess_words_check(values, files, file_count, err);
}

static enum pp_exit run(void *words, char **files, int file_count)
{
    return pp_assess_run(words, "report", files, file_count, print);
}

static const struct pp_option_group groups[] = {
    {"What is judged", pp_assess_words_choice, 0},
    PP_ROOM_BY_HAND_GROUPS(PLACE(room)),
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

const struct pp_command pp_command_report = {
    .name = "report",
    .summary = "all of it as one page: drawings, figures, verdicts",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct pp_assess_words),
    .more_help = pp_assess_words_help,
    .init = pp_assess_words_init,
    .check = check,
    .run = run,
    .clear = pp_assess_words_clear,
    .deals = true,
    .ranks_place = PLACE(room.ranks),
};
