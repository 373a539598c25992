/* cache_records.c - reads a file of records into a cache that has the same options. */
#include "studies/engines/cache_records.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#include "model/base/read_file.h"
#include "simulate/cache/cache_file.h"

enum { MOST_BYTES = 1 << 30 };

static enum pp_status load(struct pp_irradiance_cache *cache, const char *file,
                           struct pp_error *err)
{
    char *bytes;
    size_t length;
    if (access(file, F_OK) != 0 && errno == ENOENT)
        return PP_OK;
    enum pp_status status = pp_read_file(&bytes, &length, file, MOST_BYTES, err);
    if (status != PP_OK)
        return status;
    status = length > MOST_BYTES
                 ? pp_fail(err, PP_BAD_INPUT, "%s is too large for a cache", file)
                 : pp_cache_file_unpack(cache, bytes, length, file, err);
    free(bytes);
    return status;
}

enum pp_status pp_cache_records_open(
    struct pp_irradiance_cache **cache, const char *file,
    const struct pp_light_scene *scene, const struct pp_environment *environment,
    const struct pp_opening_store *store, const struct pp_radiance_options *light,
    const struct pp_cache_options *options, struct pp_error *err)
{
    enum pp_status status = pp_irradiance_cache_create(cache, scene, environment, store,
                                                       light, options, err);
    if (status == PP_OK && file)
        status = load(*cache, file, err);
    if (status != PP_OK) {
        pp_irradiance_cache_destroy(*cache);
        *cache = NULL;
    }
    return status;
}
