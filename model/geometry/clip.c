/* clip.c - see clip.h. */
#include "model/geometry/clip.h"

#include <stdbool.h>

/* Intersection of an edge with the plane. The calculation starts from the end that is
 * first in order of x, y, z, so that reversing the edge or the plane gives the same
 * result, bit for bit. */
static struct pp_vec3 edge_crossing(struct pp_vec3 a, double depth_a, struct pp_vec3 b,
                                    double depth_b)
{
    bool swap = a.x != b.x ? a.x > b.x : a.y != b.y ? a.y > b.y : a.z > b.z;
    if (swap)
        return pp_vec_along(b, depth_b / (depth_b - depth_a), pp_vec_sub(a, b));
    return pp_vec_along(a, depth_a / (depth_a - depth_b), pp_vec_sub(b, a));
}

int pp_clip_convex(struct pp_vec3 *out, const struct pp_vec3 *in, int count,
                   struct pp_vec3 normal, double offset)
{
    int left = 0;
    if (count < 3)
        return 0;
    struct pp_vec3 last = in[count - 1];
    double last_depth = pp_vec_dot(normal, last) - offset;
    for (int i = 0; i < count; i++) {
        double depth = pp_vec_dot(normal, in[i]) - offset;
        if ((depth > 0.0) != (last_depth > 0.0))
            out[left++] = edge_crossing(last, last_depth, in[i], depth);
        if (depth > 0.0)
            out[left++] = in[i];
        last = in[i];
        last_depth = depth;
    }
    return left < 3 ? 0 : left;
}

int pp_clip_tidy(double (*xy)[2], int count, double grain)
{
    int left = 0;
    for (int i = 0; i < count; i++) {
        const double *last = left > 0 ? xy[left - 1] : xy[count - 1];
        if (hypot(xy[i][0] - last[0], xy[i][1] - last[1]) > grain) {
            xy[left][0] = xy[i][0];
            xy[left++][1] = xy[i][1];
        }
    }
    double twice = 0.0, longest = 0.0;
    for (int i = 1; i < left; i++) {
        double ax = xy[i][0] - xy[0][0], ay = xy[i][1] - xy[0][1];
        longest = fmax(longest, hypot(ax, ay));
        if (i > 1)
            twice += (xy[i - 1][0] - xy[0][0]) * ay - ax * (xy[i - 1][1] - xy[0][1]);
    }
    return left >= 3 && fabs(twice) > grain * longest ? left : 0;
}
