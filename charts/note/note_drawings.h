/* note_drawings.h - the drawings in the margin of a worked note: plan and section of
 * the room with the point, and the wall of an opening beside the lines about that
 * opening. */
#ifndef PP_CHARTS_NOTE_NOTE_DRAWINGS_H
#define PP_CHARTS_NOTE_NOTE_DRAWINGS_H

#include "charts/sheet/style.h"
#include "charts/sheet/lettering.h"
#include "model/results/report.h"

/* Draws the plan and below it the section, from the top of the box, to scale. *height:
 * height of both together. PP_BAD_INPUT if the point is on no section. */
enum pp_status pp_note_drawings_room(double *height, cairo_t *cr,
                                     const struct pp_style *style,
                                     const struct pp_report *report, struct pp_box box,
                                     struct pp_error *err);

/* Draws the wall with the opening, tinted, seen from inside, as wide as the box;
 * returns its height; only measures unless `drawn`. */
double pp_note_drawings_opening(cairo_t *cr, const struct pp_style *style,
                                const struct pp_report *report, int opening,
                                struct pp_box box, bool drawn);

#endif
