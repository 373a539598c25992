/* draw_note.c - a calculation as a design note: the worksheet of df --explain for a
 * point, typeset with drawings. There is one note for each point. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "api/chart_kind.h"
#include "api/cited_works.h"
#include "charts/note/note_chart.h"
#include "model/base/text.h"
#include "reports/parts/print_notes.h"
#include "reports/parts/print_reliability.h"
#include "studies/study_report.h"

enum { POINTS_MOST = 12, WORKS_MOST = 32, NOTES_MOST = 32, SENTENCE = 256, WORK = 512 };

/* Texts of the note that the report does not contain. */
struct note_words {
    char (*sentences)[SENTENCE]; /* one per column */
    const char **contents;       /* pointers to the rows of `sentences` */
    char works[WORKS_MOST][WORK];
    const char *sources[WORKS_MOST], *keys[WORKS_MOST];
    int source_count;
    char *text; /* all notes in succession; `notes` points into this text */
    const char *notes[NOTES_MOST];
    int note_count;
};

static void add_work(struct note_words *words, const char *place)
{
    const char *key, *work = place ? pp_cited_works_find(place, &key) : NULL;
    for (int i = 0; work && i < words->source_count; i++)
        if (strcmp(words->keys[i], key) == 0)
            return;
    if (!work || words->source_count == WORKS_MOST)
        return;
    words->keys[words->source_count] = key;
    snprintf(words->works[words->source_count], WORK, "[%s] %s", key, work);
    words->sources[words->source_count] = words->works[words->source_count];
    words->source_count++;
}

/* Adds a sentence on the allowances that the method includes, and the publications of
 * the method and its formulae. */
static void add_method(struct note_words *words, const char *name, int column)
{
    const struct pp_method *method = pp_method_find(name);
    if (!method)
        return;
    pp_allowance_sentence(words->sentences[column], SENTENCE, method->source,
                          method->allowances);
    add_work(words, method->source);
    for (int i = 0; method->formulae && method->formulae[i]; i++)
        add_work(words, method->formulae[i]->source);
}

/* Adds the notes below a table of df, one line each. */
static enum pp_status add_notes(struct note_words *words,
                                const struct pp_report *report, struct pp_error *err)
{
    enum { ONE_LINE = 100000 };
    size_t length;
    FILE *out = open_memstream(&words->text, &length);
    if (!out)
        return pp_fail_memory(err);
    bool written = pp_print_notes(report, ONE_LINE, out);
    struct pp_reliability reliability = pp_reliability_of(report);
    pp_print_reliability(&reliability, ONE_LINE, out);
    if (fclose(out) != 0 || !written)
        return pp_fail_memory(err);
    char *rest = words->text;
    while (rest && *rest && words->note_count < NOTES_MOST) {
        char *line = strsep(&rest, "\n");
        line += strspn(line, " -");
        if (*line)
            words->notes[words->note_count++] = line;
    }
    return PP_OK;
}

static enum pp_status find_words(struct note_words *words,
                                 const struct pp_report *report, struct pp_error *err)
{
    size_t count = (size_t)report->column_count + 1;
    words->sentences = calloc(count, sizeof *words->sentences);
    words->contents = calloc(count, sizeof *words->contents);
    if (!words->sentences || !words->contents)
        return pp_fail_memory(err);
    for (int i = 0; i < report->column_count; i++) {
        words->contents[i] = words->sentences[i];
        add_method(words, report->columns[i].name, i);
    }
    return add_notes(words, report, err);
}

static enum pp_status draw_words(struct pp_canvas *canvas,
                                 const struct pp_report *report, struct pp_error *err)
{
    struct note_words *words = calloc(1, sizeof *words);
    if (!words)
        return pp_fail_memory(err);
    enum pp_status status = find_words(words, report, err);
    const struct pp_note_chart note = {.report = report,
                                       .contents = words->contents,
                                       .sources = words->sources,
                                       .source_count = words->source_count,
                                       .notes = words->notes,
                                       .note_count = words->note_count};
    if (status == PP_OK)
        status = pp_note_chart_draw(canvas, &note, err);
    free(words->sentences);
    free(words->contents);
    free(words->text);
    free(words);
    return status;
}

/* Draws the note of one of the room's points. */
static enum pp_status draw_point(struct pp_canvas *canvas,
                                 const struct pp_study_room *room, int point,
                                 const struct pp_study_options *study,
                                 struct pp_error *err)
{
    struct pp_study_room one = *room;
    struct pp_study_options options = *study;
    struct pp_report report = {.finished = true};
    one.receivers = room->receivers + point;
    one.receiver_count = 1;
    options.explain = true;
    enum pp_status status = pp_study_report_methods(&report, &one, &options, err);
    if (status == PP_OK)
        status = draw_words(canvas, &report, err);
    pp_report_clear(&report);
    return status;
}

static enum pp_status draw_note(struct pp_canvas *canvas, struct pp_study_room *room,
                                const struct pp_study_options *study,
                                const struct pp_chart_choice *choice, bool *finished,
                                struct pp_error *err)
{
    (void)choice, (void)finished;
    if (room->receiver_count < 1 || room->receiver_count > POINTS_MOST)
        return pp_fail(
            err, PP_BAD_INPUT,
            "%s: a note covers 1 to %d points, but there are %d; expected --points X,Y",
            room->world->name, POINTS_MOST, room->receiver_count);
    if (room->receiver_count > 1 && !pp_canvas_has_sheets(canvas))
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: there are %d points, but only a PDF can hold a sheet for "
                       "each; expected -o FILE.pdf, or one point",
                       room->world->name, room->receiver_count);
    enum pp_status status = PP_OK;
    for (int i = 0; i < room->receiver_count && status == PP_OK; i++) {
        if (i > 0)
            status = pp_canvas_next_sheet(canvas, err);
        if (status == PP_OK)
            status = draw_point(canvas, room, i, study, err);
    }
    return status;
}

static enum pp_status check_note_choice(const char *methods, bool simulate,
                                        struct pp_error *err)
{
    (void)methods;
    return simulate ? pp_fail(err, PP_BAD_INPUT,
                              "a note shows hand calculations, but a simulation has "
                              "none; expected hand methods without --simulate")
                    : PP_OK;
}

const struct pp_chart_kind pp_draw_note = {
    .name = "note",
    .summary = "the calculation of df --explain as a typeset note with drawings",
    .check = check_note_choice,
    .draw = draw_note,
};
