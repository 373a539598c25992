/* share_finding.c - see share_finding.h. */
#include "studies/criteria/grid/share_finding.h"

#include <math.h>

#include "studies/criteria/factors.h"

enum pp_status pp_share_finding(struct pp_finding *finding,
                                const struct pp_share_target *target,
                                const struct pp_column *column,
                                const struct pp_receiver *receivers, int count,
                                const struct pp_plane_grid *grid, const char *what,
                                struct pp_error *err)
{
    struct pp_plane_share share;
    struct pp_grid_error error = {NAN, NAN};
    struct pp_band_ends band;
    enum pp_status status =
        pp_plane_share(&share, column->points, receivers, count, column->common,
                       target->part, target->wanted, err);
    if (status == PP_OK && grid && grid->count > 0)
        status = pp_grid_error(&error, grid, column->points, target->part,
                               target->wanted, err);
    if (status == PP_OK)
        status = pp_factors_band(&band, column, receivers, count, target->part, err);
    if (status != PP_OK)
        return status;
    *finding =
        pp_finding_of(target->kind, share.level, target->wanted, false, "%s", what);
    finding->reached_over = share.over;
    pp_factors_judge_share(finding, &share, &error, 1.0);
    pp_finding_by_hand(finding, band);
    return PP_OK;
}
