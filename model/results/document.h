/* document.h - the content of a report, in order: headings, paragraphs, tables and
 * pictures. It is laid out as a page of HTML (reports/page/document_html.h) or on
 * sheets of paper (charts/document/document_sheets.h).
 *
 * A document grows at its end: additions go to the last table, its last row and that
 * row's last cell. Texts are copied; their formats are printf's. When memory runs out
 * the rest is left out, as pp_document_status reports.
 */
#ifndef PP_MODEL_RESULTS_DOCUMENT_H
#define PP_MODEL_RESULTS_DOCUMENT_H

#include <stdbool.h>

#include "model/base/error.h"

/* Role of a text among others. */
enum pp_tone {
    PP_TONE_PLAIN,
    PP_TONE_SOFT, /* a remark, which stands back */
    PP_TONE_GOOD,
    PP_TONE_BAD,
    PP_TONE_VERDICT, /* a paragraph: the overall result */
    PP_TONE_CODE,    /* a paragraph: as it would be typed */
};

enum pp_document_column_kind {
    PP_COLUMN_WORDS,   /* to the left, as many lines as they take */
    PP_COLUMN_NUMBERS, /* to the right, on one line */
    PP_COLUMN_LABELS,  /* to the left, on one line, in a lighter tone: the subject of a
                       * row */
};

struct pp_document_column {
    enum pp_document_column_kind kind;
    char *heading;
};

struct pp_document_cell {
    enum pp_tone tone;
    char *text;
    char *note; /* below the text, standing back; NULL: none */
};

enum pp_document_row_kind {
    PP_ROW_CELLS,
    PP_ROW_GROUP,  /* one cell across all columns: the subject of the rows below */
    PP_ROW_REMARK, /* one cell all across, standing back: belongs to the group above */
};

struct pp_document_row {
    enum pp_document_row_kind kind;
    struct pp_document_cell *cells; /* one for each column, or a single one; missing
                                     * ones are empty */
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
    PP_BLOCK_CONTENTS, /* the chapters, where they begin */
};

struct pp_document_block {
    enum pp_document_block_kind kind;
    enum pp_tone tone; /* of a paragraph */
    int level;         /* of a heading: 1 the title, 2 a chapter, 3 a part of one */
    char *text;        /* caption of a picture; NULL for a table */
    struct pp_document_table table;
    int picture; /* its number among those that whoever sets the document is given */
};

struct pp_document {
    struct pp_document_block *blocks;
    int block_count;
    bool lacks_memory;
};

/* Empty is all zero. */
void pp_document_clear(struct pp_document *document);

void pp_document_heading(struct pp_document *document, int level, const char *format,
                         ...) __attribute__((format(printf, 3, 4)));
void pp_document_paragraph(struct pp_document *document, enum pp_tone tone,
                           const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void pp_document_picture(struct pp_document *document, int picture, const char *title);

/* A table of contents here, of the headings of level 2. */
void pp_document_contents(struct pp_document *document);

/* A new table at the end; its columns are added before its rows. Headings may be empty:
 * a table in which all are has no head. */
void pp_document_table(struct pp_document *document);
void pp_document_column(struct pp_document *document, enum pp_document_column_kind kind,
                        const char *format, ...) __attribute__((format(printf, 3, 4)));
void pp_document_row(struct pp_document *document, enum pp_document_row_kind kind);
void pp_document_cell(struct pp_document *document, enum pp_tone tone,
                      const char *format, ...) __attribute__((format(printf, 3, 4)));
void pp_document_note(struct pp_document *document, const char *note);

/* True if the table has a head. */
bool pp_document_has_head(const struct pp_document_table *table);

/* PP_OK, or PP_SYSTEM where a part of the document is missing. */
enum pp_status pp_document_status(const struct pp_document *document,
                                  struct pp_error *err);

/* Calls `tell` with each text of the document in order, including cells and
 * headings. */
void pp_document_texts(const struct pp_document *document,
                       void (*tell)(void *closure, const char *text), void *closure);

#endif
