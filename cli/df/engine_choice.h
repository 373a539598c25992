/* engine_choice.h - the engines that `df --simulate` uses, and the options of the
 * cache. */
#ifndef PP_CLI_DF_ENGINE_CHOICE_H
#define PP_CLI_DF_ENGINE_CHOICE_H

#include "cli/cache_choice.h"
#include "cli/options.h"

struct pp_engine_choice {
    unsigned engines; /* bit i: engine i of the list is selected; 0: path tracer */
    bool interpolate;
    double sensor_m; /* radius (m) of the discs on which photons are counted; 0: not
                      * given */
    struct pp_cache_choice cache;
};

bool pp_engine_choice_has(const struct pp_engine_choice *choice, int engine);

/* Options --engine, --sensor and --interpolate; the values are stored in a struct
 * pp_engine_choice. */
extern const struct pp_option pp_engine_options[];

/* Checks the options. PP_BAD_INPUT if --engine is given without --simulate, or an
 * option without the engine that it requires. */
enum pp_status pp_engine_choice_settle(struct pp_engine_choice *words, bool simulate,
                                       struct pp_error *err);

#endif
