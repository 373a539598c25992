/* atlas_sweep.h - computes the rooms of an atlas, and recalculates the values of hand
 * methods in an existing atlas. */
#ifndef PP_CLI_ATLAS_ATLAS_SWEEP_H
#define PP_CLI_ATLAS_ATLAS_SWEEP_H

#include "cli/exit_status.h"
#include "cli/room_options.h"
#include "studies/research/atlas/atlas_columns.h"
#include "studies/research/atlas/atlas_drawn.h"

/* Settings that determine, with the methods, the rows of a file. */
struct pp_atlas_making {
    enum pp_atlas_sky sky;
    struct pp_atlas_trace trace;
};

/* Appends rooms to the output file until it contains the first `rooms` rooms of the
 * atlas. */
enum pp_exit pp_atlas_sweep_on(const struct pp_atlas_making *making, int rooms,
                               const struct pp_room_options *options);

/* Recalculates the values of hand methods in the atlas `path`, keeps its simulated
 * values, and writes the result to the output in one step. */
enum pp_exit pp_atlas_sweep_anew(const char *path,
                                 const struct pp_room_options *options);

#endif
