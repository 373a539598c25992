/* overture.h - the irradiance cache filled for a picture before that is rendered.
 *
 * As Radiance's overture does: the cache grows until it has what the middles of all
 * pixels ask for, so that the picture interpolates between records and does not
 * extrapolate; then it may be the ambient store. A large picture is shown to it in
 * parts, first each pixel of a coarser one, over and over until no new record is made:
 * memory is that of one part.
 */
#ifndef PP_SIMULATE_RENDER_OVERTURE_H
#define PP_SIMULATE_RENDER_OVERTURE_H

#include "simulate/render/render.h"

struct pp_overture;

/* cache and scene must live as long as the overture. part_pixels: about how many a part
 * has; 0: a million, which take some 100 MB. */
enum pp_status pp_overture_create(struct pp_overture **overture,
                                  struct pp_irradiance_cache *cache,
                                  const struct pp_light_scene *scene,
                                  const struct pp_render_options *options,
                                  int part_pixels, struct pp_error *err);
void pp_overture_destroy(struct pp_overture *overture); /* NULL is allowed */

/* Works for about `seconds`; the records don't depend on how often. */
enum pp_status pp_overture_advance(struct pp_overture *overture, double seconds,
                                   struct pp_error *err);
bool pp_overture_done(const struct pp_overture *overture);
double pp_overture_progress(const struct pp_overture *overture); /* 0 to 1 */

#endif
