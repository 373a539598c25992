/* document_html.h - a document as one self-contained HTML page. */
#ifndef PP_REPORTS_PAGE_DOCUMENT_HTML_H
#define PP_REPORTS_PAGE_DOCUMENT_HTML_H

#include <stdio.h>

#include "model/results/document.h"

/* SVG file of a picture. The bytes may begin with an XML declaration. */
struct pp_svg_picture {
    const char *bytes; /* not owned */
    size_t length;
};

/* Writes the page. In print, each chapter except the first begins on a new sheet, and
 * pictures are at most as wide as the page and 10.5 cm high. pictures: drawings in the
 * order of their numbers. */
void pp_document_html(const struct pp_document *document, const char *title,
                      const struct pp_svg_picture *pictures, FILE *out);

#endif
