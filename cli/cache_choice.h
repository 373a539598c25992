/* cache_choice.h - the options of the irradiance cache, shared by all commands that use
 * it. */
#ifndef PP_CLI_CACHE_CHOICE_H
#define PP_CLI_CACHE_CHOICE_H

#include "cli/options.h"
#include "simulate/cache/irradiance_cache.h"

struct pp_cache_choice {
    struct pp_cache_options options; /* options of the cache, without seed and
                                      * threads */
    const char *include, *exclude;   /* lists of materials, separated by commas; NULL:
                                      * none */
    const char *file;                /* file of records, from --cache; NULL: none */
    char *names;                     /* memory for the names in options.materials */
    const char **materials;
};

/* Options --accuracy (-aa), --resolution (-ar), --divisions (-ad), --supersamples
 * (-as), --bounces (-ab), --ambient (-av), --include (-ai), --exclude (-ae) and
 * --cache. The values are stored in a struct pp_cache_choice. */
extern const struct pp_option pp_cache_choice_options[];

struct pp_cache_choice pp_cache_choice_default(void);

/* Splits the list of materials to be included or excluded, after all options are read.
 * PP_BAD_INPUT if both lists are given. */
enum pp_status pp_cache_choice_settle(struct pp_cache_choice *words,
                                      struct pp_error *err);
void pp_cache_choice_clear(struct pp_cache_choice *words);

/* First option given that applies only to a cache (all options above except --bounces);
 * NULL: none. */
const char *pp_cache_choice_used(const struct pp_cache_choice *words);

/* Makes the cache for a scene. Reads the records in the file of --cache, if the file
 * exists. */
enum pp_status pp_cache_choice_open(struct pp_irradiance_cache **cache,
                                    const struct pp_cache_choice *words,
                                    const struct pp_light_scene *scene,
                                    const struct pp_environment *environment,
                                    const struct pp_opening_store *store,
                                    const struct pp_radiance_options *light,
                                    uint64_t seed, int threads, struct pp_error *err);

/* Writes `bytes` to the file of --cache in one step. --cache must be given. */
enum pp_status pp_cache_choice_write(const struct pp_cache_choice *words,
                                     const char *bytes, size_t length,
                                     struct pp_error *err);

/* Writes the records of a cache to the file of --cache, if --cache is given. */
enum pp_status pp_cache_choice_save(const struct pp_cache_choice *words,
                                    const struct pp_irradiance_cache *cache,
                                    struct pp_error *err);

#endif
