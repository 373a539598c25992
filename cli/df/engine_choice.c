/* engine_choice.c - reads the list of engines and checks the options that apply to one
 * engine only. */
#include "cli/df/engine_choice.h"

#include <string.h>

#include "model/base/text.h"
#include "studies/engines/engine.h"

static enum pp_status refuse_engine_choice(struct pp_error *err)
{
    char names[128] = "";
    const struct pp_engine *engine;
    for (int i = 0; (engine = pp_engine_at(i)) != NULL; i++)
        pp_text_append(names, sizeof names, "%s%s",
                       i == 0                ? ""
                       : pp_engine_at(i + 1) ? ", "
                                             : " or ",
                       engine->name);
    return pp_fail(err, PP_BAD_INPUT, "%s, or several of these, separated by commas",
                   names);
}

/* Index in the list of engines; -1: there is no engine of that name. */
static int find_engine(const char *name, size_t length)
{
    const struct pp_engine *engine;
    for (int i = 0; (engine = pp_engine_at(i)) != NULL; i++)
        if (strlen(engine->name) == length && strncmp(engine->name, name, length) == 0)
            return i;
    return -1;
}

static enum pp_status read_engines(const char *text, void *place, struct pp_error *err)
{
    unsigned engines = 0;
    for (const char *at = text;; at++) {
        size_t length = strcspn(at, ",");
        int engine = find_engine(at, length);
        if (engine < 0 || engines & 1u << engine)
            return refuse_engine_choice(err);
        engines |= 1u << engine;
        at += length;
        if (!*at)
            break;
    }
    *(unsigned *)place = engines;
    return PP_OK;
}

bool pp_engine_choice_has(const struct pp_engine_choice *choice, int engine)
{
    return choice->engines ? choice->engines >> engine & 1u
                           : pp_engine_at(engine) == &pp_engine_path;
}

static bool has(const struct pp_engine_choice *choice, const struct pp_engine *engine)
{
    for (int i = 0; pp_engine_at(i); i++)
        if (pp_engine_at(i) == engine)
            return pp_engine_choice_has(choice, i);
    return false;
}

static enum pp_status read_sensor(const char *text, void *place, struct pp_error *err)
{
    double radius;
    if (!pp_text_parse_number(text, &radius) || !(radius >= 0.001 && radius <= 10.0))
        return pp_fail(err, PP_BAD_INPUT, "a radius of 0.001 to 10 m");
    *(double *)place = radius;
    return PP_OK;
}

const struct pp_option pp_engine_options[] = {
    {"engine", 0, "LIST",
     "Simulation engine, or several separated by commas to compare them (such as "
     "path,photons). path (default): unbiased paths from the points; photons: "
     "unbiased paths from the openings; radiosity: finite elements; cache: "
     "irradiance cache; plain: textbook path tracing, slower.",
     read_engines, offsetof(struct pp_engine_choice, engines)},
    {"sensor", 0, "RADIUS",
     "Count photons on discs of this radius in metres around the points, instead of "
     "connecting each photon to the points.",
     read_sensor, offsetof(struct pp_engine_choice, sensor_m)},
    {"interpolate", 0, NULL,
     "Interpolate reflected light from the cache at the points as well.", NULL,
     offsetof(struct pp_engine_choice, interpolate)},
    {0},
};

enum pp_status pp_engine_choice_settle(struct pp_engine_choice *words, bool simulate,
                                       struct pp_error *err)
{
    const bool cached = has(words, &pp_engine_cache);
    if (words->engines && !simulate)
        return pp_fail(err, PP_BAD_INPUT,
                       "--engine selects a simulation; expected --simulate as well");
    if (words->sensor_m > 0.0 && !has(words, &pp_engine_photons))
        return pp_fail(err, PP_BAD_INPUT, "--sensor needs --engine photons");
    if (words->interpolate && !cached)
        return pp_fail(err, PP_BAD_INPUT, "--interpolate needs --engine cache");
    const char *used = pp_cache_choice_used(&words->cache);
    if (!used && words->cache.options.bounces != pp_irradiance_cache_defaults().bounces)
        used = "--bounces"; /* the path tracer has no limit on bounces */
    if (used && !cached)
        return pp_fail(err, PP_BAD_INPUT, "%s needs --engine cache", used);
    return pp_cache_choice_settle(&words->cache, err);
}
