/* path_trace.c - the path-tracing loop: emission, direct light, a direction of a lobe,
 * Russian roulette. */
#include "simulate/path_tracer/path_trace.h"

#include "simulate/path_tracer/next_event.h"
#include "simulate/sampling/sample_discrete.h"
#include "simulate/sampling/lobe.h"
#include "simulate/scene/light_scene_parts.h"

/* Russian roulette begins where beta has fallen below LEAST. A path ends at MOST_BOUNCES
 * where nothing absorbs. */
static const double LEAST = 0.3;
enum { MOST_BOUNCES = 1 << 14 };

void pp_path_trace_draw(struct pp_path_trace *path, int count, double *u)
{
    pp_sobol_sequence_draw(&path->sequence, path->index, path->vertex++, count, u);
}

enum pp_meeting pp_path_trace_meet(struct pp_path_trace *path,
                                   const struct pp_light_ray *ray,
                                   struct pp_light_hit *hit)
{
    enum pp_meeting meeting = pp_light_scene_trace(path->scene, ray, hit);
    path->rays++;
    path->leaks += meeting == PP_MEETS_LEAK;
    return meeting;
}

/* The lobes of the surface towards wo; the ground outside is diffuse. */
static struct pp_lobes lobes_at(const struct pp_path_trace *path,
                                enum pp_meeting meeting, const struct pp_light_hit *hit,
                                struct pp_vec3 wo)
{
    struct pp_lobes lobes = {.eye = wo, .frame = {.z = hit->normal}};
    if (meeting == PP_MEETS_PART) {
        pp_light_scene_parts_lobes(path->scene, hit, pp_vec_scale(wo, -1.0), &lobes);
        return lobes;
    }
    lobes.share[PP_LOBE_DIFFUSE] =
        pp_rgb_grey(pp_outside_light_ground(&path->environment->light));
    pp_lobe_frame(hit->normal, &lobes.frame.x, &lobes.frame.y);
    return lobes;
}

/* Radiance of the surface's own along the ray; lamps that were sampled are left out. */
static struct pp_rgb emitted(const struct pp_path_trace *path,
                             const struct pp_light_hit *hit,
                             struct pp_path_counted counted)
{
    const struct pp_light_part *part = &path->scene->parts[hit->part];
    const struct pp_material *material = &path->scene->materials[hit->material];
    bool gives =
        material->emits != PP_EMITS_NOTHING && (!hit->back || part->back_emits);
    bool sampled = part->emitter[hit->back] >= 0 && counted.emitters;
    return gives && !sampled ? material->radiance : pp_rgb_grey(0.0);
}

/* Radiance of sky, open ground, skylines and distant sources along the ray. */
static struct pp_rgb environment_light(const struct pp_path_trace *path,
                                       struct pp_vec3 direction,
                                       struct pp_path_counted counted, bool *is_sky)
{
    const struct pp_light_scene *scene = path->scene;
    struct pp_rgb L =
        pp_light_scene_environment(scene, path->environment, direction, is_sky);
    for (int i = 0; i < scene->distant_count && !counted.emitters; i++)
        if (scene->distants[i].emitter >= 0)
            L = pp_rgb_add(L, pp_light_scene_distant_radiance(scene, i, direction));
    return L;
}

enum pp_lobe pp_path_trace_scatter(struct pp_path_trace *path,
                                   const struct pp_lobes *lobes,
                                   const struct pp_light_hit *hit,
                                   struct pp_light_ray *ray, struct pp_rgb *beta)
{
    double u[3], albedo[PP_LOBE_COUNT], total = 0.0, factor;
    pp_path_trace_draw(path, 3, u);
    for (int i = 0; i < PP_LOBE_COUNT; i++)
        total += albedo[i] = pp_rgb_most(lobes->share[i]);
    int lobe = pp_sample_discrete(albedo, PP_LOBE_COUNT, u[2] * total);
    struct pp_vec3 wi;
    if (lobe < 0
        || !pp_scatter_sample(lobes, (enum pp_lobe)lobe, u[0], u[1], &wi, &factor))
        return PP_LOBE_COUNT;
    /* The lobe's BSDF x cosine / pdf is its albedo times the factor; the lobe itself was
     * drawn with the probability albedo / total. */
    *beta = pp_rgb_times(*beta, lobes->share[lobe]);
    *beta = pp_rgb_scale(*beta, factor * total / albedo[lobe]);

    bool through = pp_scatter_goes_through((enum pp_lobe)lobe);
    struct pp_vec3 n = lobes->frame.z;
    enum pp_space space = hit->space;
    if (hit->part >= 0)
        space = pp_light_scene_parts_space(path->scene, hit, through);
    *ray = (struct pp_light_ray){.from = pp_rays_draw_back(hit->point, ray->to),
                                 .off = through ? pp_vec_scale(n, -1.0) : n,
                                 .to = wi,
                                 .space = space};
    return (enum pp_lobe)lobe;
}

/* theory: path loop */
struct pp_rgb pp_path_trace_radiance(struct pp_path_trace *path,
                                     struct pp_light_ray ray,
                                     struct pp_path_counted counted, bool aims,
                                     enum pp_path_first *first)
{
    struct pp_rgb L = pp_rgb_grey(0.0), beta = pp_rgb_grey(1.0);
    enum pp_path_first met = PP_FIRST_NONE;
    for (int bounce = 0; bounce < MOST_BOUNCES; bounce++) {
        /* 1. The first surface that the ray meets, if any. */
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_path_trace_meet(path, &ray, &hit);
        if (meeting == PP_MEETS_LEAK)
            break;
        if (meeting == PP_MEETS_ENVIRONMENT) {
            bool is_sky;
            struct pp_rgb Le = environment_light(path, ray.to, counted, &is_sky);
            L = pp_rgb_add(L, pp_rgb_times(beta, Le));
            if (met == PP_FIRST_NONE)
                met = is_sky ? PP_FIRST_SKY : PP_FIRST_OUTSIDE;
            break;
        }

        /* 2. Its own light. */
        if (meeting == PP_MEETS_PART)
            L = pp_rgb_add(L, pp_rgb_times(beta, emitted(path, &hit, counted)));

        /* 3. The lobes of its BSDF. Light that comes in by an opening has been counted
         * where the ray began: of that opening, the ray sees the reflection alone. */
        struct pp_vec3 wo = pp_vec_scale(ray.to, -1.0);
        struct pp_lobes lobes = lobes_at(path, meeting, &hit, wo);
        bool opening =
            meeting == PP_MEETS_PART && path->scene->parts[hit.part].window >= 0;
        if (opening && !hit.back && counted.openings)
            pp_next_event_leave_out(&lobes);

        /* 4. Next-event estimation: openings and lamps by directions of their own. */
        struct pp_light_hit from = hit;
        from.point = pp_rays_draw_back(hit.point, ray.to);
        L = pp_rgb_add(
            L, pp_rgb_times(beta, pp_next_event_reflected(path, &lobes, &from, aims)));

        /* 5. A direction wi of one of the lobes. */
        enum pp_lobe lobe = pp_path_trace_scatter(path, &lobes, &hit, &ray, &beta);
        if (lobe == PP_LOBE_COUNT)
            break;
        if (!pp_scatter_goes_through(lobe) && met == PP_FIRST_NONE)
            met = hit.space == PP_INDOORS ? PP_FIRST_INSIDE : PP_FIRST_OUTSIDE;
        if (lobe != PP_LOBE_STRAIGHT)
            counted = pp_next_event_counted(lobe, ray.space, aims);

        /* 6. Russian roulette: a faint path goes on with probability q. */
        double u, q = pp_rgb_most(beta) / LEAST;
        pp_path_trace_draw(path, 1, &u);
        if (u >= q)
            break;
        if (q < 1.0)
            beta = pp_rgb_scale(beta, 1.0 / q);
    }
    if (first)
        *first = met;
    return L;
}
/* theory: end */
