/* document_sheets.h - a document on sheets of paper.
 *
 * Chapters begin sheets of their own unless most of one is left. Tables break between their
 * rows, with their heads and their groups' titles repeated; no row, paragraph or picture is
 * cut, and no heading is the last of a sheet. Pictures stand at true scale, as they were
 * drawn, and say themselves what they show. At the foot of each sheet stand the document's
 * name and which of how many sheets it is; chapters are the PDF's list of contents.
 */
#ifndef PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H
#define PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H

#include "charts/sheet/canvas.h"
#include "model/results/document.h"

/* Canvas of a half-page picture: text width of A4 sheets less its own margin. */
struct pp_sheet pp_document_sheets_picture(void);

/* Draws the document on a canvas that has sheets. name: for their feet; pictures: drawings
 * that are to be placed, by their numbers. */
enum pp_status pp_document_sheets_draw(struct pp_canvas *canvas,
                                       const struct pp_document *document,
                                       const char *name,
                                       struct pp_canvas *const *pictures,
                                       struct pp_error *err);

#endif
