/* sweep.h - changes to attributes of room files: fixed values, and values that differ
 * from run to run.
 *
 * There is a run for each combination of values of the swept attributes. The attribute
 * swept last changes fastest.
 */
#ifndef PP_STUDIES_SWEEP_H
#define PP_STUDIES_SWEEP_H

#include "model/base/error.h"
#include "model/room/text/room_change.h"

enum { PP_SWEEP_RUNS_MOST = 1000, PP_SWEEP_AXES_MOST = 8 };

/* An attribute and its values; owned. */
struct pp_sweep_axis {
    char *address;
    char **values;
    int count;
};

struct pp_sweep {
    struct pp_room_change *set; /* changes given by --set; owned, including their
                                 * texts */
    int set_count;
    struct pp_sweep_axis axes[PP_SWEEP_AXES_MOST];
    int axis_count;             /* 0: no --sweep */
    struct pp_room_changes now; /* changes of the current run; owned */
};

/* Number of runs, but at most 2 PP_SWEEP_RUNS_MOST; 1 if there are no axes. */
int pp_sweep_count(const struct pp_sweep *sweep);

/* Value of an axis in the given run. */
const char *pp_sweep_value(const struct pp_sweep *sweep, int run, int axis);

/* Sets sweep->now to the changes of the given run. PP_SYSTEM: out of memory. */
enum pp_status pp_sweep_choose(struct pp_sweep *sweep, int run, struct pp_error *err);

void pp_sweep_clear(struct pp_sweep *sweep);

#endif
