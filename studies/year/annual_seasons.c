/* annual_seasons.c - see annual_seasons.h. */
#include "studies/year/annual_seasons.h"

#include <stdlib.h>
#include <string.h>

#include "model/room/build/device_states.h"
#include "model/room/outside/trees.h"

/* Marks the skies of hours without leaves; returns their number. */
static int find_bare_skies(struct pp_annual_work *work)
{
    int count = 0;
    for (int i = 0; i < work->year->count; i++) {
        const struct pp_weather_hour *hour = &work->year->hours[i];
        if (hour->sky < 0 || !pp_trees_are_bare(work->world, hour->date.month))
            continue;
        count += !work->is_bare[hour->sky];
        work->is_bare[hour->sky] = true;
    }
    return count;
}

enum pp_status pp_annual_seasons_plan(struct pp_annual_work *work, struct pp_error *err)
{
    const struct pp_world *world = work->open.world;
    if (!pp_trees_change(world))
        return PP_OK;
    work->is_bare = calloc((size_t)work->year->sky_count + 1, 1);
    if (!work->is_bare)
        return pp_fail_memory(err);
    int bare = find_bare_skies(work);
    bool all = bare > 0 && bare == work->year->sky_count;
    enum pp_status status = pp_trees_in_season(&work->season, world, all, err);
    if (status == PP_OK)
        work->open.world = work->season;
    if (status == PP_OK && bare > 0 && !all)
        status = pp_trees_in_season(&work->leafless, world, true, err);
    work->bare.world = work->leafless;
    return status;
}

void pp_annual_seasons_clear(struct pp_annual_work *work)
{
    pp_device_states_destroy(work->season);
    pp_device_states_destroy(work->leafless);
    free(work->is_bare);
}

void pp_annual_seasons_merge_sun(struct pp_annual_work *work)
{
    size_t count = (size_t)work->year->sky_count;
    size_t rows = (size_t)work->receiver_count * (size_t)work->groups.count;
    for (size_t row = 0; row < rows; row++)
        for (size_t t = 0; t < count; t++)
            if (work->is_bare[t])
                work->open.direct_sun[row * count + t] =
                    work->bare.direct_sun[row * count + t];
}

void pp_annual_seasons_merge(const struct pp_annual_work *work, float *light,
                             const float *bare, size_t rows)
{
    size_t count = (size_t)work->year->sky_count, step = work->open.step;
    for (size_t row = 0; row < rows; row++)
        for (size_t t = 0; t < count; t++)
            if (work->is_bare[t])
                light[row * step + t] = bare[row * step + t];
}

enum pp_status pp_annual_seasons_on_panes(const struct pp_annual_work *work, int group,
                                          float *on_panes, struct pp_error *err)
{
    pp_year_coefficients_on_panes(work->open.coefficients, group, on_panes);
    if (!work->leafless)
        return PP_OK;
    float *bare = calloc(PP_YEAR_BATCHES * work->open.step + 1, sizeof *bare);
    if (!bare)
        return pp_fail_memory(err);
    pp_year_coefficients_on_panes(work->bare.coefficients, group, bare);
    pp_annual_seasons_merge(work, on_panes, bare, PP_YEAR_BATCHES);
    free(bare);
    return PP_OK;
}

/* Gives the state its world in one season. */
static enum pp_status set_season(struct pp_annual_state *state, bool is_bare,
                                 struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (state->turned)
        state->turned->trees_are_bare = is_bare;
    else
        status = pp_trees_in_season(&state->turned, state->world, is_bare, err);
    if (status == PP_OK)
        state->world = state->turned;
    return status;
}

/* Moves the shares of hours without leaves to another state. */
static void move_bare_shares(const struct pp_annual_work *work, float *from, float *to)
{
    size_t skies = (size_t)work->year->sky_count;
    for (int g = 0; g < work->groups.count; g++)
        for (size_t t = 0; t < skies; t++)
            if (work->is_bare[t]) {
                to[(size_t)g * skies + t] = from[(size_t)g * skies + t];
                from[(size_t)g * skies + t] = 0.0f;
            }
}

/* True if the state has a share of an hour of that season. */
static bool has_season(const struct pp_annual_work *work, const float *share,
                       bool is_bare)
{
    size_t skies = (size_t)work->year->sky_count;
    for (int g = 0; g < work->groups.count; g++)
        for (size_t t = 0; t < skies; t++)
            if (share[(size_t)g * skies + t] > 0.0f && work->is_bare[t] == is_bare)
                return true;
    return false;
}

/* Appends the state with its hours without leaves to the closed states. */
static enum pp_status append_bare(struct pp_annual_work *work,
                                  struct pp_annual_state *leafy, struct pp_error *err)
{
    size_t shares = (size_t)work->groups.count * (size_t)work->year->sky_count + 1;
    struct pp_annual_state *bare = &work->closed[work->closed_count++];
    *bare = (struct pp_annual_state){.share = calloc(shares, sizeof(float))};
    if (!bare->share)
        return pp_fail_memory(err);
    move_bare_shares(work, leafy->share, bare->share);
    enum pp_status status = pp_device_states_copy(&bare->turned, leafy->world, err);
    return status == PP_OK ? set_season(bare, true, err) : status;
}

enum pp_status pp_annual_seasons_divide(struct pp_annual_work *work,
                                        struct pp_error *err)
{
    int count = work->closed_count;
    enum pp_status status = PP_OK;
    for (int s = 0; s < count && work->season && status == PP_OK; s++) {
        struct pp_annual_state *state = &work->closed[s];
        bool bare = has_season(work, state->share, true);
        bool leafy = has_season(work, state->share, false);
        if (bare && leafy)
            status = append_bare(work, state, err);
        if (status == PP_OK)
            status = set_season(state, bare && !leafy, err);
    }
    return status;
}
