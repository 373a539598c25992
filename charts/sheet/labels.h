/* labels.h - placement of labels next to the objects that they name.
 *
 * Drawn objects are registered as places that labels must not cover. A label is put
 * near one of the places registered for its owner: positions on all sides of these
 * places are tried, at increasing distances. The label gets the nearest position where
 * it does not cover anything, or is omitted.
 */
#ifndef PP_CHARTS_SHEET_LABELS_H
#define PP_CHARTS_SHEET_LABELS_H

#include <stdbool.h>

#include "charts/sheet/lettering.h"

enum { PP_LABEL_PLACES_MOST = 12000 };

struct pp_label_place {
    double x, y;
    int owner; /* index of the curve to which the place belongs; -1: none */
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

/* Registers the current path of cairo, flattened, as places about 1 mm apart. */
void pp_labels_note_path(struct pp_labels *labels, cairo_t *cr, int owner);

/* Registers the whole area of a box. */
void pp_labels_note_box(struct pp_labels *labels, struct pp_box box);

/* True if a place of that owner is registered within `distance` of x, y. */
bool pp_labels_is_near(const struct pp_labels *labels, int owner, double x, double y,
                       double distance);

/* True if a box is within the field and free of all registered places. */
bool pp_labels_is_free(const struct pp_labels *labels, struct pp_box box);

/* Owner of the marks of points. Unlike lines, marks are never covered. */
enum { PP_LABEL_MARKS = 1000000 };

/* True if a box is within the field and covers nothing except lines. Lines have owners
 * from 0 to PP_LABEL_MARKS - 1. */
bool pp_labels_covers_lines_only(const struct pp_labels *labels, struct pp_box box);

/* Finds a position for a box next to one of the owner's places, where places of other
 * owners are farther away. *anchor is set to the end of a leader. Returns false if
 * there is no such position. */
bool pp_labels_find(const struct pp_labels *labels, const struct pp_style *style,
                    double width, double height, int owner, struct pp_box *box,
                    double anchor[2]);

/* Draws a leader from the box to the anchor, unless the box is next to the anchor. */
void pp_labels_lead(cairo_t *cr, const struct pp_style *style, struct pp_box box,
                    const double anchor[2]);

#endif
