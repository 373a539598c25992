/* cache_choice.h - the options of the irradiance cache, shared by all commands that use
 * it. */
#ifndef PP_CLI_CACHE_CHOICE_H
#define PP_CLI_CACHE_CHOICE_H

#include "cli/options.h"
#include "simulate/cache/irradiance_cache.h"

struct pp_cache_choice {
    struct pp_cache_options options; /* except seed and threads */
    const char *include, *exclude;   /* lists of materials, separated by commas; NULL:
                                      * none */
    const char *file;                /* --cache; NULL: none */
    char *names;                     /* storage of the names in options.materials */
    const char **materials;
};

/* --accuracy (-aa), --resolution (-ar), --divisions (-ad), --supersamples (-as),
 * --bounces (-ab), --ambient (-av), --include (-ai), --exclude (-ae), --cache; the
 * values are stored in a struct pp_cache_choice. */
extern const struct pp_option pp_cache_choice_options[];

struct pp_cache_choice pp_cache_choice_default(void);

/* Splits the list of materials to include or exclude, after all options are read.
 * PP_BAD_INPUT if both lists are given. */
enum pp_status pp_cache_choice_settle(struct pp_cache_choice *words,
                                      struct pp_error *err);
void pp_cache_choice_clear(struct pp_cache_choice *words);

/* Name of the first option that is given and applies only to a cache (all except
 * --bounces); NULL: none. */
const char *pp_cache_choice_used(const struct pp_cache_choice *words);

/* Makes the cache for a scene, and reads the records in the file of --cache if it
 * exists. */
enum pp_status pp_cache_choice_open(struct pp_irradiance_cache **cache,
                                    const struct pp_cache_choice *words,
                                    const struct pp_light_scene *scene,
                                    const struct pp_environment *environment,
                                    const struct pp_opening_store *store,
                                    const struct pp_radiance_options *light,
                                    uint64_t seed, int threads, struct pp_error *err);

/* Writes `bytes` to the file of --cache, which must be given, in one step. */
enum pp_status pp_cache_choice_write(const struct pp_cache_choice *words,
                                     const char *bytes, size_t length,
                                     struct pp_error *err);

/* Writes a cache's records to the file of --cache, if given. */
enum pp_status pp_cache_choice_save(const struct pp_cache_choice *words,
                                    const struct pp_irradiance_cache *cache,
                                    struct pp_error *err);

#endif
