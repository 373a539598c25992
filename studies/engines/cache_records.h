/* cache_records.h - makes an irradiance cache that begins with the records in a
 * file. */
#ifndef PP_STUDIES_ENGINES_CACHE_RECORDS_H
#define PP_STUDIES_ENGINES_CACHE_RECORDS_H

#include "simulate/cache/irradiance_cache.h"

/* Makes a cache for a scene under an environment. The cache begins with the records of
 * `file`, if the file exists (NULL: no file). PP_BAD_INPUT if the file belongs to
 * another scene or light. */
enum pp_status pp_cache_records_open(
    struct pp_irradiance_cache **cache, const char *file,
    const struct pp_light_scene *scene, const struct pp_environment *environment,
    const struct pp_opening_store *store, const struct pp_radiance_options *light,
    const struct pp_cache_options *options, struct pp_error *err);

#endif
