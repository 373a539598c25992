/* device_drawing.h - blinds, screens and curtains in plans, sections and elevations.
 *
 * A blind whose slats are cut is a row of short strokes at the tilt of the slats; other
 * blinds are a dashed line. The strokes are farther apart than the slats. A screen is a
 * dotted line, a curtain a wavy line.
 */
#ifndef PP_CHARTS_ROOM_DEVICE_DRAWING_H
#define PP_CHARTS_ROOM_DEVICE_DRAWING_H

#include <cairo.h>

#include "charts/sheet/style.h"
#include "model/room/world.h"

/* Draws the device of the opening beside the glass. The cut through the glass runs from
 * `from` to `to` on paper (mm), along the axis on which the slats follow each other.
 * inwards: unit vector on paper into the room. slats_are_cut: slats are seen end-on. */
void pp_device_drawing_cut(cairo_t *cr, const struct pp_style *style,
                           const struct pp_opening *opening, const double from[2],
                           const double to[2], const double inwards[2],
                           bool slats_are_cut);

/* Fills the current path (the outline of an opening in elevation) with the lines of its
 * device, and keeps the path. */
void pp_device_drawing_front(cairo_t *cr, const struct pp_style *style,
                             const struct pp_opening *opening);

#endif
