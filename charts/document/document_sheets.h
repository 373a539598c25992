/* document_sheets.h - lays out a document on sheets of paper.
 *
 * A chapter begins on a new sheet unless most of the current sheet is free. Tables
 * break between rows and repeat their heads and the titles of their groups. Rows,
 * paragraphs and pictures are never split between sheets, and a heading is never the
 * last line of a sheet. Pictures keep their scale and have titles. The foot of each
 * sheet states the document's name, the number of the sheet and the total number of
 * sheets. The title and the chapters form the outline of the PDF, and a table of
 * contents gives the sheets of the chapters.
 */
#ifndef PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H
#define PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H

#include "charts/sheet/canvas.h"
#include "model/results/document.h"

/* Sheet for a half-page picture. Its width is the text width of an A4 sheet plus the
 * picture's own margins, so that the drawing without them is as wide as the text. */
struct pp_sheet pp_document_sheets_picture(void);

/* Draws the document on a canvas with sheets. name: text at the foot of each sheet;
 * pictures: drawings to be placed, in the order of their numbers. */
enum pp_status pp_document_sheets_draw(struct pp_canvas *canvas,
                                       const struct pp_document *document,
                                       const char *name,
                                       struct pp_canvas *const *pictures,
                                       struct pp_error *err);

#endif
