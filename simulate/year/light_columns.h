/* light_columns.h - skies and suns of many hours, as quantities that multiply the
 * coefficients of light paths: luminances of patches, exitances of skylines, horizontal
 * illuminances.
 *
 * Columns are: the patches of the sky; the horizontal illuminance; the skylines without
 * a distance.
 */
#ifndef PP_SIMULATE_YEAR_LIGHT_COLUMNS_H
#define PP_SIMULATE_YEAR_LIGHT_COLUMNS_H

#include <stddef.h>

#include "model/base/thread_pool.h"
#include "model/light/perez_sky.h"
#include "model/light/sky_patches.h"
#include "simulate/scene/environment.h"

enum { PP_LIGHT_LANES = 16 };

struct pp_light_columns {
    struct pp_sky_patches patches;
    int count;                        /* number of hours */
    int tiles;                        /* number of tiles of PP_LIGHT_LANES hours */
    const struct pp_perez_sky *skies; /* in the room's axes; not owned */
    int column_count;
    float
        *columns; /* [hour / PP_LIGHT_LANES][column][hour % PP_LIGHT_LANES]: cd/m2, lx,
                   * or exitance divided by pi */
};

/* skies: in the axes of the scene's room; must outlive *light. patch_count: 145, 577 or
 * 2305. On success the caller must clear *light. */
enum pp_status pp_light_columns_init(struct pp_light_columns *light,
                                     const struct pp_environment *environment,
                                     const struct pp_perez_sky *skies, int count,
                                     int patch_count, double north_rad,
                                     struct pp_thread_pool *pool, struct pp_error *err);
void pp_light_columns_clear(struct pp_light_columns *light);

/* Horizontal illuminance Eh of the unobstructed sky, including the sun (lx). */
static inline double pp_light_columns_horizontal(const struct pp_perez_sky *sky)
{
    return sky->diffuse_lx + (sky->sun.z > 0.0 ? sky->direct_lx * sky->sun.z : 0.0);
}

/* Light of one column in one hour. */
static inline float pp_light_columns_at(const struct pp_light_columns *light,
                                        int column, int hour)
{
    size_t tile = (size_t)(hour / PP_LIGHT_LANES) * (size_t)light->column_count;
    return light->columns[(tile + (size_t)column) * PP_LIGHT_LANES
                          + (size_t)(hour % PP_LIGHT_LANES)];
}

#endif
