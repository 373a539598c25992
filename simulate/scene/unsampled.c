/* unsampled.c - the light that rays have to find by themselves, summed and bounded. */
#include "simulate/scene/unsampled.h"

#include <math.h>

#include "simulate/scene/light_scene_parts.h"

/* Over the emitters so far. */
struct unsampled_light {
    struct pp_rgb
        all; /* the irradiance of all of them, from the cone that each fills */
    struct pp_rgb brightest; /* the greatest radiance */
};

static struct pp_rgb greater(struct pp_rgb a, struct pp_rgb b)
{
    return pp_rgb(fmax(a.r, b.r), fmax(a.g, b.g), fmax(a.b, b.b));
}

static void add_unsampled(struct unsampled_light *light, struct pp_rgb radiance,
                          double solid, double share)
{
    if (!(share > 0.0))
        return;
    light->all = pp_rgb_along(light->all, share * fmin(solid, PP_PI), radiance);
    light->brightest = greater(light->brightest, radiance);
}

void pp_unsampled_find_glow(struct pp_light_scene *scene)
{
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side <= (int)scene->parts[i].back_emits; side++) {
            const struct pp_material *material =
                &scene->materials[scene->parts[i].material[side]];
            if (material->emits == PP_EMITS_EXTENDED)
                scene->glow = greater(scene->glow, material->radiance);
        }
}

struct pp_rgb pp_unsampled_bound(const struct pp_light_scene *scene,
                                 struct pp_vec3 point, bool by_chance, long paths)
{
    struct unsampled_light light = {pp_rgb_grey(0.0), pp_rgb_grey(0.0)};
    struct pp_vec3 from = pp_vec_sub(point, scene->centre);
    for (int i = 0; i < scene->emitter_count; i++) {
        double spread = pp_emitters_angular_size(&scene->emitters[i], scene, from);
        add_unsampled(&light, scene->emitters[i].radiance, spread * spread,
                      by_chance ? 1.0 : scene->unsampled_share);
    }
    for (int i = 0; i < scene->distant_count; i++) {
        const struct pp_distant *distant = &scene->distants[i];
        const struct pp_material *material = &scene->materials[distant->material];
        if (distant->emitter < 0 && material->pattern < 0)
            add_unsampled(&light, material->radiance, distant->solid, 1.0);
    }
    add_unsampled(&light, scene->glow, PP_PI, 1.0);
    struct pp_rgb one = pp_rgb_scale(light.brightest, PP_PI / (double)paths);
    return pp_rgb(fmin(light.all.r, one.r), fmin(light.all.g, one.g),
                  fmin(light.all.b, one.b));
}
