/* page.h - title and subtitle above the drawing, and notes below it, for all charts. */
#ifndef PP_CHARTS_SHEET_PAGE_H
#define PP_CHARTS_SHEET_PAGE_H

#include "charts/sheet/canvas.h"
#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"
#include "model/light/outside_light.h"
#include "model/room/world.h"

struct pp_page {
    const char *title;    /* name of the room; may be long; NULL: no title line */
    const char *subtitle; /* content of the chart, and the sky */
    const char *foot;     /* notes, which may have several lines; NULL or "": none */
};

/* Draws title and notes. Returns the free box between them. */
struct pp_box pp_page_draw(struct pp_canvas *canvas, const struct pp_style *style,
                           const struct pp_page *page);

/* Returns the box that pp_page_draw would return, without drawing. */
struct pp_box pp_page_measure(struct pp_canvas *canvas, const struct pp_style *style,
                              const struct pp_page *page);

/* Appends a sentence to `text` (a buffer of `room` bytes), after a space unless the
 * sentence begins a line. Text that does not fit is cut. */
void pp_page_say(char *text, size_t room, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Writes the common name of the sky: "CIE overcast sky", "ISO 15469 sky of type 12, sun
 * 30° high at bearing 180°". */
void pp_page_sky(char *text, size_t room, const struct pp_world *world,
                 const struct pp_outside_light *light);

/* Like pp_page_sky, for a sky that does not belong to a room. north_rad: bearing of the
 * +y axis. */
void pp_page_sky_words(char *text, size_t room, const struct pp_sky *sky,
                       double north_rad);

/* Appends the room's assumptions, as pp_page_say does: transmittance, frame and dirt of
 * the openings, and reflectances. */
void pp_page_assumptions(char *text, size_t room, const struct pp_world *world,
                         const struct pp_outside_light *light);

/* Style for the size of the canvas. */
struct pp_style pp_page_style(const struct pp_canvas *canvas);

#endif
