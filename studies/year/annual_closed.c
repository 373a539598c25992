/* annual_closed.c - the states of a year's closed windows: one with devices as they are
 * drawn, and some with slats that follow the sun at angles of equal steps.
 *
 * The light of the sky through slats that follow the sun is interpolated between the
 * two nearest angles. Light of the sun needs no interpolation: every state calculates
 * it for the slats at their exact angle (model/light/slats/blind_follow.h).
 */
#include <math.h>
#include <stdlib.h>

#include "model/room/build/device_states.h"
#include "studies/year/annual_work.h"

enum { STEPS = 18, ANGLES = 2 * STEPS + 1 }; /* -90 to 90 degrees */
#define STEP_RAD (0.5 * PP_PI / STEPS)

/* Index of the state with devices as drawn; before it, those by angle. */
enum { DRAWN = ANGLES, STATES };

struct closed_plan {
    struct pp_annual_work *work;
    float *share[STATES]; /* [group][sky]; NULL: not needed */
    size_t skies;
};

static enum pp_status take(struct closed_plan *plan, int state, size_t at, float share)
{
    size_t groups = (size_t)plan->work->groups.count;
    if (!(share > 0.0f))
        return PP_OK;
    if (!plan->share[state])
        plan->share[state] = calloc(groups * plan->skies + 1, sizeof(float));
    if (!plan->share[state])
        return pp_fail_memory(NULL);
    plan->share[state][at] += share;
    plan->work->taken[at] = true;
    return PP_OK;
}

/* An opening of the group with slats that follow the sun; NULL: there is none. Such
 * openings of a group are alike. */
static const struct pp_opening *following(const struct pp_annual_work *work, int group)
{
    for (int i = 0; i < work->world->opening_count; i++)
        if (work->groups.of_opening[i] == group
            && pp_device_states_follows(&work->world->openings[i]))
            return &work->world->openings[i];
    return NULL;
}

static enum pp_status share_turned(struct closed_plan *plan, int group,
                                   const struct pp_opening *opening)
{
    enum pp_status status = PP_OK;
    for (size_t t = 0; t < plan->skies && status == PP_OK; t++) {
        size_t at = (size_t)group * plan->skies + t;
        const struct pp_perez_sky *sky = &plan->work->open.skies[t];
        if (!plan->work->closes[at])
            continue;
        double tilt =
            sky->direct_lx > 0.0 ? pp_device_states_tilt(opening, sky->sun) : 0.0;
        double steps = tilt / STEP_RAD + STEPS;
        int low = (int)fmin(floor(steps), ANGLES - 2);
        float part = (float)(steps - low);
        status = take(plan, low, at, 1.0f - part);
        if (status == PP_OK)
            status = take(plan, low + 1, at, part);
    }
    return status;
}

static enum pp_status share_drawn(struct closed_plan *plan, int group)
{
    enum pp_status status = PP_OK;
    for (size_t t = 0; t < plan->skies && status == PP_OK; t++)
        if (plan->work->closes[(size_t)group * plan->skies + t])
            status = take(plan, DRAWN, (size_t)group * plan->skies + t, 1.0f);
    return status;
}

/* The light of an open group without a device is that of the states of the first closed
 * group, whose blinds reflect this light. */
static enum pp_status share_open(struct closed_plan *plan, int group)
{
    const struct pp_annual_work *work = plan->work;
    enum pp_status status = PP_OK;
    for (size_t t = 0; t < plan->skies; t++) {
        size_t at = (size_t)group * plan->skies + t;
        for (int g = 0; g < work->groups.count && !work->closes[at]; g++) {
            size_t from = (size_t)g * plan->skies + t;
            if (!work->closes[from] || !pp_annual_direct_has_device(work, g))
                continue;
            for (int s = 0; s < STATES && status == PP_OK; s++)
                if (plan->share[s])
                    status = take(plan, s, at, plan->share[s][from]);
            break;
        }
    }
    return status;
}

static enum pp_status share_groups(struct closed_plan *plan)
{
    int groups = plan->work->groups.count;
    enum pp_status status = PP_OK;
    for (int g = 0; g < groups && status == PP_OK; g++) {
        const struct pp_opening *opening = following(plan->work, g);
        if (pp_annual_direct_has_device(plan->work, g))
            status = opening ? share_turned(plan, g, opening) : share_drawn(plan, g);
    }
    for (int g = 0; g < groups && status == PP_OK; g++)
        if (!pp_annual_direct_has_device(plan->work, g))
            status = share_open(plan, g);
    return status;
}

enum pp_status pp_annual_closed_plan(struct pp_annual_work *work, struct pp_error *err)
{
    struct closed_plan plan = {.work = work, .skies = (size_t)work->year->sky_count};
    const struct pp_world *other = NULL;
    work->closed = calloc(2 * STATES, sizeof *work->closed);
    enum pp_status status = work->closed ? share_groups(&plan) : PP_SYSTEM;
    if (status != PP_OK)
        status = pp_fail_memory(err);
    for (int s = 0; s < STATES; s++) {
        if (status != PP_OK || !plan.share[s]) {
            free(plan.share[s]);
            continue;
        }
        struct pp_annual_state *state = &work->closed[work->closed_count++];
        *state = (struct pp_annual_state){.world = work->world, .share = plan.share[s]};
        if (s == DRAWN)
            continue;
        status = pp_device_states_tilted(&state->turned, work->world,
                                         (s - STEPS) * STEP_RAD, other, err);
        state->world = other = state->turned;
    }
    return status;
}
