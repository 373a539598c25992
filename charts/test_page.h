/* test_page.h - a sheet to check a printer with: rulers, greys, line widths, hatches and
 * text, at true scale.
 */
#ifndef PP_CHARTS_TEST_PAGE_H
#define PP_CHARTS_TEST_PAGE_H

#include "charts/sheet/canvas.h"

/* Length of both rulers on paper, mm. */
enum { PP_TEST_PAGE_RULER_MM = 100 };

/* Draws the page; the canvas is a portrait sheet of A4. PP_SYSTEM if text cannot be
 * laid out. */
enum pp_status pp_test_page_draw(struct pp_canvas *canvas, struct pp_error *err);

/* Family name of the font of charts on this machine, as UTF-8. Returns the number of
 * characters of the test page that no font of the machine has. */
int pp_test_page_font(char *family, size_t room);

#endif
