/* assess_text.c - lays out assessments: one row per finding with the verdict at the
 * end, and notes below the row. */
#include "reports/assess/assess_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reports/assess/finding_cells.h"
#include "reports/assess/trees_note.h"
#include "reports/parts/print.h"
#include "reports/parts/print_reliability.h"
#include "reports/gains_report.h"
#include "reports/parts/format.h"
#include "model/base/text.h"

enum { CELL = PP_FINDING_CELL, COLUMNS = 6, INDENT = 4, GAP = 2, NOTE_INDENT = 6 };
enum { WHAT, FIGURE, LUX, WANTED, OVER, VERDICT };

struct layout {
    int widths[COLUMNS];
    double external_lux; /* external illuminance; 0: no illuminances are printed */
    bool utf8;
    int width;
};

/* ---- cells ---- */

/* Writes the verdict and its probability: in whole per cent, from 99 % rounded down to
 * two decimals, and above 99.995 % as "certain". For an undecided verdict, writes the
 * probability that the target is met. */
static void write_verdict(char cell[CELL], const struct pp_finding *finding)
{
    const char *word = pp_finding_own_word(finding);
    double sure = finding->confidence;
    if (isnan(sure))
        snprintf(cell, CELL, "%s", word ? word : "");
    else if (finding->verdict == PP_UNDECIDED)
        snprintf(cell, CELL, "%s: met %.0f %%", word, 100.0 * sure);
    else if (sure > 0.99995)
        snprintf(cell, CELL, "%s: certain", word);
    else
        snprintf(cell, CELL, "%s: %.*f %%", word, sure < 0.99 ? 0 : 2,
                 floor(1e4 * sure) / 100.0);
}

static void write_cells(char cells[COLUMNS][CELL], const struct pp_finding *finding,
                        const struct layout *layout)
{
    pp_finding_cells_figure(cells[FIGURE], finding, layout->utf8);
    pp_finding_cells_wanted(cells[WANTED], finding, layout->utf8);
    write_verdict(cells[VERDICT], finding);
    cells[LUX][0] = cells[OVER][0] = '\0';
    if (isfinite(finding->reached_over))
        snprintf(cells[OVER], CELL, "over %.0f %%", 100.0 * finding->reached_over);
    if (layout->external_lux > 0.0 && finding->kind == PP_FIGURE_FACTOR
        && isfinite(finding->figure))
        snprintf(cells[LUX], CELL, "%.0f lx", layout->external_lux * finding->figure);
}

/* Limits of the first column's width, and its width if less than the least is left: the
 * terminal then wraps the lines. */
enum { WHAT_LEAST = 6, WHAT_MOST = 44, WHAT_WRAPPED = 20 };

/* Sets the column widths. All columns except the first are as wide as necessary, and at
 * least as wide as in most criteria, so that columns of different criteria are
 * aligned. */
static void lay_out_columns(struct layout *layout,
                            const struct pp_finding_list *findings)
{
    static const int usual[COLUMNS] = {[FIGURE] = 9, [WANTED] = 9, [VERDICT] = 10};
    char cells[COLUMNS][CELL];
    int used = INDENT;
    memcpy(layout->widths, usual, sizeof usual);
    for (int k = 0; k < findings->count; k++) {
        write_cells(cells, &findings->list[k], layout);
        for (int c = FIGURE; c < COLUMNS; c++) {
            int width = pp_format_utf8_width(cells[c]);
            if (width > layout->widths[c])
                layout->widths[c] = width;
        }
    }
    for (int c = FIGURE; c < COLUMNS; c++)
        used += layout->widths[c] ? layout->widths[c] + GAP : 0;
    layout->widths[WHAT] = layout->width - used;
    if (layout->widths[WHAT] > WHAT_MOST)
        layout->widths[WHAT] = WHAT_MOST;
    if (layout->widths[WHAT] < WHAT_LEAST)
        layout->widths[WHAT] = WHAT_WRAPPED;
}

/* ---- rows ---- */

/* Number of bytes of the text that fit on a line of `columns`, without the blank after
 * them. A line is not broken between a number and a per cent sign. */
static int fitting(const char *text, int columns)
{
    int length = 0, fits = 0, used = 0;
    while (text[length]) {
        int bytes = pp_format_utf8_length(text + length);
        if (text[length] == ' ' && text[length + 1] != '%')
            fits = length;
        if (++used > columns)
            return fits ? fits : length;
        length += bytes;
    }
    return length;
}

static void put_note(const char *text, const struct layout *layout, FILE *out)
{
    fprintf(out, "%*s", NOTE_INDENT, "");
    pp_print_wrapped(text, NOTE_INDENT, NOTE_INDENT, layout->width, out);
}

/* Prints all cells except the first. All are right-aligned except the verdict; there
 * are no blanks at the end of the line. */
static void print_cells(char cells[COLUMNS][CELL], const struct layout *layout,
                        int blanks, FILE *out)
{
    for (int c = FIGURE; c < COLUMNS; c++) {
        int width = layout->widths[c], used = pp_format_utf8_width(cells[c]);
        if (width == 0)
            continue;
        blanks += GAP + (c < VERDICT ? width - used : 0);
        if (!cells[c][0])
            continue;
        fprintf(out, "%*s%s", blanks, "", cells[c]);
        blanks = 0;
    }
    fputc('\n', out);
}

static void print_finding(const struct pp_finding *finding, const char *note,
                          const struct layout *layout, FILE *out)
{
    char cells[COLUMNS][CELL], part[sizeof finding->what];
    write_cells(cells, finding, layout);
    const char *rest = finding->what;
    for (bool first = true; first || *rest; first = false) {
        int bytes = fitting(rest, layout->widths[WHAT] - (first ? 0 : 2));
        snprintf(part, sizeof part, "%.*s", bytes, rest);
        rest += bytes;
        rest += strspn(rest, " ");
        fprintf(out, "%*s", first ? INDENT : INDENT + 2, "");
        pp_format_utf8_put(out, part);
        if (first)
            print_cells(cells, layout,
                        layout->widths[WHAT] - pp_format_utf8_width(part), out);
        else
            fputc('\n', out);
    }
    if (note[0])
        put_note(note, layout, out);
}

/* Writes the number of findings to which a note applies: "both: ", "all 3: "; nothing
 * for a single finding. */
static void put_extent(char *words, size_t size, int findings)
{
    if (findings == 2)
        pp_text_append(words, size, "both: ");
    else if (findings > 2)
        pp_text_append(words, size, "all %d: ", findings);
}

/* Prints a sentence that applies to all findings of a criterion. */
static void put_sentence(const char *text, const struct layout *layout, FILE *out)
{
    fprintf(out, "%*s", INDENT, "");
    pp_print_wrapped(text, INDENT, INDENT, layout->width, out);
}

static void print_answer(const struct pp_answer *answer, struct layout layout,
                         FILE *out)
{
    lay_out_columns(&layout, &answer->findings);
    fprintf(out, "\n  %s  [%s]%s\n", answer->criterion->title,
            answer->criterion->source,
            answer->criterion->withdrawn ? "  (withdrawn)" : "");
    const struct pp_finding_list *findings = &answer->findings;
    if (answer->criterion->withdrawn)
        put_sentence(answer->criterion->withdrawn, &layout, out);
    if (findings->basis[0])
        put_sentence(findings->basis, &layout, out);
    /* A note that several consecutive findings have in common is printed once, below
     * the last of them. */
    int same = 1;
    for (int i = 0; i < findings->count; i++) {
        const struct pp_finding *finding = &findings->list[i];
        char note[sizeof finding->note + 16] = "";
        bool said_again = i + 1 < findings->count
                          && strcmp(finding->note, findings->list[i + 1].note) == 0;
        if (!said_again && finding->note[0]) {
            put_extent(note, sizeof note, same);
            pp_text_append(note, sizeof note, "%s", finding->note);
        }
        print_finding(finding, note, &layout, out);
        same = said_again ? same + 1 : 1;
    }
}

/* ---- a room ---- */

/* Number of findings with that verdict. Findings on levels above the lowest are not
 * counted. */
static int count_verdicts(const struct pp_assessment *assessment,
                          enum pp_verdict verdict)
{
    int count = 0;
    for (int i = 0; i < assessment->answers.count; i++)
        for (int k = 0; k < assessment->answers.list[i].findings.count; k++) {
            const struct pp_finding *finding =
                &assessment->answers.list[i].findings.list[k];
            count += finding->verdict == verdict && !finding->is_optional;
        }
    return count;
}

static void print_sum(const struct pp_assessment *assessment, FILE *out)
{
    static const enum pp_verdict verdicts[] = {PP_MET, PP_NOT_MET, PP_UNDECIDED,
                                               PP_NOT_JUDGED};
    const char *before = "";
    fputs("\n  ", out);
    for (int v = 0; v < 4; v++) {
        int count = count_verdicts(assessment, verdicts[v]);
        if (count == 0)
            continue;
        fprintf(out, "%s%d %s", before, count, pp_finding_word(verdicts[v]));
        before = ", ";
    }
    fputs(*before ? "\n" : "no verdicts\n", out);
}

static void print_simulation(const struct pp_assessment *assessment,
                             const struct pp_study_options *options,
                             const struct layout *layout, FILE *out)
{
    char text[256];
    snprintf(text, sizeof text,
             "Simulated figures: %s one standard error, seed %llu. Each verdict is "
             "followed by the probability that it is correct%s",
             layout->utf8 ? "\xc2\xb1" : "+-", (unsigned long long)options->seed,
             !assessment->report.finished ? "; NOT FINISHED, interrupted"
             : assessment->by_clock
                 ? "; stopped at the --time limit, so another run may differ"
                 : "");
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, layout->width, out);
}

/* Explains the bands in brackets after values of hand methods, or prints why there are
 * none. */
static void print_bands(const struct pp_assessment *assessment,
                        const struct layout *layout, FILE *out)
{
    const char *text = assessment->report.no_bands;
    for (int i = 0; i < assessment->answers.count && !text; i++)
        for (int k = 0; k < assessment->answers.list[i].findings.count; k++)
            if (pp_band_is_known(assessment->answers.list[i].findings.list[k].band))
                text = "Figures in brackets show the likely range, which contained the "
                       "true value in 95 of 100 similar simulated rooms (the atlas). "
                       "For results that apply to a share of the working plane, all "
                       "points are assumed to have the same relative error.";
    if (!text)
        return;
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, layout->width, out);
}

/* Prints a note if criteria leave trees out. */
static void print_trees(const struct pp_assessment *assessment,
                        const struct layout *layout, FILE *out)
{
    char text[PP_TREES_NOTE_BYTES];
    if (!pp_trees_note_text(text, assessment, 1,
                            layout->utf8 ? "\xc2\xb0" : " degrees"))
        return;
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, layout->width, out);
}

static void print_assessed_room(const struct pp_assessment *assessment,
                                const struct pp_study_options *options,
                                struct layout layout, FILE *out)
{
    pp_print_title(assessment->room->world, assessment->room->file, out);
    fputc('\n', out);
    pp_print_assumed(assessment->room->world, &assessment->room->light, layout.width,
                     out);
    if (assessment->before) {
        fputs("  before         ", out);
        pp_print_title(assessment->before->world, assessment->before->file, out);
    }
    if (assessment->answers.count == 0)
        fprintf(out, "\n  None of these criteria applies to a room with the use %s.\n",
                pp_room_use_words[assessment->room->world->use]);
    for (int i = 0; i < assessment->answers.count; i++)
        print_answer(&assessment->answers.list[i], layout, out);
    if (options->simulate
        && (assessment->has_factors || assessment->points.receiver_count > 0))
        print_simulation(assessment, options, &layout, out);
    if (!options->simulate && assessment->has_factors) {
        print_bands(assessment, &layout, out);
        struct pp_reliability reliability = pp_reliability_of(&assessment->report);
        pp_print_reliability(&reliability, layout.width, out);
    }
    print_trees(assessment, &layout, out);
    print_sum(assessment, out);
    if (assessment->has_gains)
        pp_gains_report(&assessment->gains, layout.width, out);
}

enum pp_status pp_assess_text(const struct pp_assessments *assessments, int width,
                              bool utf8, FILE *out, struct pp_error *err)
{
    (void)err;
    const struct layout layout = {.width = width,
                                  .utf8 = utf8,
                                  .external_lux = assessments->options->external_lux};
    for (int i = 0; i < assessments->count; i++) {
        if (i > 0)
            fputs("\n\n", out);
        print_assessed_room(&assessments->list[i], assessments->options, layout, out);
    }
    return PP_OK;
}
