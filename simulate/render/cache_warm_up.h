/* cache_warm_up.h - fills the irradiance cache for a picture before rendering.
 *
 * As in Radiance's overture calculation, the cache grows until it covers the requests
 * of all pixel centres. The picture then interpolates between records and does not
 * extrapolate. A large picture is processed in parts, each a coarse grid of pixels.
 * Rounds over all parts are repeated until no new record is made. Memory is needed for
 * one part at a time.
 */
#ifndef PP_SIMULATE_RENDER_CACHE_WARM_UP_H
#define PP_SIMULATE_RENDER_CACHE_WARM_UP_H

#include "simulate/render/render.h"

struct pp_cache_warm_up;

/* cache and scene must outlive the warm-up. part_pixels: approximate number of pixels
 * in a part; 0: a million, which take about 100 MB. */
enum pp_status pp_cache_warm_up_create(struct pp_cache_warm_up **warm_up,
                                       struct pp_irradiance_cache *cache,
                                       const struct pp_light_scene *scene,
                                       const struct pp_render_options *options,
                                       int part_pixels, struct pp_error *err);
void pp_cache_warm_up_destroy(struct pp_cache_warm_up *warm_up); /* NULL is allowed */

/* Calculates for about `seconds`; the records do not depend on the length of calls. */
enum pp_status pp_cache_warm_up_advance(struct pp_cache_warm_up *warm_up,
                                        double seconds, struct pp_error *err);
bool pp_cache_warm_up_done(const struct pp_cache_warm_up *warm_up);
double pp_cache_warm_up_progress(const struct pp_cache_warm_up *warm_up); /* 0 to 1 */

#endif
