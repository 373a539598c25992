/* document_pdf.h - writes a document as a PDF with sheets of A4. */
#ifndef PP_CLI_DOCUMENT_PDF_H
#define PP_CLI_DOCUMENT_PDF_H

#include <stdio.h>

#include "charts/document/document_sheets.h"

/* title: title of the file, and foot of each sheet; description: subject of the file;
 * pictures: see pp_document_sheets_draw; NULL: the document has none. */
enum pp_status pp_document_pdf(const struct pp_document *document, const char *title,
                               const char *description, bool landscape,
                               struct pp_canvas *const *pictures, FILE *out,
                               struct pp_error *err);

#endif
