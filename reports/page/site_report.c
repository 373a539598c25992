/* site_report.c - see site_report.h. */
#include "reports/page/site_report.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/page/criteria_tables.h"
#include "reports/page/limits_chapter.h"
#include "reports/page/made_chapter.h"
#include "reports/page/project_table.h"
#include "reports/page/room_chapter.h"
#include "reports/page/rooms_table.h"
#include "reports/page/year_section.h"
#include "reports/parts/figure_unit.h"
#include "studies/criteria/br209_count.h"
#include "studies/criteria/site_table.h"

/* ---- verdicts ---- */

static const enum pp_verdict verdicts[] = {PP_MET, PP_NOT_MET, PP_UNDECIDED,
                                           PP_NOT_JUDGED};

enum { VERDICTS = sizeof verdicts / sizeof *verdicts };

/* Number of findings of a room with that verdict. As in pepperpot assess, optional
 * levels are not counted. */
static int count_verdicts(const struct pp_assessment *room, enum pp_verdict verdict)
{
    int count = 0;
    for (int k = 0; k < room->answers.count; k++) {
        const struct pp_finding_list *list = &room->answers.list[k].findings;
        for (int n = 0; n < list->count; n++)
            count += list->list[n].verdict == verdict && !list->list[n].is_optional;
    }
    return count;
}

/* Adds the numbers of windows and rooms that meet BR 209, if any are assessed, and the
 * numbers of verdicts. */
static void say_sum(struct pp_document *document, const struct pp_assessments *all)
{
    char words[160] = "", br209_words[PP_BR209_WORDS];
    const struct pp_br209_count br209 = pp_br209_count_of(all->list, all->count);
    pp_br209_count_words(br209_words, &br209);
    bool by_br209 = br209_words[0] != '\0';
    for (int v = 0; v < VERDICTS; v++) {
        int count = 0;
        for (int i = 0; i < all->count; i++)
            count += count_verdicts(&all->list[i], verdicts[v]);
        if (count > 0)
            pp_text_append(words, sizeof words, "%s%d %s", words[0] ? ", " : "", count,
                           pp_finding_word(verdicts[v]));
    }
    if (by_br209)
        pp_document_paragraph(document, PP_TONE_VERDICT, "%s.%s%s%s", br209_words,
                              words[0] ? " All verdicts: " : "", words,
                              words[0] ? "." : "");
    else
        pp_document_paragraph(document, PP_TONE_VERDICT, "%s of %d room%s",
                              words[0] ? words : "no verdicts", all->count,
                              all->count == 1 ? "" : "s");
}

/* Writes a cell such as "1 of 2"; the cell is empty if count is 0. */
static void put_share(struct pp_document *document, int met, int count)
{
    if (count > 0)
        pp_document_cell(document, PP_TONE_PLAIN, "%d of %d", met, count);
    else
        pp_document_cell(document, PP_TONE_PLAIN, "%s", "");
}

static void put_verdicts(struct pp_document *document, const struct pp_assessments *all)
{
    const struct pp_br209_count br209 = pp_br209_count_of(all->list, all->count);
    bool windows = br209.windows > 0, rooms = br209.rooms > 0;
    if (all->count < 2)
        return;
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    if (windows)
        pp_document_column(document, PP_COLUMN_NUMBERS, "windows that meet BR 209");
    if (rooms)
        pp_document_column(document, PP_COLUMN_NUMBERS, "lit area meets BR 209");
    for (int v = 0; v < VERDICTS; v++)
        pp_document_column(document, PP_COLUMN_NUMBERS, "verdicts: %s",
                           pp_finding_word(verdicts[v]));
    for (int i = 0; i < all->count; i++) {
        const char *name = all->list[i].room->world->name;
        const struct pp_br209_count own = pp_br209_count_of(&all->list[i], 1);
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(document, PP_TONE_PLAIN, "%s", name ? name : "");
        if (windows)
            put_share(document, own.windows_met, own.windows);
        if (rooms)
            pp_document_cell(document, PP_TONE_PLAIN, "%s",
                             own.rooms == 0  ? ""
                             : own.rooms_met ? "yes"
                                             : "no");
        for (int v = 0; v < VERDICTS; v++)
            pp_document_cell(document, PP_TONE_PLAIN, "%d",
                             count_verdicts(&all->list[i], verdicts[v]));
    }
}

/* ---- the site ---- */

/* True if any former value is known. */
static bool has_before(const struct pp_site_row *rows, int count)
{
    for (int i = 0; i < count; i++)
        if (isfinite(rows[i].existing))
            return true;
    return false;
}

static bool has_cumulative(const struct pp_site_row *rows, int count)
{
    for (int i = 0; i < count; i++)
        if (rows[i].in_cumulative)
            return true;
    return false;
}

static bool has_mirror_image(const struct pp_site_row *rows, int count)
{
    for (int i = 0; i < count; i++)
        if (rows[i].by_mirror_image)
            return true;
    return false;
}

/* Columns of a table of windows, rooms or gardens. */
struct site_columns {
    const char *of;  /* heading of the second column; NULL: no such column */
    bool compares;   /* show the former state */
    bool cumulative; /* show the cumulative state */
    bool mirrored;   /* show the mirror image */
};

/* Adds a cell with the verdict of a further finding in the row. The cell is empty if
 * there is no such finding. */
static void put_other_verdict(struct pp_document *document,
                              const struct pp_finding *finding)
{
    if (finding)
        pp_room_chapter_verdict(document, finding);
    else
        pp_document_cell(document, PP_TONE_PLAIN, "%s", "");
}

static void put_site_row(struct pp_document *document, const struct pp_site_row *row,
                         const struct site_columns *columns)
{
    const char *name = row->room->room->world->name;
    double scale = pp_figure_scale(row->finding->compared);
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", name ? name : "");
    if (columns->of)
        pp_document_cell(document, PP_TONE_PLAIN, "%s", row->finding->what);
    if (columns->compares)
        pp_room_chapter_number(document, scale * row->existing, 2);
    pp_room_chapter_number(document, scale * row->proposed, 2);
    if (columns->compares) {
        pp_room_chapter_number(document, 100.0 * (1.0 - row->ratio), 1);
        pp_room_chapter_number(document, row->ratio, 3);
    }
    pp_room_chapter_verdict(document, row->finding);
    if (columns->cumulative) {
        pp_room_chapter_number(document, scale * row->cumulative, 2);
        pp_room_chapter_number(document, row->cumulative_ratio, 3);
        put_other_verdict(document, row->in_cumulative);
    }
    if (columns->mirrored) {
        pp_room_chapter_number(document, scale * row->mirrored, 2);
        put_other_verdict(document, row->by_mirror_image);
    }
}

static void put_rows_of(struct pp_document *document, const char *title,
                        const char *unit, const struct pp_site_row *rows, int count,
                        const struct site_columns *columns)
{
    pp_document_heading(document, 3, "%s", title);
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    if (columns->of)
        pp_document_column(document, PP_COLUMN_WORDS, "%s", columns->of);
    if (columns->compares)
        pp_document_column(document, PP_COLUMN_NUMBERS, "existing, %s", unit);
    pp_document_column(document, PP_COLUMN_NUMBERS,
                       columns->compares ? "proposed, %s" : "now, %s", unit);
    if (columns->compares) {
        pp_document_column(document, PP_COLUMN_NUMBERS, "loss, %%");
        pp_document_column(document, PP_COLUMN_NUMBERS, "ratio");
    }
    pp_document_column(document, PP_COLUMN_WORDS, "verdict");
    if (columns->cumulative) {
        pp_document_column(document, PP_COLUMN_NUMBERS, "cumulative, %s", unit);
        pp_document_column(document, PP_COLUMN_NUMBERS, "cumulative ratio");
        pp_document_column(document, PP_COLUMN_WORDS, "cumulative verdict");
    }
    if (columns->mirrored) {
        pp_document_column(document, PP_COLUMN_NUMBERS, "mirror image, %s", unit);
        pp_document_column(document, PP_COLUMN_WORDS, "verdict by mirror image");
    }
    for (int i = 0; i < count; i++)
        put_site_row(document, &rows[i], columns);
}

/* Writes separate tables for existing and proposed rooms, or one table if all rooms are
 * existing or all are proposed. of: heading of the second column; NULL: no such
 * column. */
static void put_rows(struct pp_document *document, const char *title, const char *of,
                     const char *unit, const struct pp_site_row *rows, int count)
{
    char words[160];
    const int old = pp_site_table_existing(rows, count);
    if (count == 0)
        return;
    for (int is_new = 0; is_new < 2; is_new++) {
        const struct pp_site_row *own = is_new ? rows + old : rows;
        const int own_count = is_new ? count - old : old;
        const struct site_columns columns = {of, has_before(own, own_count),
                                             has_cumulative(own, own_count),
                                             has_mirror_image(own, own_count)};
        snprintf(words, sizeof words, "%s%s", title,
                 old == count ? ""
                 : is_new     ? ", proposed rooms"
                              : ", existing rooms");
        if (own_count > 0)
            put_rows_of(document, words, unit, own, own_count, &columns);
    }
}

static void put_areas(struct pp_document *document, const char *name,
                      const struct pp_lit_change *lit, bool compares)
{
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", name ? name : "");
    pp_room_chapter_number(document, lit->plane_m2, 2);
    if (compares)
        pp_room_chapter_number(document, lit->before_m2, 2);
    pp_room_chapter_number(document, lit->lit_m2, 2);
    pp_room_chapter_number(document, 100.0 * lit->lit_m2 / lit->plane_m2, 1);
    if (compares) {
        pp_room_chapter_number(document, lit->lost_m2, 2);
        pp_room_chapter_number(document, lit->loss.equivalent_m2, 2);
    }
}

/* Adds the areas of the rooms and, if there are several rooms, the sum. */
static void put_rights(struct pp_document *document, const struct pp_site_table *table)
{
    const struct pp_lit_change unknown = pp_lit_area_change(NAN, NAN, NAN);
    bool compares = has_before(table->rights, table->rights_count);
    if (table->rights_count == 0)
        return;
    pp_document_heading(document, 3,
                        "Rights of light: area inside the 0.2 %% contour [WW23]");
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    pp_document_column(document, PP_COLUMN_NUMBERS, "room, m²");
    if (compares)
        pp_document_column(document, PP_COLUMN_NUMBERS, "existing, m²");
    pp_document_column(document, PP_COLUMN_NUMBERS,
                       compares ? "proposed, m²" : "now, m²");
    pp_document_column(document, PP_COLUMN_NUMBERS, "share, %%");
    if (compares) {
        pp_document_column(document, PP_COLUMN_NUMBERS, "lost, m²");
        pp_document_column(document, PP_COLUMN_NUMBERS,
                           "lost, equivalent first zone, m²");
    }
    pp_document_column(document, PP_COLUMN_WORDS, "verdict");
    for (int i = 0; i < table->rights_count; i++) {
        const struct pp_site_row *row = &table->rights[i];
        put_areas(document, row->room->room->world->name,
                  row->lit ? row->lit : &unknown, compares);
        pp_room_chapter_verdict(document, row->finding);
    }
    if (table->rights_count > 1)
        put_areas(document, "sum", &table->rights_sum, compares);
}

static void put_loss_heads(struct pp_document *document)
{
    for (int i = 0; i < PP_LOSS_BANDS; i++)
        if (i == 0)
            pp_document_column(document, PP_COLUMN_NUMBERS, "below %.0f %%",
                               100.0 * pp_loss_bands[1]);
        else if (i + 1 < PP_LOSS_BANDS)
            pp_document_column(document, PP_COLUMN_NUMBERS, "%.0f to %.0f %%",
                               100.0 * pp_loss_bands[i], 100.0 * pp_loss_bands[i + 1]);
        else
            pp_document_column(document, PP_COLUMN_NUMBERS, "%.0f %% or more",
                               100.0 * pp_loss_bands[i]);
}

static void put_loss_row(struct pp_document *document, const char *words,
                         const struct pp_br209_count *count)
{
    pp_document_row(document, PP_ROW_CELLS);
    pp_document_cell(document, PP_TONE_PLAIN, "%s", words);
    put_share(document, count->windows_met, count->windows);
    put_share(document, count->rooms_met, count->rooms);
    for (int i = 0; i < PP_LOSS_BANDS; i++)
        pp_document_cell(document, PP_TONE_PLAIN, "%d", count->losses[i]);
}

/* Adds a table of the number of windows in each band of loss of vertical sky component,
 * by floor and house. Adds nothing if no window has a former value. */
static enum pp_status put_losses(struct pp_document *document,
                                 const struct pp_assessments *all, struct pp_error *err)
{
    const struct pp_br209_count sum = pp_br209_count_of(all->list, all->count);
    struct pp_br209_group *groups;
    int count;
    if (sum.compared == 0)
        return PP_OK;
    enum pp_status status =
        pp_br209_count_groups(&groups, &count, all->list, all->count, err);
    if (status == PP_OK) {
        pp_document_heading(document, 3, "Windows by loss of sky");
        pp_document_table(document);
        pp_document_column(document, PP_COLUMN_WORDS, "floor");
        pp_document_column(document, PP_COLUMN_NUMBERS, "windows that meet BR 209");
        pp_document_column(document, PP_COLUMN_NUMBERS, "rooms");
        put_loss_heads(document);
    }
    for (int i = 0; i < count && status == PP_OK; i++) {
        char words[PP_BR209_WORDS];
        pp_br209_count_group_words(words, groups, count, i);
        put_loss_row(document, words, &groups[i].count);
    }
    if (status == PP_OK && count > 1
        && strcmp(groups[0].house, groups[count - 1].house) != 0)
        put_loss_row(document, "all", &sum);
    free(groups);
    return status;
}

static enum pp_status put_tables(struct pp_document *document,
                                 const struct pp_assessments *all, struct pp_error *err)
{
    struct pp_site_table table;
    enum pp_status status = pp_site_table_of(&table, all->list, all->count, err);
    if (status == PP_OK) {
        put_rows(document, "Vertical sky component of windows [BR209]", "window", "%",
                 table.windows, table.window_count);
        put_rows(document, "Area of the working plane with a view of the sky [BR209]",
                 NULL, "m²", table.rooms, table.room_count);
        char title[96];
        snprintf(title, sizeof title, "%s as a share of those on open ground [BR209]",
                 pp_site_table_sun_title(&table));
        put_rows(document, title, "window", "%", table.suns, table.sun_count);
        put_rows(document,
                 "Share of each garden with two hours of sun on 21 March [BR209]",
                 "garden", "%", table.gardens, table.garden_count);
        status = put_losses(document, all, err);
    }
    if (status == PP_OK)
        put_rights(document, &table);
    pp_site_table_clear(&table);
    return status;
}

/* Adds a table of the simulated years of the rooms, if there are any. */
static enum pp_status put_years(struct pp_document *document,
                                const struct pp_assessments *all, struct pp_error *err)
{
    const struct pp_annual_sheet **years =
        calloc((size_t)all->count + 1, sizeof(struct pp_annual_sheet *));
    if (!years)
        return pp_fail_memory(err);
    int count = 0;
    for (int i = 0; i < all->count; i++)
        if (all->list[i].has_year)
            years[count++] = &all->list[i].year;
    if (count > 0)
        pp_year_section_rooms(document, years, count);
    free(years);
    return PP_OK;
}

/* ---- the whole report ---- */

static void put_title(struct pp_document *document, const struct pp_site_report *report)
{
    const struct pp_assessments *all = report->all;
    bool finished = true;
    for (int i = 0; i < all->count; i++)
        finished &= all->list[i].report.finished;
    pp_document_heading(document, 1, "%s", report->title);
    pp_document_paragraph(document, PP_TONE_SOFT, "Daylight: %s%s",
                          all->count ? all->list[0].room->file : "",
                          finished ? "" : "; NOT FINISHED, interrupted");
    pp_project_table(document, report->project);
}

enum pp_status pp_site_report(struct pp_document *document,
                              const struct pp_site_report *report, struct pp_error *err)
{
    const struct pp_assessments *all = report->all;
    put_title(document, report);
    say_sum(document, all);
    pp_document_contents(document);
    pp_document_heading(document, 2, "Summary");
    put_verdicts(document, all);
    pp_room_chapter_pictures(document, report, PP_SITE_WHOLE);
    enum pp_status status = put_tables(document, all, err);
    if (status == PP_OK && !report->full)
        status = put_years(document, all, err);
    if (!report->full) {
        pp_document_heading(document, 2, "Rooms");
        pp_rooms_table(document, all);
        if (status == PP_OK)
            status = pp_criteria_tables(document, all, err);
    }
    for (int i = 0; i < all->count && report->full; i++)
        pp_room_chapter(document, report, i);
    pp_limits_chapter(document, report);
    if (status == PP_OK)
        status = pp_made_chapter(document, report, err);
    return status == PP_OK ? pp_document_status(document, err) : status;
}
