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
    struct pp_size_request request; /* study is set by pp_size_options_settle */
    const char *write;              /* path for the changed room file; NULL: none */
    const char *obstruction;        /* name of the block whose height is searched; NULL:
                                     * none */
    const char *envelope; /* name of the block on whose plot the largest envelope is
                           * searched; NULL: none */
    const char *draw;     /* path for the drawing of the envelope; NULL: none */
    double highest_m;     /* upper limit of the block's height, or of the envelope's */
    struct pp_retained_sky_rule
        rule; /* share of sky that each window or room retains; its room is set by
               * pp_size_options_settle */
    enum pp_format format;
};

/* Default share of the former sky that windows and rooms retain [BR209]. */
#define PP_SIZE_OPTIONS_KEEP 0.8

/* Greatest height considered for a block: few buildings are higher. */
#define PP_SIZE_OPTIONS_HIGHEST_M 300.0

/* The block to be sized instead of a window; NULL: none. */
const char *pp_size_options_block(const struct pp_size_options *options);

/* The options of the command, except those for simulation and output; the values are
 * stored in a struct pp_size_options. */
extern const struct pp_option pp_size_task_options[];
extern const struct pp_option pp_size_write_option[];
extern const struct pp_option pp_size_block_options[];

/* PP_BAD_INPUT if the options contradict each other. */
enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err);

#endif
