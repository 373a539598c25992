/* moment_plan_study.c - see moment_plan_study.h. */
#include "studies/year/moment_plan_study.h"

#include <math.h>
#include <stdlib.h>

#include "methods/exact/sky_view.h"
#include "model/base/thread_pool.h"
#include "model/room/position.h"
#include "model/room/surface_materials.h"
#include "studies/criteria/grid/plane_grid.h"

enum { SUB = PP_MOMENT_PLAN_SUB };

static const double CELL_M = 0.25;
static const double CELLS_MOST = 600.0;

/* Ratio of the error of a cell to the error of a point. Cells may have larger errors,
 * since their values are smoothed by interpolation. */
static const double ERROR_OF_CELLS = 4.0;

/* ---- cells ---- */

static enum pp_status make_moment_cells(struct pp_moment_plan *plan,
                                        const struct pp_world *world,
                                        struct pp_error *err)
{
    struct pp_plane_grid grid;
    const struct pp_bounds2 bounds = pp_region_bounds(&world->plane);
    double area = (bounds.high[0] - bounds.low[0]) * (bounds.high[1] - bounds.low[1]);
    const struct pp_grid_choice choice = {.spacing_m =
                                              fmax(CELL_M, sqrt(area / CELLS_MOST))};
    enum pp_status status = pp_plane_grid_make(&grid, world, NULL, &choice, 0, err);
    if (status == PP_OK && grid.count == 0)
        status = pp_fail(err, PP_BAD_INPUT,
                         "%s has no working plane to draw; expected a plan or a "
                         "working plane",
                         world->name ? world->name : "the room");
    size_t cells = (size_t)grid.columns * (size_t)grid.rows;
    if (status == PP_OK) {
        plan->columns = grid.columns;
        plan->rows = grid.rows;
        plan->cell_at = malloc(cells * sizeof *plan->cell_at);
        plan->diffuse = malloc(cells * SUB * SUB * sizeof *plan->diffuse);
        plan->sun = calloc(cells * SUB * SUB, sizeof *plan->sun);
        if (!plan->cell_at || !plan->diffuse || !plan->sun)
            status = pp_fail_memory(err);
    }
    if (status == PP_OK) {
        for (int k = 0; k < 2; k++) {
            plan->low[k] = bounds.low[k];
            plan->cell_m[k] = grid.cell_m[k];
        }
        for (size_t i = 0; i < cells; i++)
            plan->cell_at[i] = -1;
        for (int i = 0; i < grid.count; i++)
            plan->cell_at[grid.cells[i][1] * grid.columns + grid.cells[i][0]] = i;
        plan->centres = grid.receivers;
        plan->cells.receiver_count = grid.count;
        grid.receivers = NULL;
    }
    pp_plane_grid_clear(&grid);
    return status;
}

/* ---- parts of cells ---- */

/* Illuminance at a cell without direct sun; NAN: there is no such cell. */
static double diffuse_of(const struct pp_moment_plan *plan, int column, int row)
{
    if (column < 0 || column >= plan->columns || row < 0 || row >= plan->rows)
        return NAN;
    int at = plan->cell_at[row * plan->columns + column];
    return at < 0 ? NAN
                  : plan->cells.points[at].year_lxh.value
                        - plan->cells.points[at].sun_lxh.value;
}

/* Interpolates bilinearly among the four nearest cells, as far as they exist. */
static double interpolate(const struct pp_moment_plan *plan, int part_column,
                          int part_row)
{
    double x = (part_column + 0.5) / SUB - 0.5, y = (part_row + 0.5) / SUB - 0.5;
    int column = (int)floor(x), row = (int)floor(y);
    double sum = 0.0, weights = 0.0;
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 2; i++) {
            double value = diffuse_of(plan, column + i, row + j);
            double weight = fabs(1 - i - (x - column)) * fabs(1 - j - (y - row));
            if (isnan(value))
                continue;
            sum += weight * value;
            weights += weight;
        }
    return weights > 0.0 ? sum / weights : NAN;
}

struct parts_work {
    struct pp_moment_plan *plan;
    const struct pp_world *world;
    struct pp_perez_sky sky; /* in the room's axes */
    enum pp_status *status;  /* indexed by row of cells */
    const struct pp_watch *watch;
};

/* True if a straight line in the plane crosses neither the plane's border nor a
 * fitting. */
static bool is_clear(const struct parts_work *work, const double from[2],
                     const double to[2])
{
    const double *cell = work->plan->cell_m;
    double length = hypot(to[0] - from[0], to[1] - from[1]);
    int steps = (int)ceil(length / (fmin(cell[0], cell[1]) / SUB));
    for (int i = 1; i < steps; i++) {
        double x = from[0] + (to[0] - from[0]) * i / steps;
        double y = from[1] + (to[1] - from[1]) * i / steps;
        if (!pp_region_contains(&work->world->plane, x, y)
            || pp_position_in_fitting(work->world,
                                      pp_vec(x, y, work->world->working_plane_m)))
            return false;
    }
    return true;
}

/* Value of the nearest cell that is visible from a part without neighbours, as in an
 * acute corner; NAN: no cell is visible. */
static double nearest(const struct parts_work *work, const double at[2])
{
    const struct pp_moment_plan *plan = work->plan;
    double value = NAN, least = INFINITY;
    for (int row = 0; row < plan->rows; row++)
        for (int column = 0; column < plan->columns; column++) {
            const double centre[2] = {plan->low[0] + (column + 0.5) * plan->cell_m[0],
                                      plan->low[1] + (row + 0.5) * plan->cell_m[1]};
            double own = diffuse_of(plan, column, row);
            double distance = hypot(centre[0] - at[0], centre[1] - at[1]);
            if (isnan(own) || distance >= least || !is_clear(work, at, centre))
                continue;
            least = distance;
            value = own;
        }
    return value;
}

static enum pp_status light_part(struct parts_work *work, int column, int row)
{
    struct pp_moment_plan *plan = work->plan;
    size_t part = (size_t)row * (size_t)(plan->columns * SUB) + (size_t)column;
    const struct pp_receiver receiver = {
        .position = pp_vec(plan->low[0] + (column + 0.5) / SUB * plan->cell_m[0],
                           plan->low[1] + (row + 0.5) / SUB * plan->cell_m[1],
                           work->world->working_plane_m),
        .normal = pp_vec(0.0, 0.0, 1.0)};
    plan->diffuse[part] = NAN;
    if (!pp_region_contains(&work->world->plane, receiver.position.x,
                            receiver.position.y)
        || pp_position_in_fitting(work->world, receiver.position))
        return PP_OK;
    double diffuse = interpolate(plan, column, row);
    if (isnan(diffuse))
        diffuse =
            nearest(work, (const double[2]){receiver.position.x, receiver.position.y});
    plan->diffuse[part] = (float)diffuse;
    if (!(work->sky.direct_lx > 0.0) || !(work->sky.sun.z > 0.0))
        return PP_OK;
    struct pp_sky_view view;
    enum pp_status status =
        pp_sky_view_init_for_sun(&view, work->world, &receiver, NULL);
    if (status != PP_OK)
        return status;
    plan->sun[part] = (float)(pp_sky_view_sun(&view, work->sky.sun, NULL)
                              * pp_surface_materials_past_outer_panes(
                                  work->world, receiver.position, work->sky.sun)
                              * work->sky.direct_lx);
    pp_sky_view_clear(&view);
    return PP_OK;
}

/* Worker 0 is the calling thread, which reports progress and checks for
 * interruption. */
static bool light_row(void *data, int worker, int row)
{
    struct parts_work *work = data;
    const struct pp_watch *watch = work->watch;
    enum pp_status *status = &work->status[row];
    if (worker == 0 && watch->look
        && !watch->look(watch->data, (double)row / work->plan->rows, NAN))
        *status = PP_INTERRUPTED;
    for (int r = row * SUB; r < (row + 1) * SUB && *status == PP_OK; r++)
        for (int c = 0; c < work->plan->columns * SUB && *status == PP_OK; c++)
            *status = light_part(work, c, r);
    return *status == PP_OK;
}

static void sum_parts_up(struct pp_moment_plan *plan)
{
    int parts = plan->columns * SUB * plan->rows * SUB, in_plane = 0, sunlit = 0;
    double sun_sum = 0.0;
    plan->lowest_lx = INFINITY;
    for (int i = 0; i < parts; i++) {
        double lx = plan->diffuse[i] + plan->sun[i];
        if (isnan(lx))
            continue;
        in_plane++;
        sunlit += plan->sun[i] > 0.0f;
        sun_sum += plan->sun[i];
        plan->lowest_lx = fmin(plan->lowest_lx, lx);
        plan->highest_lx = fmax(plan->highest_lx, lx);
    }
    plan->sun_share = in_plane > 0 ? (double)sunlit / in_plane : NAN;
    plan->sun_lx = in_plane > 0 ? sun_sum / in_plane : NAN;
}

static enum pp_status light_parts(struct pp_moment_plan *plan,
                                  const struct pp_world *world,
                                  const struct pp_moment *moment,
                                  const struct pp_annual_options *options,
                                  struct pp_error *err)
{
    struct pp_thread_pool *pool;
    const struct pp_watch *watch = &options->watch;
    struct parts_work work = {
        .plan = plan,
        .world = world,
        .sky = pp_weather_year_turned(&moment->sky, world->north_rad),
        .status = calloc((size_t)plan->rows, sizeof *work.status),
        .watch = watch};
    if (!work.status)
        return pp_fail_memory(err);
    enum pp_status status = pp_thread_pool_create(&pool, options->threads, err);
    if (status == PP_OK) {
        bool shown = pp_watch_begin(watch, world->name);
        pp_thread_pool_run(pool, 0, plan->rows, light_row, &work);
        pp_watch_end(watch, shown);
        for (int r = 0; r < plan->rows && status == PP_OK; r++)
            if (work.status[r] == PP_INTERRUPTED)
                status = pp_fail(err, PP_INTERRUPTED, "interrupted");
            else if (work.status[r] != PP_OK)
                status = pp_fail_memory(err);
        pp_thread_pool_destroy(pool);
    }
    free(work.status);
    if (status == PP_OK)
        sum_parts_up(plan);
    return status;
}

/* ---- the plan ---- */

enum pp_status pp_moment_plan_study_make(struct pp_moment_plan *plan,
                                         const struct pp_study_room *room,
                                         const struct pp_moment *moment,
                                         const struct pp_annual_options *options,
                                         struct pp_error *err)
{
    struct pp_annual_options of_cells = *options;
    of_cells.error *= ERROR_OF_CELLS;
    *plan = (struct pp_moment_plan){.when = NULL};
    enum pp_status status = make_moment_cells(plan, room->world, err);
    if (status == PP_OK)
        status =
            pp_moment_of_room(&plan->points, room->world, &room->light, room->receivers,
                              room->receiver_count, moment, options, err);
    if (status == PP_OK && plan->points.finished)
        status =
            pp_moment_of_room(&plan->cells, room->world, &room->light, plan->centres,
                              plan->cells.receiver_count, moment, &of_cells, err);
    if (status == PP_OK && !plan->cells.finished)
        return pp_fail(err, PP_INTERRUPTED, "interrupted");
    if (status == PP_OK)
        status = light_parts(plan, room->world, moment, options, err);
    return status;
}

void pp_moment_plan_study_clear(struct pp_moment_plan *plan)
{
    pp_annual_sheet_clear(&plan->points);
    pp_annual_sheet_clear(&plan->cells);
    free(plan->centres);
    free(plan->cell_at);
    free(plan->diffuse);
    free(plan->sun);
    *plan = (struct pp_moment_plan){.when = NULL};
}
