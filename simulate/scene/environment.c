/* environment.c - the exitance of a scene's skylines, and the light in a direction. */
#include "simulate/scene/environment.h"

#include <math.h>
#include <stdlib.h>

#include "model/light/graded_sky.h"
#include "model/light/photographs/sky_bright.h"
#include "model/light/photographs/sky_picture.h"
#include "simulate/sampling/hash.h"

/* Brightness of an overcast sky and of the ground, relative to the sky at the
 * horizon. */
static struct pp_brightness brightness_of(const struct pp_outside_light *light)
{
    double b = PP_GRADED_SKY_OVERCAST;
    return (struct pp_brightness){.ground = pp_outside_light_ground(light)
                                            / pp_graded_sky_horizon(b),
                                  .gradation = b};
}

static void light_skylines(struct pp_environment *environment)
{
    const struct pp_scene_skylines *skylines = environment->skylines;
    const struct pp_outside_light *light = &environment->light;
    for (int i = 0; i < skylines->far_count; i++) {
        const struct pp_far_skyline *far = &skylines->far[i];
        environment->far_exitance[i] = pp_outside_light_exitance(
            light, far->reflectance, pp_vec_scale(far->outward, -1.0));
    }
}

enum pp_status pp_environment_create(struct pp_environment **result,
                                     const struct pp_scene_skylines *skylines,
                                     const struct pp_outside_light *light,
                                     struct pp_error *err)
{
    *result = NULL;
    struct pp_environment *environment = calloc(1, sizeof *environment);
    if (!environment)
        return pp_fail_memory(err);
    environment->light = *light;
    environment->skylines = skylines;
    environment->brightness = brightness_of(light);
    enum pp_status status =
        pp_sky_bright_create(&environment->bright, &light->sky, err);
    environment->brightness.bright = environment->bright;
    environment->far_exitance =
        calloc((size_t)skylines->far_count + 1, sizeof *environment->far_exitance);
    if (status == PP_OK && !environment->far_exitance)
        status = pp_fail_memory(err);
    if (status != PP_OK) {
        pp_environment_destroy(environment);
        return status;
    }
    light_skylines(environment);
    *result = environment;
    return PP_OK;
}

void pp_environment_destroy(struct pp_environment *environment)
{
    if (!environment)
        return;
    pp_sky_bright_destroy(environment->bright);
    free(environment->far_exitance);
    free(environment);
}

uint64_t pp_environment_hash(const struct pp_environment *environment)
{
    const struct pp_sky *sky = &environment->light.sky;
    const double numbers[] = {sky->kind,
                              sky->iso,
                              sky->a,
                              sky->b,
                              sky->c,
                              sky->d,
                              sky->e,
                              sky->per_horizontal,
                              pp_outside_light_ground(&environment->light)};
    uint64_t hash = pp_hash_vec(0, sky->sun);
    if (environment->light.sun.per_sky > 0.0)
        hash = pp_hash_double(pp_hash_vec(hash, environment->light.sun.to),
                              environment->light.sun.per_sky);
    if (sky->kind == PP_SKY_PICTURE)
        hash = pp_hash(pp_hash_double(hash, sky->north[1]), sky->picture->hash);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        hash = pp_hash_double(hash, numbers[i]);
    return hash;
}

double pp_environment_light(const struct pp_environment *environment, struct pp_vec3 u,
                            bool *is_sky)
{
    *is_sky = false;
    if (!(u.z > 0.0))
        return pp_outside_light_sunlit_ground(&environment->light);
    int far = pp_scene_skylines_far(environment->skylines, u);
    if (far >= 0)
        return environment->far_exitance[far];
    *is_sky = true;
    return PP_PI * pp_sky_luminance(&environment->light.sky, u);
}
