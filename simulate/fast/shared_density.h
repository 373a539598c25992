/* shared_density.h - density of points on a room's surfaces whose light all receivers
 * share, and the weight of a point at a receiver.
 *
 * D = B - G is the residual of the control variate G of path.h. Without sharing, D
 * would be sampled again for each receiver. Instead, it is sampled once, at points y on
 * the room's surfaces with density p (1/m2). With an unbiased estimate D(y) at each
 * point (shared_light.h), a receiver at x gets
 *
 *     min(k(x, y)/p(y), c) D(y),        k = cos cos' / (pi r2)                      (1)
 *
 * The mean of (1) over p is the mean of D over the cosine lobe at x, except for the
 * part that the bound c cuts off if x and y are near each other. The lobe's own rays
 * sample this part: a ray that has met y continues with the probability
 *
 *     1 - c p(y)/k(x, y)                                                            (2)
 *
 * if that is positive. The sum of both is unbiased for all p and c. This is the method
 * of many lights [KELLER97], bounded as in [KK06].
 *
 * The method is used only in rooms where any two points see each other (convex_room.h),
 * so that (1) needs no ray. The sides of niches are not visible from everywhere: they
 * have no points, their light is sampled by the lobe's rays, and receivers in a niche
 * share no light.
 */
#ifndef PP_SIMULATE_FAST_SHARED_DENSITY_H
#define PP_SIMULATE_FAST_SHARED_DENSITY_H

#include "model/base/error.h"
#include "simulate/fast/control_variate.h"

/* Greatest weight c in (1). Measured: between c = 6 and 25, the work for a given error
 * changes by less than a tenth. But with c = 6, 12 and 25, respectively 0.08, 0.2 and
 * 0.6 % of 6,000 points in random rooms end with more than twice the target standard
 * error. */
#define PP_SHARED_DENSITY_MOST_WEIGHT 6.0

/* A shared point y with its light. */
struct pp_shared_light {
    struct pp_vec3 point, normal; /* in the scene's coordinates */
    double per_density;           /* 1/(pi p), m2 */
    double light;                 /* D(y) over Eh; 0 if there is no surface at y */
};

struct pp_shared_density;

/* Makes the density for a scene with a known G; both must outlive *density. The caller
 * destroys *density, which is NULL if the room does not allow sharing. */
enum pp_status pp_shared_density_create(struct pp_shared_density **density,
                                        const struct pp_light_scene *scene,
                                        const struct pp_control_variate *variate,
                                        struct pp_error *err);
void pp_shared_density_destroy(struct pp_shared_density *density); /* NULL is allowed */

/* True if a receiver at this point sees all shared points. Other receivers share no
 * light. */
bool pp_shared_density_serves(const struct pp_shared_density *density,
                              struct pp_vec3 point);

/* A place drawn by three numbers in (0, 1), with 1/(pi p), and the ray to this place
 * from the middle of the room. If the ray meets another part, there is no surface at
 * the place: the place is on a pane, or outside the surface's outline. */
struct pp_shared_place {
    int part;
    struct pp_light_ray sight;
    double per_density;
};
struct pp_shared_place pp_shared_density_draw(const struct pp_shared_density *density,
                                              const double u[3]);

/* Probability (2), or 0 if it is negative, for a ray of the lobe that reaches y
 * directly from x. */
double pp_shared_density_left(const struct pp_shared_density *density,
                              const struct pp_light_ray *ray,
                              const struct pp_light_hit *met);

/* The light (1) of a shared point at a receiver with normal `normal`, over Eh. */
static inline double pp_shared_density_taken(const struct pp_shared_light *shared,
                                             struct pp_vec3 point,
                                             struct pp_vec3 normal)
{
    struct pp_vec3 to = pp_vec_sub(shared->point, point);
    double cosine = pp_vec_dot(normal, to), other = -pp_vec_dot(shared->normal, to);
    if (!(cosine > 0.0 && other > 0.0))
        return 0.0;
    double square = pp_vec_dot(to, to);
    double weight = cosine * other * shared->per_density / (square * square);
    return shared->light
           * (weight < PP_SHARED_DENSITY_MOST_WEIGHT ? weight
                                                     : PP_SHARED_DENSITY_MOST_WEIGHT);
}

#endif
