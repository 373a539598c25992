/* outdoors.c - see outdoors.h. */
#include "simulate/elements/outdoors.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "model/room/ground.h"

static struct pp_outdoor_skyline skyline_of(const struct pp_world *world,
                                            const struct pp_outside_light *light,
                                            const struct pp_skyline *skyline)
{
    const struct pp_polygon *wall = &world->surfaces[skyline->face].outline;
    struct pp_vec3 away = pp_vec_unit(pp_vec(-wall->normal.x, -wall->normal.y, 0.0));
    struct pp_vec3 back = pp_vec_scale(away, -1.0);
    return (struct pp_outdoor_skyline){
        .away = away,
        .before_m = pp_vec_dot(away, wall->vertices[0]) + skyline->distance_m,
        .slope = tan(skyline->angle_rad),
        .exitance = {pp_outside_light_exitance(light, skyline->reflectance, back),
                     pp_outside_light_exitance(light, skyline->reflectance, away)}};
}

enum pp_status pp_outdoors_init(struct pp_outdoors *outdoors,
                                const struct pp_world *world,
                                const struct pp_outside_light *light, double reach_m,
                                struct pp_error *err)
{
    *outdoors =
        (struct pp_outdoors){.world = world,
                             .light = *light,
                             .ground_m = pp_ground_level(world),
                             .farthest_m = PP_OUTDOORS_FARTHEST * (reach_m + 1.0)};
    outdoors->skylines =
        calloc((size_t)world->skyline_count + 1, sizeof *outdoors->skylines);
    if (!outdoors->skylines)
        return pp_fail_memory(err);
    for (int i = 0; i < world->skyline_count; i++)
        outdoors->skylines[i] = skyline_of(world, light, &world->skylines[i]);
    return PP_OK;
}

void pp_outdoors_clear(struct pp_outdoors *outdoors)
{
    free(outdoors->skylines);
    outdoors->skylines = NULL;
}

/* Distance to a skyline that stands somewhere; INFINITY: it is not met. */
static double distance_to(const struct pp_outdoors *outdoors, int index,
                          struct pp_vec3 from, struct pp_vec3 to)
{
    const struct pp_outdoor_skyline *skyline = &outdoors->skylines[index];
    double distance = (skyline->before_m - pp_vec_dot(skyline->away, from))
                      / pp_vec_dot(skyline->away, to);
    double z = from.z + distance * to.z;
    bool met = distance > 1e-6 && z < outdoors->world->skylines[index].head_z_m
               && (to.z >= 0.0 || z >= outdoors->ground_m);
    return met ? distance : INFINITY;
}

/* The nearest skyline's light, with its distance; INFINITY: it, too, may be infinitely
 * far; NAN: none. */
static double skyline_light(const struct pp_outdoors *outdoors, struct pp_vec3 from,
                            struct pp_vec3 to, double *nearest_m)
{
    double light = NAN, far = NAN;
    *nearest_m = INFINITY;
    for (int i = 0; i < outdoors->world->skyline_count; i++) {
        const struct pp_outdoor_skyline *skyline = &outdoors->skylines[i];
        double approach = pp_vec_dot(skyline->away, to);
        if (isinf(skyline->before_m)) {
            if (isnan(far) && to.z > 0.0 && to.z < skyline->slope * approach)
                far = skyline->exitance[0];
            continue;
        }
        double distance = distance_to(outdoors, i, from, to);
        if (distance < *nearest_m) {
            *nearest_m = distance;
            light = skyline->exitance[approach < 0.0];
        }
    }
    return isinf(*nearest_m) ? far : light;
}

enum pp_outdoors_end pp_outdoors_meet(const struct pp_outdoors *outdoors,
                                      struct pp_vec3 from, struct pp_vec3 to,
                                      double facet_m, double *light, double *distance)
{
    double skyline_m = INFINITY, ground_m = INFINITY, skyline = NAN;
    if (outdoors->world->skyline_count > 0)
        skyline = skyline_light(outdoors, from, to, &skyline_m);
    double over = from.z - outdoors->ground_m;
    if (!outdoors->world->ground_is_open && to.z < 0.0 && over > 0.0)
        ground_m = over / -to.z;
    if (ground_m < outdoors->farthest_m && ground_m < facet_m && ground_m < skyline_m) {
        *distance = ground_m;
        return PP_OUTDOORS_GROUND;
    }
    if (facet_m < skyline_m)
        return PP_OUTDOORS_NOTHING;
    *distance = INFINITY;
    *light = skyline;
    if (!isnan(skyline))
        return PP_OUTDOORS_FIXED;
    if (!(to.z > 0.0)) {
        *light = pp_outside_light_ground(&outdoors->light);
        return PP_OUTDOORS_FIXED;
    }
    *light = PP_PI * pp_sky_luminance(&outdoors->light.sky, to);
    return PP_OUTDOORS_SKY;
}
