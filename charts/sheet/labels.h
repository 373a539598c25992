/* labels.h - placement of labels next to the objects that they name.
 *
 * Drawn objects are registered as places that labels must not cover. For each place
 * that a label may name, positions on all sides and at increasing distances are tried.
 * The label is put at the nearest position where it covers nothing, or left out.
 */
#ifndef PP_CHARTS_SHEET_LABELS_H
#define PP_CHARTS_SHEET_LABELS_H

#include <stdbool.h>

#include "charts/sheet/lettering.h"

enum { PP_LABEL_PLACES_MOST = 12000 };

struct pp_label_place {
    double x, y;
    int owner; /* index of a curve; -1: no owner */
};

struct pp_labels {
    struct pp_box field; /* area that labels must not leave */
    int count;
    struct pp_label_place places[PP_LABEL_PLACES_MOST];
};

/* Registers a straight line, as places at most 1 mm apart. Places beyond
 * PP_LABEL_PLACES_MOST are ignored. */
void pp_labels_note(struct pp_labels *labels, int owner, double x0, double y0,
                    double x1, double y1);

/* Registers cairo's current path, flattened, as places about a millimetre apart. */
void pp_labels_note_path(struct pp_labels *labels, cairo_t *cr, int owner);

/* Registers the whole area of a box. */
void pp_labels_note_box(struct pp_labels *labels, struct pp_box box);

/* True if a place of that owner is registered within `distance` of x, y. */
bool pp_labels_is_near(const struct pp_labels *labels, int owner, double x, double y,
                       double distance);

/* True if a box is within the field and free of all registered places. */
bool pp_labels_is_free(const struct pp_labels *labels, struct pp_box box);

/* Owner of marks of points: unlike lines they are never covered. */
enum { PP_LABEL_MARKS = 1000000 };

/* The same, but lines, which have owners from 0 to below PP_LABEL_MARKS, may be
 * covered. */
bool pp_labels_covers_lines_only(const struct pp_labels *labels, struct pp_box box);

/* Finds a place for a box next to one of the owner's places, farther from places of
 * other owners than from the owner's. *anchor: the end of a leader. False: there is no
 * place. */
bool pp_labels_find(const struct pp_labels *labels, const struct pp_style *style,
                    double width, double height, int owner, struct pp_box *box,
                    double anchor[2]);

/* Draws a leader from the box to the anchor, unless they are adjacent. */
void pp_labels_lead(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                    const double anchor[2]);

#endif
