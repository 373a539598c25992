/* html.h - the frame of self-contained HTML pages: no network, no scripts; light or
 * dark by the reader's setting, and suitable for print. */
#ifndef PP_REPORTS_PAGE_HTML_H
#define PP_REPORTS_PAGE_HTML_H

#include <stdio.h>

/* Writes the page up to its first element. title: escaped here; more_style: CSS, or
 * "". */
void pp_html_begin(const char *title, const char *more_style, FILE *out);
void pp_html_end(FILE *out);

/* Writes text with markup escaped, and bytes that are not UTF-8 replaced. */
void pp_html_text(const char *text, FILE *out);

#endif
