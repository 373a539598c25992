/* annual.c - computes the annual figures of a room from its weather. */
#include "studies/year/annual.h"

#include <math.h>
#include <stdlib.h>

#include "model/results/lattice.h"
#include "model/results/sheets/point_areas.h"
#include "model/room/build/device_states.h"
#include "studies/year/annual_plane.h"
#include "studies/year/annual_seasons.h"
#include "studies/year/annual_store.h"
#include "studies/year/annual_words.h"
#include "studies/year/annual_work.h"

/* With a target error, a run with PILOT paths first estimates the number of paths. */
enum { PILOT = 32, SAMPLES = 128, SAMPLES_MOST = 8192 };

/* Shares of the work done after the steps with open windows: paths, sunlit cells,
 * direct light. If the room has its own blinds, these shares are multiplied by
 * OPEN_SHARE, and the states with closed blinds end at CLOSED. */
static const double TRACED = 0.4, LIT = 0.6, SEEN = 0.9;
static const double OPEN_SHARE = 0.3, CLOSED = 0.85;

static enum pp_status make_tables(struct pp_annual_work *work, struct pp_error *err)
{
    size_t points = (size_t)work->receiver_count, groups = (size_t)work->groups.count;
    size_t skies = (size_t)work->year->sky_count;
    struct pp_annual_sheet *sheet = work->sheet;
    int share = (work->receiver_count - 1) / pp_thread_pool_size(work->pool) + 1;
    work->block = pp_annual_point_block_size(work->groups.count);
    work->block = work->options->exact_sky ? 1
                  : share < work->block    ? share
                                           : work->block;
    work->closes = calloc(groups * skies + 1, 1);
    work->taken = calloc(groups * skies + 1, 1);
    work->on_panes =
        calloc(groups * PP_YEAR_BATCHES * work->open.step + 1, sizeof(float));
    work->without =
        calloc(points * PP_YEAR_BATCHES * PP_ANNUAL_FIGURES + 1, sizeof(double));
    work->group_light =
        calloc(points * groups * (1 + PP_YEAR_BATCHES) + 1, sizeof(double));
    work->status = calloc(points + 1, sizeof *work->status);
    sheet->points = calloc(points + 1, sizeof *sheet->points);
    sheet->groups = calloc(groups + 1, sizeof *sheet->groups);
    sheet->lx = calloc(points * skies + 1, sizeof *sheet->lx);
    sheet->sun_lx = calloc(points * skies + 1, sizeof *sheet->sun_lx);
    if (!work->closes || !work->taken || !work->on_panes || !work->without
        || !work->group_light || !work->status || !sheet->points || !sheet->groups
        || !sheet->lx || !sheet->sun_lx)
        return pp_fail_memory(err);
    return pp_annual_point_make_spaces(work, err);
}

/* Largest relative standard error of a point's simulated light
 * (pp_year_coefficients_spread). */
static double worst_error(const struct pp_annual_work *work)
{
    double worst = 0.0;
    for (int x = 0; x < work->receiver_count; x++)
        worst = fmax(worst, pp_year_coefficients_spread(work->open.coefficients, x));
    return worst;
}

/* Traces with open windows, with more paths until the target error or SAMPLES_MOST is
 * reached. */
static enum pp_status trace(struct pp_annual_work *work, struct pp_error *err)
{
    const struct pp_annual_options *options = work->options;
    struct pp_year_stores stores;
    int samples = options->samples;
    enum pp_status status =
        pp_annual_store_begin(&stores, work, &work->open, &samples, err);
    if (status != PP_OK)
        return status;
    bool by_error = samples == 0 && options->error > 0.0 && !options->exact_sky;
    work->samples = samples > 0 ? samples : by_error ? PILOT : SAMPLES;
    for (;;) {
        bool is_pilot = by_error && work->samples == PILOT;
        stores.origin.paths = work->samples;
        if (!pp_annual_work_next_step(work, (is_pilot ? 0.05 : TRACED) * work->scale))
            return pp_fail(err, PP_INTERRUPTED, "interrupted");
        status = pp_annual_state_trace(&work->open, work, work->samples,
                                       is_pilot ? NULL : &stores, err);
        if (status != PP_OK || !by_error)
            break;
        double ratio = worst_error(work) / options->error;
        if ((ratio <= 1.0 && work->samples >= SAMPLES) || work->samples >= SAMPLES_MOST)
            break;
        while (work->samples < SAMPLES
               || (work->samples < SAMPLES_MOST && ratio > 1.0)) {
            work->samples *= 2;
            ratio /= sqrt(2.0);
        }
        pp_year_coefficients_destroy(work->open.coefficients);
        work->open.coefficients = NULL;
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
    if (status == PP_OK)
        status = pp_thread_pool_create(&work->pool, options->threads, err);
    if (status == PP_OK && options->blinds != PP_BLINDS_AS_DRAWN
        && pp_device_states_exist(work->world))
        status = pp_device_states_open(&work->opened, work->world, err);
    work->open.world = work->opened ? work->opened : work->world;
    if (status == PP_OK)
        status = pp_annual_seasons_plan(work, err);
    if (status == PP_OK)
        status = pp_annual_state_init(&work->open, work, err);
    if (status == PP_OK)
        status = make_tables(work, err);
    work->scale = work->opened && options->blinds != PP_BLINDS_NEVER ? OPEN_SHARE : 1.0;
    return status;
}

/* Calculates the light of a state after its paths: sunlit cells and direct light. */
static enum pp_status see_state(struct pp_annual_work *work,
                                struct pp_annual_state *state, double lit, double seen,
                                struct pp_error *err)
{
    if (!pp_annual_work_next_step(work, lit))
        return PP_INTERRUPTED;
    enum pp_status status = pp_annual_state_light(state, err);
    if (status != PP_OK || !pp_annual_work_next_step(work, seen))
        return status != PP_OK ? status : PP_INTERRUPTED;
    work->state = state;
    return pp_annual_work_for_points(work, 1, pp_annual_direct_see, err);
}

/* Traces a closed state with as many paths as the open one. States with a world of
 * their own (slats turned to the sun, or trees of one season) are not stored, since
 * another year needs other such states. */
static enum pp_status trace_closed(struct pp_annual_work *work,
                                   struct pp_annual_state *state, struct pp_error *err)
{
    struct pp_year_stores stores;
    int samples = work->samples;
    if (state->turned)
        return pp_annual_state_trace(state, work, work->samples, NULL, err);
    enum pp_status status = pp_annual_store_begin(&stores, work, state, &samples, err);
    stores.origin.paths = work->samples;
    return status == PP_OK
               ? pp_annual_state_trace(state, work, work->samples, &stores, err)
               : status;
}

/* Calculates the room with open windows, without leaves on the trees. */
static enum pp_status see_bare(struct pp_annual_work *work, struct pp_error *err)
{
    double ended = SEEN * work->scale;
    if (!work->leafless)
        return PP_OK;
    enum pp_status status = pp_annual_state_init(&work->bare, work, err);
    if (status == PP_OK)
        status = trace_closed(work, &work->bare, err);
    if (status == PP_OK)
        status = see_state(work, &work->bare, ended, ended, err);
    if (status == PP_OK)
        pp_annual_seasons_merge_sun(work);
    return status;
}

/* Calculates the room with its own blinds in the hours in which any are closed. */
static enum pp_status close_windows(struct pp_annual_work *work, struct pp_error *err)
{
    enum pp_status status = pp_annual_closed_plan(work, err);
    if (status == PP_OK)
        status = pp_annual_seasons_divide(work, err);
    for (int s = 0; s < work->closed_count && status == PP_OK; s++) {
        struct pp_annual_state *state = &work->closed[s];
        double begun = OPEN_SHARE + (CLOSED - OPEN_SHARE) * s / work->closed_count;
        double share = (CLOSED - OPEN_SHARE) / work->closed_count;
        status = pp_annual_state_init(state, work, err);
        if (status == PP_OK && !pp_annual_work_next_step(work, begun + TRACED * share))
            status = PP_INTERRUPTED;
        if (status == PP_OK)
            status = trace_closed(work, state, err);
        if (status == PP_OK)
            status =
                see_state(work, state, begun + LIT * share, begun + SEEN * share, err);
    }
    if (status == PP_OK)
        pp_annual_direct_count_unmet(work);
    return status;
}

/* Stores the direct and reflected light of each point from each patch and from the
 * ground, per unit of their luminance. */
static enum pp_status keep_coefficients(struct pp_annual_work *work,
                                        struct pp_error *err)
{
    const struct pp_annual_state *open = &work->open;
    int columns = open->columns.column_count, patches = open->columns.patches.count;
    int groups = work->groups.count;
    struct pp_annual_sheet *sheet = work->sheet;
    double ground = pp_outside_light_ground(work->light) / PP_PI;
    if (work->leafless)
        return pp_fail(err, PP_BAD_INPUT,
                       "the trees have another transmittance in winter, so that one "
                       "set of coefficients is not enough; expected trees without "
                       "winter-transmittance");
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
        pp_year_coefficients_mean(open->coefficients, x, row);
        for (int g = 0; g < groups; g++)
            for (int k = 0; k < columns; k++)
                row[k] += open->direct[((size_t)x * (size_t)groups + (size_t)g)
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
    int points = work->receiver_count;
    pp_annual_plane_fill(sheet, work->without, PP_YEAR_BATCHES);
    pp_annual_lighting_finish(work->lighting);
    for (int g = 0; g < work->groups.count; g++) {
        double sums[1 + PP_YEAR_BATCHES] = {0.0}, without[PP_YEAR_BATCHES];
        for (int x = 0; x < points; x++) {
            double share =
                pp_point_areas_share(work->receivers, points, work->area_m2, x);
            const double *light = work->group_light
                                  + ((size_t)x * (size_t)work->groups.count + (size_t)g)
                                        * (1 + PP_YEAR_BATCHES);
            for (int i = 0; i <= PP_YEAR_BATCHES; i++)
                sums[i] += share * light[i];
        }
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
        status = trace(work, err);
    if (status != PP_OK)
        return status;
    pp_annual_words_method(work->sheet, work->options, work->samples,
                           work->open.coefficients
                               ? pp_year_coefficients_cells(work->open.coefficients)
                               : 0);
    status = see_state(work, &work->open, LIT * work->scale, SEEN * work->scale, err);
    if (status != PP_OK)
        return status;
    status = see_bare(work, err);
    if (status == PP_OK && work->sheet->has_blinds)
        status = pp_annual_direct_find(work, err);
    if (status == PP_OK && work->opened && work->sheet->has_blinds)
        status = close_windows(work, err);
    if (status == PP_OK && work->options->coefficients && work->open.coefficients)
        status = keep_coefficients(work, err);
    if (status == PP_OK && pp_annual_work_next_step(work, 0.95))
        status =
            pp_annual_work_for_points(work, work->block, pp_annual_point_block, err);
    if (status == PP_OK && work->options->measure && work->open.coefficients
        && pp_annual_work_next_step(work, 1.0))
        status = pp_annual_discretisation_measure(work, err);
    if (status == PP_OK && !work->stopped)
        finish(work);
    return status;
}

static void clear_work(struct pp_annual_work *work)
{
    pp_annual_point_clear_spaces(work);
    pp_annual_lighting_destroy(work->lighting);
    pp_annual_state_clear(&work->open);
    pp_annual_state_clear(&work->bare);
    for (int s = 0; s < work->closed_count; s++)
        pp_annual_state_clear(&work->closed[s]);
    free(work->closed);
    pp_annual_seasons_clear(work);
    pp_device_states_destroy(work->opened);
    pp_thread_pool_destroy(work->pool);
    pp_blind_groups_clear(&work->groups);
    pp_year_clock_clear(&work->clock);
    free(work->closes);
    free(work->taken);
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
    .blinds = PP_BLINDS_LM83,
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
    struct pp_annual_work work = {
        .sheet = sheet,
        .world = world,
        .light = light,
        .receivers = receivers,
        .receiver_count = receiver_count,
        .area_m2 = pp_point_areas_sum(receivers, receiver_count),
        .whole = pp_point_areas_whole(receivers, receiver_count),
        .year = year,
        .options = options};
    const struct pp_watch *watch = &options->watch;
    bool shown = pp_watch_begin(watch, world->name);
    enum pp_status status = work_out(&work, err);
    pp_watch_end(watch, shown);
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
