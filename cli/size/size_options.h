/* size_options.h - what is asked of the command size. */
#ifndef PP_CLI_SIZE_SIZE_OPTIONS_H
#define PP_CLI_SIZE_SIZE_OPTIONS_H

#include <stdbool.h>

#include "cli/room_options.h"
#include "reports/parts/format.h"
#include "studies/sizing/retained_sky.h"
#include "studies/sizing/size_room.h"

struct pp_size_options {
    struct pp_room_options room;
    struct pp_size_request request; /* its study is set by pp_size_options_settle */
    const char *write;       /* where the changed room file goes; NULL: nowhere */
    const char *obstruction; /* the block whose height is asked for; NULL: none */
    const char *envelope;    /* the block on whose plot the largest envelope is; NULL */
    const char *draw;        /* the file that the envelope is drawn to; NULL: none */
    double highest_m;        /* of either */
    struct pp_retained_sky_rule
        rule; /* what each window or room keeps then; its room is set by
               * pp_size_options_settle */
    enum pp_format format;
};

/* The least share that windows and rooms keep, unless told otherwise [BR209]. */
#define PP_SIZE_OPTIONS_KEEP 0.8

/* Nobody builds higher beside a house. */
#define PP_SIZE_OPTIONS_HIGHEST_M 300.0

/* The block that is asked about in place of a window; NULL: none. */
const char *pp_size_options_block(const struct pp_size_options *options);

/* The options of the command, apart from the simulation's and the output's; with a
 * struct pp_size_options as values. */
extern const struct pp_option pp_size_task_options[];
extern const struct pp_option pp_size_write_option[];
extern const struct pp_option pp_size_block_options[];

/* PP_BAD_INPUT if they contradict each other. */
enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err);

#endif
