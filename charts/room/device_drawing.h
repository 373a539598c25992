/* device_drawing.h - blinds, screens and curtains in plans, sections and elevations.
 *
 * Blind: slats that are cut are short strokes with their tilt, others are a dashed line;
 * strokes are not as close as the slats. Screen: a dotted line. Curtain: a wavy line.
 */
#ifndef PP_CHARTS_ROOM_DEVICE_DRAWING_H
#define PP_CHARTS_ROOM_DEVICE_DRAWING_H

#include <cairo.h>

#include "charts/sheet/style.h"
#include "model/room/world.h"

/* Draws the device of the opening beside its glass, which is cut from `from` to `to` on
 * paper (mm), along the axis that its slats follow each other on; inwards: unit vector
 * on paper into the room. slats_are_cut: they are seen end-on. */
void pp_device_drawing_cut(cairo_t *cr, const struct pp_style *style,
                           const struct pp_opening *opening, const double from[2],
                           const double to[2], const double inwards[2],
                           bool slats_are_cut);

/* Fills the current path, the outline of an opening in elevation, with lines for its
 * device; keeps the path. */
void pp_device_drawing_front(cairo_t *cr, const struct pp_style *style,
                             const struct pp_opening *opening);

#endif
