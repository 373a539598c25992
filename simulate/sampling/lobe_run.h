/* lobe_run.h - cosine-weighted directions of a run. */
#ifndef PP_SIMULATE_SAMPLING_LOBE_RUN_H
#define PP_SIMULATE_SAMPLING_LOBE_RUN_H

#include "model/geometry/frame.h"
#include "simulate/sampling/lanes.h"

/* Computes pp_lobe_sample_in_frame of u[0][i] and u[1][i] for the first `count`
 * directions (at most PP_RUN_MOST); results are bit-identical. Further directions up to
 * a multiple of PP_LANES are undefined. */
void pp_lobe_run(const struct pp_frame *frame, double u[2][PP_RUN_MOST], int count,
                 struct pp_lanes_directions *to);

#endif
