/* elevation_cover.h - areas that are certainly hidden by the obstructions drawn so far,
 * in which nothing more has to be drawn. For elevation.c only.
 *
 * The visible part of the opening is divided into vertical columns. For each column,
 * the cover stores the height up to which the column is hidden without a gap, and the
 * distance of the farthest obstruction that contributes. Since nearly all obstructions
 * stand on the ground, these heights are usually their skyline.
 */
#ifndef PP_METHODS_VIEW_ELEVATION_COVER_H
#define PP_METHODS_VIEW_ELEVATION_COVER_H

#include "methods/view/elevation.h"

enum { PP_ELEVATION_COLUMNS = 1024 };

struct pp_elevation_cover {
    double left, width; /* left edge and width of the first column */
    bool alike;         /* true: all columns are like the first one, and only the first
                         * is set */
    double high[PP_ELEVATION_COLUMNS];
    double distance_m[PP_ELEVATION_COLUMNS];
};

/* Initialises the cover: nothing of `seen`, which must not be empty, is hidden yet. */
void pp_elevation_cover_init(struct pp_elevation_cover *cover,
                             const struct pp_elevation_part *seen);

/* Adds an obstruction. distance_m: distance of its nearest corner. */
void pp_elevation_cover_add(struct pp_elevation_cover *cover,
                            const struct pp_elevation_part *outline, double distance_m);

/* True if the whole area between two jambs and up to `high` is hidden for objects at
 * that distance. Conservative: never true if any part of the area is visible. */
bool pp_elevation_cover_hides(const struct pp_elevation_cover *cover, double left,
                              double right, double high, double distance_m);

#endif
