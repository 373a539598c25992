/* path_vertex.c - a shading point's BRDF, and how many directions sample a source. */
#include "simulate/transport/path_vertex.h"

struct pp_rgb pp_path_vertex_brdf(const struct pp_shading_point *shading,
                                  struct pp_vec3 o, double angular_size)
{
    const struct pp_lobes *lobes = shading->lobes;
    bool through = pp_vec_dot(lobes->frame.z, shading->normal) < 0.0;
    struct pp_rgb diffuse =
        lobes->share[through ? PP_LOBE_THROUGH_DIFFUSE : PP_LOBE_DIFFUSE];
    struct pp_rgb f = pp_rgb_scale(diffuse, 1.0 / PP_PI);
    if (angular_size < PP_DIRECTLY_SAMPLED_WIDTHS * pp_scatter_gloss_width(lobes))
        f = pp_rgb_add(f, pp_scatter_gloss_brdf(lobes, o));
    return f;
}

uint32_t pp_path_vertex_direction_count(const struct pp_radiance_state *state,
                                        const struct pp_shading_point *shading,
                                        double angular_size)
{
    double size = state->options.source_size;
    uint32_t count = 1, most = (uint32_t)state->options.source_most;
    if (!shading->split || !(size > 0.0))
        return count;
    double wanted = angular_size / size * (angular_size / size);
    while ((double)count < wanted && 2 * count <= most)
        count *= 2;
    return count;
}
