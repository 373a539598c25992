/* environment.c - the world's skylines as half planes that give off light. */
#include "simulate/scene/environment.h"

#include <math.h>
#include <stdlib.h>

/* The horizontal outward direction of the wall that a skyline is parallel to. */
static struct pp_vec3 outward_of(const struct pp_world *world,
                                 const struct pp_skyline *skyline)
{
    struct pp_vec3 n = world->surfaces[skyline->face].outline.normal;
    return pp_vec_unit(pp_vec(-n.x, -n.y, 0.0));
}

static double exitance_of(const struct pp_world *world, double reflectance,
                          struct pp_vec3 normal)
{
    return reflectance
           * (pp_sky_on_plane(&world->sky, normal) + world->ground_reflectance / 2.0);
}

static void add_skyline(struct pp_environment *environment,
                        const struct pp_world *world, const struct pp_skyline *skyline,
                        struct pp_vec3 centre)
{
    struct pp_vec3 outward = outward_of(world, skyline);
    double facing =
        exitance_of(world, skyline->reflectance, pp_vec_scale(outward, -1.0));
    if (isinf(skyline->distance_m)) {
        environment->far_skylines[environment->far_count++] =
            (struct pp_far_skyline){outward, tan(skyline->angle_rad), facing};
        return;
    }
    struct pp_vec3 on_wall =
        pp_vec_sub(world->surfaces[skyline->face].outline.vertices[0], centre);
    environment->near_skylines[environment->near_count++] = (struct pp_near_skyline){
        .outward = outward,
        .offset_m = pp_vec_dot(outward, on_wall) + skyline->distance_m,
        .head_m = skyline->head_z_m - centre.z,
        .exitance = {facing, exitance_of(world, skyline->reflectance, outward)}};
}

enum pp_status pp_environment_init(struct pp_environment *environment,
                                   const struct pp_world *world, struct pp_vec3 centre,
                                   struct pp_error *err)
{
    *environment =
        (struct pp_environment){.sky = world->sky,
                                .ground_reflectance = world->ground_reflectance,
                                .ground_level_m = world->ground_level_m - centre.z};
    size_t count = (size_t)world->skyline_count;
    if (count == 0)
        return PP_OK;
    environment->far_skylines = calloc(count, sizeof *environment->far_skylines);
    environment->near_skylines = calloc(count, sizeof *environment->near_skylines);
    if (!environment->far_skylines || !environment->near_skylines) {
        pp_environment_clear(environment);
        return pp_fail_memory(err);
    }
    for (size_t i = 0; i < count; i++)
        add_skyline(environment, world, &world->skylines[i], centre);
    return PP_OK;
}

void pp_environment_clear(struct pp_environment *environment)
{
    free(environment->far_skylines);
    free(environment->near_skylines);
    environment->far_skylines = NULL;
    environment->near_skylines = NULL;
    environment->far_count = environment->near_count = 0;
}

double pp_environment_near_skyline(const struct pp_environment *environment,
                                   struct pp_vec3 p, struct pp_vec3 u, double *exitance)
{
    double nearest = INFINITY;
    for (int i = 0; i < environment->near_count; i++) {
        const struct pp_near_skyline *skyline = &environment->near_skylines[i];
        double approach = pp_vec_dot(u, skyline->outward);
        double t = (skyline->offset_m - pp_vec_dot(p, skyline->outward)) / approach;
        double z = p.z + t * u.z;
        if (!(t > 1e-6) || t >= nearest || z >= skyline->head_m
            || (z < environment->ground_level_m && u.z < 0.0))
            continue;
        nearest = t;
        *exitance = skyline->exitance[approach < 0.0];
    }
    return nearest;
}

double pp_environment_light(const struct pp_environment *environment, struct pp_vec3 u,
                            bool *is_sky)
{
    *is_sky = false;
    if (!(u.z > 0.0))
        return environment->ground_reflectance;
    for (int i = 0; i < environment->far_count; i++) {
        const struct pp_far_skyline *skyline = &environment->far_skylines[i];
        if (u.z < skyline->slope * pp_vec_dot(u, skyline->outward))
            return skyline->exitance;
    }
    *is_sky = true;
    return PP_PI * pp_sky_luminance(&environment->sky, u);
}
