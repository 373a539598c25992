/* light_images.c - a direction to an opening's image, and from the reflector to the
 * opening. */
#include "simulate/transport/light_images.h"

#include "simulate/scene/environment.h"

static int vertex_of(const struct pp_shading_point *shading)
{
    return pp_path_vertex_branch(shading->vertex * PP_DRAWS + PP_DRAW_WINDOWS, -2);
}

/* Weight of light from direction `to`, drawn with density `pdf`, at the diffuse
 * surface. */
static struct pp_rgb weight_of(const struct pp_shading_point *shading,
                               struct pp_vec3 to, double pdf)
{
    double cosine = pp_vec_dot(shading->normal, to);
    if (!(cosine > 0.0) || !(pdf > 0.0))
        return pp_rgb_grey(0.0);
    return pp_rgb_scale(shading->diffuse, pp_path_vertex_mis(pdf, cosine / PP_PI)
                                              * cosine / (PP_PI * pdf));
}

bool pp_light_images_view(struct pp_radiance_state *state,
                          const struct pp_shading_point *shading,
                          struct pp_image_view *view)
{
    const struct pp_light_scene *scene = state->scene;
    int most = state->options.bounces;
    if (!pp_path_vertex_images(state) || shading->space == PP_OUTDOORS
        || pp_rgb_is_black(shading->diffuse) || (most >= 0 && shading->depth >= most))
        return false;
    double u[3], probability, pdf;
    int vertex = vertex_of(shading);
    const struct pp_image_viewer viewer = {shading->point, shading->normal,
                                           &state->environment->brightness};
    struct pp_light_ray ray = pp_path_vertex_shadow_ray(shading, shading->normal);
    struct pp_light_hit hit;
    pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 3, u);
    int image = pp_window_images_choose(scene, &viewer, u[2], &probability);
    if (image < 0
        || !pp_window_images_sample(scene, image, &viewer, u[0], u[1], &ray.to, &pdf))
        return false;
    view->weight = weight_of(shading, ray.to, probability * pdf);
    if (pp_rgb_is_black(view->weight)
        || pp_radiance_state_meet(state, &ray, &hit) != PP_MEETS_PART
        || scene->parts[hit.part].reflector[hit.back]
               != scene->window_images[image].reflector)
        return false;
    pp_light_scene_parts_lobes(scene, &hit, ray.to, &view->lobes);
    view->window = scene->window_images[image].window;
    view->there =
        (struct pp_shading_point){.point = pp_rays_draw_back(hit.point, ray.to),
                                  .normal = hit.normal,
                                  .space = hit.space,
                                  .diffuse = pp_rgb_grey(0.0),
                                  .vertex = vertex,
                                  .depth = shading->depth + 1,
                                  .whole_gloss = true};
    return true;
}

/* True if the lobe fills a smaller solid angle than the window, as seen from the
 * reflector. Facets of slopes up to the roughness turn a direction by twice as much. */
static bool is_narrow(const struct pp_radiance_state *state,
                      const struct pp_image_view *view)
{
    const struct pp_gloss *gloss = view->lobes.gloss;
    double size =
        pp_openings_angular_size(&state->scene->panes[view->window], view->there.point);
    return 4.0 * PP_PI * gloss->along * gloss->across < size * size;
}

bool pp_light_images_sample(struct pp_radiance_state *state,
                            const struct pp_image_view *view,
                            struct pp_opening_sample *sample)
{
    struct pp_shading_point there = view->there;
    enum pp_lobe lobe = view->lobes.gloss ? PP_LOBE_GLOSS : PP_LOBE_MIRROR;
    double u[2];
    struct pp_rgb factor;
    there.lobes = &view->lobes;
    pp_sobol_sequence_draw(&state->sequence, state->index,
                           pp_path_vertex_branch(there.vertex, 0), 2, u);
    if (lobe == PP_LOBE_MIRROR || is_narrow(state, view)) {
        struct pp_vec3 to;
        if (!pp_scatter_sample(&view->lobes, lobe, u[0], u[1], &to, &factor)
            || !pp_sample_openings_along(state, &there, view->window, to, sample))
            return false;
        pp_sample_openings_scale(sample, pp_rgb_times(view->lobes.share[lobe], factor));
    } else if (!pp_sample_openings_aim(state, &there, view->window, u, sample)) {
        return false;
    }
    pp_sample_openings_scale(sample, view->weight);
    return true;
}

bool pp_light_images_in_glass(struct pp_radiance_state *state,
                              const struct pp_shading_point *shading,
                              struct pp_glass_view *view,
                              struct pp_shading_point *there,
                              struct pp_opening_sample *sample)
{
    const struct pp_light_scene *scene = state->scene;
    struct pp_light_ray ray = pp_path_vertex_shadow_ray(shading, shading->normal);
    struct pp_light_hit hit;
    double u[4], pdf; /* direction (2), choice of an image, whether to sample one */
    int vertex =
        pp_path_vertex_branch(shading->vertex * PP_DRAWS + PP_DRAW_WINDOWS, -3);
    pp_sobol_sequence_draw(&state->sequence, state->index, vertex, 4, u);
    if (u[3] >= PP_GLASS_CHANCE)
        return false;
    int image =
        pp_glass_images_sample(scene, view, shading->point, shading->normal,
                               &state->environment->brightness, u, &ray.to, &pdf);
    if (image < 0)
        return false;
    double cosine = pp_vec_dot(shading->normal, ray.to);
    const struct pp_glass_image *pair = &scene->glass_images[image];
    if (!(cosine > 0.0) || pp_radiance_state_meet(state, &ray, &hit) != PP_MEETS_PART
        || hit.part != scene->panes[pair->glass].part || hit.back)
        return false;
    struct pp_rgb weight =
        pp_rgb_scale(shading->diffuse, cosine / (PP_PI * pdf * PP_GLASS_CHANCE));
    hit.point = pp_rays_draw_back(hit.point, ray.to);
    if (!pp_light_scene_parts_reflect(scene, &hit, &ray, &weight))
        return false;
    *there = (struct pp_shading_point){.point = hit.point,
                                       .normal = hit.normal,
                                       .space = hit.space,
                                       .vertex = vertex,
                                       .depth = shading->depth};
    if (!pp_sample_openings_along(state, there, pair->window, ray.to, sample))
        return false;
    pp_sample_openings_scale(sample, weight);
    return true;
}
