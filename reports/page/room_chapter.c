/* room_chapter.c - see room_chapter.h. */
#include "reports/page/room_chapter.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "model/results/reading.h"
#include "reports/assess/finding_cells.h"
#include "reports/page/year_section.h"
#include "reports/parts/print.h"

void pp_room_chapter_number(struct pp_document *document, double value, int decimals)
{
    if (isfinite(value))
        pp_document_cell(document, PP_TONE_PLAIN, "%.*f", decimals, value + 0.0);
    else
        pp_document_cell(document, PP_TONE_PLAIN, "–");
}

void pp_room_chapter_verdict(struct pp_document *document,
                             const struct pp_finding *finding)
{
    const char *word = pp_finding_own_word(finding);
    enum pp_tone tone = finding->is_optional             ? PP_TONE_PLAIN
                        : finding->verdict == PP_MET     ? PP_TONE_GOOD
                        : finding->verdict == PP_NOT_MET ? PP_TONE_BAD
                                                         : PP_TONE_PLAIN;
    pp_document_cell(document, tone, "%s",
                     word                     ? word
                     : isnan(finding->wanted) ? "no target"
                                              : "–");
}

void pp_room_chapter_pictures(struct pp_document *document,
                              const struct pp_site_report *report, int room)
{
    for (int i = 0; i < report->picture_count; i++)
        if (report->pictures[i].room == room)
            pp_document_picture(document, i, report->pictures[i].title);
}

/* ---- input data ---- */

static void add_chapter_fact(void *document, const char *label, const char *text)
{
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", label);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", text);
}

static void put_facts(struct pp_document *document, const struct pp_assessment *room)
{
    const struct pp_world *world = room->room->world;
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_LABELS, "%s", "");
    pp_document_column(document, PP_COLUMN_WORDS, "%s", "");
    if (world->ref)
        add_chapter_fact(document, "reference", world->ref);
    if (world->use)
        add_chapter_fact(document, "use", pp_room_use_words[world->use]);
    pp_print_facts(world, &room->room->light, add_chapter_fact, document);
}

/* ---- averages ---- */

/* True if any average daylight factor has a standard error. */
static bool any_sampled(const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++)
        if (report->columns[i].component == PP_DF
            && isfinite(report->columns[i].average.std_error))
            return true;
    return false;
}

static bool any_band(const struct pp_report *report)
{
    for (int i = 0; i < report->column_count; i++)
        if (report->columns[i].component == PP_DF
            && pp_band_is_known(report->columns[i].average_band))
            return true;
    return false;
}

static void put_average(struct pp_document *document, const struct pp_column *column,
                        bool sampled, bool bands)
{
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", column->name);
    pp_room_chapter_number(document, 100.0 * column->average.value, 2);
    if (sampled)
        pp_room_chapter_number(document, pp_reading_printed_error(&column->average), 2);
    if (bands && pp_band_is_known(column->average_band))
        pp_document_cell(document, PP_TONE_PLAIN, "%.2f–%.2f",
                         100.0 * column->average_band.low,
                         100.0 * column->average_band.high);
    else if (bands)
        pp_document_cell(document, PP_TONE_PLAIN, "–");
}

/* Writes the averages over the working plane, for each method that has one. */
static void put_averages(struct pp_document *document, const struct pp_report *report)
{
    bool sampled = any_sampled(report), bands = any_band(report);
    if (report->column_count == 0)
        return;
    pp_document_heading(document, 3, "Average daylight factor over the working plane");
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "by");
    pp_document_column(document, PP_COLUMN_NUMBERS, "average, %%");
    if (sampled)
        pp_document_column(document, PP_COLUMN_NUMBERS, "± standard error");
    if (bands)
        pp_document_column(document, PP_COLUMN_NUMBERS, "95 %% band");
    for (int i = 0; i < report->column_count; i++)
        if (report->columns[i].component == PP_DF
            && isfinite(report->columns[i].average.value))
            put_average(document, &report->columns[i], sampled, bands);
    if (bands)
        pp_document_paragraph(document, PP_TONE_SOFT,
                              "95 %% band: in 95 of 100 similar simulated rooms (the "
                              "atlas) the true value was in this range.");
}

/* ---- verdicts ---- */

static void put_finding(struct pp_document *document, const struct pp_finding *finding)
{
    char figure[PP_FINDING_CELL], wanted[PP_FINDING_CELL];
    pp_finding_cells_figure(figure, finding, true);
    pp_finding_cells_wanted(wanted, finding, true);
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", finding->what);
    if (finding->note[0])
        pp_document_note(document, finding->note);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", figure);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", wanted);
    pp_room_chapter_verdict(document, finding);
}

static void put_answer(struct pp_document *document, const struct pp_answer *answer)
{
    const struct pp_finding_list *findings = &answer->findings;
    pp_document_row(document, PP_ROW_GROUP);
    const struct pp_criterion *criterion = answer->criterion;
    pp_document_cell(document, PP_TONE_PLAIN, "%s [%s]%s", criterion->title,
                     criterion->source, criterion->withdrawn ? " (withdrawn)" : "");
    if (criterion->withdrawn) {
        pp_document_row(document, PP_ROW_REMARK);
        pp_document_cell(document, PP_TONE_SOFT, "%s", criterion->withdrawn);
    }
    if (findings->basis[0]) {
        pp_document_row(document, PP_ROW_REMARK);
        pp_document_cell(document, PP_TONE_SOFT, "%s", findings->basis);
    }
    for (int i = 0; i < findings->count; i++)
        put_finding(document, &findings->list[i]);
}

static void put_answers(struct pp_document *document, const struct pp_assessment *room)
{
    if (room->answers.count == 0) {
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "None of the selected criteria applies to this room.");
        return;
    }
    pp_document_heading(document, 3, "Criteria");
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "what");
    pp_document_column(document, PP_COLUMN_NUMBERS, "found");
    pp_document_column(document, PP_COLUMN_NUMBERS, "target");
    pp_document_column(document, PP_COLUMN_WORDS, "verdict");
    for (int i = 0; i < room->answers.count; i++)
        put_answer(document, &room->answers.list[i]);
}

static void put_gains(struct pp_document *document, const struct pp_gains *gains)
{
    char sentence[256];
    if (!gains->method || gains->count == 0)
        return;
    pp_gains_sentence(gains, sentence, sizeof sentence);
    pp_document_heading(document, 3, "Effect of changes");
    pp_document_paragraph(document, PP_TONE_PLAIN, "%s", sentence);
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "change");
    pp_document_column(document, PP_COLUMN_NUMBERS, "average, %%, %s",
                       strcmp(gains->method, "traced") == 0 ? "simulated"
                                                            : gains->method);
    pp_document_column(document, PP_COLUMN_NUMBERS, "gained");
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_SOFT, "as it is");
    pp_room_chapter_number(document, 100.0 * gains->now.average, 2);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", "");
    for (int i = 0; i < gains->count; i++) {
        const struct pp_gain *gain = &gains->list[i];
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", gain->change);
        pp_room_chapter_number(document, 100.0 * gain->values.average, 2);
        pp_document_cell(document, PP_TONE_PLAIN, "%+.0f %%",
                         100.0 * (gain->values.average / gains->now.average - 1.0));
    }
}

void pp_room_chapter(struct pp_document *document, const struct pp_site_report *report,
                     int room)
{
    const struct pp_assessment *one = &report->all->list[room];
    const char *name = one->room->world->name;
    pp_document_heading(document, 2, "%s", name ? name : "Room");
    put_facts(document, one);
    put_averages(document, &one->report);
    put_answers(document, one);
    if (one->has_gains)
        put_gains(document, &one->gains);
    if (one->has_year && one->year.finished)
        pp_year_section(document, &one->year);
    pp_room_chapter_pictures(document, report, room);
}
