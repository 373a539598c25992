/* block_height.c - see block_height.h. */
#include "studies/sizing/block_height.h"

#include <math.h>

enum { STEPS_MOST = 60 };
static const double share_tolerance[] = {
    [PP_SKY_DUES_VSC] = 1e-6, [PP_SKY_DUES_LIT_AREA] = 1e-4};
static const double height_tolerance_m = 1e-5;
static const double lowest_m = 0.002; /* nothing, and yet a block */

/* The building as proposed, with the block so high. */
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
    return status == PP_OK
               ? pp_sky_dues_before(&found->dues, &task->rule, task->building, err)
               : status;
}

static enum pp_status surplus_at(double *value, struct pp_block_height *found,
                                 const struct pp_block_height_task *task,
                                 double height_m, struct pp_error *err)
{
    enum pp_status status = raise_block(task, height_m, err);
    if (status == PP_OK)
        status = pp_sky_dues_after(&found->dues, &task->rule, task->building, err);
    *value = pp_sky_dues_surplus(&found->dues, &task->rule, &found->deciding);
    return status;
}

/* Between `low_m`, where everyone has his due, and `high_m`, where one has not. */
static enum pp_status narrow(struct pp_block_height *found,
                             const struct pp_block_height_task *task, double low_m,
                             double at_low, double high_m, double at_high,
                             struct pp_error *err)
{
    enum pp_status status = PP_OK;
    int side = 0;
    double value = NAN, tolerance = share_tolerance[task->rule.of];
    for (int step = 0;
         step < STEPS_MOST && status == PP_OK && !(high_m - low_m < height_tolerance_m);
         step++) {
        double middle = low_m + (high_m - low_m) * at_low / (at_low - at_high);
        status = surplus_at(&value, found, task, middle, err);
        found->height_m = middle;
        if (fabs(value) < tolerance)
            return status;
        if (value > 0.0) {
            low_m = middle;
            at_low = value;
            at_high *= side > 0 ? 0.5 : 1.0;
            side = 1;
        } else {
            high_m = middle;
            at_high = value;
            at_low *= side < 0 ? 0.5 : 1.0;
            side = -1;
        }
    }
    found->height_m = low_m;
    return status == PP_OK ? surplus_at(&value, found, task, low_m, err) : status;
}

enum pp_status pp_block_height_find(struct pp_block_height *found,
                                    const struct pp_block_height_task *task,
                                    struct pp_error *err)
{
    *found = (struct pp_block_height){
        .now_m = pp_building_block_height(task->building, task->block),
        .height_m = NAN,
        .deciding = -1};
    double at_low = 0.0, at_high = 0.0;
    enum pp_status status =
        pp_building_set_state(task->building, PP_STATE_PROPOSED, err);
    if (status == PP_OK)
        status = pp_sky_dues_list(&found->dues, &task->rule, task->building, err);
    if (status == PP_OK)
        status = look_before(found, task, err);
    if (status == PP_OK)
        status = surplus_at(&at_high, found, task, task->most_m, err);
    if (status == PP_OK && !(at_high < 0.0)) {
        found->verdict = PP_BLOCK_HEIGHT_ANY;
        found->height_m = task->most_m;
        return PP_OK;
    }
    if (status == PP_OK)
        status = surplus_at(&at_low, found, task, lowest_m, err);
    if (status == PP_OK && at_low < 0.0) {
        found->verdict = PP_BLOCK_HEIGHT_NONE;
        return PP_OK;
    }
    if (status == PP_OK)
        status = narrow(found, task, lowest_m, at_low, task->most_m, at_high, err);
    return status;
}

void pp_block_height_clear(struct pp_block_height *found)
{
    pp_sky_dues_clear(&found->dues);
    *found = (struct pp_block_height){0};
}
