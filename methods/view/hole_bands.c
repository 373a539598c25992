/* hole_bands.c - see hole_bands.h. */
#include "methods/view/hole_bands.h"

int pp_hole_bands(struct pp_elevation_part bands[4], const struct pp_world *world,
                  const struct pp_opening *opening, struct pp_vec3 point,
                  const struct pp_frame *axes)
{
    if (!(opening->recess_m > 0.0))
        return 0;
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
    for (int i = 0; i < opening->outer.count; i++) {
        struct pp_vec3 p =
            pp_frame_in(axes, pp_vec_sub(opening->outer.vertices[i], point));
        double y = p.y + opening->recess_m;
        left = fmin(left, p.x / y);
        right = fmax(right, p.x / y);
        low = fmin(low, p.z / y);
        high = fmax(high, p.z / y);
    }
    double all = INFINITY, reflectance = world->facades[opening->facade].reflectance;
    bands[0] = (struct pp_elevation_part){-all, left, -all, all, reflectance};
    bands[1] = (struct pp_elevation_part){right, all, -all, all, reflectance};
    bands[2] = (struct pp_elevation_part){left, right, high, all, reflectance};
    bands[3] = (struct pp_elevation_part){left, right, -all, low, reflectance};
    return 4;
}
