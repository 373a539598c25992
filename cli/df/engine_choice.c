/* engine_choice.c - reads the list of engines and checks the options that belong to
 * one of them. */
#include "cli/df/engine_choice.h"

#include <string.h>

static enum pp_status read_engines(const char *text, void *place, struct pp_error *err)
{
    static const char *const lists[] = {"path", "cache", "path,cache", "cache,path"};
    for (int i = 0; i < 4; i++)
        if (strcmp(text, lists[i]) == 0) {
            *(const char **)place = lists[i];
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "path, cache or path,cache");
}

const struct pp_option pp_engine_options[] = {
    {"engine", 0, "LIST",
     "What simulates: path (default), without bias; cache, through an irradiance "
     "cache; or path,cache, and how far they are apart.",
     read_engines, offsetof(struct pp_engine_choice, engines)},
    {"interpolate", 0, NULL,
     "Interpolate what is reflected at the points, too, from the cache.", NULL,
     offsetof(struct pp_engine_choice, interpolate)},
    {0},
};

enum pp_status pp_engine_choice_settle(struct pp_engine_choice *words, bool simulate,
                                       struct pp_error *err)
{
    words->cached = words->engines && strstr(words->engines, "cache");
    words->path = !words->engines || strstr(words->engines, "path");
    if (words->engines && !simulate)
        return pp_fail(err, PP_BAD_INPUT,
                       "--engine says what simulates; it needs --simulate");
    if (words->interpolate && !words->cached)
        return pp_fail(err, PP_BAD_INPUT, "--interpolate needs --engine cache");
    const char *used = pp_cache_choice_used(&words->cache);
    if (!used && words->cache.options.bounces != pp_irradiance_cache_defaults().bounces)
        used = "--bounces"; /* the tracer has no limit */
    if (used && !words->cached)
        return pp_fail(err, PP_BAD_INPUT, "%s needs --engine cache", used);
    return pp_cache_choice_settle(&words->cache, err);
}
