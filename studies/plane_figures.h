/* plane_figures.h - figures of a whole working plane: minimum, median, average,
 * uniformity, and the fractions of its area above 1, 2 and 5 %.
 *
 * The figures are computed from a grid of points, each of which counts by the area that
 * it represents: from the requested points if they form a grid
 * (model/results/lattice.h), otherwise from the grid points of EN 17037.
 * That grid omits 0.5 m along the walls; the criteria also use it. Grid points are
 * evaluated together with the requested points, and then removed from the report.
 */
#ifndef PP_STUDIES_PLANE_FIGURES_H
#define PP_STUDIES_PLANE_FIGURES_H

#include "model/results/report.h"
#include "studies/study_room.h"

/* Makes the receivers of a report: the room's own points, followed by the grid points
 * of EN 17037 if the room's points are not a grid. The caller frees *all. */
enum pp_status pp_plane_figures_receivers(struct pp_receiver **all, int *count,
                                          const struct pp_study_room *room,
                                          struct pp_error *err);

/* Sets `plane` in the daylight factor columns of the report. The receivers must begin
 * with the room's own points; afterwards the report has only these. A column that lacks
 * a value at any grid point has no plane figures. */
enum pp_status pp_plane_figures_fill(struct pp_report *report,
                                     const struct pp_study_room *room,
                                     struct pp_error *err);

/* Sets `plane` of one column from the readings at grid points, the receivers; each
 * counts by its area, if they have areas. has_plane is set to false if any reading has
 * no value. */
enum pp_status pp_plane_figures_sum_up(struct pp_column *column,
                                       const struct pp_reading *points,
                                       const struct pp_receiver *receivers, int count,
                                       struct pp_error *err);

#endif
