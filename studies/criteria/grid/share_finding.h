/* share_finding.h - the finding on a level to be reached on a part of the plane. */
#ifndef PP_STUDIES_CRITERIA_GRID_SHARE_FINDING_H
#define PP_STUDIES_CRITERIA_GRID_SHARE_FINDING_H

#include "model/results/report.h"
#include "studies/criteria/finding.h"
#include "studies/criteria/grid/plane_grid.h"

struct pp_share_target {
    enum pp_figure kind;
    double wanted; /* level; NAN: the figure is only stated */
    double part;   /* fraction of the plane on which the level is to be reached */
};

/* Compares the level that the part of the plane reaches with the target. The column has
 * a value at each of `count` points (1 or more), which are the receivers. grid: the
 * grid of these points; NULL: no grid, and no error due to a grid. Bands of the column,
 * if any, can make the verdict undecided. */
enum pp_status pp_share_finding(struct pp_finding *finding,
                                const struct pp_share_target *target,
                                const struct pp_column *column,
                                const struct pp_receiver *receivers, int count,
                                const struct pp_plane_grid *grid, const char *what,
                                struct pp_error *err);

#endif
