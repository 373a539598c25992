/* sweep.c - see sweep.h. */
#include "studies/sweep.h"

#include <math.h>
#include <stdlib.h>

int pp_sweep_count(const struct pp_sweep *sweep)
{
    double count = 1.0;
    for (int i = 0; i < sweep->axis_count; i++)
        count *= sweep->axes[i].count;
    return (int)fmin(count, 2.0 * PP_SWEEP_RUNS_MOST);
}

const char *pp_sweep_value(const struct pp_sweep *sweep, int run, int axis)
{
    for (int i = sweep->axis_count - 1; i > axis; i--)
        run /= sweep->axes[i].count;
    return sweep->axes[axis].values[run % sweep->axes[axis].count];
}

enum pp_status pp_sweep_choose(struct pp_sweep *sweep, int run, struct pp_error *err)
{
    int count = sweep->set_count + sweep->axis_count;
    free(sweep->now.list);
    sweep->now.count = 0;
    sweep->now.list = calloc((size_t)count + 1, sizeof *sweep->now.list);
    if (!sweep->now.list)
        return pp_fail_memory(err);
    for (int i = 0; i < sweep->set_count; i++)
        sweep->now.list[sweep->now.count++] = sweep->set[i];
    for (int i = 0; i < sweep->axis_count; i++)
        sweep->now.list[sweep->now.count++] = (struct pp_room_change){
            sweep->axes[i].address, pp_sweep_value(sweep, run, i)};
    return PP_OK;
}

void pp_sweep_clear(struct pp_sweep *sweep)
{
    for (int i = 0; i < sweep->set_count; i++) {
        free((char *)sweep->set[i].address);
        free((char *)sweep->set[i].value);
    }
    for (int i = 0; i < sweep->axis_count; i++) {
        free(sweep->axes[i].address);
        for (int k = 0; k < sweep->axes[i].count; k++)
            free(sweep->axes[i].values[k]);
        free(sweep->axes[i].values);
    }
    free(sweep->set);
    free(sweep->now.list);
    *sweep = (struct pp_sweep){0};
}
