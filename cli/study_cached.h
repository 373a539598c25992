/* study_cached.h - a room's daylight factors by the irradiance cache, for a report. */
#ifndef PP_CLI_STUDY_CACHED_H
#define PP_CLI_STUDY_CACHED_H

#include "cli/render/cache_choice.h"
#include "cli/room_options.h"
#include "model/results/report.h"

/* Which engines `df --simulate` uses, and how the cache is made. */
struct pp_engine_choice {
    const char *engines; /* as typed: path, cache or path,cache; NULL: path */
    bool interpolate;
    struct pp_cache_choice cache;
    bool path, cached; /* settled */
};

/* --engine, --interpolate; values are a struct pp_engine_choice. */
extern const struct pp_option pp_engine_options[];

/* What is set without --engine cache, two rooms in one cache file ...: PP_BAD_INPUT. */
enum pp_status pp_study_cached_settle(struct pp_engine_choice *words, bool simulate,
                                      struct pp_error *err);

/* Adds the columns "cached", until done, out of time, or interrupted. */
enum pp_status pp_study_cached_add(struct pp_report *report,
                                   const struct pp_room_options *options,
                                   const struct pp_engine_choice *words, bool *by_clock,
                                   struct pp_error *err);

#endif
