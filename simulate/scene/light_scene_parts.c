/* light_scene_parts.c - scattering and transmission at the part that a ray has met. */
#include "simulate/scene/light_scene_parts.h"

void pp_light_scene_parts_lobes(const struct pp_light_scene *scene,
                                const struct pp_light_hit *hit, struct pp_vec3 to,
                                struct pp_lobes *lobes)
{
    pp_scatter_init(lobes, &scene->materials[hit->material],
                    pp_light_scene_gloss(scene, hit->material), hit->normal,
                    pp_vec_scale(to, -1.0));
    const struct pp_material *material = &scene->materials[hit->material];
    if (!material->surface_pattern)
        return;
    if (material->bumps)
        pp_scatter_add_bumps(lobes, material, pp_vec_add(hit->point, scene->centre));
    else
        lobes->share[PP_LOBE_DIFFUSE] = pp_light_scene_parts_diffuse(scene, hit);
}

bool pp_light_scene_parts_pass(const struct pp_light_scene *scene,
                               const struct pp_light_hit *hit, struct pp_light_ray *ray,
                               struct pp_rgb *light)
{
    *light = pp_rgb_times(*light, pp_scatter_straight(&scene->materials[hit->material],
                                                      hit->normal,
                                                      pp_vec_scale(ray->to, -1.0)));
    ray->from = hit->point;
    ray->off = pp_vec_scale(hit->normal, -1.0);
    ray->space = pp_light_scene_parts_space(scene, hit, true);
    return !pp_rgb_is_black(*light);
}

bool pp_light_scene_parts_reflect(const struct pp_light_scene *scene,
                                  const struct pp_light_hit *hit,
                                  struct pp_light_ray *ray, struct pp_rgb *light)
{
    double cosine = -pp_vec_dot(hit->normal, ray->to);
    if (pp_light_scene_gloss(scene, hit->material))
        return false;
    *light = pp_rgb_times(*light, pp_scatter_specular_reflectance(
                                      &scene->materials[hit->material], cosine));
    ray->from = hit->point;
    ray->off = hit->normal;
    ray->to = pp_vec_mirrored(ray->to, hit->normal);
    ray->space = hit->space;
    return !pp_rgb_is_black(*light);
}
