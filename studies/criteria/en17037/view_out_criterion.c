/* view_out_criterion.c - the view out that [EN17037] 5.2 recommends, over 75 % of the
 * used area.
 *
 *   horizontal sight angle   14, 28, 54 degrees     minimum, medium, high
 *   outside distance         6, 20, 50 m
 *   layers                   landscape; landscape and one more; all three
 *
 * The rules for these three quantities are in view_out.h. The level at a point is the
 * lowest of the three; the room has the level that 75 % of the points reach. The
 * standard does not define the used area: here it is the working plane less 0.5 m along
 * the walls. Eyes are 1.2 m above the floor, as for people who sit.
 */
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "model/base/thread_pool.h"
#include "simulate/scene/light_scene_of_world.h"
#include "studies/criteria/bearing.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/grid/plane_grid.h"
#include "studies/view_out.h"

static const double part = 0.75;
static const double eye_m = 1.2;
static const double spacing_m = 0.5;
static const int most_cells = 400;
/* Distance (m) used where a distance is unlimited. */
static const double endless_m = 1000.0;

static const char *const level_names[] = {"none", "minimum", "medium", "high"};
static const char *const level_layers[] = {"", "landscape", "2 layers", "3 layers"};

static int descending(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x < *y) - (*x > *y);
}

/* Value that the fraction `part` of the points reaches; sorts the values. */
static double value_reached(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, descending);
    return values[(int)ceil(part * count - 1e-9) - 1];
}

/* Work of the threads: the view from each point of the grid. */
struct views_work {
    const struct pp_world *world;
    const struct pp_light_scene *scene;
    const struct pp_plane_grid *grid;
    struct pp_view_out *views;
    atomic_bool failed;
};

static bool find_view(void *data, int worker, int i)
{
    (void)worker;
    struct views_work *work = data;
    struct pp_vec3 eye = work->grid->receivers[i].position;
    eye.z = eye_m;
    if (pp_view_out_from(&work->views[i], work->world, work->scene, eye,
                         PP_VIEW_OUT_LINES, NULL)
        != PP_OK)
        atomic_store(&work->failed, true);
    return !atomic_load(&work->failed);
}

/* Views from all points of the grid, in its order; the caller frees them. */
static enum pp_status find_views(struct pp_view_out **views,
                                 const struct pp_inquiry *inquiry,
                                 const struct pp_plane_grid *grid, struct pp_error *err)
{
    struct pp_light_scene *scene = NULL;
    struct pp_thread_pool *pool = NULL;
    struct pp_view_out *list = calloc((size_t)grid->count, sizeof *list);
    *views = NULL;
    if (!list)
        return pp_fail_memory(err);
    enum pp_status status = pp_light_scene_of_world_matt(&scene, inquiry->world, err);
    if (status == PP_OK)
        status = pp_thread_pool_create(&pool, inquiry->threads, err);
    if (status == PP_OK) {
        struct views_work work = {inquiry->world, scene, grid, list, false};
        pp_thread_pool_run(pool, 0, grid->count, find_view, &work);
        if (work.failed)
            status = pp_fail_memory(err);
    }
    pp_thread_pool_destroy(pool);
    pp_light_scene_destroy(scene);
    if (status == PP_OK)
        *views = list;
    else
        free(list);
    return status;
}

/* Finding without a bound: the horizontal sight angle that 75 % of the points reach. */
static struct pp_finding angle_finding(const struct pp_view_out *views, double *values,
                                       int count)
{
    for (int i = 0; i < count; i++)
        values[i] = views[i].sight_angle_rad;
    return pp_finding_of(PP_FIGURE_ANGLE, value_reached(values, count), NAN, false,
                         "horizontal sight angle");
}

static struct pp_finding distance_finding(const struct pp_view_out *views,
                                          double *values, int count)
{
    for (int i = 0; i < count; i++)
        values[i] = fmin(views[i].distance_m, endless_m);
    double distance_m = value_reached(values, count);
    struct pp_finding finding = pp_finding_of(PP_FIGURE_LENGTH, distance_m, NAN, false,
                                              "distance of the view outside");
    if (distance_m >= endless_m)
        pp_finding_note(&finding, "1 km or more: the view reaches sky or open ground");
    return finding;
}

static struct pp_finding layer_finding(const struct pp_view_out *views, double *values,
                                       int count)
{
    for (int i = 0; i < count; i++)
        values[i] = views[i].layers_together;
    return pp_finding_of(PP_FIGURE_COUNT, value_reached(values, count), NAN, false,
                         "layers visible through one opening");
}

/* Finding on the fraction of points that reach a level; the bound is `part`. */
static struct pp_finding level_finding(const struct pp_view_out *views, int count,
                                       enum pp_view_level level)
{
    int reached = 0;
    for (int i = 0; i < count; i++)
        reached += pp_view_out_level(&views[i]) >= level;
    struct pp_finding finding =
        pp_finding_of(PP_FIGURE_SHARE, (double)reached / count, part, false,
                      "%s: %.0f degrees, %.0f m, %s", level_names[level],
                      pp_view_out_angle_rad[level] / PP_RAD,
                      pp_view_out_distance_m[level], level_layers[level]);
    finding.level = (int)level;
    finding.is_optional = level > PP_VIEW_MINIMUM;
    return finding;
}

static enum pp_status add_views(struct pp_finding_list *findings,
                                const struct pp_view_out *views, int count,
                                struct pp_error *err)
{
    double *values = calloc((size_t)count, sizeof *values);
    if (!values)
        return pp_fail_memory(err);
    const struct pp_finding all[] = {
        angle_finding(views, values, count),
        distance_finding(views, values, count),
        layer_finding(views, values, count),
        level_finding(views, count, PP_VIEW_MINIMUM),
        level_finding(views, count, PP_VIEW_MEDIUM),
        level_finding(views, count, PP_VIEW_HIGH),
    };
    free(values);
    enum pp_view_level level = PP_VIEW_NONE;
    while (level < PP_VIEW_HIGH && all[3 + level].verdict == PP_MET)
        level++;
    pp_finding_list_add_basis(findings, "level reached: %s", level_names[level]);
    enum pp_status status = PP_OK;
    for (size_t i = 0; i < sizeof all / sizeof *all && status == PP_OK; i++)
        status = pp_finding_list_add(findings, &all[i], err);
    return status;
}

static enum pp_status assess_view(const struct pp_inquiry *inquiry,
                                  struct pp_finding_list *findings,
                                  struct pp_error *err)
{
    struct pp_plane_grid grid;
    enum pp_status status = pp_plane_grid_at_most(
        &grid, inquiry->world, spacing_m, PP_PLANE_GRID_MARGIN_M, most_cells, err);
    if (status == PP_OK && grid.count == 0) {
        struct pp_finding none = pp_finding_not_judged(
            "no part of the working plane is 0.5 m or more from the walls", "view out");
        status = pp_finding_list_add(findings, &none, err);
    } else if (status == PP_OK) {
        struct pp_view_out *views = NULL;
        char words[PP_PLANE_GRID_WORDS];
        pp_plane_grid_words(words, &grid);
        pp_finding_list_add_basis(findings,
                                  "each figure is the value that 75 %% of the points "
                                  "reach, 1.2 m above the floor, on %s; ",
                                  words);
        status = find_views(&views, inquiry, &grid, err);
        if (status == PP_OK)
            status = add_views(findings, views, grid.count, err);
        free(views);
    }
    pp_plane_grid_clear(&grid);
    return status;
}

const struct pp_criterion pp_criterion_view_out = {
    .name = "view-out",
    .title = "EN 17037 view out",
    .source = "EN17037",
    .summary = "sight angle, distance and layers of the view from 75 % of the plane",
    .bears_on_use = pp_bearing_needs_daylight,
    .without_trees = true,
    .evaluate = assess_view,
};
