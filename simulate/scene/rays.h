/* rays.h - what a ray meets first among triangles and round shapes. The only door to
 * Embree.
 *
 * Coordinates are single precision and best near the origin. The structure is built
 * once, by one thread, and only read afterwards: any number of threads may ask.
 */
#ifndef PP_SIMULATE_SCENE_RAYS_H
#define PP_SIMULATE_SCENE_RAYS_H

#include "model/base/error.h"
#include "model/light/scene_description.h"

struct pp_rays;

/* Copies the triangles; none at all is allowed. */
enum pp_status pp_rays_create(struct pp_rays **rays, const float (*triangles)[3][3],
                              int count, struct pp_error *err);

/* The same with round shapes (round.h), which are met exactly; their indices follow
 * those of the triangles. */
enum pp_status pp_rays_create_with(struct pp_rays **rays,
                                   const float (*triangles)[3][3], int count,
                                   const struct pp_shape *rounds, int round_count,
                                   struct pp_error *err);
void pp_rays_destroy(struct pp_rays *rays); /* NULL is allowed */

/* The index of the first triangle that the ray from origin along direction meets, from
 * either side, with its distance in units of direction's length; -1 if none. */
int pp_rays_first(const struct pp_rays *rays, const float origin[3],
                  const float direction[3], float *distance);

#endif
