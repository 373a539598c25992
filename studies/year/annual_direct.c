/* annual_direct.c - direct sun at the points, and the hours in which it, or the chosen
 * control, closes blinds. */
#include "model/results/sheets/point_areas.h"
#include "studies/year/annual_seasons.h"
#include "studies/year/annual_work.h"

bool pp_annual_direct_see(void *data, int worker, int x)
{
    struct pp_annual_work *work = data;
    (void)worker;
    work->status[x] = pp_annual_state_see(work->state, work, x);
    return work->status[x] == PP_OK;
}

bool pp_annual_direct_has_device(const struct pp_annual_work *work, int group)
{
    if (!work->opened)
        return false;
    for (int i = 0; i < work->world->opening_count; i++)
        if (work->groups.of_opening[i] == group
            && work->world->openings[i].device.kind != PP_DEVICE_NONE)
            return true;
    return false;
}

/* LM-83: true if the sun through the group in that hour of the state closes blinds. */
static bool is_sunlit(const struct pp_annual_work *work,
                      const struct pp_annual_state *state, int group, int hour)
{
    static const float SUNLIT_LX = 1000.0f;
    size_t count = (size_t)state->count;
    double sunlit = 0.0;
    for (int x = 0; x < work->receiver_count; x++)
        if (state->direct_sun[((size_t)x * (size_t)work->groups.count + (size_t)group)
                                  * count
                              + (size_t)hour]
            >= SUNLIT_LX)
            sunlit += pp_point_areas_weight(work->receivers, work->area_m2, x);
    return pp_blind_groups_closes(sunlit, work->whole);
}

/* True if the control closes the group in record i of the year. */
static bool closes_at(const struct pp_annual_work *work, int group, bool device, int i)
{
    const struct pp_annual_options *options = work->options;
    int sky = work->year->hours[i].sky;
    switch (options->blinds) {
    case PP_BLINDS_LM83:
        return sky >= 0 && is_sunlit(work, &work->open, group, sky);
    case PP_BLINDS_ALWAYS:
        return device;
    case PP_BLINDS_SCHEDULE:
        return device && options->schedule[i];
    case PP_BLINDS_AS_DRAWN:
    case PP_BLINDS_NEVER:
        break;
    }
    return false;
}

enum pp_status pp_annual_direct_find(struct pp_annual_work *work, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    int count = work->year->sky_count;
    for (int g = 0; g < work->groups.count && status == PP_OK; g++) {
        bool device = pp_annual_direct_has_device(work, g);
        for (int i = 0; i < work->year->count; i++) {
            int sky = work->year->hours[i].sky;
            if (!closes_at(work, g, device, i))
                continue;
            work->sheet->groups[g].closed_h += work->sheet->hours[i].occupied_h;
            if (sky >= 0)
                work->closes[(size_t)g * (size_t)count + (size_t)sky] = true;
        }
        if (!device && work->options->blinds == PP_BLINDS_LM83
            && work->open.coefficients)
            status = pp_annual_seasons_on_panes(
                work, g,
                work->on_panes + (size_t)(g * PP_YEAR_BATCHES) * work->open.step, err);
    }
    return status;
}

/* True if an earlier state than s has a share of the group's light, too. */
static bool is_in_earlier(const struct pp_annual_work *work, int s, size_t at)
{
    for (int k = 0; k < s; k++)
        if (work->closed[k].share[at] > 0.0f)
            return true;
    return false;
}

void pp_annual_direct_count_unmet(struct pp_annual_work *work)
{
    size_t skies = (size_t)work->year->sky_count;
    for (int s = 0; s < work->closed_count; s++)
        for (int g = 0; g < work->groups.count; g++)
            for (int i = 0; i < work->closed[s].count; i++) {
                int sky = work->closed[s].hours[i];
                size_t at = (size_t)g * skies + (size_t)sky;
                if (work->closes[at] && work->closed[s].share[at] > 0.0f
                    && !is_in_earlier(work, s, at)
                    && is_sunlit(work, &work->closed[s], g, i))
                    work->sheet->groups[g].unmet_h += work->clock.occupied_h[sky];
            }
}
