/* scene_skylines.c - see scene_skylines.h. */
#include "simulate/scene/scene_skylines.h"

#include <math.h>
#include <stdlib.h>

/* The horizontal outward direction of the wall to which a skyline is parallel. */
static struct pp_vec3 outward_of(const struct pp_world *world,
                                 const struct pp_skyline *skyline)
{
    struct pp_vec3 n = world->surfaces[skyline->face].outline.normal;
    return pp_vec_unit(pp_vec(-n.x, -n.y, 0.0));
}

enum pp_status pp_scene_skylines_init(struct pp_scene_skylines *skylines,
                                      const struct pp_world *world,
                                      struct pp_error *err)
{
    *skylines = (struct pp_scene_skylines){0};
    if (world->skyline_count == 0)
        return PP_OK;
    skylines->far = calloc((size_t)world->skyline_count, sizeof *skylines->far);
    if (!skylines->far)
        return pp_fail_memory(err);
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        if (isinf(skyline->distance_m))
            skylines->far[skylines->far_count++] =
                (struct pp_far_skyline){outward_of(world, skyline),
                                        tan(skyline->angle_rad), skyline->reflectance};
    }
    return PP_OK;
}

void pp_scene_skylines_clear(struct pp_scene_skylines *skylines)
{
    free(skylines->far);
    *skylines = (struct pp_scene_skylines){0};
}

int pp_scene_skylines_far(const struct pp_scene_skylines *skylines, struct pp_vec3 u)
{
    for (int i = 0; i < skylines->far_count; i++)
        if (u.z < skylines->far[i].slope * pp_vec_dot(u, skylines->far[i].outward))
            return i;
    return -1;
}
