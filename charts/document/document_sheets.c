/* document_sheets.c - see document_sheets.h. The document is processed twice: first to
 * count the sheets, then to draw them. */
#include "charts/document/document_sheets.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "charts/document/document_grid.h"
#include "charts/sheet/page.h"

/* The type size is that of a chart on a sheet of this width (mm), a little larger than
 * on an A4 chart, because a document has more text. */
static const double type_of_mm = 240.0;

/* Left, right and top margin of sheets; bottom margin with the foot line (mm). */
static const double margin_mm = 16.0, foot_mm = 18.0;

/* If less than this fraction of a sheet is left, a chapter begins a new sheet. */
static const double chapter_share = 0.6;

/* Maximum number of lines of a heading or paragraph. A text given by the user, such as
 * a name or a command line, may be long. */
enum { LINES_MOST = 12 };

struct sheet_setter {
    struct pp_canvas *canvas;
    cairo_t *cr;
    struct pp_style style;
    const struct pp_document *document;
    const char *name;
    struct pp_canvas *const *pictures;
    struct pp_box body;
    double y;         /* y of the next block, mm */
    int sheet, count; /* sheet: number of the current sheet, from 1; count: all sheets,
                       * 0 in the first pass */
    int *chapters;    /* first sheet of each chapter (a heading of level 2) */
    int chapter;      /* index of the next chapter */
    bool drawn;       /* false: sheets are only counted */
    enum pp_status status;
    struct pp_error *err;
};

struct pp_sheet pp_document_sheets_picture(void)
{
    const double a4_mm = 210.0, own_margin_mm = 10.0;
    return (struct pp_sheet){.width_mm = a4_mm - 2.0 * (margin_mm - own_margin_mm),
                             .height_mm = 146.0};
}

/* ---- sheets ---- */

static void put_foot(struct sheet_setter *setter)
{
    const struct pp_box *body = &setter->body;
    struct pp_lettering set = {.size = PP_TEXT_SMALL,
                               .grey = PP_GREY_TEXT,
                               .width = 0.75 * body->width,
                               .lines = 1};
    double y = body->y + body->height + 4.0;
    char words[64];
    pp_style_line(setter->cr, setter->style.hair, PP_GREY_LINE);
    cairo_move_to(setter->cr, body->x, y - 1.0);
    cairo_line_to(setter->cr, body->x + body->width, y - 1.0);
    cairo_stroke(setter->cr);
    pp_lettering_draw(setter->cr, &setter->style, &set, body->x, y, setter->name);
    set.across = 1.0;
    snprintf(words, sizeof words, "page %d of %d", setter->sheet, setter->count);
    pp_lettering_draw(setter->cr, &setter->style, &set, body->x + body->width, y,
                      words);
}

static void begin_sheet(struct sheet_setter *setter)
{
    if (setter->drawn && setter->sheet > 0)
        setter->status = pp_canvas_next_sheet(setter->canvas, setter->err);
    setter->sheet++;
    setter->y = setter->body.y;
    if (setter->drawn && setter->status == PP_OK)
        put_foot(setter);
}

static bool at_top(const struct sheet_setter *setter)
{
    return setter->y <= setter->body.y + 1e-9;
}

static double left_on_sheet(const struct sheet_setter *setter)
{
    return setter->body.y + setter->body.height - setter->y;
}

/* Begins a new sheet unless `height` (mm) is left on the current sheet, or the current
 * sheet is empty. */
static void need(struct sheet_setter *setter, double height)
{
    if (height > left_on_sheet(setter) && !at_top(setter))
        begin_sheet(setter);
}

/* ---- blocks ---- */

static double gap(const struct sheet_setter *setter, double mm)
{
    return at_top(setter) ? 0.0 : mm * setter->style.scale;
}

/* Places text `in` mm from the body's left and right edges. If `drawn` is false, or in
 * the first pass, only measures. Returns the height of the text. */
static double put_sheet_words(struct sheet_setter *setter, struct pp_lettering set,
                              double in, double y, const char *words, bool drawn)
{
    set.width = setter->body.width - 2.0 * in;
    set.lines = LINES_MOST;
    return (drawn && setter->drawn ? pp_lettering_draw : pp_lettering_measure)(
               setter->cr, &setter->style, &set, setter->body.x + in, y, words)
        .height;
}

static struct pp_lettering heading_set(int level)
{
    return (struct pp_lettering){.size = level < 3 ? PP_TEXT_TITLE : PP_TEXT_HEAD,
                                 .bold = true};
}

static struct pp_lettering paragraph_set(enum pp_tone tone)
{
    bool back = tone == PP_TONE_SOFT;
    return (struct pp_lettering){.size = tone == PP_TONE_VERDICT ? PP_TEXT_HEAD
                                         : back                  ? PP_TEXT_SMALL
                                                                 : PP_TEXT_BODY,
                                 .bold = tone == PP_TONE_BAD,
                                 .grey = back ? PP_GREY_TEXT : PP_INK};
}

/* Distance of a verdict's text from the edge of its box (mm). */
static double inset(const struct sheet_setter *setter, enum pp_tone tone)
{
    return tone == PP_TONE_VERDICT ? 2.5 * setter->style.scale : 0.0;
}

static double paragraph_height(struct sheet_setter *setter,
                               const struct pp_document_block *block)
{
    double in = inset(setter, block->tone);
    return 2.0 * in
           + put_sheet_words(setter, paragraph_set(block->tone), in, 0.0, block->text,
                             false);
}

/* Margin of a picture (mm). The margin is empty, so it is not part of the picture's
 * height here. */
static double picture_margin(const struct pp_canvas *picture)
{
    return pp_page_style(picture).margin;
}

static double picture_height(const struct sheet_setter *setter,
                             const struct pp_document_block *block)
{
    const struct pp_canvas *picture = setter->pictures[block->picture];
    return pp_canvas_height_mm(picture) - 2.0 * picture_margin(picture);
}

static struct pp_document_grid grid_of(const struct sheet_setter *setter,
                                       const struct pp_document_block *block)
{
    return pp_document_grid_lay(setter->cr, &setter->style, &block->table,
                                setter->body.x, setter->body.width);
}

static double table_least(const struct sheet_setter *setter,
                          const struct pp_document_block *block)
{
    struct pp_document_grid grid = grid_of(setter, block);
    return pp_document_grid_head(&grid, 0.0, false) + pp_document_grid_unit(&grid, 0);
}

/* Least height (mm) that must be left on the sheet for a block to begin there. A
 * heading stays with the next block, and a paragraph before a table stays with the
 * table. */
static double least(struct sheet_setter *setter, int index)
{
    double height = 0.0;
    for (; index < setter->document->block_count; index++) {
        const struct pp_document_block *block = &setter->document->blocks[index],
                                       *next = block + 1;
        switch (block->kind) {
        case PP_BLOCK_HEADING:
            height += 6.0 * setter->style.scale
                      + put_sheet_words(setter, heading_set(block->level), 0.0, 0.0,
                                        block->text, false);
            break;
        case PP_BLOCK_PARAGRAPH:
            height += 2.0 * setter->style.scale + paragraph_height(setter, block);
            if (index + 1 == setter->document->block_count
                || next->kind != PP_BLOCK_TABLE)
                return height;
            break;
        case PP_BLOCK_TABLE:
            return height + table_least(setter, block);
        case PP_BLOCK_CONTENTS:
            return height;
        case PP_BLOCK_PICTURE:
            return height + picture_height(setter, block);
        }
    }
    return height;
}

static void put_heading(struct sheet_setter *setter, int index)
{
    const struct pp_document_block *block = &setter->document->blocks[index];
    bool chapter = block->level == 2;
    if (chapter && !at_top(setter)
        && left_on_sheet(setter) < chapter_share * setter->body.height)
        begin_sheet(setter);
    need(setter, least(setter, index));
    setter->y += gap(setter, chapter ? 6.0 : 4.0);
    if (chapter)
        setter->chapters[setter->chapter++] = setter->sheet;
    if (setter->drawn && block->level < 3)
        pp_canvas_add_outline(setter->canvas, block->level, block->text, setter->y);
    setter->y += put_sheet_words(setter, heading_set(block->level), 0.0, setter->y,
                                 block->text, true)
                 + 1.0 * setter->style.scale;
}

/* Draws the box of a verdict, with a bar at its left. */
static void draw_box(struct sheet_setter *setter, double height)
{
    cairo_t *cr = setter->cr;
    pp_style_grey(cr, PP_GREY_FILL);
    cairo_rectangle(cr, setter->body.x, setter->y, setter->body.width, height);
    cairo_fill(cr);
    pp_style_grey(cr, PP_INK);
    cairo_rectangle(cr, setter->body.x, setter->y, 1.0, height);
    cairo_fill(cr);
}

static void put_paragraph(struct sheet_setter *setter, int index)
{
    const struct pp_document_block *block = &setter->document->blocks[index];
    double height = paragraph_height(setter, block), in = inset(setter, block->tone);
    need(setter, least(setter, index));
    setter->y += gap(setter, 1.5);
    if (setter->drawn && in > 0.0)
        draw_box(setter, height);
    put_sheet_words(setter, paragraph_set(block->tone), in, setter->y + in, block->text,
                    true);
    setter->y += height + 0.5 * setter->style.scale;
}

/* Repeats, on a new sheet, the table's head and the title of the group to which `row`
 * belongs. */
static void continue_table(struct sheet_setter *setter,
                           const struct pp_document_grid *grid, int row)
{
    const struct pp_document_row *rows = grid->table->rows;
    int group = row;
    while (group >= 0 && rows[group].kind != PP_ROW_GROUP)
        group--;
    setter->y += pp_document_grid_head(grid, setter->y, setter->drawn);
    if (group >= 0 && group < row)
        setter->y += pp_document_grid_row(grid, group, setter->y, setter->drawn);
}

static void put_table(struct sheet_setter *setter, int index)
{
    struct pp_document_grid grid = grid_of(setter, &setter->document->blocks[index]);
    need(setter, table_least(setter, &setter->document->blocks[index]));
    setter->y += gap(setter, 1.0);
    setter->y += pp_document_grid_head(&grid, setter->y, setter->drawn);
    for (int i = 0; i < grid.table->row_count && setter->status == PP_OK; i++) {
        int sheet = setter->sheet;
        need(setter, pp_document_grid_unit(&grid, i));
        if (setter->sheet != sheet)
            continue_table(setter, &grid, i);
        setter->y += pp_document_grid_row(&grid, i, setter->y, setter->drawn);
    }
}

static void put_picture(struct sheet_setter *setter, int index)
{
    const struct pp_document_block *block = &setter->document->blocks[index];
    const struct pp_canvas *picture = setter->pictures[block->picture];
    double height = picture_height(setter, block), space = gap(setter, 4.0);
    need(setter, space + height);
    setter->y += gap(setter, 4.0);
    if (setter->drawn)
        pp_canvas_place(setter->canvas, picture,
                        setter->body.x
                            + 0.5 * (setter->body.width - pp_canvas_width_mm(picture)),
                        setter->y - picture_margin(picture));
    setter->y += height;
}

/* Places a line of the table of contents, with the sheet number at the right. */
static void put_contents_line(struct sheet_setter *setter, const char *words, int sheet,
                              double height)
{
    struct pp_lettering set = paragraph_set(PP_TONE_PLAIN);
    char number[16];
    set.width = setter->body.width - 12.0;
    set.lines = 1;
    need(setter, height);
    if (setter->drawn) {
        pp_lettering_draw(setter->cr, &setter->style, &set, setter->body.x, setter->y,
                          words);
        set.across = 1.0;
        snprintf(number, sizeof number, "%d", sheet);
        pp_lettering_draw(setter->cr, &setter->style, &set,
                          setter->body.x + setter->body.width, setter->y, number);
    }
    setter->y += height;
}

/* Places the table of contents. The first pass has found the sheets of the chapters. */
static void put_contents(struct sheet_setter *setter, int index)
{
    const struct pp_document *document = setter->document;
    double height = 1.4
                    * put_sheet_words(setter, paragraph_set(PP_TONE_PLAIN), 0.0, 0.0,
                                      "Chapter", false);
    need(setter, 3.0 * height);
    setter->y += gap(setter, 4.0);
    setter->y += put_sheet_words(setter, heading_set(3), 0.0, setter->y,
                                 document->blocks[index].text, true)
                 + 1.0 * setter->style.scale;
    for (int i = 0, chapter = 0; i < document->block_count; i++)
        if (document->blocks[i].kind == PP_BLOCK_HEADING
            && document->blocks[i].level == 2)
            put_contents_line(setter, document->blocks[i].text,
                              setter->chapters[chapter++], height);
}

static void put_all(struct sheet_setter *setter)
{
    static void (*const put_block[])(struct sheet_setter *, int) = {
        [PP_BLOCK_HEADING] = put_heading,   [PP_BLOCK_PARAGRAPH] = put_paragraph,
        [PP_BLOCK_TABLE] = put_table,       [PP_BLOCK_PICTURE] = put_picture,
        [PP_BLOCK_CONTENTS] = put_contents,
    };
    begin_sheet(setter);
    for (int i = 0; i < setter->document->block_count && setter->status == PP_OK; i++)
        put_block[setter->document->blocks[i].kind](setter, i);
}

enum pp_status pp_document_sheets_draw(struct pp_canvas *canvas,
                                       const struct pp_document *document,
                                       const char *name,
                                       struct pp_canvas *const *pictures,
                                       struct pp_error *err)
{
    const struct sheet_setter fresh = {
        .canvas = canvas,
        .cr = pp_canvas_cairo(canvas),
        .style = pp_style_for(type_of_mm),
        .document = document,
        .name = name,
        .pictures = pictures,
        .chapters = calloc((size_t)document->block_count + 1, sizeof(int)),
        .body = {margin_mm, margin_mm, pp_canvas_width_mm(canvas) - 2.0 * margin_mm,
                 pp_canvas_height_mm(canvas) - margin_mm - foot_mm},
        .err = err};
    if (!fresh.chapters)
        return pp_fail_memory(err);
    struct sheet_setter counting = fresh, drawing = fresh;
    put_all(&counting);
    drawing.drawn = true;
    drawing.count = counting.sheet;
    put_all(&drawing);
    free(fresh.chapters);
    return drawing.status;
}
