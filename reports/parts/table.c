/* table.c - measures columns, breaks headings into lines, and prints panels that fit
 * the width. */
#include "reports/parts/table.h"

#include <stdlib.h>
#include <string.h>

#include "reports/parts/format.h"
#include "model/base/array.h"

enum {
    INDENT = 2,
    GAP = 2,       /* blanks between columns */
    GROUP_GAP = 3, /* blanks between groups of columns */
    HEADING = 6,   /* headings are broken to this width, unless cells are wider */
    HEADING_LINES = 6,
};

void pp_table_init(struct pp_table *table, int row_count)
{
    *table = (struct pp_table){.row_count = row_count};
}

void pp_table_clear(struct pp_table *table)
{
    for (int i = 0; i < table->column_count; i++)
        free(table->columns[i].cells);
    free(table->columns);
    *table = (struct pp_table){0};
}

struct pp_table_column *pp_table_add(struct pp_table *table, const char *group,
                                     const char *group_short, const char *heading)
{
    if (pp_array_append(&table->columns, table->column_count, sizeof *table->columns,
                        NULL)
        != PP_OK)
        return NULL;
    struct pp_table_column *column = &table->columns[table->column_count];
    *column = (struct pp_table_column){.group = group, .group_short = group_short};
    snprintf(column->heading, sizeof column->heading, "%s", heading);
    column->cells = calloc((size_t)table->row_count + 1, sizeof *column->cells);
    if (!column->cells)
        return NULL;
    table->column_count++;
    return column;
}

/* Length of the first part of a heading, up to where it may be broken: before "+" or a
 * blank, or after "-". */
static int fragment(const char *text)
{
    int length = 1;
    while (text[length] && text[length] != '+' && text[length] != ' '
           && text[length - 1] != '-')
        length++;
    return length;
}

/* Breaks a heading into lines, each at most `width` wide if possible. Returns the
 * number of lines. lines: pointers into the heading, not null-terminated. */
static int break_heading(const char *heading, int width,
                         const char *lines[HEADING_LINES], int lengths[HEADING_LINES])
{
    int count = 0;
    while (*heading && count < HEADING_LINES) {
        heading += *heading == ' ';
        int length = fragment(heading);
        while (heading[length]) {
            int longer = length + fragment(heading + length);
            if (longer > width && count < HEADING_LINES - 1)
                break;
            length = longer;
        }
        lines[count] = heading;
        lengths[count++] = length;
        heading += length;
    }
    return count;
}

/* Width of one line of a heading, in columns of the terminal. */
static int piece_width(const char *piece, int length)
{
    char text[sizeof((struct pp_table_column *)0)->heading];
    snprintf(text, sizeof text, "%.*s", length, piece);
    return pp_format_utf8_width(text);
}

static int cells_width(const struct pp_table *table,
                       const struct pp_table_column *column)
{
    int width = 0;
    for (int row = 0; row < table->row_count; row++) {
        int cell = pp_format_utf8_width(column->cells[row]);
        width = cell > width ? cell : width;
    }
    return width;
}

/* True if both columns belong to the same group. */
static bool same_group(const struct pp_table_column *a, const struct pp_table_column *b)
{
    return a->group == b->group;
}

/* Index of the first column after the group that contains column `first`. */
static int group_end(const struct pp_table *table, int first)
{
    int end = first + 1;
    while (end < table->column_count
           && same_group(&table->columns[end], &table->columns[first]))
        end++;
    return end;
}

/* Widens the first column of each group that is narrower than its short title, so that
 * titles do not touch. */
static void widen_groups(struct pp_table *table)
{
    for (int i = table->key_count, next; i < table->column_count; i = next) {
        next = group_end(table, i);
        const char *title = table->columns[i].group_short;
        int width = table->columns[i].width;
        for (int j = i + 1; j < next; j++)
            width += GAP + table->columns[j].width;
        if (title && pp_format_utf8_width(title) > width)
            table->columns[i].width += pp_format_utf8_width(title) - width;
    }
}

static void measure_columns(struct pp_table *table)
{
    for (int i = 0; i < table->column_count; i++) {
        struct pp_table_column *column = &table->columns[i];
        column->width = cells_width(table, column);
        const char *lines[HEADING_LINES];
        int lengths[HEADING_LINES];
        int wanted = column->width > HEADING ? column->width : HEADING;
        int count = break_heading(column->heading, wanted, lines, lengths);
        for (int line = 0; line < count; line++) {
            int width = piece_width(lines[line], lengths[line]);
            column->width = width > column->width ? width : column->width;
        }
    }
    widen_groups(table);
}

/* Number of blanks before column i in a panel. first: the first column of the panel
 * after the key columns. */
static int gap_before(const struct pp_table *table, int i, int first)
{
    if (i == 0)
        return INDENT;
    bool starts_group =
        i == first || !same_group(&table->columns[i], &table->columns[i - 1]);
    return starts_group ? GROUP_GAP : GAP;
}

static int keys_width(const struct pp_table *table)
{
    int width = 0;
    for (int i = 0; i < table->key_count; i++)
        width += gap_before(table, i, table->key_count) + table->columns[i].width;
    return width;
}

/* Index of the first column after a panel that begins with column `first`. A panel
 * consists of whole groups; if one group is too wide, of the columns of the group that
 * fit. */
static int panel_end(const struct pp_table *table, int first, int width)
{
    int used = keys_width(table);
    int end = first;
    while (end < table->column_count) {
        int next = group_end(table, end), needed = 0;
        for (int i = end; i < next; i++)
            needed += gap_before(table, i, first) + table->columns[i].width;
        if (used + needed > width)
            break;
        used += needed;
        end = next;
    }
    if (end > first)
        return end;
    for (; end < group_end(table, first); end++) {
        used += gap_before(table, end, first) + table->columns[end].width;
        if (end > first && used > width)
            break;
    }
    return end;
}

/* Output without trailing blanks: blanks are stored, and written only before further
 * text. */
struct writer {
    FILE *out;
    int blanks;
};

static void put_text(struct writer *writer, const char *text, int length)
{
    if (length <= 0)
        return;
    for (; writer->blanks > 0; writer->blanks--)
        fputc(' ', writer->out);
    fwrite(text, 1, (size_t)length, writer->out);
}

static void end_line(struct writer *writer)
{
    fputc('\n', writer->out);
    writer->blanks = 0;
}

static void put_rule(struct writer *writer, int width)
{
    for (int i = 0; i < width; i++)
        put_text(writer, "-", 1);
}

static void put_right(struct writer *writer, const char *text, int length, int columns,
                      int width)
{
    writer->blanks += width - columns;
    put_text(writer, text, length);
    writer->blanks += length > 0 ? 0 : columns;
}

static void put_aligned(struct writer *writer, const char *text, int length,
                        int columns, const struct pp_table_column *column)
{
    if (!column->is_words) {
        put_right(writer, text, length, columns, column->width);
        return;
    }
    put_text(writer, text, length);
    writer->blanks += column->width - (length > 0 ? columns : 0);
}

/* Columns printed side by side: the key columns and the columns [first, end). */
struct panel {
    const struct pp_table *table;
    int first, end;
};

/* Index of the column printed to the right of column i. */
static int next_column(const struct panel *panel, int i)
{
    return i + 1 == panel->table->key_count ? panel->first : i + 1;
}

static void put_gap(struct writer *writer, const struct panel *panel, int i)
{
    writer->blanks += gap_before(panel->table, i, panel->first);
}

/* Prints group titles, and rules below them over the width of the group. */
static void print_groups(const struct panel *panel, struct writer *writer)
{
    const struct pp_table *table = panel->table;
    for (int ruled = 0; ruled < 2; ruled++) {
        writer->blanks += keys_width(table);
        for (int i = panel->first, next; i < panel->end; i = next) {
            next = group_end(table, i) < panel->end ? group_end(table, i) : panel->end;
            int width = table->columns[i].width;
            for (int j = i + 1; j < next; j++)
                width += GAP + table->columns[j].width;
            const char *title = table->columns[i].group;
            if (pp_format_utf8_width(title) > width)
                title = table->columns[i].group_short;
            put_gap(writer, panel, i);
            if (ruled) {
                put_rule(writer, width);
            } else {
                put_text(writer, title, (int)strlen(title));
                writer->blanks += width - pp_format_utf8_width(title);
            }
        }
        end_line(writer);
    }
}

/* Prints headings, aligned at the bottom. */
static void print_headings(const struct panel *panel, struct writer *writer)
{
    const struct pp_table *table = panel->table;
    const char *lines[HEADING_LINES];
    int lengths[HEADING_LINES], most = 0;
    for (int i = 0; i < panel->end; i = next_column(panel, i)) {
        const struct pp_table_column *column = &table->columns[i];
        int count = break_heading(column->heading, column->width, lines, lengths);
        most = count > most ? count : most;
    }
    for (int line = 0; line < most; line++) {
        for (int i = 0; i < panel->end; i = next_column(panel, i)) {
            const struct pp_table_column *column = &table->columns[i];
            int count = break_heading(column->heading, column->width, lines, lengths);
            int which = line - (most - count);
            put_gap(writer, panel, i);
            if (which < 0)
                writer->blanks += column->width;
            else
                put_aligned(writer, lines[which], lengths[which],
                            piece_width(lines[which], lengths[which]), column);
        }
        end_line(writer);
    }
}

static void print_row(const struct panel *panel, int row, bool labelled,
                      struct writer *writer)
{
    const struct pp_table *table = panel->table;
    if (labelled) {
        writer->blanks += INDENT;
        put_text(writer, table->last_label, (int)strlen(table->last_label));
        writer->blanks +=
            keys_width(table) - INDENT - pp_format_utf8_width(table->last_label);
    }
    for (int i = labelled ? panel->first : 0; i < panel->end;
         i = next_column(panel, i)) {
        const char *cell = table->columns[i].cells[row];
        put_gap(writer, panel, i);
        put_aligned(writer, cell, (int)strlen(cell), pp_format_utf8_width(cell),
                    &table->columns[i]);
    }
    end_line(writer);
}

static void print_panel(const struct panel *panel, FILE *out)
{
    const struct pp_table *table = panel->table;
    struct writer writer = {out, 0};
    print_groups(panel, &writer);
    print_headings(panel, &writer);

    int width = keys_width(table) - INDENT;
    for (int i = panel->first; i < panel->end; i++)
        width += gap_before(table, i, panel->first) + table->columns[i].width;
    for (int row = 0; row < table->row_count; row++) {
        bool labelled = table->last_label && row == table->row_count - 1;
        if (labelled || row == 0) {
            writer.blanks = INDENT;
            put_rule(&writer, width);
            end_line(&writer);
        }
        print_row(panel, row, labelled, &writer);
    }
}

/* ---- shortening of key columns, so that a table fits the width ---- */

/* Replaces characters in the middle of a cell by two dots, so that the cell is
 * `columns` wide. */
static void shorten(char cell[PP_CELL_BYTES], int columns)
{
    char text[PP_CELL_BYTES];
    memcpy(text, cell, PP_CELL_BYTES);
    int head = 0, tail = (int)strlen(text), all = pp_format_utf8_width(text);
    if (all <= columns)
        return;
    for (int kept = 0; kept < (columns - 2) / 2; kept++)
        head += pp_format_utf8_length(text + head);
    while (tail > head) {
        int before = tail - 1;
        while (before > head && ((unsigned char)text[before] & 0xc0) == 0x80)
            before--;
        if (piece_width(text, head) + 2 + pp_format_utf8_width(text + before) > columns)
            break;
        tail = before;
    }
    snprintf(cell, PP_CELL_BYTES, "%.*s..%s", head, text, text + tail);
}

/* True if cells of column k that differ still differ when they are shortened to that
 * width. */
static bool tells_apart(const struct pp_table *table, int k, int columns)
{
    const struct pp_table_column *column = &table->columns[k];
    char(*cut)[PP_CELL_BYTES] = malloc((size_t)table->row_count * sizeof *cut);
    bool apart = cut != NULL;
    for (int i = 0; i < table->row_count && apart; i++) {
        memcpy(cut[i], column->cells[i], sizeof *cut);
        shorten(cut[i], columns);
        for (int j = 0; j < i && apart; j++)
            apart = strcmp(cut[i], cut[j]) != 0
                    || strcmp(column->cells[i], column->cells[j]) == 0;
    }
    free(cut);
    return apart;
}

void pp_table_fit(struct pp_table *table, int width)
{
    enum { KEY_LEAST = 9 };
    measure_columns(table);
    int needed = keys_width(table);
    for (int i = table->key_count; i < table->column_count; i++)
        needed += gap_before(table, i, table->key_count) + table->columns[i].width;
    while (needed > width) {
        int widest = -1;
        for (int i = 0; i < table->key_count; i++)
            if (table->columns[i].width > KEY_LEAST
                && (widest < 0
                    || table->columns[i].width > table->columns[widest].width)
                && tells_apart(table, i, table->columns[i].width - 1))
                widest = i;
        if (widest < 0)
            return;
        table->columns[widest].width--;
        needed--;
    }
    for (int i = 0; i < table->key_count; i++)
        for (int row = 0; row < table->row_count; row++)
            shorten(table->columns[i].cells[row], table->columns[i].width);
}

void pp_table_print(struct pp_table *table, int width, FILE *out)
{
    measure_columns(table);
    int key_width = keys_width(table) - INDENT;
    int label_width = table->last_label ? pp_format_utf8_width(table->last_label) : 0;
    if (table->key_count > 0 && key_width < label_width)
        table->columns[0].width += label_width - key_width;

    struct panel panel = {table, table->key_count, 0};
    for (; panel.first < table->column_count; panel.first = panel.end) {
        panel.end = panel_end(table, panel.first, width);
        if (panel.first > table->key_count)
            fputc('\n', out);
        print_panel(&panel, out);
    }
}
