/* document_html.h - a document as one page of HTML that needs nothing else. */
#ifndef PP_REPORTS_PAGE_DOCUMENT_HTML_H
#define PP_REPORTS_PAGE_DOCUMENT_HTML_H

#include <stdio.h>

#include "model/results/document.h"

/* A picture of a document, as SVG; bytes may begin with XML's declaration. */
struct pp_svg_picture {
    const char *bytes; /* not owned */
    size_t length;
};

/* Chapters begin sheets of their own in print, the first one aside; pictures are as wide as
 * the page. pictures: by their numbers. */
void pp_document_html(const struct pp_document *document, const char *title,
                      const struct pp_svg_picture *pictures, FILE *out);

#endif
