/* scene_skylines.c - the world's skylines as half planes and hidden directions. */
#include "simulate/scene/scene_skylines.h"

#include <math.h>
#include <stdlib.h>

#include "model/room/ground.h"

/* The horizontal outward direction of the wall that a skyline is parallel to. */
static struct pp_vec3 outward_of(const struct pp_world *world,
                                 const struct pp_skyline *skyline)
{
    struct pp_vec3 n = world->surfaces[skyline->face].outline.normal;
    return pp_vec_unit(pp_vec(-n.x, -n.y, 0.0));
}

static void add(struct pp_scene_skylines *skylines, const struct pp_world *world,
                const struct pp_skyline *skyline, struct pp_vec3 centre)
{
    struct pp_vec3 outward = outward_of(world, skyline);
    if (isinf(skyline->distance_m)) {
        skylines->far[skylines->far_count++] = (struct pp_far_skyline){
            outward, tan(skyline->angle_rad), skyline->reflectance};
        return;
    }
    struct pp_vec3 on_wall =
        pp_vec_sub(world->surfaces[skyline->face].outline.vertices[0], centre);
    skylines->near[skylines->near_count++] = (struct pp_near_skyline){
        .outward = outward,
        .offset_m = pp_vec_dot(outward, on_wall) + skyline->distance_m,
        .head_m = skyline->head_z_m - centre.z,
        .reflectance = skyline->reflectance};
}

enum pp_status pp_scene_skylines_init(struct pp_scene_skylines *skylines,
                                      const struct pp_world *world,
                                      struct pp_vec3 centre, struct pp_error *err)
{
    *skylines =
        (struct pp_scene_skylines){.ground_level_m = pp_ground_level(world) - centre.z};
    size_t count = (size_t)world->skyline_count;
    if (count == 0)
        return PP_OK;
    skylines->far = calloc(count, sizeof *skylines->far);
    skylines->near = calloc(count, sizeof *skylines->near);
    if (!skylines->far || !skylines->near) {
        pp_scene_skylines_clear(skylines);
        return pp_fail_memory(err);
    }
    for (size_t i = 0; i < count; i++)
        add(skylines, world, &world->skylines[i], centre);
    return PP_OK;
}

void pp_scene_skylines_clear(struct pp_scene_skylines *skylines)
{
    free(skylines->far);
    free(skylines->near);
    *skylines = (struct pp_scene_skylines){0};
}

double pp_scene_skylines_near(const struct pp_scene_skylines *skylines,
                              struct pp_vec3 p, struct pp_vec3 u, int *met, int *side)
{
    double nearest = INFINITY;
    for (int i = 0; i < skylines->near_count; i++) {
        const struct pp_near_skyline *skyline = &skylines->near[i];
        double approach = pp_vec_dot(u, skyline->outward);
        double t = (skyline->offset_m - pp_vec_dot(p, skyline->outward)) / approach;
        double z = p.z + t * u.z;
        if (!(t > 1e-6) || t >= nearest || z >= skyline->head_m
            || (z < skylines->ground_level_m && u.z < 0.0))
            continue;
        nearest = t;
        *met = i;
        *side = approach < 0.0;
    }
    return nearest;
}

int pp_scene_skylines_far(const struct pp_scene_skylines *skylines, struct pp_vec3 u)
{
    for (int i = 0; i < skylines->far_count; i++)
        if (u.z < skylines->far[i].slope * pp_vec_dot(u, skylines->far[i].outward))
            return i;
    return -1;
}
