/* document.c - see document.h. */
#include "model/results/document.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

/* ---- memory ---- */

static void clear_table(struct pp_document_table *table)
{
    for (int i = 0; i < table->column_count; i++)
        free(table->columns[i].heading);
    for (int i = 0; i < table->row_count; i++) {
        for (int k = 0; k < table->rows[i].cell_count; k++) {
            free(table->rows[i].cells[k].text);
            free(table->rows[i].cells[k].note);
        }
        free(table->rows[i].cells);
    }
    free(table->columns);
    free(table->rows);
}

void pp_document_clear(struct pp_document *document)
{
    for (int i = 0; i < document->block_count; i++) {
        free(document->blocks[i].text);
        clear_table(&document->blocks[i].table);
    }
    free(document->blocks);
    *document = (struct pp_document){0};
}

enum pp_status pp_document_status(const struct pp_document *document,
                                  struct pp_error *err)
{
    return document->lacks_memory ? pp_fail_memory(err) : PP_OK;
}

/* Makes space for one more item in a list. Returns false if memory has run out, now or
 * earlier. */
static bool grow_document_list(struct pp_document *document, void *list, int count,
                               size_t size)
{
    if (!document->lacks_memory && pp_array_append(list, count, size, NULL) != PP_OK)
        document->lacks_memory = true;
    return !document->lacks_memory;
}

static char *formatted_words(struct pp_document *document, const char *format,
                             va_list arguments)
{
    char *text;
    if (vasprintf(&text, format, arguments) >= 0)
        return text;
    document->lacks_memory = true;
    return NULL;
}

/* ---- blocks ---- */

static struct pp_document_block *add_block(struct pp_document *document,
                                           enum pp_document_block_kind kind)
{
    if (!grow_document_list(document, &document->blocks, document->block_count,
                            sizeof *document->blocks))
        return NULL;
    struct pp_document_block *block = &document->blocks[document->block_count++];
    *block = (struct pp_document_block){.kind = kind};
    return block;
}

void pp_document_heading(struct pp_document *document, int level, const char *format,
                         ...)
{
    struct pp_document_block *block = add_block(document, PP_BLOCK_HEADING);
    if (!block)
        return;
    va_list arguments;
    va_start(arguments, format);
    block->level = level;
    block->text = formatted_words(document, format, arguments);
    va_end(arguments);
}

void pp_document_paragraph(struct pp_document *document, enum pp_tone tone,
                           const char *format, ...)
{
    struct pp_document_block *block = add_block(document, PP_BLOCK_PARAGRAPH);
    if (!block)
        return;
    va_list arguments;
    va_start(arguments, format);
    block->tone = tone;
    block->text = formatted_words(document, format, arguments);
    va_end(arguments);
}

void pp_document_picture(struct pp_document *document, int picture, const char *title)
{
    struct pp_document_block *block = add_block(document, PP_BLOCK_PICTURE);
    if (!block)
        return;
    block->picture = picture;
    block->text = strdup(title);
    document->lacks_memory |= !block->text;
}

void pp_document_contents(struct pp_document *document)
{
    struct pp_document_block *block = add_block(document, PP_BLOCK_CONTENTS);
    if (!block)
        return;
    block->text = strdup("Contents");
    document->lacks_memory |= !block->text;
}

/* ---- tables ---- */

/* Last table of the document; NULL if memory has run out. */
static struct pp_document_table *last_table(struct pp_document *document)
{
    return document->lacks_memory ? NULL
                                  : &document->blocks[document->block_count - 1].table;
}

static struct pp_document_row *last_row(struct pp_document *document)
{
    struct pp_document_table *table = last_table(document);
    return table ? &table->rows[table->row_count - 1] : NULL;
}

void pp_document_table(struct pp_document *document)
{
    add_block(document, PP_BLOCK_TABLE);
}

void pp_document_column(struct pp_document *document, enum pp_document_column_kind kind,
                        const char *format, ...)
{
    struct pp_document_table *table = last_table(document);
    if (!table
        || !grow_document_list(document, &table->columns, table->column_count,
                               sizeof *table->columns))
        return;
    va_list arguments;
    va_start(arguments, format);
    table->columns[table->column_count++] =
        (struct pp_document_column){kind, formatted_words(document, format, arguments)};
    va_end(arguments);
}

void pp_document_row(struct pp_document *document, enum pp_document_row_kind kind)
{
    struct pp_document_table *table = last_table(document);
    if (table
        && grow_document_list(document, &table->rows, table->row_count,
                              sizeof *table->rows))
        table->rows[table->row_count++] = (struct pp_document_row){.kind = kind};
}

void pp_document_cell(struct pp_document *document, enum pp_tone tone,
                      const char *format, ...)
{
    struct pp_document_row *row = last_row(document);
    if (!row
        || !grow_document_list(document, &row->cells, row->cell_count,
                               sizeof *row->cells))
        return;
    va_list arguments;
    va_start(arguments, format);
    row->cells[row->cell_count++] = (struct pp_document_cell){
        .tone = tone, .text = formatted_words(document, format, arguments)};
    va_end(arguments);
}

void pp_document_note(struct pp_document *document, const char *note)
{
    struct pp_document_row *row = last_row(document);
    if (!row)
        return;
    char *copy = strdup(note);
    document->lacks_memory |= !copy;
    row->cells[row->cell_count - 1].note = copy;
}

bool pp_document_has_head(const struct pp_document_table *table)
{
    for (int i = 0; i < table->column_count; i++)
        if (table->columns[i].heading[0])
            return true;
    return false;
}

/* ---- texts ---- */

void pp_document_texts(const struct pp_document *document,
                       void (*tell)(void *closure, const char *text), void *closure)
{
    for (int i = 0; i < document->block_count; i++) {
        const struct pp_document_block *block = &document->blocks[i];
        if (block->text)
            tell(closure, block->text);
        for (int k = 0; k < block->table.column_count; k++)
            tell(closure, block->table.columns[k].heading);
        for (int k = 0; k < block->table.row_count; k++)
            for (int n = 0; n < block->table.rows[k].cell_count; n++) {
                tell(closure, block->table.rows[k].cells[n].text);
                if (block->table.rows[k].cells[n].note)
                    tell(closure, block->table.rows[k].cells[n].note);
            }
    }
}
