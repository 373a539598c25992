/* annual_state.c - see annual_state.h. */
#include "studies/year/annual_state.h"

#include <stdlib.h>

#include "methods/exact/sky_view.h"
#include "model/room/build/device_states.h"
#include "model/room/surface_materials.h"
#include "simulate/scene/light_scene_of_world.h"
#include "studies/year/annual_work.h"

enum { CELLS = 600 };

/* Largest size of a piece of sky: 1.7 degrees, about a third of the width of one of 577
 * patches. */
static const double PIECE_RAD = 0.03;

/* True if a group takes light of the state in that hour of the year. */
static bool is_used(const struct pp_annual_state *state,
                    const struct pp_annual_work *work, int t)
{
    size_t skies = (size_t)work->year->sky_count;
    for (int g = 0; g < work->groups.count; g++)
        if (state->share[(size_t)g * skies + (size_t)t] > 0.0f)
            return true;
    return false;
}

static enum pp_status choose_hours(struct pp_annual_state *state,
                                   const struct pp_annual_work *work,
                                   struct pp_error *err)
{
    const struct pp_weather_year *year = work->year;
    size_t all = (size_t)year->sky_count + 1;
    state->skies = calloc(all, sizeof *state->skies);
    state->hours = calloc(all, sizeof *state->hours);
    if (!state->skies || !state->hours)
        return pp_fail_memory(err);
    for (int t = 0; t < year->sky_count; t++) {
        if (state->share && !is_used(state, work, t))
            continue;
        state->hours[state->count] = t;
        state->skies[state->count++] =
            pp_weather_year_turned(&year->skies[t], state->world->north_rad);
    }
    return PP_OK;
}

enum pp_status pp_annual_state_init(struct pp_annual_state *state,
                                    const struct pp_annual_work *work,
                                    struct pp_error *err)
{
    size_t rows = (size_t)work->receiver_count * (size_t)work->groups.count;
    const struct pp_world *world = state->world;
    enum pp_status status = choose_hours(state, work, err);
    if (status == PP_OK)
        status = pp_light_scene_of_world_matt(&state->scene, world, err);
    if (status == PP_OK)
        status =
            pp_light_scene_under(&state->environment, state->scene, work->light, err);
    if (status == PP_OK)
        status = pp_light_columns_init(
            &state->columns, state->environment, state->skies, state->count,
            work->options->patches, world->north_rad, work->pool, err);
    if (status != PP_OK)
        return status;
    state->step = (size_t)state->columns.tiles * PP_LIGHT_LANES;
    state->direct =
        calloc(rows * (size_t)state->columns.column_count + 1, sizeof(float));
    state->direct_sun = calloc(rows * (size_t)state->count + 1, sizeof(float));
    return state->direct && state->direct_sun ? PP_OK : pp_fail_memory(err);
}

void pp_annual_state_clear(struct pp_annual_state *state)
{
    pp_year_coefficients_destroy(state->coefficients);
    pp_plain_year_destroy(state->plain);
    pp_light_columns_clear(&state->columns);
    pp_environment_destroy(state->environment);
    pp_light_scene_destroy(state->scene);
    free(state->hours);
    free(state->skies);
    free(state->direct);
    free(state->direct_sun);
    free(state->share);
    pp_device_states_destroy(state->turned);
    *state = (struct pp_annual_state){.world = NULL};
}

enum pp_status pp_annual_state_trace(struct pp_annual_state *state,
                                     struct pp_annual_work *work, int paths,
                                     const struct pp_year_stores *stores,
                                     struct pp_error *err)
{
    const struct pp_annual_options *options = work->options;
    const struct pp_year_coefficient_options year = {.paths = paths,
                                                     .cells = CELLS,
                                                     .patches = options->patches,
                                                     .seed = options->seed,
                                                     .stores = stores,
                                                     .goes_on = pp_annual_work_goes_on,
                                                     .data = work};
    if (options->exact_sky)
        return pp_plain_year_create(&state->plain, state->scene, state->environment,
                                    work->receivers, work->groups.of_opening,
                                    work->groups.count, paths, options->seed, err);
    return pp_year_coefficients_create(&state->coefficients, state->scene,
                                       state->environment, work->receivers,
                                       work->receiver_count, work->groups.of_opening,
                                       work->groups.count, &year, work->pool, err);
}

enum pp_status pp_annual_state_light(struct pp_annual_state *state,
                                     struct pp_error *err)
{
    return state->coefficients
               ? pp_year_coefficients_light(state->coefficients, &state->columns, err)
               : PP_OK;
}

/* ---- direct light ---- */

struct piece_sums {
    const struct pp_annual_work *work;
    const struct pp_world *world; /* of the state */
    const struct pp_light_columns *columns;
    struct pp_vec3 point;
    float *rows;
};

static void add_piece_of_sky(void *data, const struct pp_sky_piece *piece)
{
    struct piece_sums *sums = data;
    const struct pp_annual_work *work = sums->work;
    float *row =
        sums->rows
        + work->groups.of_opening[piece->opening] * sums->columns->column_count;
    double coefficient =
        piece->coefficient
        * pp_surface_materials_past_outer_panes(sums->world, sums->point, piece->u);
    if (piece->ground)
        row[sums->columns->patches.count] +=
            (float)(coefficient * pp_outside_light_ground(work->light) / PP_PI);
    else
        row[pp_sky_patches_of(&sums->columns->patches, piece->u)] += (float)coefficient;
}

enum pp_status pp_annual_state_see(struct pp_annual_state *state,
                                   const struct pp_annual_work *work, int x)
{
    struct pp_sky_view view;
    size_t groups = (size_t)work->groups.count, count = (size_t)state->count;
    enum pp_status status =
        pp_sky_view_init(&view, state->world, &work->receivers[x], NULL);
    if (status != PP_OK)
        return status;
    struct piece_sums sums = {
        work, state->world, &state->columns, work->receivers[x].position,
        state->direct + (size_t)x * groups * (size_t)state->columns.column_count};
    status = pp_sky_view_pieces(&view, PIECE_RAD, add_piece_of_sky, &sums, NULL);
    float *sun = state->direct_sun + (size_t)x * groups * count;
    for (size_t t = 0; t < count; t++) {
        const struct pp_perez_sky *sky = &state->skies[t];
        int opening;
        double share =
            sky->direct_lx > 0.0 ? pp_sky_view_sun(&view, sky->sun, &opening) : 0.0;
        if (share > 0.0)
            share *= pp_surface_materials_past_outer_panes(
                state->world, work->receivers[x].position, sky->sun);
        if (share > 0.0)
            sun[(size_t)work->groups.of_opening[opening] * count + t] =
                (float)(share * sky->direct_lx);
    }
    pp_sky_view_clear(&view);
    return status;
}
