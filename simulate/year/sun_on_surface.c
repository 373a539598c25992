/* sun_on_surface.c - tests whether openings are in the sun's direction, then traces the
 * ray. */
#include "simulate/year/sun_on_surface.h"

#include <math.h>

#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/rays.h"

/* Intersection of a target's plane, from the room's side, with the line from a point
 * along u; false if there is none. */
static bool meets_plane(const struct pp_target *target, struct pp_vec3 point,
                        struct pp_vec3 u, struct pp_vec3 *at)
{
    double height = pp_target_height(target, point);
    double approach = -pp_vec_dot(target->normal, u);
    if (!(height > 0.0) || !(approach > 0.0))
        return false;
    *at = pp_vec_along(point, height / approach, u);
    return true;
}

static bool in_rectangle(const struct pp_target *target, struct pp_vec3 at)
{
    struct pp_vec3 d = pp_vec_sub(at, target->corner);
    double x = pp_vec_dot(d, target->along), y = pp_vec_dot(d, target->up);
    return x >= 0.0 && x <= target->width_m && y >= 0.0 && y <= target->height_m;
}

/* True if u leads from an indoor point to a pane, or to the plane of a pane that is no
 * rectangle. *free: nothing can hide this pane, on either side; *pane is then set. */
static bool leads_to_pane(const struct pp_light_scene *scene, struct pp_vec3 point,
                          struct pp_vec3 u, int *pane, bool *free)
{
    bool leads = false;
    *free = false;
    for (int i = 0; i < scene->pane_count; i++) {
        const struct pp_pane *p = &scene->panes[i];
        struct pp_vec3 at;
        if (!meets_plane(&p->target, point, u, &at))
            continue;
        if (!p->target.rectangle) {
            leads = true;
        } else if (in_rectangle(&p->target, at)) {
            leads = true;
            *free = p->seen_by_all && p->unobstructed;
            *pane = i;
            if (*free)
                return true;
        }
    }
    return leads;
}

static double regular_transmittance(const struct pp_light_scene *scene, int pane,
                                    struct pp_vec3 u)
{
    const struct pp_light_part *part = &scene->parts[scene->panes[pane].part];
    return pp_scatter_straight(&scene->materials[part->material[0]], part->normal,
                               pp_vec_scale(u, -1.0))
        .g;
}

/* The transmittance along the ray to the sun; 0 if the ray meets an opaque surface.
 * *opening: the last opening that the ray passes from inside; unchanged if there is
 * none. */
static double traced(const struct pp_light_scene *scene, struct pp_light_ray ray,
                     int *opening)
{
    struct pp_rgb light = pp_rgb_grey(1.0);
    struct pp_light_hit hit;
    for (;;) {
        enum pp_meeting meeting = pp_light_scene_meet(scene, &ray, &hit);
        if (meeting == PP_MEETS_ENVIRONMENT)
            return light.g;
        if (meeting != PP_MEETS_PART)
            return 0.0;
        int window = scene->parts[hit.part].window; /* -1: surface or outer pane */
        hit.point = pp_rays_draw_back(hit.point, ray.to);
        if (!pp_light_scene_parts_pass(scene, &hit, &ray, &light))
            return 0.0;
        if (window >= 0 && !hit.back)
            *opening = window;
    }
}

double pp_sun_on_surface(const struct pp_light_scene *scene,
                         const struct pp_lit_point *at, struct pp_vec3 sun,
                         int *opening)
{
    double cosine = pp_vec_dot(at->normal, sun);
    int pane = -1;
    bool free = false;
    *opening = -1;
    if (!(cosine > 0.0) || !(sun.z > 0.0)
        || pp_scene_skylines_far(&scene->skylines, sun) >= 0)
        return 0.0;
    if (at->space == PP_INDOORS && !leads_to_pane(scene, at->point, sun, &pane, &free))
        return 0.0;
    if (free) {
        *opening = scene->parts[scene->panes[pane].part].window;
        return cosine * regular_transmittance(scene, pane, sun);
    }
    struct pp_light_ray ray = {at->point, at->normal, sun, at->space};
    return cosine * traced(scene, ray, opening);
}

double pp_sun_on_surface_scattered(const struct pp_opening *opening, struct pp_vec3 sun,
                                   int leaving)
{
    const struct pp_pane_scatter *scatter =
        opening->scatter->for_sun ? opening->scatter->for_sun : opening->scatter;
    struct pp_vec3 in =
        pp_vec(-pp_vec_dot(sun, opening->along), -pp_vec_dot(sun, opening->up),
               -pp_vec_dot(sun, opening->inner.normal));
    return in.z > 0.0 ? scatter->class_btdf(scatter->data, in, leaving) : 0.0;
}
