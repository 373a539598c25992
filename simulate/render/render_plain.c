/* render_plain.c - see render_plain.h. */
#include "simulate/render/render_plain.h"

#include <stddef.h>

#include "simulate/path_tracer/path_trace.h"
#include "simulate/scene/light_scene_parts.h"

struct pp_rgb pp_render_plain_radiance(struct pp_path_walk *walk,
                                       struct pp_light_ray ray)
{
    walk->vertex = 0;
    ray.from = pp_vec_sub(ray.from, walk->scene->centre);
    return pp_path_trace_radiance(walk, ray, false, true, NULL);
}

bool pp_render_plain_irradiance(struct pp_path_walk *walk, struct pp_light_ray ray,
                                double decorations, struct pp_rgb *value)
{
    struct pp_light_hit hit;
    walk->vertex = 0;
    ray.from = pp_vec_sub(ray.from, walk->scene->centre);
    if (pp_path_walk_meet(walk, &ray, &hit) != PP_MEETS_PART)
        return false;
    const struct pp_material *material = &walk->scene->materials[hit.material];
    if (material->kind == PP_MATERIAL_GLASS || material->kind == PP_MATERIAL_AIR)
        return false;
    const struct pp_lit_point at = {hit.point, hit.normal, hit.space};
    bool indoors = hit.space == PP_INDOORS;
    enum pp_path_first first = PP_FIRST_NONE;
    struct pp_rgb direct = pp_rgb_grey(0.0);
    if (indoors)
        direct = pp_path_trace_openings(walk, &at, &first);
    if (first == PP_FIRST_INSIDE)
        direct = pp_rgb_scale(direct, decorations);
    struct pp_rgb reflected = pp_path_trace_lobe(walk, &at, indoors, NULL);
    *value = pp_rgb_add(direct, pp_rgb_scale(reflected, indoors ? decorations : 1.0));
    return true;
}
