/* note_drawings.h - the drawings in the margin of a worked note: plan and section of
 * the room with the point, and the wall of an opening beside the lines about it. */
#ifndef PP_CHARTS_NOTE_NOTE_DRAWINGS_H
#define PP_CHARTS_NOTE_NOTE_DRAWINGS_H

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"
#include "model/results/report.h"

/* Draws the plan, and the section below the plan, from the top of the box, to scale.
 * *height is set to the total height. PP_BAD_INPUT if no section contains the point. */
enum pp_status pp_note_drawings_room(double *height, cairo_t *cr,
                                     const struct pp_style *style,
                                     const struct pp_report *report, struct pp_box box,
                                     struct pp_error *err);

/* Draws the wall with the opening tinted, seen from inside, at the largest usual scale
 * that fits the box. If `drawn` is false, only measures. Returns the height. */
double pp_note_drawings_opening(cairo_t *cr, const struct pp_style *style,
                                const struct pp_report *report, int opening,
                                struct pp_box box, bool drawn);

#endif
