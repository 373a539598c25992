/* plane_figures.h - figures of a working plane as a whole: minimum, median, average,
 * uniformity, and the shares of its area above 1, 2 and 5 %.
 *
 * They are computed from points that represent equal parts of the plane: the requested
 * points if they are a grid (model/results/lattice.h), else those of EN 17037's grid,
 * which leaves out 0.5 m along the walls and by which the criteria judge. Both are
 * evaluated together; the grid's points are then removed from the report.
 */
#ifndef PP_STUDIES_PLANE_FIGURES_H
#define PP_STUDIES_PLANE_FIGURES_H

#include "model/results/report.h"
#include "studies/study_room.h"

/* Receivers for a report: the room's own, followed, if these are not a grid, by those
 * of EN 17037. The caller frees *all. */
enum pp_status pp_plane_figures_receivers(struct pp_receiver **all, int *count,
                                          const struct pp_study_room *room,
                                          struct pp_error *err);

/* Fills `plane` of the report's daylight factor columns, whose receivers begin with the
 * room's own; afterwards the report has only these. A column without a value at some
 * point of the grid has no figures. */
enum pp_status pp_plane_figures_fill(struct pp_report *report,
                                     const struct pp_study_room *room,
                                     struct pp_error *err);

/* Fills `plane` of one column from its readings at the points of a grid; has_plane
 * becomes false if a reading has no value. */
enum pp_status pp_plane_figures_sum_up(struct pp_column *column,
                                       const struct pp_reading *points, int count,
                                       struct pp_error *err);

#endif
