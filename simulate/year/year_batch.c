/* year_batch.c - traces paths of all cells and receivers, and stores them as sparse
 * rows. */
#include "simulate/year/year_batch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/sampling/hash.h"
#include "simulate/sampling/triangle.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/year/outdoor_cells.h"
#include "simulate/year/year_path.h"
#include "simulate/year/year_solve.h"

/* Paths do not end at surfaces nearer than this many cell sizes (see year_batch.h). */
static const double NEAR = 1.5;

/* State of one randomisation. */
struct batch_work {
    const struct pp_year_task *task;
    struct pp_year_batch *batch;
    int worker;
    struct pp_outdoor_cells outdoor;
    struct pp_path_walk walk;
    uint64_t seed;
    struct pp_sparse_rows of_cells[PP_YEAR_ROWS_COUNT], of_points[PP_YEAR_ROWS_COUNT],
        of_panes[PP_YEAR_ROWS_COUNT];
    struct pp_sparse_rows *rows; /* rows being filled */
    double scale;                /* 1 divided by the number of paths */
    bool views_sky;              /* direct light of the receiver is calculated in closed
                                  * form */
};

static int column_of(const struct batch_work *work, int opening, int column)
{
    const struct pp_year_task *task = work->task;
    int group = opening >= 0 ? task->group_of_opening[opening] : 0;
    return group * pp_year_solve_columns(task) + column;
}

/* ---- events ---- */

static void add_light(struct batch_work *work, const struct pp_year_event *event,
                      int column)
{
    pp_sparse_rows_add(&work->rows[PP_YEAR_ROWS_D],
                       column_of(work, event->opening, column),
                       event->weight * work->scale);
}

static void take_sky(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    if (!(event->straight && work->views_sky))
        add_light(work, event, pp_sky_patches_of(work->task->patches, event->u));
}

static void take_horizontal(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    if (!(event->straight && work->views_sky))
        add_light(work, event, work->task->patches->count);
}

static void take_skyline(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    add_light(work, event, work->task->patches->count + 1 + event->far);
}

static void take_lit(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    if (event->at.space == PP_INDOORS) {
        int cell = pp_year_cells_of(work->task->cells, event->hit);
        if (cell >= 0)
            pp_sparse_rows_add(&work->rows[PP_YEAR_ROWS_N], cell,
                               event->weight * work->scale);
        return;
    }
    int index = pp_outdoor_cells_find(&work->outdoor, &event->at, event->weight);
    add_light(work, event, work->task->column_count + index);
}

static void take_pane(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    add_light(work, event, pp_year_solve_columns(work->task) - 1);
}

static void take_pane_sun(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    add_light(work, event,
              work->task->column_count + PP_YEAR_OUTDOOR_CELLS + event->leaving);
}

static bool take_known(void *data, const struct pp_year_event *event)
{
    struct batch_work *work = data;
    const struct pp_year_cells *cells = work->task->cells;
    int cell = pp_year_cells_of(cells, event->hit);
    if (cell < 0 || !work->batch->cell_has_point[cell]
        || event->hit->distance_m < NEAR * cells->size_m)
        return false;
    pp_sparse_rows_add(&work->rows[PP_YEAR_ROWS_G], cell, event->weight * work->scale);
    return true;
}

/* ---- paths ---- */

static const struct pp_year_sink batch_sink = {.sky = take_sky,
                                               .skyline = take_skyline,
                                               .horizontal = take_horizontal,
                                               .lit = take_lit,
                                               .pane = take_pane,
                                               .pane_sun = take_pane_sun,
                                               .pane_sun_apart = true,
                                               .known = take_known};

static void begin_paths(struct batch_work *work, uint64_t place)
{
    pp_sobol_sequence_init(&work->walk.sequence, work->task->sobol,
                           pp_hash(work->seed, place));
}

/* Follows one path through the openings and one in the cosine lobe. */
static void follow_both(struct batch_work *work, const struct pp_lit_point *at)
{
    struct pp_year_sink sink = batch_sink;
    sink.data = work;
    sink.pane_sun_apart = work->views_sky; /* cells have no separate samples of sun on
                                            * panes */
    pp_year_path_openings(&work->walk, &sink, at);
    pp_year_path_lobe(&work->walk, &sink, at);
}

/* Draws a point for every path of a cell. Points that are not on the cell get a zero
 * normal. Returns the number of points on the cell. */
static int draw_places(struct batch_work *work, int cell, struct pp_lit_point *places)
{
    int drawn = 0;
    for (int i = 0; i < work->task->cell_paths; i++) {
        double u[2];
        work->walk.index = (uint32_t)i;
        work->walk.vertex = 0;
        pp_path_walk_draw(&work->walk, 2, u);
        if (pp_year_cells_point(work->task->cells, cell, u[0], u[1], &places[i]))
            drawn++;
        else
            places[i].normal = pp_vec(0.0, 0.0, 0.0);
    }
    return drawn;
}

/* Traces the paths of a cell that has a point. Paths begin at the drawn points that are
 * on the cell. If there are none, all paths begin at the cell's point. */
static void follow_cell(struct batch_work *work, int cell, struct pp_lit_point *places)
{
    const struct pp_year_task *task = work->task;
    begin_paths(work, (uint64_t)cell);
    int drawn = draw_places(work, cell, places);
    work->scale = 1.0 / (drawn > 0 ? drawn : task->cell_paths);
    for (int i = 0; i < task->cell_paths; i++) {
        const struct pp_lit_point *at =
            drawn > 0 ? &places[i] : &work->batch->cell_points[cell];
        work->walk.index = (uint32_t)i;
        work->walk.vertex = 1;
        if (pp_vec_length(at->normal) > 0.0)
            follow_both(work, at);
    }
}

/* Finds the points at which the sun is tested, with a limited number of draws for each
 * cell. The randomisations use different parts of the cell. */
static void place_suns(struct batch_work *work, int index)
{
    enum { DRAWS = 64 };
    const struct pp_year_cells *cells = work->task->cells;
    for (int c = 0; c < cells->count; c++) {
        /* parts of a 4 x 4 grid over the cell, in a different order for each cell */
        uint64_t order = pp_hash(work->task->seed, (uint64_t)c);
        int part = (int)((index * 7 + order) % 16);
        begin_paths(work, (UINT64_C(1) << 40) + (uint64_t)c);
        for (int i = 0; i < DRAWS && !work->batch->cell_has_point[c]; i++) {
            double u[2];
            work->walk.index = (uint32_t)i;
            work->walk.vertex = 0;
            pp_path_walk_draw(&work->walk, 2, u);
            if (i < DRAWS / 2) {
                u[0] = (part / 4 + u[0]) / 4.0;
                u[1] = (part % 4 + u[1]) / 4.0;
            }
            work->batch->cell_has_point[c] =
                pp_year_cells_point(cells, c, u[0], u[1], &work->batch->cell_points[c]);
        }
    }
}

/* Ends a row of each matrix. PP_INTERRUPTED if the task is to be stopped. */
static enum pp_status end_row(const struct batch_work *work,
                              struct pp_sparse_rows *rows, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int k = 0; k < PP_YEAR_ROWS_COUNT && status == PP_OK; k++)
        status = pp_sparse_rows_end(&rows[k], err);
    if (status == PP_OK && !work->task->goes_on(work->task->data, work->worker))
        status = pp_fail(err, PP_INTERRUPTED, "interrupted");
    return status;
}

static enum pp_status follow_cells(struct batch_work *work, struct pp_error *err)
{
    const struct pp_year_task *task = work->task;
    struct pp_lit_point *places = malloc((size_t)task->cell_paths * sizeof *places);
    enum pp_status status = places ? PP_OK : pp_fail_memory(err);
    work->rows = work->of_cells;
    work->views_sky = false;
    for (int c = 0; c < task->cells->count && status == PP_OK; c++) {
        if (work->batch->cell_has_point[c])
            follow_cell(work, c, places);
        status = end_row(work, work->of_cells, err);
    }
    free(places);
    return status;
}

/* Adds the sunlight that scattering panes send directly to a receiver. Bright
 * directions of a pane fill a small part of its view; therefore many samples are
 * needed. */
static void add_direct_pane_sun(struct batch_work *work, const struct pp_lit_point *at,
                                uint64_t place)
{
    enum { SAMPLES = 1024 };
    struct pp_year_sink sink = batch_sink;
    sink.data = work;
    begin_paths(work, place ^ UINT64_C(0x70616e65));
    work->scale = 1.0 / SAMPLES;
    for (int i = 0; i < SAMPLES; i++) {
        work->walk.index = (uint32_t)i;
        work->walk.vertex = 0;
        pp_year_path_pane_sun(&work->walk, &sink, at);
    }
}

static enum pp_status follow_points(struct batch_work *work, struct pp_error *err)
{
    const struct pp_year_task *task = work->task;
    enum pp_status status = PP_OK;
    work->rows = work->of_points;
    work->views_sky = true;
    for (int x = 0; x < task->receiver_count && status == PP_OK; x++) {
        const struct pp_receiver *receiver = &task->receivers[x];
        struct pp_lit_point at = {pp_vec_sub(receiver->position, task->scene->centre),
                                  receiver->normal, PP_INDOORS};
        uint64_t place =
            pp_hash_vec(pp_hash_vec(0, receiver->position), receiver->normal);
        if (task->class_count > 0)
            add_direct_pane_sun(work, &at, place);
        begin_paths(work, place);
        work->scale = 1.0 / task->point_paths;
        for (int i = 0; i < task->point_paths; i++) {
            work->walk.index = (uint32_t)i;
            work->walk.vertex = 0;
            follow_both(work, &at);
        }
        status = end_row(work, work->of_points, err);
    }
    return status;
}

static int group_of_pane(const struct pp_year_task *task, int pane)
{
    const struct pp_light_scene *scene = task->scene;
    return task->group_of_opening[scene->parts[scene->panes[pane].part].window];
}

/* A random point on the outside of a group's panes, uniform by area. */
static struct pp_lit_point draw_on_pane(struct batch_work *work, int group)
{
    const struct pp_year_task *task = work->task;
    const struct pp_light_scene *scene = task->scene;
    double u[3], area_m2 = 0.0;
    pp_path_walk_draw(&work->walk, 3, u);
    const struct pp_target *target = NULL;
    for (int i = 0; i < scene->pane_count; i++)
        if (group_of_pane(task, i) == group)
            area_m2 += scene->panes[i].target.area_m2;
    double left_m2 = u[2] * area_m2;
    for (int i = 0; i < scene->pane_count; i++) {
        if (group_of_pane(task, i) != group)
            continue;
        target = &scene->panes[i].target;
        if (left_m2 < target->area_m2)
            break;
        left_m2 -= target->area_m2;
    }
    struct pp_lit_point at = {.space = PP_OUTDOORS};
    if (!target)
        return at;
    at.normal = pp_vec_scale(target->normal, -1.0);
    at.point =
        target->rectangle
            ? pp_target_point(target, u[0] * target->width_m, u[1] * target->height_m)
            : pp_triangle_point_of((const struct pp_vec3(*)[3])target->triangles,
                                   target->triangle_count, target->area_m2, u[0], u[1]);
    return at;
}

static enum pp_status follow_panes(struct batch_work *work, struct pp_error *err)
{
    const struct pp_year_task *task = work->task;
    struct pp_year_batch *batch = work->batch;
    struct pp_year_sink sink = batch_sink;
    struct pp_sparse_rows *rows = work->of_panes;
    enum pp_status status = PP_OK;
    sink.data = work;
    work->rows = rows;
    work->views_sky = false;
    work->scale = 1.0 / task->point_paths;
    for (int g = 0; g < task->group_count && status == PP_OK; g++) {
        begin_paths(work, (UINT64_C(1) << 41) + (uint64_t)g);
        for (int i = 0; i < task->point_paths; i++) {
            work->walk.index = (uint32_t)i;
            work->walk.vertex = 0;
            struct pp_lit_point at = draw_on_pane(work, g);
            if (i < PP_YEAR_PANE_POINTS)
                batch->pane_points[g * PP_YEAR_PANE_POINTS + i] = at;
            if (pp_vec_length(at.normal) > 0.0)
                pp_year_path_lobe(&work->walk, &sink, &at);
        }
        status = end_row(work, rows, err);
        /* Adds the columns of all groups: some paths end outside only after passing the
         * room, through an opening of any group. */
        const struct pp_sparse_rows *D = &rows[PP_YEAR_ROWS_D];
        for (int k = D->first[g]; status == PP_OK && k < D->first[g + 1]; k++) {
            int column = D->entries[k].column % pp_year_solve_columns(task);
            float value = D->entries[k].value;
            if (column < task->column_count)
                batch->on_pane[g * task->column_count + column] += value;
            else if (column < task->column_count + PP_YEAR_OUTDOOR_CELLS)
                batch->on_pane_outdoor[g * PP_YEAR_OUTDOOR_CELLS + column
                                       - task->column_count] += value;
        }
    }
    return status;
}

/* ---- the whole batch ---- */

enum pp_status pp_year_batch_make_space(struct pp_year_batch *batch,
                                        const struct pp_year_task *task,
                                        struct pp_error *err)
{
    *batch = (struct pp_year_batch){.light = NULL};
    size_t points = (size_t)task->receiver_count, groups = (size_t)task->group_count;
    size_t cells = (size_t)task->cells->count;
    batch->light =
        calloc(points * groups * (size_t)task->column_count + 1, sizeof(float));
    batch->outdoor = calloc(points * groups * PP_YEAR_OUTDOOR_CELLS + 1, sizeof(float));
    batch->inside = calloc(points * cells + 1, sizeof(float));
    batch->classes =
        calloc(points * groups * (size_t)task->class_count + 1, sizeof(float));
    batch->by_pane = calloc(points * groups + 1, sizeof(float));
    batch->on_pane = calloc(groups * (size_t)task->column_count + 1, sizeof(float));
    batch->on_pane_outdoor = calloc(groups * PP_YEAR_OUTDOOR_CELLS + 1, sizeof(float));
    batch->pane_points =
        calloc(groups * PP_YEAR_PANE_POINTS + 1, sizeof *batch->pane_points);
    batch->cell_points = calloc(cells + 1, sizeof *batch->cell_points);
    batch->cell_has_point = calloc(cells + 1, sizeof *batch->cell_has_point);
    if (!batch->light || !batch->classes || !batch->outdoor || !batch->inside
        || !batch->cell_points || !batch->by_pane || !batch->on_pane
        || !batch->on_pane_outdoor || !batch->pane_points || !batch->cell_has_point)
        return pp_fail_memory(err);
    return PP_OK;
}

enum pp_status pp_year_batch_make(struct pp_year_batch *batch,
                                  const struct pp_year_task *task, int index,
                                  int worker, struct pp_error *err)
{
    enum pp_status status = pp_year_batch_make_space(batch, task, err);
    struct batch_work *work = calloc(1, sizeof *work);
    if (status != PP_OK || !work) {
        free(work);
        return pp_fail_memory(err);
    }
    work->task = task;
    work->batch = batch;
    work->worker = worker;
    work->seed = pp_hash(task->seed, UINT64_C(0x9ea1) + (uint64_t)index);
    work->walk =
        (struct pp_path_walk){.scene = task->scene, .environment = task->environment};
    pp_outdoor_cells_init(&work->outdoor, task->scene, batch->outdoor_points,
                          PP_YEAR_OUTDOOR_CELLS, work->seed);
    int columns = task->group_count * pp_year_solve_columns(task);
    for (int k = 0; k < PP_YEAR_ROWS_COUNT && status == PP_OK; k++) {
        int width = k == PP_YEAR_ROWS_D ? columns : task->cells->count;
        status = pp_sparse_rows_init(&work->of_cells[k], width, err);
        if (status == PP_OK)
            status = pp_sparse_rows_init(&work->of_points[k], width, err);
        if (status == PP_OK)
            status = pp_sparse_rows_init(&work->of_panes[k], width, err);
    }
    if (status == PP_OK) {
        place_suns(work, index);
        status = follow_cells(work, err);
    }
    if (status == PP_OK)
        status = follow_points(work, err);
    if (status == PP_OK)
        status = follow_panes(work, err);
    if (status == PP_OK)
        status = pp_year_solve(batch, task, work->of_cells, work->of_points, err);
    for (int i = 0; i < PP_YEAR_OUTDOOR_CELLS; i++)
        batch->outdoor_is_used[i] = work->outdoor.weights[i] > 0.0;
    for (int k = 0; k < PP_YEAR_ROWS_COUNT; k++) {
        pp_sparse_rows_clear(&work->of_cells[k]);
        pp_sparse_rows_clear(&work->of_points[k]);
        pp_sparse_rows_clear(&work->of_panes[k]);
    }
    free(work);
    return status;
}

void pp_year_batch_clear(struct pp_year_batch *batch)
{
    free(batch->light);
    free(batch->outdoor);
    free(batch->inside);
    free(batch->classes);
    free(batch->cell_points);
    free(batch->cell_has_point);
    free(batch->by_pane);
    free(batch->on_pane);
    free(batch->on_pane_outdoor);
    free(batch->pane_points);
    *batch = (struct pp_year_batch){.light = NULL};
}
