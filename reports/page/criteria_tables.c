/* criteria_tables.c - see criteria_tables.h. */
#include "reports/page/criteria_tables.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/assess/finding_cells.h"
#include "reports/page/basis_clauses.h"
#include "reports/page/room_chapter.h"
#include "studies/criteria/site_table.h"

enum {
    FIGURES_MOST = 6, /* figures in a row: more do not fit on A4 */
    WHATS_MOST = 24,  /* different figures of a criterion that has one row per room */
    NOTES_MOST = 9,   /* notes below a table */
    FIGURE_NOTES = 3, /* different notes on the same figure: more are left out */
};

/* The findings of one criterion in all rooms. */
struct topic {
    const struct pp_criterion *criterion;
    const struct pp_site_row **rows; /* owned; in the order of the rooms */
    const char **bases;              /* owned; for each row the basis of its finding */
    int count;
};

/* A figure that most rooms of a topic have. */
struct topic_figure {
    const char *what;
    int rooms;        /* number of rooms that have it */
    bool same_wanted; /* true: the same target in all rooms */
    const struct pp_finding *first;
};

/* Different notes of a topic, below its table; the table refers to them by number. */
struct topic_notes {
    const char *list[NOTES_MOST];
    int count;
    bool omits; /* true: some notes are not in the list */
};

/* True if the row is the first one of its room. */
static bool begins_room(const struct topic *topic, int row)
{
    return row == 0 || topic->rows[row]->room != topic->rows[row - 1]->room;
}

static int count_topic_rooms(const struct topic *topic)
{
    int count = 0;
    for (int i = 0; i < topic->count; i++)
        count += begins_room(topic, i);
    return count;
}

/* ---- figures ---- */

static bool same_bound(const struct pp_finding *a, const struct pp_finding *b)
{
    char first[PP_FINDING_CELL], second[PP_FINDING_CELL];
    if (isnan(a->figure) || isnan(b->figure))
        return true;
    pp_finding_cells_wanted(first, a, true);
    pp_finding_cells_wanted(second, b, true);
    return strcmp(first, second) == 0;
}

/* Counts the finding in the list of `count` figures, and adds its figure if the list
 * does not have it. Returns the new count, or -1 if there are too many figures. */
static int count_topic_figure(struct topic_figure figures[WHATS_MOST], int count,
                              const struct pp_finding *finding)
{
    for (int i = 0; i < count; i++) {
        struct topic_figure *figure = &figures[i];
        if (strcmp(figure->what, finding->what) != 0)
            continue;
        figure->rooms++;
        figure->same_wanted &= same_bound(figure->first, finding);
        if (isnan(figure->first->figure))
            figure->first = finding;
        return count;
    }
    if (count == WHATS_MOST)
        return -1;
    figures[count] = (struct topic_figure){finding->what, 1, true, finding};
    return count + 1;
}

/* True if a room has several findings of the same name. */
static bool has_doubles(const struct topic *topic)
{
    for (int i = 1; i < topic->count; i++)
        for (int k = i - 1; k >= 0 && topic->rows[k]->room == topic->rows[i]->room; k--)
            if (strcmp(topic->rows[k]->finding->what, topic->rows[i]->finding->what)
                == 0)
                return true;
    return false;
}

/* Finds the figures of a topic. Returns their number if they can be columns of a table:
 * there are several, more than half of the rooms have each of them, and no room has one
 * of them twice. Otherwise returns 0. */
static int find_figures(struct topic_figure figures[WHATS_MOST],
                        const struct topic *topic)
{
    const int rooms = count_topic_rooms(topic);
    int count = 0;
    for (int i = 0; i < topic->count && count >= 0; i++)
        count = count_topic_figure(figures, count, topic->rows[i]->finding);
    for (int i = 0; i < count; i++)
        if (2 * figures[i].rooms <= rooms)
            return 0;
    return count > 1 && !has_doubles(topic) ? count : 0;
}

/* ---- notes ---- */

/* Index of the note; -1: not in the list. */
static int find_note(const struct topic_notes *notes, const char *note)
{
    for (int i = 0; i < notes->count; i++)
        if (strcmp(notes->list[i], note) == 0)
            return i;
    return -1;
}

/* Adds the notes on one figure (`what`; NULL: on all) to the list, unless there are
 * more than `most` different ones or the list is full. */
static void add_notes(struct topic_notes *notes, const struct topic *topic,
                      const char *what, int most)
{
    struct topic_notes longer = *notes;
    for (int i = 0; i < topic->count; i++) {
        const struct pp_finding *finding = topic->rows[i]->finding;
        if (!finding->note[0] || (what && strcmp(finding->what, what) != 0)
            || find_note(&longer, finding->note) >= 0)
            continue;
        if (longer.count == NOTES_MOST || longer.count - notes->count == most) {
            notes->omits = true;
            return;
        }
        longer.list[longer.count++] = finding->note;
    }
    *notes = longer;
}

static const char *const note_marks[NOTES_MOST] = {"¹", "²", "³", "⁴", "⁵",
                                                   "⁶", "⁷", "⁸", "⁹"};

/* Mark of the finding's note in the table; empty if the note is not in the list. */
static const char *note_mark(const struct topic_notes *notes,
                             const struct pp_finding *finding)
{
    const int index = finding->note[0] ? find_note(notes, finding->note) : -1;
    return index >= 0 ? note_marks[index] : "";
}

static void put_notes(struct pp_document *document, const struct topic_notes *notes)
{
    for (int i = 0; i < notes->count; i++)
        pp_document_paragraph(document, PP_TONE_SOFT, "%s %s.", note_marks[i],
                              notes->list[i]);
    if (notes->omits)
        pp_document_paragraph(document, PP_TONE_SOFT,
                              "Notes that differ from room to room are in the complete "
                              "report (--full).");
}

/* ---- a table with one row for each room ---- */

static enum pp_tone tone_of(const struct pp_finding *finding)
{
    return finding->is_optional             ? PP_TONE_PLAIN
           : finding->verdict == PP_MET     ? PP_TONE_GOOD
           : finding->verdict == PP_NOT_MET ? PP_TONE_BAD
                                            : PP_TONE_PLAIN;
}

static bool has_levels(const struct topic *topic)
{
    char level[PP_BASIS_CLAUSES];
    for (int i = 0; i < topic->count; i++)
        if (pp_basis_clauses_level(level, topic->bases[i]))
            return true;
    return false;
}

static void put_level(struct pp_document *document, const struct topic *topic, int row)
{
    char level[PP_BASIS_CLAUSES];
    bool known = pp_basis_clauses_level(level, topic->bases[row]);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", known ? level : "–");
}

static void put_room_name(struct pp_document *document, const struct topic *topic,
                          int row)
{
    const char *name = topic->rows[row]->room->room->world->name;
    pp_document_cell(document, PP_TONE_PLAIN, "%s", name ? name : "");
}

/* The finding of that name in the room of row `first`; NULL: none. */
static const struct pp_finding *find_in_room(const struct topic *topic, int first,
                                             const char *what)
{
    for (int i = first;
         i < topic->count && topic->rows[i]->room == topic->rows[first]->room; i++)
        if (strcmp(topic->rows[i]->finding->what, what) == 0)
            return topic->rows[i]->finding;
    return NULL;
}

/* True if an earlier figure of the table has the same uncertain value in this room, as
 * the medians of all levels of EN 17037 do. */
static bool is_said_before(const struct topic *topic, int row,
                           const struct topic_figure *figures, int index)
{
    const struct pp_finding *own = find_in_room(topic, row, figures[index].what);
    if (!isfinite(own->std_error) && !pp_band_is_known(own->band))
        return false;
    for (int i = 0; i < index; i++) {
        const struct pp_finding *other = find_in_room(topic, row, figures[i].what);
        if (other && other->kind == own->kind && other->figure == own->figure)
            return true;
    }
    return false;
}

/* Writes the value unless an earlier column has it, the target unless it is in the
 * heading, and the verdict. */
static void put_figure(struct pp_document *document, const struct topic *topic, int row,
                       const struct topic_figure *figures, int index,
                       const struct topic_notes *notes)
{
    char value[PP_FINDING_CELL] = "", wanted[PP_FINDING_CELL] = "";
    const struct pp_finding *finding = find_in_room(topic, row, figures[index].what);
    const char *word = finding ? pp_finding_own_word(finding) : NULL;
    if (!finding) {
        pp_document_cell(document, PP_TONE_PLAIN, "–");
        return;
    }
    if (!word || !is_said_before(topic, row, figures, index))
        pp_finding_cells_figure(value, finding, true);
    if (!figures[index].same_wanted)
        pp_finding_cells_wanted(wanted, finding, true);
    pp_document_cell(document, tone_of(finding), "%s%s%s%s%s%s%s", value,
                     wanted[0] ? " (" : "", wanted, wanted[0] ? ")" : "",
                     value[0] && word ? " " : "", word ? word : "",
                     note_mark(notes, finding));
}

/* Adds a table of some of the figures of a topic. levelled: with the column of levels. */
static void put_figures(struct pp_document *document, const struct topic *topic,
                        const struct topic_figure *figures, int count,
                        const struct topic_notes *notes, bool levelled)
{
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    for (int i = 0; i < count; i++) {
        char wanted[PP_FINDING_CELL] = "";
        if (figures[i].same_wanted)
            pp_finding_cells_wanted(wanted, figures[i].first, true);
        pp_document_column(document, PP_COLUMN_WORDS, "%s%s%s%s", figures[i].what,
                           wanted[0] ? " (" : "", wanted, wanted[0] ? ")" : "");
    }
    if (levelled)
        pp_document_column(document, PP_COLUMN_WORDS, PP_BASIS_LEVEL);
    for (int i = 0; i < topic->count; i++) {
        if (!begins_room(topic, i))
            continue;
        pp_document_row(document, PP_ROW_CELLS);
        put_room_name(document, topic, i);
        for (int k = 0; k < count; k++)
            put_figure(document, topic, i, figures, k, notes);
        if (levelled)
            put_level(document, topic, i);
    }
}

/* Adds one table or, if there are too many figures for the width of the paper, several
 * tables. */
static void put_room_rows(struct pp_document *document, const struct topic *topic,
                          const struct topic_figure *figures, int count)
{
    struct topic_notes notes = {0};
    bool repeats = false;
    for (int i = 0; i < count; i++)
        add_notes(&notes, topic, figures[i].what, FIGURE_NOTES);
    for (int i = 0; i < count; i += FIGURES_MOST)
        put_figures(document, topic, figures + i,
                    count - i < FIGURES_MOST ? count - i : FIGURES_MOST, &notes,
                    i == 0 && has_levels(topic));
    for (int i = 0; i < count && !repeats; i++)
        for (int k = i % FIGURES_MOST; k > 0 && !repeats; k--)
            repeats = is_said_before(topic, 0, figures + i - i % FIGURES_MOST, k);
    if (repeats)
        pp_document_paragraph(
            document, PP_TONE_SOFT,
            "A verdict without a value is for the value with the same "
            "share of the plane, further to the left.");
    put_notes(document, &notes);
}

/* ---- a table with one row for each finding ---- */

static void put_findings(struct pp_document *document, const struct topic *topic)
{
    struct topic_notes notes = {0};
    const bool levelled = has_levels(topic);
    add_notes(&notes, topic, NULL, NOTES_MOST);
    notes.omits = false; /* a note that is not in the list stands in its row */
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    pp_document_column(document, PP_COLUMN_WORDS, "what");
    pp_document_column(document, PP_COLUMN_NUMBERS, "found");
    pp_document_column(document, PP_COLUMN_NUMBERS, "target");
    pp_document_column(document, PP_COLUMN_WORDS, "verdict");
    if (levelled)
        pp_document_column(document, PP_COLUMN_WORDS, PP_BASIS_LEVEL);
    for (int i = 0; i < topic->count; i++) {
        const struct pp_finding *finding = topic->rows[i]->finding;
        const char *mark = note_mark(&notes, finding);
        char figure[PP_FINDING_CELL], wanted[PP_FINDING_CELL];
        pp_finding_cells_figure(figure, finding, true);
        pp_finding_cells_wanted(wanted, finding, true);
        pp_document_row(document, PP_ROW_CELLS);
        put_room_name(document, topic, i);
        pp_document_cell(document, PP_TONE_PLAIN, "%s%s", finding->what, mark);
        if (finding->note[0] && !mark[0])
            pp_document_note(document, finding->note);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", figure);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", wanted);
        pp_room_chapter_verdict(document, finding);
        if (levelled && begins_room(topic, i))
            put_level(document, topic, i);
    }
    put_notes(document, &notes);
}

/* Appends the room's name to a list of names. */
static void append_room(char *names, size_t size, const struct pp_assessment *room)
{
    const char *name = room->room->world->name;
    pp_text_append(names, size, "%s%s", names[0] ? ", " : "",
                   name ? name : "a room without a name");
}

/* ---- the basis: clauses separated by "; " ---- */

/* True if the clauses in which the bases of two rooms differ from the common ones are
 * the same. */
static bool same_basis(const struct topic *topic, int a, int b)
{
    char first[PP_BASIS_CLAUSES], second[PP_BASIS_CLAUSES];
    pp_basis_clauses_own(first, topic->bases, topic->count, a);
    pp_basis_clauses_own(second, topic->bases, topic->count, b);
    return strcmp(first, second) == 0;
}

/* Adds the bases that differ between rooms, as a table of rooms and their basis. */
static void put_bases(struct pp_document *document, const struct topic *topic)
{
    char text[PP_BASIS_CLAUSES];
    bool any = false;
    for (int i = 0; i < topic->count; i++) {
        bool known = !begins_room(topic, i);
        for (int k = 0; k < i && !known; k++)
            known = same_basis(topic, k, i);
        pp_basis_clauses_own(text, topic->bases, topic->count, i);
        if (known || !text[0])
            continue;
        if (!any) {
            pp_document_table(document);
            pp_document_column(document, PP_COLUMN_WORDS, "rooms");
            pp_document_column(document, PP_COLUMN_WORDS, "basis");
        }
        any = true;
        char rooms[512] = "";
        for (int k = i; k < topic->count; k++)
            if (begins_room(topic, k) && same_basis(topic, i, k))
                append_room(rooms, sizeof rooms, topic->rows[k]->room);
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", rooms);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", text);
    }
}

/* ---- a criterion ---- */

static void put_topic(struct pp_document *document, const struct topic *topic)
{
    const struct pp_criterion *criterion = topic->criterion;
    struct topic_figure figures[WHATS_MOST];
    char basis[PP_BASIS_CLAUSES];
    const int count = find_figures(figures, topic);
    pp_document_heading(document, 3, "%s [%s]%s", criterion->title, criterion->source,
                        criterion->withdrawn ? " (withdrawn)" : "");
    if (criterion->withdrawn)
        pp_document_paragraph(document, PP_TONE_SOFT, "%s.", criterion->withdrawn);
    pp_basis_clauses_common(basis, topic->bases, topic->count);
    if (basis[0])
        pp_document_paragraph(document, PP_TONE_SOFT, "%s.", basis);
    if (count > 0)
        put_room_rows(document, topic, figures, count);
    else
        put_findings(document, topic);
    put_bases(document, topic);
}

static const char *basis_of(const struct pp_site_row *row)
{
    const struct pp_answer_list *answers = &row->room->answers;
    for (int i = 0; i < answers->count; i++)
        if (answers->list[i].criterion == row->criterion)
            return answers->list[i].findings.basis;
    return "";
}

/* Adds the section of the criterion of row `first`. */
static enum pp_status put_criterion(struct pp_document *document,
                                    const struct pp_site_table *table, int first,
                                    struct pp_error *err)
{
    struct topic topic = {table->others[first].criterion,
                          calloc((size_t)table->other_count, sizeof *topic.rows),
                          calloc((size_t)table->other_count, sizeof(const char *)), 0};
    bool stored = topic.rows && topic.bases;
    for (int i = first; i < table->other_count && stored; i++)
        if (table->others[i].criterion == topic.criterion) {
            topic.rows[topic.count] = &table->others[i];
            topic.bases[topic.count++] = basis_of(&table->others[i]);
        }
    if (stored)
        put_topic(document, &topic);
    free(topic.rows);
    free(topic.bases);
    return stored ? PP_OK : pp_fail_memory(err);
}

/* True if a row before `row` belongs to the same criterion. */
static bool is_repeated(const struct pp_site_table *table, int row)
{
    for (int i = 0; i < row; i++)
        if (table->others[i].criterion == table->others[row].criterion)
            return true;
    return false;
}

/* Adds the names of the rooms to which no selected criterion applies, if any. */
static void say_unjudged(struct pp_document *document, const struct pp_assessments *all)
{
    char names[512] = "";
    for (int i = 0; i < all->count; i++)
        if (all->list[i].answers.count == 0)
            append_room(names, sizeof names, &all->list[i]);
    if (names[0])
        pp_document_paragraph(document, PP_TONE_PLAIN,
                              "None of the selected criteria applies to: %s.", names);
}

enum pp_status pp_criteria_tables(struct pp_document *document,
                                  const struct pp_assessments *all,
                                  struct pp_error *err)
{
    struct pp_site_table table;
    enum pp_status status = pp_site_table_of(&table, all->list, all->count, err);
    if (status == PP_OK && table.other_count > 0)
        pp_document_heading(document, 2, "Criteria");
    for (int i = 0; i < table.other_count && status == PP_OK; i++)
        if (!is_repeated(&table, i))
            status = put_criterion(document, &table, i, err);
    say_unjudged(document, all);
    pp_site_table_clear(&table);
    return status;
}
