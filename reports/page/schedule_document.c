/* schedule_document.c - see schedule_document.h. */
#include "reports/page/schedule_document.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "reports/page/project_table.h"
#include "reports/page/room_chapter.h"
#include "studies/criteria/br209_count.h"

/* Quantities that share one table. */
struct schedule_part {
    const struct pp_window_schedule *schedule;
    enum pp_schedule_quantity quantities[PP_SCHEDULE_CHANGES];
    int count;
    bool compares; /* true if any window has an existing value */
};

/* Number of columns for each quantity: proposed; also existing and loss if there is a
 * former state; also cumulative if there is a cumulative state. */
static int columns_each(const struct schedule_part *part)
{
    return (part->compares ? 3 : 1) + (part->schedule->has_cumulative ? 1 : 0);
}

static bool has_quantity(const struct pp_window_schedule *schedule,
                         enum pp_schedule_quantity quantity)
{
    for (int i = 0; i < schedule->count; i++) {
        const struct pp_schedule_change *change = &schedule->rows[i].changes[quantity];
        if (isfinite(change->existing) || isfinite(change->proposed))
            return true;
    }
    return false;
}

static bool has_existing(const struct pp_window_schedule *schedule)
{
    for (int i = 0; i < schedule->count; i++)
        for (int k = 0; k < PP_SCHEDULE_CHANGES; k++)
            if (isfinite(schedule->rows[i].changes[k].existing))
                return true;
    return false;
}

static void put_columns(struct pp_document *document, const struct schedule_part *part)
{
    pp_document_table(document);
    pp_document_column(document, PP_COLUMN_WORDS, "room");
    pp_document_column(document, PP_COLUMN_WORDS, "window");
    for (int n = 0; n < part->count; n++) {
        enum pp_schedule_quantity k = part->quantities[n];
        char title[PP_SCHEDULE_TITLE];
        pp_window_schedule_title(title, part->schedule, k);
        if (part->compares)
            pp_document_column(document, PP_COLUMN_NUMBERS, "%s: existing", title);
        pp_document_column(document, PP_COLUMN_NUMBERS, "%s",
                           part->compares ? "proposed" : title);
        if (part->compares)
            pp_document_column(document, PP_COLUMN_NUMBERS, "loss, %%");
        if (part->schedule->has_cumulative)
            pp_document_column(document, PP_COLUMN_NUMBERS, "cumulative");
        if (k == PP_SCHEDULE_SKY)
            pp_document_column(document, PP_COLUMN_WORDS, "BR 209, sky");
    }
}

static void put_change(struct pp_document *document, const struct schedule_part *part,
                       enum pp_schedule_quantity quantity,
                       const struct pp_schedule_row *row)
{
    const struct pp_schedule_change change = row->changes[quantity];
    const double scale = pp_schedule_scale(quantity), loss = pp_schedule_loss(change);
    if (part->compares)
        pp_room_chapter_number(document, scale * change.existing, 2);
    pp_room_chapter_number(document, scale * change.proposed, 2);
    if (part->compares && loss >= pp_loss_bands[1])
        pp_document_cell(document, PP_TONE_BAD, "%.1f", 100.0 * loss);
    else if (part->compares)
        pp_room_chapter_number(document, 100.0 * loss, 1);
    if (part->schedule->has_cumulative)
        pp_room_chapter_number(document, scale * change.cumulative, 2);
    if (quantity == PP_SCHEDULE_SKY)
        pp_document_cell(
            document,
            row->verdict == PP_MET       ? PP_TONE_GOOD
            : row->verdict == PP_NOT_MET ? PP_TONE_BAD
                                         : PP_TONE_PLAIN,
            "%s", row->verdict == PP_STATED ? "–" : pp_finding_word(row->verdict));
}

/* True if both windows are on the same floor of the same house. */
static bool same_floor(const struct pp_schedule_row *a, const struct pp_schedule_row *b)
{
    const char *house_a = a->room->room->world->address,
               *house_b = b->room->room->world->address;
    return a->level_m == b->level_m
           && strcmp(house_a ? house_a : "", house_b ? house_b : "") == 0;
}

static void put_floor(struct pp_document *document, const struct pp_schedule_row *row)
{
    const char *house = row->room->room->world->address;
    pp_document_row(document, PP_ROW_GROUP);
    pp_document_cell(document, PP_TONE_PLAIN, "%s%sfloor at %+.2f m",
                     house ? house : "", house ? ", " : "", row->level_m);
}

static void put_part(struct pp_document *document, const struct schedule_part *part)
{
    const struct pp_window_schedule *schedule = part->schedule;
    put_columns(document, part);
    for (int i = 0; i < schedule->count; i++) {
        const struct pp_schedule_row *row = &schedule->rows[i];
        const struct pp_world *world = row->room->room->world;
        if (i == 0 || !same_floor(row, row - 1))
            put_floor(document, row);
        pp_document_row(document, PP_ROW_CELLS);
        pp_document_cell(
            document, PP_TONE_PLAIN, "%s%s%s", world->ref ? world->ref : "",
            world->ref && world->name ? " " : "", world->name ? world->name : "");
        pp_document_cell(document, PP_TONE_PLAIN, "%s", row->window);
        for (int n = 0; n < part->count; n++)
            put_change(document, part, part->quantities[n], row);
    }
}

/* Adds the quantities that have values, in as many tables as necessary. */
static void put_parts(struct pp_document *document,
                      const struct pp_window_schedule *schedule, bool compares,
                      int most_figures)
{
    struct schedule_part part = {.schedule = schedule, .compares = compares};
    for (int k = 0; k < PP_SCHEDULE_CHANGES; k++) {
        if (!has_quantity(schedule, (enum pp_schedule_quantity)k))
            continue;
        if ((part.count + 1) * columns_each(&part) > most_figures) {
            put_part(document, &part);
            part.count = 0;
        }
        part.quantities[part.count++] = (enum pp_schedule_quantity)k;
    }
    if (part.count > 0)
        put_part(document, &part);
}

enum pp_status pp_schedule_document(struct pp_document *document,
                                    const struct pp_window_schedule *schedule,
                                    const char *title, const struct pp_project *project,
                                    int most_figures, struct pp_error *err)
{
    const bool compares = has_existing(schedule);
    pp_document_heading(document, 1, "%s", title);
    pp_document_paragraph(document, PP_TONE_SOFT, "Schedule of windows: daylight%s",
                          compares ? ", existing and proposed" : "");
    pp_project_table(document, project);
    put_parts(document, schedule, compares, most_figures);
    if (compares)
        pp_document_paragraph(
            document, PP_TONE_SOFT,
            "Losses are in per cent of the existing value; those of %.0f %% or more "
            "are marked. A dash means that the figure was not assessed for this "
            "window.",
            100.0 * pp_loss_bands[1]);
    return pp_document_status(document, err);
}
