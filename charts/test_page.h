/* test_page.h - a page for checking a printer: rulers, greys, line widths, hatching and
 * text, at full size.
 */
#ifndef PP_CHARTS_TEST_PAGE_H
#define PP_CHARTS_TEST_PAGE_H

#include "charts/sheet/canvas.h"

/* Length of each ruler on paper, mm. */
enum { PP_TEST_PAGE_RULER_MM = 100 };

/* Draws the page. The canvas must be an upright A4 sheet. PP_SYSTEM if text cannot be
 * laid out. */
enum pp_status pp_test_page_draw(struct pp_canvas *canvas, struct pp_error *err);

/* Writes the family name (UTF-8) of the font used for charts on this machine. Returns
 * the number of characters of the test page's sample text that are missing from all
 * fonts. */
int pp_test_page_font(char *family, size_t room);

#endif
