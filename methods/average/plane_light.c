/* plane_light.c - see plane_light.h. */
#include "methods/average/plane_light.h"

#include "methods/average/plane_average.h"
#include "methods/exact/direct.h"
#include "methods/fast/beam_average.h"
#include "methods/exact/pane_luminance.h"
#include "methods/view/visible.h"

/* ---- plain: an integral over points of the plane ---- */

/* Target error of the mean from the cubature over the plane, relative to the sum of
 * both components; at each point the view is integrated to PP_QUADRATURE_GLAZED. */
static const double POINT_AVERAGE_ERROR = 1e-3;

enum { MOST_POINTS = 2000 };

/* The integrand. */
struct point_light {
    const struct pp_world *world;
    const struct pp_opening *opening;
    const struct pp_plane_light *light;
};

/* Adds the light from a patch at a point that faces up. */
static enum pp_status add_patch_light(const struct point_light *of,
                                      const struct pp_visible *visible,
                                      const struct pp_visible_patch *patch,
                                      double values[PP_PLANE_VALUES])
{
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    const struct pp_plane_light *light = of->light;
    const struct pp_integrand sky = {light->sky, light->context, NULL,
                                     light->grain_rad};
    const struct pp_integrand exitance = {light->exitance, light->context, NULL, 0.0};
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

/* As pp_plane_light_average, but integrates the view, patch by patch, at each point of
 * a cubature. */
static enum pp_status average_over_points(double mean[2], const struct pp_world *world,
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
                              POINT_AVERAGE_ERROR, MOST_POINTS, alone, err);
    pp_thread_pool_destroy(alone);
    if (status == PP_OK && stopped)
        status = pp_fail_memory(err);
    return status;
}

/* ---- by points or by beams ---- */

enum pp_status pp_plane_light_average(double mean[2], struct pp_beams *beams,
                                      const struct pp_opening *opening,
                                      const struct pp_plane_light *light,
                                      struct pp_error *err)
{
    return pp_beams_plain(beams)
               ? average_over_points(mean, pp_beams_world(beams), opening, light, err)
               : pp_beam_average(mean, beams, opening, light, PP_BEAM_AVERAGE_ERROR,
                                 err);
}

enum pp_status pp_plane_light_direct(double mean[2], struct pp_beams *beams,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_glass *glass, struct pp_error *err)
{
    const struct pp_pane_luminance luminance = {
        &light->sky, glass, pp_vec_scale(opening->inner.normal, -1.0)};
    const struct pp_plane_light through = {
        .sky = pp_pane_luminance_sky,
        .exitance = pp_pane_luminance_unity,
        .context = &luminance,
        .grain_rad = PP_QUADRATURE_GRAINS_ROUGH * pp_sky_grain(&light->sky),
        .of_reflectance = pp_visible_luminance_factor(&light->sky, 1.0),
        .with_outside = true};
    struct pp_kept_beam *kept;
    if (pp_beams_plain(beams))
        return pp_plane_light_average(mean, beams, opening, &through, err);
    enum pp_status status =
        pp_beams_of(&kept, beams, opening, through.with_outside, err);
    if (status != PP_OK || pp_kept_beam_means(mean, kept, glass))
        return status;
    status = pp_plane_light_average(mean, beams, opening, &through, err);
    if (status == PP_OK)
        pp_kept_beam_keep_means(kept, glass, mean);
    return status;
}
