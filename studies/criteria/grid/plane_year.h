/* plane_year.h - a simulated year for criteria, at points of the working plane. */
#ifndef PP_STUDIES_CRITERIA_GRID_PLANE_YEAR_H
#define PP_STUDIES_CRITERIA_GRID_PLANE_YEAR_H

#include "studies/criteria/grid/plane_grid.h"
#include "studies/study_options.h"
#include "studies/study_room.h"
#include "studies/year/annual.h"

/* Options of the year of LM-83, with seed, threads, strictness and watch of the
 * study. */
struct pp_annual_options pp_plane_year_options(const struct pp_study_options *study);

/* Makes the points: by `choice`, if it gives a spacing or the largest cells; otherwise
 * 0.5 m apart, and 0.5 m from the walls or, for LM-83, up to the walls. Without a
 * choice, grids for EN 17037 have at most 400 cells, so that the spacing is wider in
 * large rooms. The spacing for LM-83 is never wider, since LM-83 permits at most 0.6 m.
 * The caller clears *grid. */
enum pp_status pp_plane_year_grid(struct pp_plane_grid *grid,
                                  const struct pp_world *world,
                                  const struct pp_grid_choice *choice, bool of_lm83,
                                  struct pp_error *err);

#endif
