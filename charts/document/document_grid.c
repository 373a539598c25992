/* document_grid.c - see document_grid.h. */
#include "charts/document/document_grid.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Maximum number of lines in a cell and in a note. Longer text is cut, so that each row
 * fits on a sheet. */
enum { LINES_MOST = 30, NOTE_LINES_MOST = 15 };

/* ---- widths ---- */

static double text_width(const struct pp_document_grid *grid, struct pp_lettering set,
                         const char *text)
{
    return pp_lettering_measure(grid->cr, grid->style, &set, 0.0, 0.0, text).width;
}

/* Width of the longest word. */
static double word_width(const struct pp_document_grid *grid, struct pp_lettering set,
                         const char *text)
{
    double widest = 0.0;
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        char word[64];
        int length = (int)strcspn(text, " ");
        snprintf(word, sizeof word, "%.*s", length, text);
        widest = fmax(widest, text_width(grid, set, word));
        text += length;
    }
    return widest;
}

/* Headings wider than this may be broken into lines (mm, for A4). */
static const double heading_mm = 24.0;

static double heading_width(const struct pp_document_grid *grid, const char *heading)
{
    const struct pp_lettering set = {.size = PP_TEXT_SMALL};
    return fmax(word_width(grid, set, heading),
                fmin(heading_mm * grid->style->scale, text_width(grid, set, heading)));
}

/* Width of the widest cell of a column, if none is broken into lines. */
static double widest_cell(const struct pp_document_grid *grid, int column)
{
    const struct pp_document_table *table = grid->table;
    const struct pp_lettering cell = {.size = PP_TEXT_BODY},
                              strong = {.size = PP_TEXT_BODY, .bold = true};
    double width = 0.0;
    for (int i = 0; i < table->row_count; i++) {
        const struct pp_document_row *row = &table->rows[i];
        if (row->kind != PP_ROW_CELLS || column >= row->cell_count)
            continue;
        bool bad = row->cells[column].tone == PP_TONE_BAD;
        width =
            fmax(width, text_width(grid, bad ? strong : cell, row->cells[column].text));
    }
    return width;
}

/* Width of a column with its heading in few lines (natural), or with one line for each
 * word of the heading (least). Cells are not broken into lines. */
struct column_width {
    double natural, least;
};

static struct column_width column_width(const struct pp_document_grid *grid, int column)
{
    const struct pp_lettering small = {.size = PP_TEXT_SMALL};
    const char *heading = grid->table->columns[column].heading;
    const double cells = widest_cell(grid, column);
    const double rounding = 0.1; /* added, so that rounding never causes a line break */
    return (struct column_width){
        .natural = fmax(cells, heading_width(grid, heading)) + rounding,
        .least = fmax(cells, word_width(grid, small, heading)) + rounding};
}

/* Distributes the width `left` among the columns of words. A column gets its natural
 * width if possible. If there is not enough width, the wider columns get equal parts of
 * the width that narrower columns leave. Any spare width is distributed in proportion
 * to the natural widths. */
static void share_words(struct pp_document_grid *grid,
                        const struct column_width *wanted, double left)
{
    bool settled[PP_GRID_COLUMNS] = {false};
    double all = 0.0;
    int open = 0;
    for (int i = 0; i < grid->column_count; i++) {
        settled[i] = grid->table->columns[i].kind != PP_COLUMN_WORDS;
        open += !settled[i];
        all += settled[i] ? 0.0 : wanted[i].natural;
    }
    for (bool found = true; found && open > 0;) {
        double share = left / open;
        found = false;
        for (int i = 0; i < grid->column_count; i++)
            if (!settled[i] && wanted[i].natural <= share) {
                grid->widths[i] = wanted[i].natural;
                left -= wanted[i].natural;
                settled[i] = found = true;
                open--;
            }
    }
    for (int i = 0; i < grid->column_count; i++)
        if (!settled[i])
            grid->widths[i] = left / open;
        else if (open == 0 && grid->table->columns[i].kind == PP_COLUMN_WORDS)
            grid->widths[i] += left * wanted[i].natural / all;
}

/* Fraction of the table's width reserved for columns of words, if they need that
 * much. */
static const double words_share = 0.3;

/* Sets the widths of the columns of numbers and labels, at most `most` in total. If
 * their natural widths do not fit, headings get more lines; if that is not enough, all
 * columns shrink. Returns the total width. */
static double share_numbers(struct pp_document_grid *grid,
                            const struct column_width *wanted, double most)
{
    double natural = 0.0, least = 0.0, sum = 0.0;
    for (int i = 0; i < grid->column_count; i++)
        if (grid->table->columns[i].kind != PP_COLUMN_WORDS) {
            natural += wanted[i].natural;
            least += wanted[i].least;
        }
    const double spare = natural > least ? (most - least) / (natural - least) : 1.0;
    const double stretch = fmin(fmax(spare, 0.0), 1.0);
    const double shrink = least > most ? most / least : 1.0;
    for (int i = 0; i < grid->column_count; i++)
        if (grid->table->columns[i].kind != PP_COLUMN_WORDS) {
            grid->widths[i] =
                shrink
                * (wanted[i].least + stretch * (wanted[i].natural - wanted[i].least));
            sum += grid->widths[i];
        }
    return sum;
}

struct pp_document_grid pp_document_grid_lay(cairo_t *cr, const struct pp_style *style,
                                             const struct pp_document_table *table,
                                             double x, double width)
{
    struct pp_document_grid grid = {.cr = cr,
                                    .style = style,
                                    .table = table,
                                    .x = x,
                                    .width = width,
                                    .gap = 3.0 * style->scale};
    grid.column_count =
        table->column_count < PP_GRID_COLUMNS ? table->column_count : PP_GRID_COLUMNS;
    struct column_width wanted[PP_GRID_COLUMNS];
    double words = 0.0;
    for (int i = 0; i < grid.column_count; i++) {
        wanted[i] = column_width(&grid, i);
        if (table->columns[i].kind == PP_COLUMN_WORDS)
            words += wanted[i].natural;
    }
    const double room = width - grid.gap * (grid.column_count - 1);
    const double numbers =
        share_numbers(&grid, wanted, room - fmin(words, words_share * room));
    share_words(&grid, wanted, room - numbers);
    return grid;
}

/* ---- rows ---- */

static double pad(const struct pp_document_grid *grid)
{
    return 0.7 * grid->style->scale;
}

static void draw_rule(const struct pp_document_grid *grid, double y, double weight_mm,
                      double grey)
{
    pp_style_line(grid->cr, weight_mm, grey);
    cairo_move_to(grid->cr, grid->x, y);
    cairo_line_to(grid->cr, grid->x + grid->width, y);
    cairo_stroke(grid->cr);
}

/* Places text in a box whose left edge is x, aligned as in `set`. If `drawn` is false,
 * only measures. Returns the height of the text. */
static double put_grid_words(const struct pp_document_grid *grid,
                             struct pp_lettering set, double x, double y, double width,
                             const char *words, bool drawn)
{
    if (!words[0])
        return 0.0;
    set.width = width;
    return (drawn ? pp_lettering_draw : pp_lettering_measure)(
               grid->cr, grid->style, &set, x + set.across * width, y, words)
        .height;
}

static double across_of(const struct pp_document_grid *grid, int column)
{
    return grid->table->columns[column].kind == PP_COLUMN_NUMBERS ? 1.0 : 0.0;
}

double pp_document_grid_head(const struct pp_document_grid *grid, double y, bool drawn)
{
    double x = grid->x, height = 0.0;
    if (!pp_document_has_head(grid->table))
        return 0.0;
    for (int i = 0; i < grid->column_count; i++) {
        const struct pp_lettering set = {.size = PP_TEXT_SMALL,
                                         .grey = PP_GREY_TEXT,
                                         .across = across_of(grid, i),
                                         .lines = 4};
        height =
            fmax(height, put_grid_words(grid, set, x, y + pad(grid), grid->widths[i],
                                        grid->table->columns[i].heading, drawn));
        x += grid->widths[i] + grid->gap;
    }
    height += 2.0 * pad(grid);
    if (drawn)
        draw_rule(grid, y + height, grid->style->thin, PP_INK);
    return height;
}

static double put_cell(const struct pp_document_grid *grid, int column,
                       const struct pp_document_cell *cell, double x, double y,
                       bool drawn)
{
    bool label = grid->table->columns[column].kind == PP_COLUMN_LABELS;
    const struct pp_lettering set = {
        .size = PP_TEXT_BODY,
        .bold = cell->tone == PP_TONE_BAD,
        .grey = label || cell->tone == PP_TONE_SOFT ? PP_GREY_TEXT : PP_INK,
        .across = across_of(grid, column),
        .lines = LINES_MOST};
    const struct pp_lettering note = {.size = PP_TEXT_SMALL,
                                      .grey = PP_GREY_TEXT,
                                      .across = set.across,
                                      .lines = NOTE_LINES_MOST};
    double width = grid->widths[column];
    double height = put_grid_words(grid, set, x, y, width, cell->text, drawn);
    if (cell->note)
        height += put_grid_words(grid, note, x, y + height, width, cell->note, drawn);
    return height;
}

static double put_cells(const struct pp_document_grid *grid,
                        const struct pp_document_row *row, double y, bool drawn)
{
    double x = grid->x, height = 0.0;
    for (int i = 0; i < grid->column_count && i < row->cell_count; i++) {
        height =
            fmax(height, put_cell(grid, i, &row->cells[i], x, y + pad(grid), drawn));
        x += grid->widths[i] + grid->gap;
    }
    height += 2.0 * pad(grid);
    if (drawn)
        draw_rule(grid, y + height, grid->style->hair, PP_GREY_LINE);
    return height;
}

/* Places a group's title (with some space above it) or a remark across all columns. If
 * `drawn` is false, only measures. Returns the height. */
static double put_across(const struct pp_document_grid *grid,
                         const struct pp_document_row *row, double y, bool drawn)
{
    bool group = row->kind == PP_ROW_GROUP;
    const struct pp_lettering set = {.size = group ? PP_TEXT_BODY : PP_TEXT_SMALL,
                                     .bold = group,
                                     .grey = group ? PP_INK : PP_GREY_TEXT,
                                     .lines = NOTE_LINES_MOST};
    double above = (group ? 3.0 : 0.0) * pad(grid);
    double height = put_grid_words(grid, set, grid->x, y + above, grid->width,
                                   row->cell_count ? row->cells[0].text : "", drawn);
    return above + height + pad(grid);
}

double pp_document_grid_row(const struct pp_document_grid *grid, int row, double y,
                            bool drawn)
{
    const struct pp_document_row *one = &grid->table->rows[row];
    return one->kind == PP_ROW_CELLS ? put_cells(grid, one, y, drawn)
                                     : put_across(grid, one, y, drawn);
}

double pp_document_grid_unit(const struct pp_document_grid *grid, int row)
{
    const struct pp_document_table *table = grid->table;
    double height = 0.0;
    int i = row;
    if (row >= table->row_count)
        return 0.0;
    while (i + 1 < table->row_count && table->rows[i].kind != PP_ROW_CELLS)
        height += pp_document_grid_row(grid, i++, 0.0, false);
    height += pp_document_grid_row(grid, i, 0.0, false);
    if (i + 2 == table->row_count)
        height += pp_document_grid_row(grid, i + 1, 0.0, false);
    return height;
}
