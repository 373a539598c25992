/* document_sheets.h - lays out a document on sheets of paper.
 *
 * A chapter begins on a new sheet unless most of the current sheet is free. Tables
 * break between rows and repeat their heads and the titles of their groups. Rows,
 * paragraphs and pictures are never cut, and a heading is never the last line of a
 * sheet. Pictures keep their true scale and have their own titles. The foot of each
 * sheet has the document's name, the sheet's number and the number of sheets. The
 * chapters form the outline of the PDF, and a table of contents gives their sheets.
 */
#ifndef PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H
#define PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H

#include "charts/sheet/canvas.h"
#include "model/results/document.h"

/* Sheet for a half-page picture: as wide as the text of an A4 sheet, less the picture's
 * own margin. */
struct pp_sheet pp_document_sheets_picture(void);

/* Draws the document on a canvas with sheets. name: text for the foot of each sheet;
 * pictures: the drawings to place, in the order of their numbers. */
enum pp_status pp_document_sheets_draw(struct pp_canvas *canvas,
                                       const struct pp_document *document,
                                       const char *name,
                                       struct pp_canvas *const *pictures,
                                       struct pp_error *err);

#endif
