/* form_factor.c - clips the polygon at the horizon and sums over its edges, by
 * Lambert's formula. */
#include "simulate/research/radiosity/form_factor.h"

#include <stdbool.h>

#include "model/geometry/clip.h"

/* Term of one edge in (1), times 2 pi. */
static double edge(struct pp_vec3 a, struct pp_vec3 b, struct pp_vec3 n)
{
    struct pp_vec3 across = pp_vec_cross(a, b);
    double sine = pp_vec_length(across);
    if (!(sine > 0.0))
        return 0.0;
    return atan2(sine, pp_vec_dot(a, b)) * pp_vec_dot(n, across) / sine;
}

double pp_form_factor(struct pp_vec3 point, struct pp_vec3 n,
                      const struct pp_vec3 *corners, int count)
{
    struct pp_vec3 seen[PP_FORM_FACTOR_MOST], above[PP_FORM_FACTOR_MOST + 1];
    const struct pp_vec3 *ring = seen;
    bool below = false, any = false;
    double sum = 0.0;
    for (int i = 0; i < count; i++) {
        seen[i] = pp_vec_sub(corners[i], point);
        double height = pp_vec_dot(seen[i], n);
        below |= height < 0.0;
        any |= height > 0.0;
    }
    if (!any)
        return 0.0;
    if (below) {
        count = pp_clip_convex(above, seen, count, n, 0.0);
        ring = above;
    }
    for (int i = 0; i < count; i++)
        sum += edge(ring[i], ring[i + 1 < count ? i + 1 : 0], n);
    return fabs(sum) / (2.0 * PP_PI);
}
