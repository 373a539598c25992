/* plot_envelope.c - see plot_envelope.h. */
#include "studies/sizing/plot_envelope.h"

#include <math.h>
#include <stdlib.h>

#include "studies/sizing/root_bracket.h"

static const double lowest_m = 0.002; /* height of the lowest cell tried, which hides
                                       * almost nothing */
static const double share_tolerance = 1e-6;
static const double angle_tolerance_rad = 1e-8, factor_tolerance = 1e-8;
static const double steepest_rad = 89.0 * PP_RAD;
enum { DOUBLINGS_MOST = 20 };

struct envelope_search {
    struct pp_plot_envelope *found;
    const struct pp_plot_envelope_task *task;
    double *tangents; /* tan(a_i) for each window; INFINITY: the window sets no limit */
    double *planes;   /* tangents of the planes in the present trial, for each window;
                       * INFINITY: no plane */
    int number;       /* index of the window whose a_i is searched */
};

/* Height z of a window's plane above the nearest corner of a cell; INFINITY if the cell
 * is behind the window's wall, or if there is no plane. */
static double plane_over(const struct pp_retained_sky_place *due, double tangent,
                         const struct pp_building_cell *cell)
{
    double nearest = INFINITY, farthest = -INFINITY;
    for (int k = 0; k < 4; k++) {
        struct pp_vec3 to = pp_vec_sub(pp_plot_cells_corner(cell, k), due->middle);
        double before = to.x * due->outward.x + to.y * due->outward.y;
        nearest = fmin(nearest, before);
        farthest = fmax(farthest, before);
    }
    if (!(farthest > 0.0) || isinf(tangent))
        return INFINITY;
    return due->middle.z + tangent * fmax(nearest, 0.0);
}

/* Makes the proposed building. All cells are as high as the planes of the trial
 * allow. */
static enum pp_status build_cells(const struct envelope_search *search,
                                  struct pp_error *err)
{
    struct pp_plot_envelope *found = search->found;
    const struct pp_plot_envelope_task *task = search->task;
    for (int c = 0; c < found->cells.count; c++) {
        struct pp_building_cell *cell = &found->cells.list[c];
        cell->height_m = task->most_m;
        for (int i = 0; i < found->retained.count; i++)
            cell->height_m = fmin(cell->height_m, plane_over(&found->retained.list[i],
                                                             search->planes[i], cell)
                                                      - cell->corner.z);
        cell->height_m = fmax(cell->height_m, lowest_m);
    }
    enum pp_status status = pp_building_divide_block(
        task->building, task->block, found->cells.list, found->cells.count, err);
    return status == PP_OK
               ? pp_building_set_state(task->building, PP_STATE_PROPOSED, err)
               : status;
}

static void set_planes(const struct envelope_search *search, double tangent)
{
    for (int i = 0; i < search->found->retained.count; i++)
        search->planes[i] = tangent;
}

/* Surplus of one window if only its own plane limits the cells. altitude_rad: altitude
 * of that plane. */
static enum pp_status alone_at(void *context, double altitude_rad, double *value,
                               struct pp_error *err)
{
    struct envelope_search *search = context;
    const struct pp_plot_envelope_task *task = search->task;
    struct pp_retained_sky *retained = &search->found->retained;
    set_planes(search, INFINITY);
    search->planes[search->number] =
        altitude_rad < steepest_rad ? tan(altitude_rad) : INFINITY;
    enum pp_status status = build_cells(search, err);
    if (status == PP_OK)
        status = pp_retained_sky_after_one(retained, search->number, &task->rule,
                                           task->building, err);
    *value = pp_retained_sky_surplus_of(&retained->list[search->number], &task->rule);
    return status;
}

/* Least surplus of all windows with the planes of the trial. */
static enum pp_status surplus(const struct envelope_search *search, double *value,
                              struct pp_error *err)
{
    struct pp_plot_envelope *found = search->found;
    const struct pp_plot_envelope_task *task = search->task;
    enum pp_status status = build_cells(search, err);
    if (status == PP_OK)
        status =
            pp_retained_sky_after(&found->retained, &task->rule, task->building, err);
    *value = pp_retained_sky_surplus(&found->retained, &task->rule, &found->deciding);
    return status;
}

static enum pp_status together_at(void *context, double factor, double *value,
                                  struct pp_error *err)
{
    struct envelope_search *search = context;
    for (int i = 0; i < search->found->retained.count; i++)
        search->planes[i] = factor * search->tangents[i];
    return surplus(search, value, err);
}

/* Finds tan(a_i) for each window. A window that has its required value even with all
 * cells at most_m sets no limit. */
static enum pp_status find_alone(struct envelope_search *search, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < search->found->retained.count && status == PP_OK; i++) {
        struct pp_root_bracket_range range = {.low = 0.0,
                                              .high = steepest_rad,
                                              .near_value = share_tolerance,
                                              .near_argument = angle_tolerance_rad};
        double altitude_rad = steepest_rad;
        search->number = i;
        status = alone_at(search, range.high, &range.at_high, err);
        if (status == PP_OK && range.at_high < 0.0) {
            status = alone_at(search, range.low, &range.at_low, err);
            if (status == PP_OK)
                status =
                    pp_root_bracket_find(&altitude_rad, &range, alone_at, search, err);
        }
        search->tangents[i] =
            altitude_rad < steepest_rad ? tan(altitude_rad) : INFINITY;
    }
    return status;
}

/* Finds the factor s and the corresponding envelope. */
static enum pp_status find_together(struct envelope_search *search,
                                    struct pp_error *err)
{
    struct pp_plot_envelope *found = search->found;
    struct pp_root_bracket_range range = {.low = 1.0,
                                          .high = 1.0,
                                          .near_value = share_tolerance,
                                          .near_argument = factor_tolerance};
    found->factor = 1.0;
    enum pp_status status = together_at(search, 1.0, &range.at_low, err);
    range.at_high = range.at_low;
    for (int i = 0; i < DOUBLINGS_MOST && status == PP_OK
                    && range.at_high > share_tolerance && isfinite(range.at_high);
         i++) {
        range.low = range.high;
        range.at_low = range.at_high;
        range.high *= 2.0;
        found->factor = range.high;
        status = together_at(search, range.high, &range.at_high, err);
    }
    if (status == PP_OK && range.at_high < -share_tolerance)
        status = pp_root_bracket_find(&found->factor, &range, together_at, search, err);
    return status;
}

static enum pp_status look_before(struct envelope_search *search, struct pp_error *err)
{
    const struct pp_plot_envelope_task *task = search->task;
    set_planes(search, 0.0); /* with horizontal planes no cell is higher than the centre
                              * of a window, so no sky is hidden */
    enum pp_status status =
        pp_building_has_states(task->building)
            ? pp_building_set_state(task->building, PP_STATE_EXISTING, err)
            : build_cells(search, err);
    return status == PP_OK ? pp_retained_sky_before(&search->found->retained,
                                                    &task->rule, task->building, err)
                           : status;
}

static enum pp_status search_all(struct envelope_search *search, struct pp_error *err)
{
    struct pp_plot_envelope *found = search->found;
    double value = 0.0;
    enum pp_status status = look_before(search, err);
    set_planes(search, INFINITY);
    if (status == PP_OK)
        status = surplus(search, &value, err);
    if (status == PP_OK && !(value < 0.0)) {
        found->verdict = PP_PLOT_ENVELOPE_ANY;
        return PP_OK;
    }
    set_planes(search, 0.0);
    if (status == PP_OK)
        status = surplus(search, &value, err);
    if (status == PP_OK && value < -share_tolerance) {
        found->verdict = PP_PLOT_ENVELOPE_NONE;
        return PP_OK;
    }
    if (status == PP_OK)
        status = find_alone(search, err);
    return status == PP_OK ? find_together(search, err) : status;
}

/* Stores the results: the cells and planes of the last trial. */
static void settle_plot_envelope(struct pp_plot_envelope *found,
                                 const struct envelope_search *search)
{
    for (int c = 0; c < found->cells.count; c++) {
        struct pp_building_cell *cell = &found->cells.list[c];
        if (cell->height_m <= lowest_m || found->verdict == PP_PLOT_ENVELOPE_NONE)
            cell->height_m = 0.0;
        found->volume_m3 += cell->width_m * cell->depth_m * cell->height_m;
    }
    for (int i = 0; i < found->retained.count; i++)
        found->altitudes_rad[i] = found->verdict == PP_PLOT_ENVELOPE_NONE ? NAN
                                  : isinf(search->planes[i])              ? INFINITY
                                                             : atan(search->planes[i]);
}

enum pp_status pp_plot_envelope_find(struct pp_plot_envelope *found,
                                     const struct pp_plot_envelope_task *task,
                                     struct pp_error *err)
{
    struct envelope_search search = {.found = found, .task = task};
    *found = (struct pp_plot_envelope){.factor = NAN, .deciding = -1};
    enum pp_status status =
        pp_building_set_state(task->building, PP_STATE_PROPOSED, err);
    if (status == PP_OK)
        status =
            pp_retained_sky_list(&found->retained, &task->rule, task->building, err);
    if (status == PP_OK)
        status = pp_plot_cells_lay(&found->cells, task->building, task->block, err);
    if (status != PP_OK)
        return status;
    size_t count = (size_t)found->retained.count;
    found->altitudes_rad = calloc(count, sizeof *found->altitudes_rad);
    search.tangents = calloc(2 * count, sizeof *search.tangents);
    search.planes = search.tangents + count;
    status = found->altitudes_rad && search.tangents ? search_all(&search, err)
                                                     : pp_fail_memory(err);
    if (status == PP_OK)
        settle_plot_envelope(found, &search);
    free(search.tangents);
    return status;
}

void pp_plot_envelope_clear(struct pp_plot_envelope *found)
{
    pp_plot_cells_clear(&found->cells);
    pp_retained_sky_clear(&found->retained);
    free(found->altitudes_rad);
    *found = (struct pp_plot_envelope){0};
}
