/* block_height.c - see block_height.h. */
#include "studies/sizing/block_height.h"

#include <math.h>

#include "studies/sizing/root_bracket.h"

static const double share_tolerance[] = {
    [PP_RETAINED_SKY_VSC] = 1e-6, [PP_RETAINED_SKY_LIT_AREA] = 1e-4};
static const double height_tolerance_m = 1e-5;
static const double lowest_m = 0.002; /* height of the lowest block tried, which hides
                                       * almost nothing */

/* Changes the proposed building so that the block has the given height. */
static enum pp_status raise_block(const struct pp_block_height_task *task,
                                  double height_m, struct pp_error *err)
{
    pp_building_set_block_height(task->building, task->block, height_m);
    return pp_building_set_state(task->building, PP_STATE_PROPOSED, err);
}

static enum pp_status look_before(struct pp_block_height *found,
                                  const struct pp_block_height_task *task,
                                  struct pp_error *err)
{
    enum pp_status status =
        pp_building_has_states(task->building)
            ? pp_building_set_state(task->building, PP_STATE_EXISTING, err)
            : raise_block(task, lowest_m, err);
    return status == PP_OK ? pp_retained_sky_before(&found->retained, &task->rule,
                                                    task->building, err)
                           : status;
}

struct height_search {
    struct pp_block_height *found;
    const struct pp_block_height_task *task;
};

static enum pp_status surplus_at(void *context, double height_m, double *value,
                                 struct pp_error *err)
{
    const struct height_search *search = context;
    const struct pp_block_height_task *task = search->task;
    struct pp_block_height *found = search->found;
    enum pp_status status = raise_block(task, height_m, err);
    if (status == PP_OK)
        status =
            pp_retained_sky_after(&found->retained, &task->rule, task->building, err);
    *value = pp_retained_sky_surplus(&found->retained, &task->rule, &found->deciding);
    return status;
}

enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err)
{
    *found = (struct pp_block_height){
        .now_m = pp_building_block_height(task->building, task->block),
        .height_m = NAN,
        .deciding = -1};
    struct height_search search = {found, task};
    struct pp_root_bracket_range range = {.low = lowest_m,
                                          .high = task->most_m,
                                          .near_value = share_tolerance[task->rule.of],
                                          .near_argument = height_tolerance_m};
    enum pp_status status =
        pp_building_set_state(task->building, PP_STATE_PROPOSED, err);
    if (status == PP_OK)
        status =
            pp_retained_sky_list(&found->retained, &task->rule, task->building, err);
    if (status == PP_OK)
        status = look_before(found, task, err);
    if (status == PP_OK)
        status = surplus_at(&search, range.high, &range.at_high, err);
    if (status == PP_OK && !(range.at_high < 0.0)) {
        found->verdict = PP_BLOCK_HEIGHT_ANY;
        found->height_m = task->most_m;
        return PP_OK;
    }
    if (status == PP_OK)
        status = surplus_at(&search, range.low, &range.at_low, err);
    if (status == PP_OK && range.at_low < 0.0) {
        found->verdict = PP_BLOCK_HEIGHT_NONE;
        return PP_OK;
    }
    if (status == PP_OK)
        status =
            pp_root_bracket_find(&found->height_m, &range, surplus_at, &search, err);
    return status;
}

void pp_block_height_clear(struct pp_block_height *found)
{
    pp_retained_sky_clear(&found->retained);
    *found = (struct pp_block_height){0};
}
