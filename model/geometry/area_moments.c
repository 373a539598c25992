/* area_moments.c - see area_moments.h. */
#include "model/geometry/area_moments.h"

#include <math.h>
#include <string.h>

struct pp_area_moments pp_area_moments_empty(void)
{
    return (struct pp_area_moments){
        .left = INFINITY, .right = -INFINITY, .low = INFINITY, .high = -INFINITY};
}

void pp_area_moments_add_edge(struct pp_area_moments *moments, const double a[2],
                              const double b[2])
{
    double cross = a[0] * b[1] - a[1] * b[0];
    moments->area += cross / 2.0;
    moments->x_moment += cross * (a[0] + b[0]) / 6.0;
    moments->z_moment += cross * (a[1] + b[1]) / 6.0;
    moments->left = fmin(moments->left, fmin(a[0], b[0]));
    moments->right = fmax(moments->right, fmax(a[0], b[0]));
    moments->low = fmin(moments->low, fmin(a[1], b[1]));
    moments->high = fmax(moments->high, fmax(a[1], b[1]));
}

/* True if b is the tip of a spike, where the outline doubles back. */
static bool is_spike(const double a[2], const double b[2], const double c[2])
{
    double to[2] = {b[0] - a[0], b[1] - a[1]}, back[2] = {c[0] - b[0], c[1] - b[1]};
    double cross = to[0] * back[1] - to[1] * back[0];
    double dot = to[0] * back[0] + to[1] * back[1];
    return dot <= 0.0 && fabs(cross) <= 1e-9 * fabs(dot);
}

/* Removes spikes from a ring. Overlays can leave spikes, which have no area but enlarge
 * the bounding box. */
static void take_spikes_off(struct pp_ring *ring)
{
    for (int i = 0, passed = 0; passed < ring->count && ring->count > 2; i++) {
        int count = ring->count, at = i % count;
        if (!is_spike(ring->xy[(at + count - 1) % count], ring->xy[at],
                      ring->xy[(at + 1) % count])) {
            passed++;
            continue;
        }
        memmove(ring->xy + at, ring->xy + at + 1,
                (size_t)(count - at - 1) * sizeof *ring->xy);
        ring->count--;
        i = at - 2 + ring->count; /* the neighbours may be spikes now */
        passed = 0;
    }
}

struct pp_area_moments pp_area_moments_above_horizon(struct pp_region *region)
{
    struct pp_area_moments moments = pp_area_moments_empty();
    for (int r = 0; r < region->count; r++) {
        take_spikes_off(region->rings + r);
        for (int i = 0; i < region->rings[r].count; i++) {
            const double *p = region->rings[r].xy[i];
            const double *q = region->rings[r].xy[(i + 1) % region->rings[r].count];
            double a[2] = {p[0], p[1]}, b[2] = {q[0], q[1]};
            if (a[1] <= 0.0 && b[1] <= 0.0)
                continue;
            double *under = a[1] < 0.0 ? a : b[1] < 0.0 ? b : NULL;
            if (under) {
                under[0] = p[0] + (q[0] - p[0]) * p[1] / (p[1] - q[1]);
                under[1] = 0.0;
            }
            pp_area_moments_add_edge(&moments, a, b);
        }
    }
    return moments;
}

/* Clips a polygon by one side: keeps sign * p[axis] <= sign * limit. Returns the number
 * of points, at most 1.5 times as many. */
static int cut_by_side(double (*to)[2], double (*from)[2], int count, int axis,
                       double sign, double limit)
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        const double *a = from[i], *b = from[(i + 1) % count];
        double over_a = sign * (a[axis] - limit), over_b = sign * (b[axis] - limit);
        if (over_a <= 0.0) {
            memcpy(to[kept], a, sizeof to[kept]);
            kept++;
        }
        if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0)) {
            double t = over_a / (over_a - over_b);
            to[kept][axis] = limit;
            to[kept][1 - axis] = a[1 - axis] + t * (b[1 - axis] - a[1 - axis]);
            kept++;
        }
    }
    return kept;
}

struct pp_area_moments pp_area_moments_in_box(double (*points)[2], double (*spare)[2],
                                              int count, double left, double right,
                                              double low, double high)
{
    const struct {
        int axis;
        double sign, limit;
    } sides[4] = {{0, -1.0, left}, {0, 1.0, right}, {1, -1.0, low}, {1, 1.0, high}};
    for (int k = 0; k < 4; k++) {
        count = cut_by_side(spare, points, count, sides[k].axis, sides[k].sign,
                            sides[k].limit);
        double(*swap)[2] = points;
        points = spare;
        spare = swap;
    }
    struct pp_area_moments moments = pp_area_moments_empty();
    for (int i = 0; i < count; i++)
        pp_area_moments_add_edge(&moments, points[i], points[(i + 1) % count]);
    return moments;
}
