/* point_average.c - the view of each point of a cubature over the plane, patch by patch. */
#include "methods/average/point_average.h"

#include "methods/average/plane_average.h"
#include "methods/exact/direct.h"

enum { MOST_POINTS = 2000 };

/* The integrand. */
struct point_light {
    const struct pp_world *world;
    const struct pp_opening *opening;
    const struct pp_plane_light *light;
};

/* Adds a patch's light at a point that faces up. */
static enum pp_status add_patch_light(const struct point_light *of,
                                      const struct pp_visible *visible,
                                      const struct pp_visible_patch *patch,
                                      double values[PP_PLANE_VALUES])
{
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    const struct pp_plane_light *light = of->light;
    const struct pp_integrand sky = {light->sky, light->context, NULL};
    const struct pp_integrand exitance = {light->exitance, light->context, NULL};
    double value;
    enum pp_status status =
        pp_direct_quadrature(&value, visible, patch, up, &sky, NULL);
    if (status != PP_OK)
        return status;
    if (!patch->hidden) {
        values[0] += value;
        return PP_OK;
    }
    values[1] += light->of_reflectance * patch->reflectance * value;
    if (!light->exitance || !(patch->exitance > 0.0))
        return PP_OK;
    status = pp_direct_quadrature(&value, visible, patch, up, &exitance, NULL);
    values[1] += patch->exitance / PP_PI * value;
    return status;
}

static bool point_light_at(void *data, int centre, const struct pp_receiver *receiver,
                           double values[PP_PLANE_VALUES])
{
    (void)centre;
    const struct point_light *of = data;
    struct pp_visible visible;
    enum pp_status status =
        (of->light->with_outside ? pp_visible_in_parts : pp_visible_opening)(
            &visible, of->world, of->opening, receiver->position, NULL);
    if (status != PP_OK)
        return false;
    values[0] = values[1] = 0.0;
    for (int i = 0; i < visible.patch_count && status == PP_OK; i++)
        status = add_patch_light(of, &visible, &visible.patches[i], values);
    pp_visible_clear(&visible);
    return status == PP_OK;
}

enum pp_status pp_point_average(double mean[2], const struct pp_world *world,
                                const struct pp_opening *opening,
                                const struct pp_plane_light *light,
                                struct pp_error *err)
{
    struct point_light of = {world, opening, light};
    const struct pp_plane_centre centre = pp_plane_centre_of(opening);
    struct pp_thread_pool *alone;
    bool stopped = false;
    enum pp_status status = pp_thread_pool_create(&alone, 1, err);
    if (status != PP_OK)
        return status;
    status = pp_plane_average(mean, &stopped, world, &centre, 1, point_light_at, &of,
                              PP_POINT_AVERAGE_ERROR, MOST_POINTS, alone, err);
    pp_thread_pool_destroy(alone);
    if (status == PP_OK && stopped)
        status = pp_fail_memory(err);
    return status;
}
