/* eye_rays.c - see eye_rays.h. */
#include "simulate/year/eye_rays.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/sampling/lobe.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/rays.h"
#include "simulate/year/sun_on_surface.h"

/* Direction of the middle of a cell, in the view's frame. A disc of radius r maps to
 * the cap with the same fraction of the hemisphere: 1 - cos s = r^2, where s is the
 * half angle of the cap. */
static struct pp_vec3 direction_of(int side, int column, int row)
{
    struct pp_vec3 disc =
        pp_lobe_sample_cosine((column + 0.5) / side, (row + 0.5) / side);
    double square = disc.x * disc.x + disc.y * disc.y;
    double stretch = sqrt(2.0 - square);
    return pp_vec(disc.x * stretch, disc.y * stretch, 1.0 - square);
}

static double frame_factor(const struct pp_light_scene *scene, int window)
{
    return scene->world->openings[window].frame_factor;
}

/* A part that is not clear glass. */
static void end_at_part(struct pp_eye_ray *ray, const struct pp_light_scene *scene,
                        const struct pp_light_hit *hit)
{
    const struct pp_world *world = scene->world;
    const struct pp_material *material = &scene->materials[hit->material];
    int window = scene->parts[hit->part].window;
    ray->at = (struct pp_lit_point){hit->point, hit->normal, hit->space};
    if (window < 0) {
        ray->end = PP_EYE_SURFACE;
        ray->tag = hit->tag;
        ray->reflectance = pp_light_scene_parts_diffuse(scene, hit).g;
        if (hit->tag >= 0 && hit->tag < world->surface_count)
            ray->exitance = world->surfaces[hit->tag].exitance;
    } else if (material->kind == PP_MATERIAL_TRANSLUCENT) {
        ray->end = PP_EYE_PANE;
        ray->reflectance = material->through_diffuse.g / frame_factor(scene, window);
        ray->clear_share *= frame_factor(scene, window);
        ray->at.normal = pp_vec_scale(hit->normal, -1.0);
        ray->at.space = pp_light_scene_parts_space(scene, hit, true);
    }
}

static void end_outside(struct pp_eye_ray *ray, const struct pp_light_scene *scene,
                        double ground_reflectance)
{
    int far = pp_scene_skylines_far(&scene->skylines, ray->u);
    ray->end = far >= 0 ? PP_EYE_FACE : ray->u.z > 0.0 ? PP_EYE_SKY : PP_EYE_GROUND;
    ray->reflectance = ground_reflectance;
    if (far >= 0) {
        ray->reflectance = scene->skylines.far[far].reflectance;
        ray->at.normal = pp_vec_scale(scene->skylines.far[far].outward, -1.0);
    }
}

/* Records a pane that scatters light. through: transmittance in front of the pane. */
static void note_pane(struct pp_eye_ray *ray, const struct pp_light_scene *scene,
                      const struct pp_light_hit *hit, double through)
{
    int window = scene->parts[hit->part].window;
    const struct pp_opening *opening = &scene->world->openings[window];
    struct pp_vec3 travel = pp_vec_scale(ray->u, -1.0);
    struct pp_vec3 out =
        pp_vec(pp_vec_dot(travel, opening->along), pp_vec_dot(travel, opening->up),
               pp_vec_dot(travel, opening->inner.normal));
    ray->pane = window;
    ray->pane_class = opening->scatter->class_of(opening->scatter->data, out);
    ray->pane_share = through / ray->clear_share * scene->materials[hit->material].dirt;
    ray->pane_at = (struct pp_lit_point){hit->point, pp_vec_scale(hit->normal, -1.0),
                                         pp_light_scene_parts_space(scene, hit, true)};
}

static void follow_ray(struct pp_eye_ray *ray, const struct pp_light_scene *scene,
                       struct pp_light_ray light, double ground_reflectance)
{
    enum { PANES_MOST = 64 };
    struct pp_rgb through = pp_rgb_grey(1.0);
    for (int panes = 0; panes < PANES_MOST; panes++) {
        struct pp_light_hit hit;
        enum pp_meeting meeting = pp_light_scene_meet(scene, &light, &hit);
        ray->transmittance = through.g / ray->clear_share;
        if (meeting == PP_MEETS_ENVIRONMENT) {
            end_outside(ray, scene, ground_reflectance);
            return;
        }
        if (meeting == PP_MEETS_GROUND) {
            ray->end = PP_EYE_SURFACE;
            ray->at = (struct pp_lit_point){hit.point, hit.normal, PP_OUTDOORS};
            ray->reflectance = ground_reflectance;
            return;
        }
        if (meeting != PP_MEETS_PART)
            return;
        int window = scene->parts[hit.part].window;
        if (window >= 0 && ray->opening < 0)
            ray->opening = window;
        bool scatters = window >= 0 && ray->pane < 0 && !hit.back
                        && scene->world->openings[window].scatter;
        if (scatters)
            note_pane(ray, scene, &hit, through.g);
        hit.point = pp_rays_draw_back(hit.point, ray->u);
        if (!pp_light_scene_parts_pass(scene, &hit, &light, &through)) {
            end_at_part(ray, scene, &hit);
            if (scatters)
                ray->clear_share *= frame_factor(scene, window);
            return;
        }
        if (window >= 0)
            ray->clear_share *= frame_factor(scene, window);
    }
}

static struct pp_eye_ray ray_towards(struct pp_vec3 u)
{
    return (struct pp_eye_ray){
        .u = u, .opening = -1, .clear_share = 1.0, .tag = -1, .pane = -1};
}

struct pp_eye_ray pp_eye_rays_outwards(const struct pp_light_scene *scene, int opening,
                                       struct pp_vec3 u, double ground_reflectance)
{
    const struct pp_polygon *glass = &scene->world->openings[opening].outer;
    struct pp_vec3 out = pp_vec_scale(glass->normal, -1.0);
    struct pp_vec3 middle = pp_vec_sub(pp_polygon_middle(glass), scene->centre);
    struct pp_eye_ray ray = ray_towards(u);
    follow_ray(&ray, scene,
               (struct pp_light_ray){
                   .from = middle, .off = out, .to = u, .space = PP_OUTDOORS},
               ground_reflectance);
    return ray;
}

enum pp_status pp_eye_rays_init(struct pp_eye_rays *rays,
                                const struct pp_light_scene *scene,
                                const struct pp_receiver *eye, int side,
                                double ground_reflectance, struct pp_error *err)
{
    struct pp_vec3 z = eye->normal;
    struct pp_vec3 x = pp_vec_unit(pp_vec_cross(z, pp_vec(0.0, 0.0, 1.0)));
    *rays = (struct pp_eye_rays){.centre = scene->centre,
                                 .view = {x, pp_vec_cross(x, z), z},
                                 .side = side,
                                 .count = side * side,
                                 .solid_angle_sr = 2.0 * PP_PI / (side * side)};
    rays->list = calloc((size_t)rays->count, sizeof *rays->list);
    if (!rays->list)
        return pp_fail_memory(err);
    struct pp_vec3 from = pp_vec_sub(eye->position, scene->centre);
    for (int i = 0; i < rays->count; i++) {
        struct pp_vec3 own = direction_of(side, i % side, i / side);
        struct pp_eye_ray *ray = &rays->list[i];
        *ray = ray_towards(pp_frame_out(&rays->view, own));
        follow_ray(
            ray, scene,
            (struct pp_light_ray){.from = from, .to = ray->u, .space = PP_INDOORS},
            ground_reflectance);
    }
    return PP_OK;
}

void pp_eye_rays_clear(struct pp_eye_rays *rays)
{
    free(rays->list);
    rays->list = NULL;
}

double pp_eye_rays_to_sun(const struct pp_light_scene *scene, struct pp_vec3 eye,
                          struct pp_vec3 sun, int *opening)
{
    const struct pp_lit_point at = {pp_vec_sub(eye, scene->centre), sun, PP_INDOORS};
    double share = pp_sun_on_surface(scene, &at, sun, opening);
    return share > 0.0 && *opening >= 0 ? share / frame_factor(scene, *opening) : share;
}
