/* document_pdf.h - writes a document as a PDF with A4 sheets. */
#ifndef PP_CLI_DOCUMENT_PDF_H
#define PP_CLI_DOCUMENT_PDF_H

#include <stdio.h>

#include "charts/document/document_sheets.h"

/* Writes the PDF to `out`. title: title of the PDF, and foot of each sheet;
 * description: subject of the PDF; pictures: see pp_document_sheets_draw; NULL: there
 * are none. */
enum pp_status pp_document_pdf(const struct pp_document *document, const char *title,
                               const char *description, bool landscape,
                               struct pp_canvas *const *pictures, FILE *out,
                               struct pp_error *err);

#endif
