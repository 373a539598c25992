/* html.h - begin and end of self-contained HTML pages, without network access or
 * scripts. Pages are light or dark according to the reader's setting, and can be
 * printed. */
#ifndef PP_REPORTS_PAGE_HTML_H
#define PP_REPORTS_PAGE_HTML_H

#include <stdio.h>

/* Writes the page up to its first element. title: plain text, escaped by this function;
 * more_style: further CSS, or "". */
void pp_html_begin(const char *title, const char *more_style, FILE *out);
void pp_html_end(FILE *out);

/* Writes text with HTML escapes; bytes that are not UTF-8 are replaced. */
void pp_html_text(const char *text, FILE *out);

#endif
