/* outdoors.c - see outdoors.h. */
#include "simulate/research/radiosity/outdoors.h"

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
        away, tan(skyline->angle_rad),
        pp_outside_light_exitance(light, skyline->reflectance, back)};
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
        if (isinf(world->skylines[i].distance_m))
            outdoors->skylines[outdoors->skyline_count++] =
                skyline_of(world, light, &world->skylines[i]);
    return PP_OK;
}

void pp_outdoors_clear(struct pp_outdoors *outdoors)
{
    free(outdoors->skylines);
    outdoors->skylines = NULL;
}

/* The light of the first skyline that hides the direction; NAN if none does. */
static double skyline_light(const struct pp_outdoors *outdoors, struct pp_vec3 to)
{
    for (int i = 0; to.z > 0.0 && i < outdoors->skyline_count; i++) {
        const struct pp_outdoor_skyline *skyline = &outdoors->skylines[i];
        if (to.z < skyline->slope * pp_vec_dot(skyline->away, to))
            return skyline->exitance;
    }
    return NAN;
}

enum pp_outdoors_end pp_outdoors_meet(const struct pp_outdoors *outdoors,
                                      struct pp_vec3 from, struct pp_vec3 to,
                                      double facet_m, double *light, double *distance)
{
    double ground_m = INFINITY, over = from.z - outdoors->ground_m;
    if (!outdoors->world->ground_is_open && to.z < 0.0 && over > 0.0)
        ground_m = over / -to.z;
    if (ground_m < outdoors->farthest_m && ground_m < facet_m) {
        *distance = ground_m;
        return PP_OUTDOORS_GROUND;
    }
    if (facet_m < INFINITY)
        return PP_OUTDOORS_NOTHING;
    *distance = INFINITY;
    *light = skyline_light(outdoors, to);
    if (!isnan(*light))
        return PP_OUTDOORS_FIXED;
    if (!(to.z > 0.0)) {
        *light = pp_outside_light_ground(&outdoors->light);
        return PP_OUTDOORS_FIXED;
    }
    *light = PP_PI * pp_sky_luminance(&outdoors->light.sky, to);
    return PP_OUTDOORS_SKY;
}
