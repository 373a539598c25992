/* size_options.h - what is asked of the command size. */
#ifndef PP_CLI_SIZE_SIZE_OPTIONS_H
#define PP_CLI_SIZE_SIZE_OPTIONS_H

#include <stdbool.h>

#include "cli/print/format.h"
#include "cli/room_options.h"
#include "studies/sizing/window_sizes.h"

struct pp_size_options {
    struct pp_room_options room;
    double target;  /* a fraction; 0: not given */
    const char *by; /* a method, a pair, or "traced"; NULL: what covers the room */
    bool traced;    /* by is "traced" */
    enum pp_size_change change;
    const char *wall;  /* only windows in that wall; NULL: any */
    long line;         /* only the opening on that line of the file; 0: any */
    const char *write; /* where the changed room file goes; NULL: nowhere */
    enum pp_format format;
};

/* As typed after --change: "width". */
extern const char *const pp_size_change_words[];

/* The options of the command, apart from the simulation's and the output's; with a
 * struct pp_size_options as values. */
extern const struct pp_option pp_size_task_options[];
extern const struct pp_option pp_size_write_option[];

/* Do they make sense together? PP_BAD_INPUT if not. */
enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err);

#endif
