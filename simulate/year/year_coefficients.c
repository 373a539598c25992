/* year_coefficients.c - traces the batches, finds the sun on their cells, and
 * calculates the light of a point in every hour. */
#include "simulate/year/year_coefficients.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "model/base/array.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/year/pane_sun.h"
#include "simulate/year/sun_on_surface.h"
#include "simulate/year/sun_sums.h"
#include "simulate/year/year_product.h"

struct pp_year_coefficients {
    struct pp_year_task task;
    struct pp_year_cells cells;
    struct pp_sky_patches patches;
    struct pp_sobol sobol;
    struct pp_thread_pool *pool;
    struct pp_year_batch batches[PP_YEAR_BATCHES];
    const struct pp_light_columns *light;
    struct pp_sun_list suns[PP_YEAR_BATCHES];
    struct pp_pane_sun panes;
    enum pp_status status[PP_YEAR_BATCHES]; /* status of each batch's task */
    struct pp_error errors[PP_YEAR_BATCHES];
    const struct pp_year_stores *stores;
    bool (*goes_on)(void *data, double done);
    void *data;
    double done; /* fraction of the batches; only worker 0 uses it */
    atomic_bool stopped;
};

/* Called by the workers between rows. Worker 0 is the calling thread; it calls the
 * caller's goes_on on behalf of all workers. */
static bool year_goes_on(void *data, int worker)
{
    struct pp_year_coefficients *c = data;
    if (worker == 0 && c->goes_on && !c->goes_on(c->data, c->done))
        atomic_store(&c->stopped, true);
    return !atomic_load(&c->stopped);
}

static bool make_batch(void *data, int worker, int index)
{
    struct pp_year_coefficients *c = data;
    if (worker == 0)
        c->done = (double)index / PP_YEAR_BATCHES;
    c->status[index] = pp_year_stores_batch(c->stores, &c->batches[index], &c->task,
                                            index, worker, c->pool, &c->errors[index]);
    return c->status[index] == PP_OK;
}

/* Runs a task for all batches. */
static enum pp_status for_batches(struct pp_year_coefficients *c,
                                  pp_thread_pool_work *work, struct pp_error *err)
{
    pp_thread_pool_run(c->pool, 0, PP_YEAR_BATCHES, work, c);
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        if (c->status[b] != PP_OK && c->status[b] != PP_INTERRUPTED)
            return c->errors[b].message[0]
                       ? pp_fail(err, c->status[b], "%s", c->errors[b].message)
                       : pp_fail_memory(err);
    return atomic_load(&c->stopped) ? pp_fail(err, PP_INTERRUPTED, "interrupted")
                                    : PP_OK;
}

enum pp_status pp_year_coefficients_create(
    struct pp_year_coefficients **coefficients, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *receivers,
    int receiver_count, const int *group_of_opening, int group_count,
    const struct pp_year_coefficient_options *options, struct pp_thread_pool *pool,
    struct pp_error *err)
{
    *coefficients = NULL;
    struct pp_year_coefficients *c = calloc(1, sizeof *c);
    if (!c)
        return pp_fail_memory(err);
    c->pool = pool;
    c->goes_on = options->goes_on;
    c->data = options->data;
    c->stores = options->stores;
    atomic_init(&c->stopped, false);
    if (!pp_sky_patches_init(&c->patches, options->patches, scene->world->north_rad)) {
        free(c);
        return pp_fail(err, PP_BAD_INPUT,
                       "there are %d sky patches; expected 145, 577 or 2305",
                       options->patches);
    }
    pp_sobol_init(&c->sobol);
    enum pp_status status = pp_year_cells_init(&c->cells, scene, options->cells, err);
    c->task = (struct pp_year_task){
        .scene = scene,
        .environment = environment,
        .cells = &c->cells,
        .patches = &c->patches,
        .receivers = receivers,
        .receiver_count = receiver_count,
        .group_of_opening = group_of_opening,
        .group_count = group_count,
        .column_count = options->patches + 1 + scene->skylines.far_count,
        .class_count = pp_pane_sun_classes(scene),
        .cell_paths = options->paths >= 4 ? options->paths / 4 : 1,
        .point_paths = options->paths,
        .sobol = &c->sobol,
        .seed = options->seed,
        .goes_on = year_goes_on,
        .data = c};
    if (status == PP_OK && c->cells.count > PP_YEAR_CELLS_MOST)
        status = pp_fail(err, PP_BAD_INPUT,
                         "the interior of the room has %d surfaces; expected at most "
                         "%d",
                         c->cells.count, PP_YEAR_CELLS_MOST);
    if (status == PP_OK)
        status = for_batches(c, make_batch, err);
    if (status == PP_OK)
        status = pp_year_stores_write(c->stores, c->batches, &c->task, err);
    if (status != PP_OK) {
        pp_year_coefficients_destroy(c);
        return status;
    }
    *coefficients = c;
    return PP_OK;
}

static void clear_suns(struct pp_year_coefficients *c)
{
    for (int b = 0; b < PP_YEAR_BATCHES; b++) {
        free(c->suns[b].first);
        free(c->suns[b].entries);
        c->suns[b] = (struct pp_sun_list){.first = NULL};
    }
}

void pp_year_coefficients_destroy(struct pp_year_coefficients *c)
{
    if (!c)
        return;
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        pp_year_batch_clear(&c->batches[b]);
    clear_suns(c);
    pp_pane_sun_clear(&c->panes);
    pp_year_cells_clear(&c->cells);
    free(c);
}

/* ---- the sun on cells ---- */

static enum pp_status add_sun(struct pp_sun_list *list, int *used,
                              struct pp_sun_entry entry)
{
    enum pp_status status = pp_array_reserve(&list->entries, &list->capacity, *used + 1,
                                             sizeof *list->entries, NULL);
    if (status == PP_OK)
        list->entries[(*used)++] = entry;
    return status;
}

static enum pp_status add_suns_of_hour(const struct pp_year_coefficients *c, int b,
                                       const struct pp_perez_sky *sky,
                                       struct pp_sun_list *list, int *used)
{
    const struct pp_year_batch *batch = &c->batches[b];
    enum pp_status status = PP_OK;
    int opening;
    if (!(sky->direct_lx > 0.0) || !(sky->sun.z > 0.0))
        return PP_OK;
    for (int i = 0; i < c->cells.count && status == PP_OK; i++) {
        if (!batch->cell_has_point[i])
            continue;
        double share = pp_sun_on_surface(c->task.scene, &batch->cell_points[i],
                                         sky->sun, &opening);
        if (share > 0.0)
            status =
                add_sun(list, used,
                        (struct pp_sun_entry){
                            i, opening >= 0 ? c->task.group_of_opening[opening] : 0,
                            (float)(share * sky->direct_lx)});
    }
    for (int i = 0; i < PP_YEAR_OUTDOOR_CELLS && status == PP_OK; i++) {
        if (!batch->outdoor_is_used[i])
            continue;
        double share = pp_sun_on_surface(c->task.scene, &batch->outdoor_points[i],
                                         sky->sun, &opening);
        if (share > 0.0)
            status = add_sun(list, used,
                             (struct pp_sun_entry){(uint16_t)i, -1,
                                                   (float)(share * sky->direct_lx)});
    }
    return status;
}

static bool light_batch(void *data, int worker, int b)
{
    struct pp_year_coefficients *c = data;
    if (worker == 0)
        c->done = (double)b / PP_YEAR_BATCHES;
    struct pp_sun_list *list = &c->suns[b];
    int used = 0;
    list->first = calloc((size_t)c->light->count + 1, sizeof *list->first);
    c->status[b] = list->first ? PP_OK : pp_fail_memory(NULL);
    for (int t = 0; t < c->light->count && c->status[b] == PP_OK; t++) {
        c->status[b] = year_goes_on(c, worker)
                           ? add_suns_of_hour(c, b, &c->light->skies[t], list, &used)
                           : PP_INTERRUPTED;
        list->first[t + 1] = used;
    }
    return c->status[b] == PP_OK;
}

enum pp_status pp_year_coefficients_light(struct pp_year_coefficients *c,
                                          const struct pp_light_columns *light,
                                          struct pp_error *err)
{
    clear_suns(c);
    pp_pane_sun_clear(&c->panes);
    c->light = light;
    enum pp_status status = pp_pane_sun_init(&c->panes, &c->task, light, err);
    return status == PP_OK ? for_batches(c, light_batch, err) : status;
}

/* ---- points ---- */

/* Adds the sunlight that the panes of a group scatter to some receivers, in rows of hours
 * that begin at `sun`, `apart` numbers from one receiver to the next. */
static void add_pane_suns(const struct pp_year_coefficients *c, int first, int count,
                          int group, int b, float *sun, size_t apart)
{
    int classes = c->task.class_count;
    for (int t = 0; t < c->light->count; t++) {
        float lx =
            (float)pp_pane_sun_lx(&c->task, &c->batches[b], group, &c->light->skies[t]);
        for (int p = 0; p < count && lx > 0.0f; p++) {
            const float *own =
                c->batches[b].classes
                + (size_t)((first + p) * c->task.group_count + group) * (size_t)classes;
            sun[(size_t)p * apart + (size_t)t] +=
                lx * pp_pane_sun_share(&c->panes, own, group, t);
        }
    }
}

/* Space for the weights and sums of one batch. */
struct sun_space {
    struct pp_sun_weights *inside, *outdoor, *sums;
};

static void add_suns(const struct pp_year_coefficients *c, int first, int count, int b,
                     const struct sun_space *space, float *sun)
{
    const struct pp_year_batch *batch = &c->batches[b];
    int groups = c->task.group_count, cells = c->cells.count;
    int outdoor = groups * PP_YEAR_OUTDOOR_CELLS;
    size_t step = (size_t)c->light->tiles * PP_LIGHT_LANES;
    for (int p = 0; p < count; p++) {
        const float *in = batch->inside + (size_t)(first + p) * (size_t)cells;
        const float *out = batch->outdoor + (size_t)(first + p) * (size_t)outdoor;
        for (int i = 0; i < cells; i++)
            space->inside[i].of[p] = in[i];
        for (int i = 0; i < outdoor; i++)
            space->outdoor[i].of[p] = out[i];
    }
    const struct pp_sun_sums sums = {&c->suns[b],     space->inside, space->outdoor,
                                     c->light->count, groups,        count};
    pp_sun_sums_find(space->sums, &sums);
    for (int p = 0; p < count; p++)
        for (int g = 0; g < groups; g++) {
            float *row = sun
                         + ((size_t)p * (size_t)(groups * PP_YEAR_BATCHES)
                            + (size_t)(g * PP_YEAR_BATCHES + b))
                               * step;
            for (int t = 0; t < c->light->count; t++)
                row[t] = space->sums[t * groups + g].of[p];
        }
    for (int g = 0; g < groups && c->panes.panes; g++)
        if (c->panes.panes[g])
            add_pane_suns(c, first, count, g, b,
                          sun + (size_t)(g * PP_YEAR_BATCHES + b) * step,
                          (size_t)(groups * PP_YEAR_BATCHES) * step);
}

enum pp_status pp_year_coefficients_sun(const struct pp_year_coefficients *c, int first,
                                        int count, float *sun, struct pp_error *err)
{
    size_t groups = (size_t)c->task.group_count;
    size_t inside = (size_t)c->cells.count + 1,
           outdoor = groups * PP_YEAR_OUTDOOR_CELLS;
    size_t sums = groups * (size_t)c->light->count;
    struct pp_sun_weights *all = calloc(inside + outdoor + sums, sizeof *all);
    if (!all)
        return pp_fail_memory(err);
    const struct sun_space space = {all, all + inside, all + inside + outdoor};
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        add_suns(c, first, count, b, &space, sun);
    free(all);
    return PP_OK;
}

enum pp_status pp_year_coefficients_sky(const struct pp_year_coefficients *c, int first,
                                        int count, const float *direct, float *sky,
                                        struct pp_error *err)
{
    int groups = c->task.group_count, columns = c->task.column_count;
    int row_count = count * groups * PP_YEAR_BATCHES;
    float *rows = malloc(((size_t)row_count * (size_t)columns + 1) * sizeof *rows);
    if (!rows)
        return pp_fail_memory(err);
    for (int i = 0; i < row_count; i++) {
        int b = i % PP_YEAR_BATCHES, of = i / PP_YEAR_BATCHES; /* point and group */
        float *row = rows + (size_t)i * (size_t)columns;
        const float *light =
            c->batches[b].light + (size_t)(first * groups + of) * (size_t)columns;
        for (int k = 0; k < columns; k++)
            row[k] = light[k] + (direct ? direct[of * columns + k] : 0.0f);
    }
    pp_year_product(sky, rows, row_count, c->light);
    free(rows);
    return PP_OK;
}

/* ---- panes ---- */

/* Work on one group's panes in one batch. */
struct panes_work {
    const struct pp_year_coefficients *c;
    int group;
    float *lx;
    size_t step;
};

static bool light_panes(void *data, int worker, int b)
{
    (void)worker;
    struct panes_work *work = data;
    const struct pp_year_coefficients *c = work->c;
    const struct pp_year_batch *batch = &c->batches[b];
    const struct pp_sun_list *list = &c->suns[b];
    float *lx = work->lx + (size_t)b * work->step;
    pp_year_product(lx, batch->on_pane + work->group * c->task.column_count, 1,
                    c->light);
    const float *outdoor = batch->on_pane_outdoor + work->group * PP_YEAR_OUTDOOR_CELLS;
    for (int t = 0; t < c->light->count; t++) {
        lx[t] +=
            (float)pp_pane_sun_lx(&c->task, batch, work->group, &c->light->skies[t]);
        for (int k = list->first[t]; k < list->first[t + 1]; k++)
            if (list->entries[k].group < 0)
                lx[t] += outdoor[list->entries[k].cell] * list->entries[k].lx;
    }
    return true;
}

void pp_year_coefficients_on_panes(const struct pp_year_coefficients *c, int group,
                                   float *lx)
{
    struct panes_work work = {c, group, lx, (size_t)c->light->tiles * PP_LIGHT_LANES};
    pp_thread_pool_run(c->pool, 0, PP_YEAR_BATCHES, light_panes, &work);
}

float pp_year_coefficients_by_panes(const struct pp_year_coefficients *c, int receiver,
                                    int group, int batch)
{
    return c->batches[batch].by_pane[receiver * c->task.group_count + group];
}

double pp_year_coefficients_spread(const struct pp_year_coefficients *c, int receiver)
{
    int columns = c->task.group_count * c->task.column_count;
    double sums[PP_YEAR_BATCHES], mean = 0.0, squares = 0.0;
    for (int b = 0; b < PP_YEAR_BATCHES; b++) {
        const float *row = c->batches[b].light + (size_t)receiver * (size_t)columns;
        sums[b] = 0.0;
        for (int i = 0; i < columns; i++)
            sums[b] += row[i];
        mean += sums[b] / PP_YEAR_BATCHES;
    }
    for (int b = 0; b < PP_YEAR_BATCHES; b++)
        squares += (sums[b] - mean) * (sums[b] - mean);
    return mean > 0.0
               ? sqrt(squares / (PP_YEAR_BATCHES * (PP_YEAR_BATCHES - 1.0))) / mean
               : 0.0;
}

void pp_year_coefficients_mean(const struct pp_year_coefficients *c, int receiver,
                               float *mean)
{
    int groups = c->task.group_count, columns = c->task.column_count;
    for (int k = 0; k < columns; k++) {
        double sum = 0.0;
        for (int b = 0; b < PP_YEAR_BATCHES; b++)
            for (int g = 0; g < groups; g++)
                sum += c->batches[b]
                           .light[(size_t)(receiver * groups + g) * (size_t)columns
                                  + (size_t)k];
        mean[k] = (float)(sum / PP_YEAR_BATCHES);
    }
}

int pp_year_coefficients_cells(const struct pp_year_coefficients *c)
{
    return c->cells.count;
}

const struct pp_sky_patches *pp_year_coefficients_patches(
    const struct pp_year_coefficients *c)
{
    return &c->patches;
}
