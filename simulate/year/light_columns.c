/* light_columns.c - each hour's luminances at the centres of the patches. */
#include "simulate/year/light_columns.h"

#include <math.h>
#include <stdlib.h>

/* Task of a pool's workers: filling the columns of several hours. */
struct columns_work {
    struct pp_light_columns *light;
    const struct pp_environment *environment;
    struct pp_vec3 *centres;
    double *solid_angles;
};

/* Exitance of a skyline, divided by pi, under one sky: sun and sky illuminate its face
 * and the ground in front of it (environment.h). */
static double skyline_of(const struct columns_work *work,
                         const struct pp_perez_sky *sky,
                         const struct pp_far_skyline *far)
{
    struct pp_vec3 n = pp_vec_scale(far->outward, -1.0);
    double E = 0.0;
    for (int i = 0; i < work->light->patches.count; i++) {
        double facing = pp_vec_dot(n, work->centres[i]);
        if (facing > 0.0)
            E += facing * work->solid_angles[i]
                 * pp_perez_sky_luminance(sky, work->centres[i]);
    }
    if (sky->sun.z > 0.0)
        E += sky->direct_lx * fmax(0.0, pp_vec_dot(n, sky->sun));
    E += 0.5 * pp_outside_light_ground(&work->environment->light)
         * pp_light_columns_horizontal(sky);
    return far->reflectance * E / PP_PI;
}

static bool light_hour(void *data, int worker, int hour)
{
    (void)worker;
    struct columns_work *work = data;
    struct pp_light_columns *light = work->light;
    const struct pp_perez_sky *sky = &light->skies[hour];
    float *at =
        light->columns
        + (size_t)(hour / PP_LIGHT_LANES) * (size_t)light->column_count * PP_LIGHT_LANES
        + hour % PP_LIGHT_LANES;
    size_t step = PP_LIGHT_LANES;
    for (int i = 0; i < light->patches.count; i++, at += step)
        *at = (float)pp_perez_sky_luminance(sky, work->centres[i]);
    *at = (float)pp_light_columns_horizontal(sky);
    for (int i = 0; i < work->environment->skylines->far_count; i++)
        *(at += step) =
            (float)skyline_of(work, sky, &work->environment->skylines->far[i]);
    return true;
}

enum pp_status pp_light_columns_init(struct pp_light_columns *light,
                                     const struct pp_environment *environment,
                                     const struct pp_perez_sky *skies, int count,
                                     int patch_count, double north_rad,
                                     struct pp_thread_pool *pool, struct pp_error *err)
{
    struct columns_work work = {.light = light, .environment = environment};
    *light = (struct pp_light_columns){.count = count,
                                       .tiles = (count + PP_LIGHT_LANES - 1)
                                                / PP_LIGHT_LANES,
                                       .skies = skies};
    if (!pp_sky_patches_init(&light->patches, patch_count, north_rad))
        return pp_fail(err, PP_BAD_INPUT,
                       "there are %d sky patches; expected 145, 577 or 2305",
                       patch_count);
    light->column_count = patch_count + 1 + environment->skylines->far_count;
    light->columns = calloc((size_t)light->column_count * (size_t)light->tiles + 1,
                            PP_LIGHT_LANES * sizeof *light->columns);
    work.centres = calloc((size_t)patch_count, sizeof *work.centres);
    work.solid_angles = calloc((size_t)patch_count, sizeof *work.solid_angles);
    bool enough = light->columns && work.centres && work.solid_angles;
    for (int i = 0; enough && i < patch_count; i++) {
        work.centres[i] = pp_sky_patches_centre(&light->patches, i);
        work.solid_angles[i] = pp_sky_patches_solid_angle(&light->patches, i);
    }
    if (enough)
        pp_thread_pool_run_small(pool, 0, count, light_hour, &work);
    free(work.centres);
    free(work.solid_angles);
    if (enough)
        return PP_OK;
    pp_light_columns_clear(light);
    return pp_fail_memory(err);
}

void pp_light_columns_clear(struct pp_light_columns *light)
{
    free(light->columns);
    light->columns = NULL;
}
