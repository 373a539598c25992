/* document_sheets.h - a document on sheets of paper.
 *
 * A chapter begins a new sheet unless most of the current one is free. Tables break
 * between their rows, with their heads and their groups' titles repeated; no row,
 * paragraph or picture is cut, and no heading is the last of a sheet. Pictures keep
 * their true scale and carry their own titles. The foot of each sheet has the
 * document's name and the number of the sheet and of all sheets. Chapters form the
 * PDF's outline, and a table of contents has their sheets.
 */
#ifndef PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H
#define PP_CHARTS_DOCUMENT_DOCUMENT_SHEETS_H

#include "charts/sheet/canvas.h"
#include "model/results/document.h"

/* Canvas of a half-page picture: text width of A4 sheets less its own margin. */
struct pp_sheet pp_document_sheets_picture(void);

/* Draws the document on a canvas with sheets. name: for the foot of each sheet;
 * pictures: the drawings to place, by number. */
enum pp_status pp_document_sheets_draw(struct pp_canvas *canvas,
                                       const struct pp_document *document,
                                       const char *name,
                                       struct pp_canvas *const *pictures,
                                       struct pp_error *err);

#endif
