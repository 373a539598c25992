/* size_options.h - the options of the command size. */
#ifndef PP_CLI_SIZE_SIZE_OPTIONS_H
#define PP_CLI_SIZE_SIZE_OPTIONS_H

#include <stdbool.h>

#include "cli/room_options.h"
#include "reports/parts/format.h"
#include "studies/sizing/retained_sky.h"
#include "studies/sizing/size_room.h"

struct pp_size_options {
    struct pp_room_options room;
    struct pp_size_request request; /* pp_size_options_settle sets the member `study` */
    const char *write;              /* path of the new room file; NULL: none */
    const char *obstruction;        /* name of the block whose greatest height is
                                     * calculated; NULL: none */
    const char *envelope; /* name of the block on whose plot the largest envelope is
                           * calculated; NULL: none */
    const char *draw;     /* path of the drawing of the envelope; NULL: none */
    double highest_m;     /* upper limit for the height of the block or the envelope */
    struct pp_retained_sky_rule
        rule; /* fraction of sky that each window or room must keep;
               * pp_size_options_settle sets the member `room` */
    enum pp_format format;
};

/* Default fraction of the former sky that windows and rooms must keep [BR209]. */
#define PP_SIZE_OPTIONS_KEEP 0.8

/* Default upper limit for the height of a block, m. Few buildings are higher. */
#define PP_SIZE_OPTIONS_HIGHEST_M 300.0

/* Name of the block to be sized instead of a window; NULL: none. */
const char *pp_size_options_block(const struct pp_size_options *options);

/* Options of the command, except those for simulation and output. The values are stored
 * in a struct pp_size_options. */
extern const struct pp_option pp_size_task_options[];
extern const struct pp_option pp_size_write_option[];
extern const struct pp_option pp_size_block_options[];

/* Checks the options; PP_BAD_INPUT if they are inconsistent. */
enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err);

#endif
