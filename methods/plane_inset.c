#include "methods/plane_inset.h"

#include <math.h>

/* The figure's interior lies on the left of its rings. */
struct pp_vec3 pp_plane_inset(const struct pp_region *plane, double z, double inset_m,
                              double x, double y)
{
    struct pp_vec3 moved = pp_vec(x, y, z);
    for (int r = 0; r < plane->count; r++)
        for (int i = 0; i < plane->rings[r].count; i++) {
            const double *a = plane->rings[r].xy[i];
            const double *b = plane->rings[r].xy[(i + 1) % plane->rings[r].count];
            double dx = b[0] - a[0], dy = b[1] - a[1], length = hypot(dx, dy);
            double share = ((x - a[0]) * dx + (y - a[1]) * dy) / (length * length);
            share = fmin(fmax(share, 0.0), 1.0);
            double off = hypot(a[0] + share * dx - x, a[1] + share * dy - y);
            if (off >= inset_m)
                continue;
            moved.x -= dy / length * (inset_m - off);
            moved.y += dx / length * (inset_m - off);
        }
    return moved;
}
