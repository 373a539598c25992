/* labels.h - placement of words next to the things that they name.
 *
 * Existing drawings are noted as places not to cover. A label is tried on all sides of
 * each place that it may name, at growing distances. It is put at the nearest place
 * where it covers nothing, or else not drawn.
 */
#ifndef PP_CHARTS_SHEET_LABELS_H
#define PP_CHARTS_SHEET_LABELS_H

#include <stdbool.h>

#include "charts/sheet/lettering.h"

enum { PP_LABEL_PLACES_MOST = 6000 };

struct pp_label_place {
    double x, y;
    int owner; /* index of a curve; -1: no owner */
};

struct pp_labels {
    struct pp_box field; /* labels stay within it */
    int count;
    struct pp_label_place places[PP_LABEL_PLACES_MOST];
};

/* Notes a straight line, as places at most a millimetre apart. Lines beyond
 * PP_LABEL_PLACES_MOST are ignored. */
void pp_labels_note(struct pp_labels *labels, int owner, double x0, double y0,
                    double x1, double y1);

/* Notes cairo's current path, flattened. */
void pp_labels_note_path(struct pp_labels *labels, cairo_t *cr, int owner);

/* Notes the whole area of a box. */
void pp_labels_note_box(struct pp_labels *labels, struct pp_box box);

/* True if a place of that owner is noted within that distance of x, y. */
bool pp_labels_is_near(const struct pp_labels *labels, int owner, double x, double y,
                       double distance);

/* True if a box is within the field and clear of all noted places. */
bool pp_labels_is_free(const struct pp_labels *labels, struct pp_box box);

/* Searches a place for a box of that size next to one of the owner's places, farther
 * from others' places than from its own; *anchor: target of a leader. False: there is
 * none. */
bool pp_labels_find(const struct pp_labels *labels, const struct pp_style *style,
                    double width, double height, int owner, struct pp_box *box,
                    double anchor[2]);

/* Draws a leader from the box to the anchor, unless they are next to each other. */
void pp_labels_lead(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                    const double anchor[2]);

#endif
