/* assess_table.c - makes and prints the tables of a site. */
#include "reports/assess/assess_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/assess/finding_cells.h"
#include "reports/assess/trees_note.h"
#include "reports/parts/figure_unit.h"
#include "reports/parts/print.h"
#include "reports/parts/table.h"
#include "studies/criteria/br209_count.h"
#include "studies/criteria/site_table.h"

/* Content of a column. */
enum shown {
    ROOM,
    REF,
    USE,
    OF,
    EXISTING,
    PROPOSED,
    LOSS,
    RATIO,
    FIGURE,
    WANTED,
    VERDICT,
    CUMULATIVE,
    CUMULATIVE_RATIO,
    BY_CUMULATIVE,
    MIRRORED,
    BY_MIRROR_IMAGE,
    /* columns for rights of light */
    AREA,
    SHARE,
    LOST,
    EQUIVALENT,
    LOST_IN, /* area lost in zone z is LOST_IN + z (enum pp_lit_zone) */
};

struct heading {
    const char *group; /* title of the column group; NULL: a key column */
    const char *words;
    enum shown shown;
    bool compares; /* omitted if there is no comparison */
};

static const char sky[] = "vertical sky component, %",
                  lit[] = "area with a view of the sky, m2",
                  cumulative[] = "cumulative", mirror_image[] = "mirror image",
                  found[] = "found", sun[] = "share of sunlight hours, %",
                  sunlit[] = "sunlit for two hours, %",
                  adequate[] = "adequately lit, m2", lost[] = "lost, m2";
static const struct heading of_windows[] = {
    {NULL, "room", ROOM, false},
    {NULL, "ref", REF, false},
    {NULL, "window", OF, false},
    {sky, "existing", EXISTING, true},
    {sky, "proposed", PROPOSED, false},
    {sky, "loss, %", LOSS, true},
    {sky, "ratio", RATIO, true},
    {sky, "verdict", VERDICT, false},
    {cumulative, "sky, %", CUMULATIVE, true},
    {cumulative, "ratio", CUMULATIVE_RATIO, true},
    {cumulative, "verdict", BY_CUMULATIVE, true},
    {mirror_image, "sky, %", MIRRORED, false},
    {mirror_image, "verdict", BY_MIRROR_IMAGE, false},
    {0}};
static const struct heading of_rooms[] = {
    {NULL, "room", ROOM, false},
    {NULL, "ref", REF, false},
    {NULL, "use", USE, false},
    {lit, "existing", EXISTING, true},
    {lit, "proposed", PROPOSED, false},
    {lit, "loss, %", LOSS, true},
    {lit, "ratio", RATIO, true},
    {lit, "verdict", VERDICT, true},
    {cumulative, "area, m2", CUMULATIVE, true},
    {cumulative, "ratio", CUMULATIVE_RATIO, true},
    {cumulative, "verdict", BY_CUMULATIVE, true},
    {mirror_image, "area, m2", MIRRORED, false},
    {mirror_image, "verdict", BY_MIRROR_IMAGE, false},
    {0}};
static const struct heading of_suns[] = {{NULL, "room", ROOM, false},
                                         {NULL, "ref", REF, false},
                                         {NULL, "window", OF, false},
                                         {sun, "existing", EXISTING, true},
                                         {sun, "proposed", PROPOSED, false},
                                         {sun, "loss, %", LOSS, true},
                                         {sun, "ratio", RATIO, true},
                                         {sun, "verdict", VERDICT, false},
                                         {cumulative, "sun, %", CUMULATIVE, true},
                                         {cumulative, "ratio", CUMULATIVE_RATIO, true},
                                         {cumulative, "verdict", BY_CUMULATIVE, true},
                                         {0}};
static const struct heading of_gardens[] = {
    {NULL, "garden", OF, false},           {sunlit, "existing", EXISTING, true},
    {sunlit, "proposed", PROPOSED, false}, {sunlit, "ratio", RATIO, true},
    {sunlit, "verdict", VERDICT, false},   {0}};
static const struct heading of_rights[] = {
    {NULL, "room", ROOM, false},
    {NULL, "ref", REF, false},
    {adequate, "of", AREA, false},
    {adequate, "existing", EXISTING, true},
    {adequate, "proposed", PROPOSED, false},
    {adequate, "share, %", SHARE, false},
    {adequate, "verdict", VERDICT, false},
    {lost, "all", LOST, true},
    {lost, "front", LOST_IN + PP_ZONE_FRONT, true},
    {lost, "first", LOST_IN + PP_ZONE_FIRST, true},
    {lost, "second", LOST_IN + PP_ZONE_SECOND, true},
    {lost, "make-weight", LOST_IN + PP_ZONE_MAKEWEIGHT, true},
    {lost, "equiv. first", EQUIVALENT, true},
    {0}};
static const struct heading of_others[] = {
    {NULL, "room", ROOM, false},        {NULL, "of", OF, false},
    {found, "figure", FIGURE, false},   {found, "wanted", WANTED, false},
    {found, "verdict", VERDICT, false}, {0}};

static void put_number(char cell[PP_CELL_BYTES], double value, int decimals)
{
    if (isnan(value))
        snprintf(cell, PP_CELL_BYTES, "-");
    else
        snprintf(cell, PP_CELL_BYTES, "%.*f", decimals, value + 0.0);
}

/* Writes an area, or a fraction of the area, for one room or for the sum of all
 * rooms. */
static void put_lit(char cell[PP_CELL_BYTES], const struct pp_lit_change *of,
                    enum shown shown)
{
    const double figures[] = {
        [AREA] = of->plane_m2,   [EXISTING] = of->before_m2,
        [PROPOSED] = of->lit_m2, [SHARE] = 100.0 * of->lit_m2 / of->plane_m2,
        [LOST] = of->lost_m2,    [EQUIVALENT] = of->loss.equivalent_m2};
    if (shown >= LOST_IN)
        put_number(cell, of->loss.zones_m2[shown - LOST_IN], 2);
    else if (shown >= AREA || shown == EXISTING || shown == PROPOSED)
        put_number(cell, figures[shown], shown == SHARE ? 1 : 2);
}

static void put_cell(char cell[PP_CELL_BYTES], const struct pp_site_row *row,
                     enum shown shown)
{
    const struct pp_world *world = row->room->room->world;
    const struct pp_finding *finding = row->finding;
    double compared = pp_figure_scale(finding->compared);
    char text[PP_FINDING_CELL];
    const char *verdict = pp_finding_own_word(finding);
    const struct pp_finding *mirrored = row->by_mirror_image;
    switch (shown) {
    case ROOM:
        pp_text_excerpt(cell, PP_CELL_BYTES, world->name ? world->name : "-");
        break;
    case REF:
        pp_text_excerpt(cell, PP_CELL_BYTES, world->ref ? world->ref : "");
        break;
    case USE:
        snprintf(cell, PP_CELL_BYTES, "%s",
                 world->use ? pp_room_use_words[world->use] : "");
        break;
    case OF:
        pp_text_excerpt(cell, PP_CELL_BYTES, finding->what);
        break;
    case EXISTING:
        put_number(cell, compared * row->existing, 2);
        break;
    case PROPOSED:
        put_number(cell, compared * row->proposed, 2);
        break;
    case LOSS:
        put_number(cell, 100.0 * (1.0 - row->ratio), 1);
        break;
    case RATIO:
        put_number(cell, row->ratio, 3);
        break;
    case FIGURE:
        pp_finding_cells_figure(text, finding, false);
        snprintf(cell, PP_CELL_BYTES, "%s", text);
        break;
    case WANTED:
        pp_finding_cells_wanted(text, finding, false);
        snprintf(cell, PP_CELL_BYTES, "%s", text);
        break;
    case VERDICT:
        snprintf(cell, PP_CELL_BYTES, "%s", verdict ? verdict : "-");
        break;
    case CUMULATIVE:
        put_number(cell, compared * row->cumulative, 2);
        break;
    case CUMULATIVE_RATIO:
        put_number(cell, row->cumulative_ratio, 3);
        break;
    case BY_CUMULATIVE:
        verdict = row->in_cumulative ? pp_finding_own_word(row->in_cumulative) : NULL;
        snprintf(cell, PP_CELL_BYTES, "%s", verdict ? verdict : "-");
        break;
    case MIRRORED:
        put_number(cell, compared * row->mirrored, 2);
        break;
    case BY_MIRROR_IMAGE:
        verdict = mirrored ? pp_finding_own_word(mirrored) : NULL;
        snprintf(cell, PP_CELL_BYTES, "%s", verdict ? verdict : "-");
        break;
    default:
        put_number(cell, NAN, 0);
    }
    if (row->lit)
        put_lit(cell, row->lit, shown);
}

/* Prints a table. sum: areas for the last line; NULL: omit that line. */
static enum pp_status print_table(const char *title, const struct heading *headings,
                                  const struct pp_site_row *rows, int count,
                                  const struct pp_lit_change *sum, int width, FILE *out,
                                  struct pp_error *err)
{
    bool compares = false, has_ref = false, all_have = true, good = true;
    bool mirrored = false, has_cumulative = false;
    for (int i = 0; i < count; i++) {
        has_cumulative |= rows[i].in_cumulative != NULL;
        compares |= !isnan(rows[i].existing);
        mirrored |= rows[i].by_mirror_image != NULL;
        has_ref |= rows[i].room->room->world->ref != NULL;
        all_have &= rows[i].room->room->world->ref != NULL;
    }
    if (count == 0)
        return PP_OK;
    struct pp_table table;
    pp_table_init(&table, sum ? count + 1 : count);
    table.last_label = sum ? "sum" : NULL;
    for (const struct heading *h = headings; h->words && good; h++) {
        if ((h->compares && !compares) || (h->shown == REF && !has_ref)
            || (h->group == cumulative && !has_cumulative)
            || (h->group == mirror_image && !mirrored))
            continue;
        /* Figures and bounds need the width of the table, so rooms are identified by
         * their references. */
        const bool by_ref = h->shown == ROOM && headings == of_others && all_have;
        const enum shown shown = by_ref ? REF : h->shown;
        struct pp_table_column *column =
            pp_table_add(&table, h->group, h->group, by_ref ? "ref" : h->words);
        good = column != NULL;
        table.key_count += good && !h->group;
        for (int i = 0; i < count && good; i++)
            put_cell(column->cells[i], &rows[i], shown);
        if (good && sum)
            put_lit(column->cells[count], sum, shown);
        if (good)
            column->is_words = h->shown <= OF || h->shown == VERDICT
                               || h->shown == BY_CUMULATIVE
                               || h->shown == BY_MIRROR_IMAGE;
    }
    fprintf(out, "\n  %s\n\n", title);
    if (good) {
        pp_table_fit(&table, width);
        pp_table_print(&table, width, out);
    }
    pp_table_clear(&table);
    return good ? PP_OK : pp_fail_memory(err);
}

/* Prints one table if all rooms exist, else separate tables for existing and proposed
 * rooms. */
static enum pp_status print_tables(const char *title, const struct heading *headings,
                                   const struct pp_site_row *rows, int count, int width,
                                   FILE *out, struct pp_error *err)
{
    char words[96];
    const int old = pp_site_table_existing(rows, count);
    if (old == count)
        return print_table(title, headings, rows, count, NULL, width, out, err);
    snprintf(words, sizeof words, "%s, existing rooms", title);
    enum pp_status status =
        print_table(words, headings, rows, old, NULL, width, out, err);
    snprintf(words, sizeof words, "%s, proposed rooms", title);
    return status == PP_OK ? print_table(words, headings, rows + old, count - old, NULL,
                                         width, out, err)
                           : status;
}

/* Prints the criteria in the table with their sources, and notes on the mirror
 * image. */
static void print_foot(const struct pp_site_table *table, int width, FILE *out)
{
    enum { LISTS = 6 };
    const struct pp_site_row *lists[LISTS] = {table->windows, table->rooms,
                                              table->suns,    table->gardens,
                                              table->rights,  table->others};
    const int counts[LISTS] = {table->window_count, table->room_count,
                               table->sun_count,    table->garden_count,
                               table->rights_count, table->other_count};
    char text[1024] = "Criteria:";
    const struct pp_criterion *listed[PP_CRITERIA_MOST];
    int count = 0;
    for (int l = 0; l < LISTS; l++)
        for (int i = 0; i < counts[l]; i++) {
            const struct pp_criterion *criterion = lists[l][i].criterion;
            int place = 0;
            while (place < count && listed[place] != criterion)
                place++;
            if (place < count || count == PP_CRITERIA_MOST)
                continue;
            pp_text_append(text, sizeof text, "%s %s [%s]%s", count > 0 ? "," : "",
                           criterion->title, criterion->source,
                           criterion->withdrawn ? " (withdrawn)" : "");
            listed[count++] = criterion;
        }
    if (table->has_mirror_image)
        pp_text_append(text, sizeof text,
                       ". Mirror image: the proposal is replaced by a mirror image of "
                       "the building at the boundary, with the same height and ground "
                       "level. The criterion is met if at least as much sky remains "
                       "with the proposal as with the mirror image [%s]",
                       pp_criterion_mirror_image.source);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}

/* Prints how many windows and rooms meet BR 209, and how many windows are in each band
 * of loss. */
static void print_count(const struct pp_assessments *all, int width, FILE *out)
{
    const struct pp_br209_count count = pp_br209_count_of(all->list, all->count);
    char text[PP_BR209_WORDS + 200];
    pp_br209_count_words(text, &count);
    if (!text[0])
        return;
    if (count.compared > 0) {
        pp_text_append(text, sizeof text, "; loss of sky below %.0f %%: %d window%s",
                       100.0 * pp_loss_bands[1], count.losses[0],
                       count.losses[0] == 1 ? "" : "s");
        for (int i = 1; i < PP_LOSS_BANDS; i++)
            pp_text_append(text, sizeof text, ", %s%.0f %%%s: %d",
                           i + 1 < PP_LOSS_BANDS ? "from " : "",
                           100.0 * pp_loss_bands[i],
                           i + 1 < PP_LOSS_BANDS ? "" : " or more", count.losses[i]);
    }
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}

enum { GROUP_WINDOWS = 1, GROUP_ROOMS, GROUP_LOSSES };
enum { GROUP_COLUMNS = GROUP_LOSSES + PP_LOSS_BANDS };
static const char meets[] = "meet BR 209", by_loss[] = "windows by loss of sky";

static void put_group_heading(char heading[32], int column)
{
    const int band = column - GROUP_LOSSES;
    if (column < GROUP_LOSSES)
        snprintf(heading, 32, "%s",
                 (const char *[]){"floor", "windows", "rooms"}[column]);
    else if (band == 0)
        snprintf(heading, 32, "< %.0f %%", 100.0 * pp_loss_bands[1]);
    else
        snprintf(heading, 32, ">= %.0f %%", 100.0 * pp_loss_bands[band]);
}

static void put_group_cell(char cell[PP_CELL_BYTES], const struct pp_br209_count *count,
                           int column)
{
    if (column == GROUP_WINDOWS) {
        snprintf(cell, PP_CELL_BYTES, "%d of %d", count->windows_met, count->windows);
    } else if (column == GROUP_ROOMS && count->rooms == 0) {
        snprintf(cell, PP_CELL_BYTES, "-");
    } else if (column == GROUP_ROOMS) {
        snprintf(cell, PP_CELL_BYTES, "%d of %d", count->rooms_met, count->rooms);
    } else {
        snprintf(cell, PP_CELL_BYTES, "%d", count->losses[column - GROUP_LOSSES]);
    }
}

/* Prints for each floor and house how many windows and rooms meet BR 209, and how many
 * windows are in each band of loss. */
static enum pp_status print_groups(const struct pp_assessments *all, int width,
                                   FILE *out, struct pp_error *err)
{
    struct pp_br209_group *groups;
    int count;
    enum pp_status status =
        pp_br209_count_groups(&groups, &count, all->list, all->count, err);
    struct pp_table table;
    pp_table_init(&table, count);
    table.key_count = 1;
    bool good = status == PP_OK && count > 1;
    for (int c = 0; c < GROUP_COLUMNS && good; c++) {
        char heading[32], words[PP_BR209_WORDS];
        put_group_heading(heading, c);
        const char *group = c == 0 ? NULL : c < GROUP_LOSSES ? meets : by_loss;
        struct pp_table_column *column = pp_table_add(&table, group, group, heading);
        good = column != NULL;
        for (int i = 0; i < count && good; i++)
            if (c > 0) {
                put_group_cell(column->cells[i], &groups[i].count, c);
            } else {
                pp_br209_count_group_words(words, groups, count, i);
                pp_text_excerpt(column->cells[i], PP_CELL_BYTES, words);
            }
        if (good)
            column->is_words = c == 0;
    }
    if (good) {
        fputs("\n  Floors and houses\n\n", out);
        pp_table_fit(&table, width);
        pp_table_print(&table, width, out);
    }
    pp_table_clear(&table);
    free(groups);
    return status == PP_OK && count > 1 && !good ? pp_fail_memory(err) : status;
}

enum pp_status pp_assess_table(const struct pp_assessments *all, int width, FILE *out,
                               struct pp_error *err)
{
    struct pp_site_table table;
    enum pp_status status = pp_site_table_of(&table, all->list, all->count, err);
    if (status == PP_OK)
        print_count(all, width, out);
    if (status == PP_OK)
        status = print_groups(all, width, out, err);
    if (status == PP_OK)
        status = print_tables("Windows", of_windows, table.windows, table.window_count,
                              width, out, err);
    if (status == PP_OK)
        status = print_tables("Rooms", of_rooms, table.rooms, table.room_count, width,
                              out, err);
    if (status == PP_OK)
        status = print_tables(pp_site_table_sun_title(&table), of_suns, table.suns,
                              table.sun_count, width, out, err);
    if (status == PP_OK)
        status = print_table("Gardens, on 21 March", of_gardens, table.gardens,
                             table.garden_count, NULL, width, out, err);
    if (status == PP_OK)
        status = print_table("Rights of light: area inside the 0.2 % contour",
                             of_rights, table.rights, table.rights_count,
                             &table.rights_sum, width, out, err);
    if (status == PP_OK)
        status = print_tables("Other criteria", of_others, table.others,
                              table.other_count, width, out, err);
    if (status == PP_OK)
        print_foot(&table, width, out);
    char note[PP_TREES_NOTE_BYTES];
    if (status == PP_OK
        && pp_trees_note_text(note, all->list, all->count, " degrees")) {
        fputs("\n  ", out);
        pp_print_wrapped(note, 2, 2, width, out);
    }
    pp_site_table_clear(&table);
    return status;
}
