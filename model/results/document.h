/* document.h - the content of a report, in order: headings, paragraphs, tables and
 * pictures. A document is laid out as an HTML page (reports/page/document_html.h) or on
 * sheets of paper (charts/document/document_sheets.h).
 *
 * A document grows at its end: additions go to the last table, its last row, and the
 * last cell of that row. Texts are copied; their formats are those of printf. If memory
 * runs out the rest is left out; pp_document_status reports that.
 */
#ifndef PP_MODEL_RESULTS_DOCUMENT_H
#define PP_MODEL_RESULTS_DOCUMENT_H

#include <stdbool.h>

#include "model/base/error.h"

/* Emphasis of a text. */
enum pp_tone {
    PP_TONE_PLAIN,
    PP_TONE_SOFT, /* a remark, in a lighter tone */
    PP_TONE_GOOD,
    PP_TONE_BAD,
    PP_TONE_VERDICT, /* paragraph with the overall result */
    PP_TONE_CODE,    /* paragraph with text to type */
};

enum pp_document_column_kind {
    PP_COLUMN_WORDS,   /* left-aligned, wrapped */
    PP_COLUMN_NUMBERS, /* right-aligned, on one line */
    PP_COLUMN_LABELS,  /* left-aligned, on one line, in a lighter tone: subject of a
                        * row */
};

struct pp_document_column {
    enum pp_document_column_kind kind;
    char *heading;
};

struct pp_document_cell {
    enum pp_tone tone;
    char *text;
    char *note; /* below the text, in a lighter tone; NULL: none */
};

enum pp_document_row_kind {
    PP_ROW_CELLS,
    PP_ROW_GROUP,  /* one cell across all columns: subject of the following rows */
    PP_ROW_REMARK, /* one cell across all columns, in a lighter tone: remark on the
                    * group */
};

struct pp_document_row {
    enum pp_document_row_kind kind;
    struct pp_document_cell *cells; /* one per column, or a single one; missing cells
                                     * are empty */
    int cell_count;
};

struct pp_document_table {
    struct pp_document_column *columns;
    int column_count;
    struct pp_document_row *rows;
    int row_count;
};

enum pp_document_block_kind {
    PP_BLOCK_HEADING,
    PP_BLOCK_PARAGRAPH,
    PP_BLOCK_TABLE,
    PP_BLOCK_PICTURE,
    PP_BLOCK_CONTENTS, /* table of contents: list of chapters */
};

struct pp_document_block {
    enum pp_document_block_kind kind;
    enum pp_tone tone; /* tone of a paragraph */
    int level;         /* level of a heading: 1 title, 2 chapter, 3 section */
    char *text;        /* text, or caption of a picture; NULL for a table */
    struct pp_document_table table;
    int picture; /* index in the list of pictures given to the layout */
};

struct pp_document {
    struct pp_document_block *blocks;
    int block_count;
    bool lacks_memory;
};

/* Frees the contents; the document is then empty, all zero. */
void pp_document_clear(struct pp_document *document);

void pp_document_heading(struct pp_document *document, int level, const char *format,
                         ...) __attribute__((format(printf, 3, 4)));
void pp_document_paragraph(struct pp_document *document, enum pp_tone tone,
                           const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void pp_document_picture(struct pp_document *document, int picture, const char *title);

/* Adds a table of contents of the headings of level 2. */
void pp_document_contents(struct pp_document *document);

/* Adds a table. Its columns must be added before its rows. A table whose headings are
 * all empty has no head. */
void pp_document_table(struct pp_document *document);
void pp_document_column(struct pp_document *document, enum pp_document_column_kind kind,
                        const char *format, ...) __attribute__((format(printf, 3, 4)));
void pp_document_row(struct pp_document *document, enum pp_document_row_kind kind);
void pp_document_cell(struct pp_document *document, enum pp_tone tone,
                      const char *format, ...) __attribute__((format(printf, 3, 4)));
void pp_document_note(struct pp_document *document, const char *note);

/* True if the table has a head. */
bool pp_document_has_head(const struct pp_document_table *table);

/* PP_SYSTEM if part of the document is missing because memory ran out. */
enum pp_status pp_document_status(const struct pp_document *document,
                                  struct pp_error *err);

/* Calls `tell` with each text of the document in order, including cells and
 * headings. */
void pp_document_texts(const struct pp_document *document,
                       void (*tell)(void *closure, const char *text), void *closure);

#endif
