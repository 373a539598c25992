/* rays.h - the first triangle or round shape that a ray meets. Only rays.c calls the
 * ray kernels, Embree.
 *
 * Coordinates are single precision and best near the origin. The structure is built
 * once, by one thread, and only read afterwards, by any number of threads.
 */
#ifndef PP_SIMULATE_SCENE_RAYS_H
#define PP_SIMULATE_SCENE_RAYS_H

#include "model/base/error.h"
#include "model/geometry/vec.h"
#include "model/light/scene_description.h"

struct pp_rays;

/* Copies triangles and round shapes (round.h), possibly none of either. Round shapes
 * are intersected exactly; their indices follow those of the triangles. */
enum pp_status pp_rays_create(struct pp_rays **rays, const float (*triangles)[3][3],
                              int count, const struct pp_shape *rounds, int round_count,
                              struct pp_error *err);
void pp_rays_destroy(struct pp_rays *rays); /* NULL is allowed */

/* The index of the first triangle or round shape that the ray from `origin` along
 * `direction` meets, from either side, and its distance in units of the length of
 * `direction`; -1 if none. */
int pp_rays_first(const struct pp_rays *rays, const float origin[3],
                  const float direction[3], float *distance);

/* Start of a ray from p, lifted off the surface with normal n by more than single
 * precision can lose, so that the ray cannot meet that surface again. */
static inline struct pp_vec3 pp_rays_lift(struct pp_vec3 p, struct pp_vec3 n)
{
    double reach = fabs(p.x) + fabs(p.y) + fabs(p.z);
    return pp_vec_along(p, 0x1p-20 + 0x1p-20 * reach, n);
}

/* Point at which a ray along `to` has met a surface, moved back along the ray by half
 * of the distance by which rays are lifted. In a corner, the point would otherwise lie
 * exactly in the other surface too, and a ray from there might start on the wrong side
 * of that surface. */
static inline struct pp_vec3 pp_rays_draw_back(struct pp_vec3 point, struct pp_vec3 to)
{
    double reach = fabs(point.x) + fabs(point.y) + fabs(point.z);
    return pp_vec_along(point, -0x1p-21 - 0x1p-21 * reach, to);
}

#endif
