/* cache_choice.c - reads the options of the irradiance cache, and opens and writes
 * its records file. */
#include "cli/cache_choice.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/output.h"
#include "studies/engines/cache_records.h"
#include "model/base/text.h"
#include "simulate/cache/cache_file.h"

static enum pp_status read_accuracy(const char *text, void *place, struct pp_error *err)
{
    double accuracy;
    if (!pp_text_parse_number(text, &accuracy) || !(accuracy > 0.0 && accuracy <= 1.0))
        return pp_fail(err, PP_BAD_INPUT, "a number above 0 and up to 1, such as 0.1");
    *(double *)place = accuracy;
    return PP_OK;
}

static enum pp_status read_int(const char *text, int least, int most, int *number,
                               struct pp_error *err)
{
    double value;
    if (!pp_text_parse_number(text, &value) || !(value >= least && value <= most)
        || value != (int)value)
        return pp_fail(err, PP_BAD_INPUT, "a whole number from %d to %d", least, most);
    *number = (int)value;
    return PP_OK;
}

static enum pp_status read_resolution(const char *text, void *place,
                                      struct pp_error *err)
{
    return read_int(text, 0, 1000000, place, err);
}

static enum pp_status read_divisions(const char *text, void *place,
                                     struct pp_error *err)
{
    return read_int(text, 16, 1048576, place, err);
}

static enum pp_status read_supersamples(const char *text, void *place,
                                        struct pp_error *err)
{
    return read_int(text, 0, 1048576, place, err);
}

static enum pp_status read_bounces(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "all") == 0) {
        *(int *)place = -1;
        return PP_OK;
    }
    if (read_int(text, 0, 1000, place, NULL) != PP_OK)
        return pp_fail(err, PP_BAD_INPUT, "a whole number from 0 to 1000, or all");
    return PP_OK;
}

/* Reads one number for all three colour channels, or three numbers separated by
 * commas. */
static enum pp_status read_ambient(const char *text, void *place, struct pp_error *err)
{
    char copy[128];
    double channels[3];
    int count = 0;
    bool good = strlen(text) < sizeof copy;
    if (good)
        strcpy(copy, text);
    for (char *rest = copy, *part; good && (part = strsep(&rest, ",")) != NULL; count++)
        good = count < 3 && pp_text_parse_number(part, &channels[count])
               && channels[count] >= 0.0 && channels[count] <= 1e6;
    if (!good || (count != 1 && count != 3))
        return pp_fail(err, PP_BAD_INPUT,
                       "a radiance of 0 or more, or three of them for red, green and "
                       "blue, separated by commas");
    *(struct pp_rgb *)place = count == 1
                                  ? pp_rgb_grey(channels[0])
                                  : pp_rgb(channels[0], channels[1], channels[2]);
    return PP_OK;
}

#define PLACE(member) offsetof(struct pp_cache_choice, member)

const struct pp_option pp_cache_choice_options[] = {
    {"accuracy -aa", 0, "A",
     "Permitted error of the cache. A smaller value places records closer together "
     "(default 0.1).",
     read_accuracy, PLACE(options.accuracy)},
    {"resolution -ar", 0, "N",
     "Place records no closer than the size of the room times the accuracy, divided by "
     "N (default 128; 0: no limit).",
     read_resolution, PLACE(options.resolution)},
    {"divisions -ad", 0, "N", "Rays per record (default 1024).", read_divisions,
     PLACE(options.divisions)},
    {"supersamples -as", 0, "N",
     "Extra rays for parts of the hemisphere that differ from their neighbours "
     "(default 256).",
     read_supersamples, PLACE(options.supersamples)},
    {"bounces -ab", 0, "N",
     "Maximum number of diffuse reflections. 0: direct light only; all: no limit "
     "(default).",
     read_bounces, PLACE(options.bounces)},
    {"ambient -av", 0, "L",
     "Radiance that replaces all light beyond the last reflection, divided by the "
     "external horizontal illuminance (default 0).",
     read_ambient, PLACE(options.constant)},
    {"include -ai", 0, "NAMES",
     "Calculate reflected light only for surfaces of these materials (floor, ceiling, "
     "south ..., separated by commas); the others get the value of --ambient.",
     pp_options_read_text, PLACE(include)},
    {"exclude -ae", 0, "NAMES",
     "Use --ambient instead of reflected light for surfaces of these materials.",
     pp_options_read_text, PLACE(exclude)},
    {"cache", 0, "FILE",
     "Read the records of the cache from FILE if it exists, and write them to it.",
     pp_options_read_updated, PLACE(file)},
    {0},
};

struct pp_cache_choice pp_cache_choice_default(void)
{
    return (struct pp_cache_choice){.options = pp_irradiance_cache_defaults()};
}

enum pp_status pp_cache_choice_settle(struct pp_cache_choice *words,
                                      struct pp_error *err)
{
    const char *list = words->include ? words->include : words->exclude;
    if (words->include && words->exclude)
        return pp_fail(
            err, PP_BAD_INPUT,
            "--include and --exclude both select materials; expected only one of them");
    if (!list)
        return PP_OK;
    words->names = strdup(list);
    words->materials = calloc(strlen(list) + 2, sizeof *words->materials);
    if (!words->names || !words->materials)
        return pp_fail_memory(err);
    int count = 0;
    for (char *rest = words->names, *name; (name = strsep(&rest, ",")) != NULL;)
        words->materials[count++] = name;
    words->options.materials = words->materials;
    words->options.material_count = count;
    words->options.only = words->include != NULL;
    return PP_OK;
}

const char *pp_cache_choice_used(const struct pp_cache_choice *words)
{
    const struct pp_cache_options none = pp_irradiance_cache_defaults(),
                                  *is = &words->options;
    return words->file                             ? "--cache"
           : words->include                        ? "--include"
           : words->exclude                        ? "--exclude"
           : is->accuracy != none.accuracy         ? "--accuracy"
           : is->resolution != none.resolution     ? "--resolution"
           : is->divisions != none.divisions       ? "--divisions"
           : is->supersamples != none.supersamples ? "--supersamples"
           : !pp_rgb_is_black(is->constant)        ? "--ambient"
                                                   : NULL;
}

void pp_cache_choice_clear(struct pp_cache_choice *words)
{
    free(words->names);
    free(words->materials);
    *words = pp_cache_choice_default();
}

enum pp_status pp_cache_choice_open(struct pp_irradiance_cache **cache,
                                    const struct pp_cache_choice *words,
                                    const struct pp_light_scene *scene,
                                    const struct pp_environment *environment,
                                    const struct pp_opening_store *store,
                                    const struct pp_radiance_options *light,
                                    uint64_t seed, int threads, struct pp_error *err)
{
    struct pp_cache_options options = words->options;
    options.seed = seed;
    options.threads = threads;
    return pp_cache_records_open(cache, words->file, scene, environment, store, light,
                                 &options, err);
}

enum pp_status pp_cache_choice_write(const struct pp_cache_choice *words,
                                     const char *bytes, size_t length,
                                     struct pp_error *err)
{
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, words->file, err);
    if (status == PP_OK) {
        fwrite(bytes, 1, length, output.stream);
        status = pp_output_commit(&output, err);
    }
    return status;
}

enum pp_status pp_cache_choice_save(const struct pp_cache_choice *words,
                                    const struct pp_irradiance_cache *cache,
                                    struct pp_error *err)
{
    char *bytes;
    size_t length;
    if (!words->file)
        return PP_OK;
    enum pp_status status = pp_cache_file_pack(cache, &bytes, &length, err);
    if (status == PP_OK) {
        status = pp_cache_choice_write(words, bytes, length, err);
        free(bytes);
    }
    return status;
}
