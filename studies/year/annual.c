/* annual.c - computes the annual figures of a room from its weather. */
#include "studies/year/annual.h"

#include <math.h>
#include <stdlib.h>

#include "model/results/lattice.h"
#include "simulate/scene/light_scene_of_world.h"
#include "studies/year/annual_plane.h"
#include "studies/year/annual_store.h"
#include "studies/year/annual_words.h"
#include "studies/year/annual_work.h"

/* With an error to reach, a run of PILOT paths first estimates their number. */
enum { CELLS = 600, PILOT = 32, SAMPLES = 128, SAMPLES_MOST = 8192 };

/* Share of the whole after the paths, for the progress bar. */
static const double TRACED = 0.4;

/* done: share of the current step. */
static bool annual_goes_on(void *data, double done)
{
    struct pp_annual_work *work = data;
    const struct pp_watch *watch = &work->options->watch;
    double share = work->begun + done * (work->ended - work->begun);
    if (watch->look && !watch->look(watch->data, share, NAN))
        work->stopped = true;
    return !work->stopped;
}

/* Begins a step of the computation that ends at this share of the whole. */
static bool next_step(struct pp_annual_work *work, double ended)
{
    work->begun = work->ended;
    work->ended = ended;
    return annual_goes_on(work, 0.0);
}

/* Worker 0 is the calling thread, which watches. */
static bool run_block(void *data, int worker, int block)
{
    struct pp_annual_work *work = data;
    if (worker == 0 && !annual_goes_on(work, (double)block / work->blocks))
        return false;
    return work->function(work, worker, block);
}

/* Calls a function for every block of points. PP_BAD_INPUT: the outline of the sky seen
 * through an opening has too many corners; PP_INTERRUPTED; otherwise it fails only if
 * out of memory. */
static enum pp_status for_points(struct pp_annual_work *work, int block,
                                 pp_thread_pool_work *function, struct pp_error *err)
{
    work->blocks = (work->receiver_count + block - 1) / block;
    work->function = function;
    pp_thread_pool_run(work->pool, 0, work->blocks, run_block, work);
    if (work->stopped)
        return pp_fail(err, PP_INTERRUPTED, "interrupted");
    for (int x = 0; x < work->receiver_count; x++)
        if (work->status[x] == PP_BAD_INPUT)
            return pp_fail(
                err, PP_BAD_INPUT,
                "the outline of the sky seen through an opening has too many corners");
        else if (work->status[x] != PP_OK)
            return pp_fail_memory(err);
    return PP_OK;
}

static enum pp_status make_tables(struct pp_annual_work *work, struct pp_error *err)
{
    size_t points = (size_t)work->receiver_count, groups = (size_t)work->groups.count;
    size_t skies = (size_t)work->year->sky_count;
    struct pp_annual_sheet *sheet = work->sheet;
    int share = (work->receiver_count - 1) / pp_thread_pool_size(work->pool) + 1;
    work->block = pp_annual_point_block_size(work->groups.count);
    work->block = share < work->block ? share : work->block;
    work->step = (size_t)work->columns.tiles * PP_LIGHT_LANES;
    work->direct =
        calloc(points * groups * (size_t)work->columns.column_count + 1, sizeof(float));
    work->direct_sun = calloc(points * groups * skies + 1, sizeof(float));
    work->closed = calloc(groups * skies + 1, 1);
    work->on_panes = calloc(groups * PP_YEAR_BATCHES * work->step + 1, sizeof(float));
    work->without =
        calloc(points * PP_YEAR_BATCHES * PP_ANNUAL_FIGURES + 1, sizeof(double));
    work->group_light =
        calloc(points * groups * (1 + PP_YEAR_BATCHES) + 1, sizeof(double));
    work->status = calloc(points + 1, sizeof *work->status);
    sheet->points = calloc(points + 1, sizeof *sheet->points);
    sheet->groups = calloc(groups + 1, sizeof *sheet->groups);
    sheet->lx = calloc(points * skies + 1, sizeof *sheet->lx);
    sheet->sun_lx = calloc(points * skies + 1, sizeof *sheet->sun_lx);
    if (!work->direct || !work->direct_sun || !work->closed || !work->on_panes
        || !work->without || !work->group_light || !work->status || !sheet->points
        || !sheet->groups || !sheet->lx || !sheet->sun_lx)
        return pp_fail_memory(err);
    return pp_annual_point_make_spaces(work, err);
}

/* Largest relative standard error of the annual light of a point, with the mean sky. */
static double worst_error(const struct pp_annual_work *work)
{
    double worst = 0.0;
    for (int x = 0; x < work->receiver_count; x++)
        worst = fmax(worst, pp_year_coefficients_spread(work->coefficients, x));
    return worst;
}

/* Creates the coefficients, with more paths until the target error or SAMPLES_MOST is
 * reached. */
static enum pp_status trace(struct pp_annual_work *work, struct pp_error *err)
{
    const struct pp_annual_options *options = work->options;
    struct pp_year_stores stores;
    int samples = options->samples;
    enum pp_status status = pp_annual_store_begin(&stores, work, &samples, err);
    if (status != PP_OK)
        return status;
    struct pp_year_coefficient_options year = {.paths = samples > 0 ? samples
                                                        : options->error > 0.0
                                                            ? PILOT
                                                            : SAMPLES,
                                               .cells = CELLS,
                                               .patches = options->patches,
                                               .seed = options->seed,
                                               .goes_on = annual_goes_on,
                                               .data = work};
    for (;;) {
        bool is_pilot = samples == 0 && year.paths == PILOT;
        work->samples = stores.origin.paths = year.paths;
        year.stores = is_pilot ? NULL : &stores;
        if (!next_step(work, is_pilot ? 0.05 : TRACED))
            return pp_fail(err, PP_INTERRUPTED, "interrupted");
        status = pp_year_coefficients_create(
            &work->coefficients, work->scene, work->environment, work->receivers,
            work->receiver_count, work->groups.of_opening, work->groups.count, &year,
            work->pool, err);
        if (status != PP_OK || samples > 0 || !(options->error > 0.0))
            break;
        double ratio = worst_error(work) / options->error;
        if ((ratio <= 1.0 && year.paths >= SAMPLES) || year.paths >= SAMPLES_MOST)
            break;
        while (year.paths < SAMPLES || (year.paths < SAMPLES_MOST && ratio > 1.0)) {
            year.paths *= 2;
            ratio /= sqrt(2.0);
        }
        pp_year_coefficients_destroy(work->coefficients);
        work->coefficients = NULL;
    }
    pp_annual_store_record(work->sheet->coefficient_record,
                           sizeof work->sheet->coefficient_record, &stores.origin);
    return status;
}

static enum pp_status prepare(struct pp_annual_work *work, struct pp_error *err)
{
    const struct pp_annual_options *options = work->options;
    enum pp_status status = pp_year_clock_init(&work->clock, work->year,
                                               &options->hours, &options->summer, err);
    if (status == PP_OK)
        status = pp_blind_groups_of_world(&work->groups, work->world, err);
    work->skies = calloc((size_t)work->year->sky_count + 1, sizeof *work->skies);
    if (status == PP_OK && !work->skies)
        status = pp_fail_memory(err);
    for (int t = 0; t < work->year->sky_count && status == PP_OK; t++)
        work->skies[t] =
            pp_weather_year_turned(&work->year->skies[t], work->world->north_rad);
    if (status == PP_OK)
        status = pp_thread_pool_create(&work->pool, options->threads, err);
    if (status == PP_OK)
        status = pp_light_scene_of_world_matt(&work->scene, work->world, err);
    if (status == PP_OK)
        status =
            pp_light_scene_under(&work->environment, work->scene, work->light, err);
    if (status == PP_OK)
        status = pp_light_columns_init(&work->columns, work->environment, work->skies,
                                       work->year->sky_count, options->patches,
                                       work->world->north_rad, work->pool, err);
    if (status == PP_OK)
        status = make_tables(work, err);
    return status;
}

static enum pp_status simulate(struct pp_annual_work *work, struct pp_error *err)
{
    enum pp_status status;
    if (work->options->exact_sky) {
        work->samples = work->options->samples > 0 ? work->options->samples : SAMPLES;
        status = pp_plain_year_create(&work->plain, work->scene, work->environment,
                                      work->receivers, work->groups.of_opening,
                                      work->groups.count, work->samples,
                                      work->options->seed, err);
        return status;
    }
    status = trace(work, err);
    if (status == PP_OK && next_step(work, 0.6))
        status = pp_year_coefficients_light(work->coefficients, &work->columns, err);
    return status;
}

/* Stores direct and reflected light of each point by patch, and by the ground's
 * luminance. */
static enum pp_status keep_coefficients(struct pp_annual_work *work,
                                        struct pp_error *err)
{
    int columns = work->columns.column_count, patches = work->columns.patches.count;
    int groups = work->groups.count;
    struct pp_annual_sheet *sheet = work->sheet;
    double ground = pp_outside_light_ground(work->light) / PP_PI;
    if (columns > patches + 1)
        return pp_fail(err, PP_BAD_INPUT,
                       "a skyline without a distance cannot be used for coefficients; "
                       "expected a skyline with a distance, or a block");
    float *row = malloc((size_t)columns * sizeof *row);
    sheet->patch_count = patches;
    sheet->coefficients = calloc((size_t)work->receiver_count * (size_t)columns + 1,
                                 sizeof *sheet->coefficients);
    for (int x = 0; row && sheet->coefficients && x < work->receiver_count; x++) {
        float *to = sheet->coefficients + (size_t)x * (size_t)columns;
        pp_year_coefficients_mean(work->coefficients, x, row);
        for (int g = 0; g < groups; g++)
            for (int k = 0; k < columns; k++)
                row[k] += work->direct[((size_t)x * (size_t)groups + (size_t)g)
                                           * (size_t)columns
                                       + (size_t)k];
        to[0] = ground > 0.0 ? (float)(row[patches] / ground) : 0.0f;
        for (int k = 0; k < patches; k++)
            to[1 + k] = row[k];
    }
    free(row);
    return row && sheet->coefficients ? PP_OK : pp_fail_memory(err);
}

static void finish(struct pp_annual_work *work)
{
    struct pp_annual_sheet *sheet = work->sheet;
    pp_annual_plane_fill(sheet, work->without, PP_YEAR_BATCHES);
    pp_annual_lighting_finish(work->lighting);
    for (int g = 0; g < work->groups.count; g++) {
        double sums[1 + PP_YEAR_BATCHES] = {0.0}, without[PP_YEAR_BATCHES];
        for (int x = 0; x < work->receiver_count; x++)
            for (int i = 0; i <= PP_YEAR_BATCHES; i++)
                sums[i] += work->group_light[((size_t)x * (size_t)work->groups.count
                                              + (size_t)g)
                                                 * (1 + PP_YEAR_BATCHES)
                                             + (size_t)i]
                           / work->receiver_count;
        for (int b = 0; b < PP_YEAR_BATCHES; b++)
            without[b] =
                (PP_YEAR_BATCHES * sums[0] - sums[1 + b]) / (PP_YEAR_BATCHES - 1);
        sheet->groups[g].light_lxh = (struct pp_annual_value){
            sums[0], pp_year_metrics_error(without, PP_YEAR_BATCHES)};
    }
    sheet->finished = true;
}

static enum pp_status work_out(struct pp_annual_work *work, struct pp_error *err)
{
    enum pp_status status = prepare(work, err);
    if (status == PP_OK)
        status = pp_annual_words_fill(work->sheet, work->world, work->year,
                                      work->options, &work->clock, &work->groups, err);
    if (status == PP_OK)
        status = pp_annual_lighting_create(
            &work->lighting, work->sheet,
            work->year->epw ? work->year->epw->latitude_rad : NAN, work->options,
            pp_thread_pool_size(work->pool), err);
    if (status == PP_OK && work->options->strict && work->sheet->warning_count > 0)
        status = pp_fail(err, PP_BAD_INPUT, "%s: %s",
                         work->world->name ? work->world->name : "the room",
                         work->sheet->warnings[0]);
    if (status == PP_OK)
        status = simulate(work, err);
    if (status != PP_OK)
        return status;
    pp_annual_words_method(
        work->sheet, work->options, work->samples,
        work->coefficients ? pp_year_coefficients_cells(work->coefficients) : 0);
    if (!next_step(work, 0.7))
        return PP_INTERRUPTED;
    status = for_points(work, 1, pp_annual_direct_see, err);
    if (status != PP_OK || !next_step(work, 0.9))
        return status;
    if (work->options->blinds)
        pp_annual_direct_close_blinds(work);
    if (work->options->coefficients && work->coefficients)
        status = keep_coefficients(work, err);
    if (status == PP_OK)
        status = for_points(work, work->block, pp_annual_point_block, err);
    if (status == PP_OK && work->options->measure && work->coefficients
        && next_step(work, 1.0))
        status = pp_annual_discretisation_measure(work, err);
    if (status == PP_OK && !work->stopped)
        finish(work);
    return status;
}

static void clear_work(struct pp_annual_work *work)
{
    pp_annual_point_clear_spaces(work);
    pp_annual_lighting_destroy(work->lighting);
    pp_year_coefficients_destroy(work->coefficients);
    pp_plain_year_destroy(work->plain);
    pp_light_columns_clear(&work->columns);
    pp_environment_destroy(work->environment);
    pp_light_scene_destroy(work->scene);
    pp_thread_pool_destroy(work->pool);
    pp_blind_groups_clear(&work->groups);
    pp_year_clock_clear(&work->clock);
    free(work->skies);
    free(work->direct);
    free(work->direct_sun);
    free(work->closed);
    free(work->on_panes);
    free(work->without);
    free(work->group_light);
    free(work->status);
}

const struct pp_annual_options pp_annual_options_lm83 = {
    .hours = {8.0, 18.0, PP_ALL_DAYS},
    .illuminance_count = 1,
    .illuminances_lx = {300.0},
    .patches = 577,
    .blinds = true,
    .seed = 1};

enum pp_status pp_annual_of_room(
    struct pp_annual_sheet *sheet, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_receiver *receivers,
    int receiver_count, bool is_grid, const struct pp_weather_year *year,
    const struct pp_annual_options *options, struct pp_error *err)
{
    *sheet = (struct pp_annual_sheet){.world = world,
                                      .receivers = receivers,
                                      .receiver_count = receiver_count,
                                      .is_grid = is_grid};
    if (world->face_count == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "%s: there is no room, only its surroundings; expected a plan "
                       "or an envelope",
                       world->name ? world->name : "the room");
    struct pp_annual_work work = {.sheet = sheet,
                                  .world = world,
                                  .light = light,
                                  .receivers = receivers,
                                  .receiver_count = receiver_count,
                                  .year = year,
                                  .options = options};
    const struct pp_watch *watch = &options->watch;
    bool watched = watch->begin && watch->begin(watch->data, world->name);
    enum pp_status status = work_out(&work, err);
    if (watched && watch->end)
        watch->end(watch->data);
    clear_work(&work);
    return status == PP_INTERRUPTED ? PP_OK : status;
}

enum pp_status pp_annual_of_study_room(struct pp_annual_sheet *sheet,
                                       const struct pp_study_room *room,
                                       const struct pp_weather_year *year,
                                       const struct pp_annual_options *options,
                                       struct pp_error *err)
{
    struct pp_lattice lattice;
    *sheet = (struct pp_annual_sheet){.points = NULL};
    enum pp_status status =
        pp_lattice_find(&lattice, room->receivers, room->receiver_count, err);
    if (status != PP_OK)
        return status;
    bool is_grid = lattice.columns > 0;
    pp_lattice_clear(&lattice);
    return pp_annual_of_room(sheet, room->world, &room->light, room->receivers,
                             room->receiver_count, is_grid, year, options, err);
}
