/* plane_figures.c - appends a grid to the requested points, and computes statistics of
 * its values. */
#include "studies/plane_figures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/results/lattice.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/criteria/grid/plane_share.h"

static enum pp_status is_grid(bool *grid, const struct pp_study_room *room,
                              struct pp_error *err)
{
    struct pp_lattice lattice;
    enum pp_status status =
        pp_lattice_find(&lattice, room->receivers, room->receiver_count, err);
    *grid =
        lattice.columns > 0
        && fabs(room->receivers[0].position.z - room->world->working_plane_m) < 1e-6;
    pp_lattice_clear(&lattice);
    return status;
}

enum pp_status pp_plane_figures_receivers(struct pp_receiver **all, int *count,
                                          const struct pp_study_room *room,
                                          struct pp_error *err)
{
    struct pp_receiver *grid = NULL;
    int own = room->receiver_count, more = 0;
    bool have = false;
    *all = NULL;
    enum pp_status status = is_grid(&have, room, err);
    if (status == PP_OK && !have)
        status = pp_plane_grid_largest(&grid, &more, room->world, err);
    if (status != PP_OK)
        return status;
    *all = malloc(((size_t)own + (size_t)more + 1) * sizeof **all);
    if (*all) {
        memcpy(*all, room->receivers, (size_t)own * sizeof **all);
        if (more)
            memcpy(*all + own, grid, (size_t)more * sizeof **all);
        *count = own + more;
    }
    free(grid);
    return *all ? PP_OK : pp_fail_memory(err);
}

/* Finds the daylight factor that is reached on a fraction `part` of the plane. */
static enum pp_status reached_by(struct pp_reading *reading,
                                 const struct pp_reading *points,
                                 const struct pp_receiver *receivers, int count,
                                 double common, double part, struct pp_error *err)
{
    struct pp_plane_share share;
    enum pp_status status =
        pp_plane_share(&share, points, receivers, count, common, part, 0.0, err);
    if (status == PP_OK) {
        *reading = pp_reading_of(share.level);
        reading->std_error = share.std_error;
    }
    return status;
}

enum pp_status pp_plane_figures_sum_up(struct pp_column *column,
                                       const struct pp_reading *points,
                                       const struct pp_receiver *receivers, int count,
                                       struct pp_error *err)
{
    struct pp_plane_reading *plane = &column->plane;
    column->has_plane = false;
    for (int i = 0; i < count; i++)
        if (!isfinite(points[i].value))
            return PP_OK;
    plane->average = pp_plane_share_mean(points, receivers, count, column->common);
    enum pp_status status =
        reached_by(&plane->minimum, points, receivers, count, column->common, 1.0, err);
    if (status == PP_OK)
        status = reached_by(&plane->median, points, receivers, count, column->common,
                            0.5, err);
    for (int i = 0; i < PP_PLANE_LEVELS && status == PP_OK; i++) {
        struct pp_plane_share share;
        status = pp_plane_share(&share, points, receivers, count, column->common, 1.0,
                                pp_plane_levels[i], err);
        plane->over[i] = share.over;
    }
    plane->uniformity =
        plane->average.value > 0.0 ? plane->minimum.value / plane->average.value : NAN;
    column->has_plane = status == PP_OK;
    return status;
}

enum pp_status pp_plane_figures_fill(struct pp_report *report,
                                     const struct pp_study_room *room,
                                     struct pp_error *err)
{
    int own = room->receiver_count, more = report->receiver_count - own;
    int first = more > 0 ? own : 0;
    enum pp_status status = PP_OK;
    bool grid = false;
    if (more == 0)
        status = is_grid(&grid, room, err);
    report->grid_of_standard = more > 0;
    report->grid_points = more > 0 ? more : grid ? own : 0;
    for (int i = 0; i < report->column_count && status == PP_OK; i++) {
        struct pp_column *column = &report->columns[i];
        if (column->component == PP_DF && column->points && report->grid_points > 0)
            status = pp_plane_figures_sum_up(column, column->points + first,
                                             report->receivers + first,
                                             report->grid_points, err);
    }
    report->receivers = room->receivers;
    report->receiver_count = own;
    return status;
}
