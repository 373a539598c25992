/* light_scene.c - intersection of rays with a light scene, its materials and its
 * environment. light_scene_of_description.c and light_scene_of_world.c make the
 * parts. */
#include "simulate/scene/light_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "simulate/scene/environment.h"
#include "simulate/scene/light_hash.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/scene/round.h"
#include "model/room/position.h"

void pp_light_scene_destroy(struct pp_light_scene *scene)
{
    if (!scene)
        return;
    pp_rays_destroy(scene->rays);
    pp_convex_room_destroy(scene->convex);
    pp_scene_skylines_clear(&scene->skylines);
    free(scene->panes);
    free(scene->pane_triangles);
    free(scene->coarse.list);
    free(scene->plane);
    free(scene->materials);
    free(scene->glass_curves);
    free(scene->glosses);
    free(scene->gloss_of_material);
    free(scene->patterns);
    for (int i = 0; i < scene->measured_count; i++)
        pp_measured_pane_release(scene->measured[i]);
    free(scene->measured);
    free(scene->parts);
    free(scene->part_of_triangle);
    free(scene->rounds);
    free(scene->emitters);
    free(scene->emitter_triangles);
    free(scene->distants);
    free(scene->mirrors);
    free(scene->mirror_paths);
    free(scene->reflectors);
    free(scene->reflections);
    free(scene->window_images);
    free(scene->glass_images);
    free(scene);
}

enum pp_space pp_light_scene_space(const struct pp_light_scene *scene,
                                   struct pp_vec3 point)
{
    if (!scene->has_room)
        return PP_ANYWHERE;
    /* A point inside a reveal is outside the envelope, but the room may be visible from
     * it. */
    return pp_position_in_room(scene->world, point) ? PP_INDOORS : PP_ANYWHERE;
}

int pp_light_scene_material_count(const struct pp_light_scene *scene)
{
    return scene->material_count;
}

const struct pp_material *pp_light_scene_material(const struct pp_light_scene *scene,
                                                  int material)
{
    return &scene->materials[material];
}

bool pp_light_scene_is_matt(const struct pp_light_scene *scene)
{
    for (int i = 0; i < scene->material_count; i++)
        if (!pp_rgb_is_black(scene->materials[i].gloss)
            || !pp_rgb_is_black(scene->materials[i].through_gloss)
            || scene->materials[i].bumps)
            return false;
    return true;
}

uint64_t pp_light_scene_hash(const struct pp_light_scene *scene)
{
    return scene->hash;
}

enum pp_status pp_light_scene_under(struct pp_environment **environment,
                                    const struct pp_light_scene *scene,
                                    const struct pp_outside_light *light,
                                    struct pp_error *err)
{
    enum pp_status status =
        pp_environment_create(environment, &scene->skylines, light, err);
    if (status != PP_OK)
        return status;
    (*environment)->brightness.beyond = scene->coarse.list;
    (*environment)->brightness.beyond_count = scene->coarse.count;
    return PP_OK;
}

struct pp_bounds3 pp_light_scene_bounds(const struct pp_light_scene *scene, bool room)
{
    return room && scene->has_room ? pp_position_bounds(scene->world) : scene->bounds;
}

/* ---- materials ---- */

static bool is_rough(const struct pp_material *material)
{
    bool scatters = material->kind == PP_MATERIAL_OPAQUE
                    || material->kind == PP_MATERIAL_TRANSLUCENT;
    return scatters
           && !(pp_rgb_is_black(material->gloss)
                && pp_rgb_is_black(material->through_gloss))
           && !pp_gloss_is_mirror(material->roughness[0], material->roughness[1]);
}

/* Index of the gloss with these roughnesses. Calculates the gloss if it is new. */
static enum pp_status find_gloss(struct pp_light_scene *scene,
                                 const double roughness[2], int *number,
                                 struct pp_error *err)
{
    int count = scene->gloss_count;
    for (*number = 0; *number < count; (*number)++)
        if (pp_gloss_is_of(&scene->glosses[*number], roughness[0], roughness[1]))
            return PP_OK;
    enum pp_status status =
        pp_array_append(&scene->glosses, count, sizeof *scene->glosses, err);
    if (status != PP_OK)
        return status;
    return pp_gloss_init(&scene->glosses[scene->gloss_count++], roughness[0],
                         roughness[1], err);
}

/* True if the material has one law for all channels. */
static bool has_one_glass(const struct pp_material *material)
{
    return material->kind == PP_MATERIAL_GLASS
           && pp_glass_is_same(&material->glass[0], &material->glass[1])
           && pp_glass_is_same(&material->glass[0], &material->glass[2]);
}

/* Greatest number of tabulated curves, 16 kB each; further kinds of glass are evaluated
 * without a table. */
enum { CURVES_MOST = 64 };

/* Tabulates a curve for each kind of glass; equal kinds share one. */
static enum pp_status add_glass_curves(struct pp_light_scene *scene,
                                       struct pp_error *err)
{
    int room = 0, count = 0;
    for (int i = 0; i < scene->material_count; i++)
        room += has_one_glass(&scene->materials[i]);
    room = room < CURVES_MOST ? room : CURVES_MOST;
    scene->glass_curves = malloc(((size_t)room + 1) * sizeof *scene->glass_curves);
    if (!scene->glass_curves)
        return pp_fail_memory(err);
    for (int i = 0; i < scene->material_count; i++) {
        struct pp_material *material = &scene->materials[i];
        int k = 0;
        if (!has_one_glass(material))
            continue;
        while (k < count
               && !pp_glass_is_same(&scene->glass_curves[k].glass, &material->glass[0]))
            k++;
        if (k == room)
            continue;
        if (k == count)
            pp_glass_curve_init(&scene->glass_curves[count++], &material->glass[0]);
        material->curve = &scene->glass_curves[k];
    }
    return PP_OK;
}

enum pp_status pp_light_scene_add_laws(struct pp_light_scene *scene,
                                       struct pp_error *err)
{
    size_t count = (size_t)scene->material_count + 1;
    scene->gloss_of_material = malloc(count * sizeof *scene->gloss_of_material);
    if (!scene->gloss_of_material)
        return pp_fail_memory(err);
    enum pp_status status = add_glass_curves(scene, err);
    for (int i = 0; status == PP_OK && i < scene->material_count; i++) {
        scene->gloss_of_material[i] = -1;
        if (is_rough(&scene->materials[i]))
            status = find_gloss(scene, scene->materials[i].roughness,
                                &scene->gloss_of_material[i], err);
    }
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side < 2; side++) {
            const struct pp_material *material =
                &scene->materials[scene->parts[i].material[side]];
            scene->parts[i].matt[side] = material->kind == PP_MATERIAL_OPAQUE
                                         && pp_rgb_is_black(material->gloss)
                                         && !material->bumps;
        }
    return status;
}

const struct pp_gloss *pp_light_scene_gloss(const struct pp_light_scene *scene,
                                            int material)
{
    int gloss = scene->gloss_of_material[material];
    return gloss < 0 ? NULL : &scene->glosses[gloss];
}

/* ---- rays ---- */

enum pp_status pp_light_scene_add_rays(struct pp_light_scene *scene,
                                       const struct pp_triangles *triangles,
                                       struct pp_error *err)
{
    size_t count = (size_t)triangles->count;
    float(*single)[3][3] = pp_triangles_single(
        (const struct pp_vec3(*)[3])triangles->corners, triangles->count);
    scene->part_of_triangle =
        malloc((count + (size_t)scene->round_count + 1) * sizeof(int));
    scene->triangle_count = triangles->count;
    enum pp_status status =
        single && scene->part_of_triangle ? PP_OK : pp_fail_memory(err);
    if (status == PP_OK) {
        if (count > 0)
            memcpy(scene->part_of_triangle, triangles->facet_of, count * sizeof(int));
        for (int i = 0; i < scene->part_count; i++)
            if (scene->parts[i].round >= 0)
                scene->part_of_triangle[count + (size_t)scene->parts[i].round] = i;
        pp_light_hash_scene(scene, (const float(*)[3][3])single);
        status =
            pp_rays_create(&scene->rays, (const float(*)[3][3])single, triangles->count,
                           scene->rounds, scene->round_count, err);
    }
    free(single);
    return status;
}

/* Moves the hit onto the part itself, in double precision. */
static void refine(const struct pp_light_scene *scene, const struct pp_light_part *part,
                   const struct pp_light_ray *ray, struct pp_vec3 start,
                   struct pp_light_hit *hit)
{
    if (part->round >= 0) {
        const struct pp_shape *round = &scene->rounds[part->round];
        double t, d = hit->distance_m;
        if (pp_round_meet(round, start, ray->to, 0.999 * d - 1e-6, 1.001 * d + 1e-6,
                          &t))
            hit->distance_m = t;
        hit->point = pp_vec_along(start, hit->distance_m, ray->to);
        hit->normal = pp_round_normal(round, hit->point);
    } else {
        struct pp_vec3 near = pp_vec_along(ray->from, hit->distance_m, ray->to);
        hit->normal = part->normal;
        hit->point = pp_vec_along(near, part->offset_m - pp_vec_dot(part->normal, near),
                                  part->normal);
    }
    hit->back = pp_vec_dot(hit->normal, ray->to) > 0.0;
    if (hit->back)
        hit->normal = pp_vec_scale(hit->normal, -1.0);
}

/* True if a point of the ground plane is within the room. If the ground is higher than
 * the floor, there is no ground in the room. This matters for rays that start in a
 * reveal, which are not known to be indoors. */
static bool is_under_roof(const struct pp_light_scene *scene, struct pp_vec3 point)
{
    static const double OVER_GROUND_M = 1e-3;
    point = pp_vec_add(point, scene->centre);
    point.z += OVER_GROUND_M;
    return pp_position_in_room(scene->world, point);
}

/* True if the ground is nearer along the ray than hit->distance_m, which is then set to
 * the ground's distance. A surface that lies on the ground, within single precision,
 * hides the ground. */
static bool meets_ground(const struct pp_light_scene *scene,
                         const struct pp_light_ray *ray, struct pp_light_hit *hit)
{
    double distance = pp_scene_ground_distance(&scene->ground, ray->from, ray->to);
    if (isinf(distance) || !(distance < hit->distance_m))
        return false;
    if (isfinite(hit->distance_m)
        && (hit->distance_m - distance) * -ray->to.z < 0x1p-20 * (1.0 + distance))
        return false;
    struct pp_vec3 point = pp_vec_along(ray->from, distance, ray->to);
    point.z = scene->ground.level_m;
    if (ray->space == PP_ANYWHERE && scene->has_room && is_under_roof(scene, point))
        return false;
    hit->part = hit->tag = -1;
    hit->distance_m = distance;
    hit->point = point;
    hit->normal = pp_vec(0.0, 0.0, 1.0);
    hit->back = false;
    hit->space = scene->has_room ? PP_OUTDOORS : PP_ANYWHERE;
    return true;
}

enum pp_meeting pp_light_scene_meet_outside(const struct pp_light_scene *scene,
                                            const struct pp_light_ray *ray,
                                            struct pp_light_hit *hit)
{
    hit->part = -1;
    hit->distance_m = INFINITY;
    return meets_ground(scene, ray, hit) ? PP_MEETS_GROUND : PP_MEETS_ENVIRONMENT;
}

/* Nearest hit in an empty convex room; false if the ray kernels must be used. */
static bool meet_convex(const struct pp_light_scene *scene,
                        const struct pp_light_ray *ray,
                        const struct pp_convex_nearest *nearest,
                        struct pp_light_hit *hit)
{
    hit->part = pp_convex_room_meet(scene->convex, scene, ray, nearest,
                                    &hit->distance_m, &hit->point);
    if (hit->part < 0)
        return false;
    const struct pp_light_part *part = &scene->parts[hit->part];
    hit->normal = part->normal;
    hit->back = false;
    hit->tag = part->tag;
    hit->material = part->material[0];
    hit->space = (enum pp_space)part->space[0];
    return true;
}

bool pp_light_scene_nearest(const struct pp_light_scene *scene, struct pp_vec3 from,
                            const struct pp_lanes_directions *to, int count,
                            struct pp_convex_nearest *nearest)
{
    return scene->convex
           && pp_convex_room_nearest(scene->convex, from, to, count, nearest);
}

enum pp_meeting pp_light_scene_meet(const struct pp_light_scene *scene,
                                    const struct pp_light_ray *ray,
                                    struct pp_light_hit *hit)
{
    return pp_light_scene_meet_by(scene, ray, NULL, hit);
}

enum pp_meeting pp_light_scene_meet_by(const struct pp_light_scene *scene,
                                       const struct pp_light_ray *ray,
                                       const struct pp_convex_nearest *nearest,
                                       struct pp_light_hit *hit)
{
    if (scene->convex && ray->space == PP_INDOORS
        && meet_convex(scene, ray, nearest, hit))
        return PP_MEETS_PART;
    return pp_light_scene_trace(scene, ray, hit);
}

enum pp_meeting pp_light_scene_trace(const struct pp_light_scene *scene,
                                     const struct pp_light_ray *ray,
                                     struct pp_light_hit *hit)
{
    struct pp_vec3 start = pp_rays_lift(ray->from, ray->off);
    float origin[3] = {(float)start.x, (float)start.y, (float)start.z};
    float direction[3] = {(float)ray->to.x, (float)ray->to.y, (float)ray->to.z};
    float distance;
    int index = pp_rays_first(scene->rays, origin, direction, &distance);
    bool indoors = ray->space == PP_INDOORS;
    hit->part = -1;
    hit->distance_m = index >= 0 ? (double)distance : INFINITY;

    if (!indoors && meets_ground(scene, ray, hit))
        return PP_MEETS_GROUND;
    if (index < 0)
        return indoors ? PP_MEETS_LEAK : PP_MEETS_ENVIRONMENT;

    hit->part = scene->part_of_triangle[index];
    const struct pp_light_part *part = &scene->parts[hit->part];
    refine(scene, part, ray, start, hit);
    hit->tag = part->tag;
    hit->material = part->material[hit->back];
    hit->space = (enum pp_space)part->space[hit->back];
    bool wrong = ray->space != PP_ANYWHERE && hit->back == indoors;
    return part->envelope && wrong ? PP_MEETS_LEAK : PP_MEETS_PART;
}

bool pp_light_scene_first(const struct pp_light_scene *scene,
                          const struct pp_light_ray *ray, struct pp_light_hit *hit)
{
    struct pp_light_ray moved = *ray;
    moved.from = pp_vec_sub(ray->from, scene->centre);
    *hit = (struct pp_light_hit){.part = -1};
    enum pp_meeting meeting = pp_light_scene_meet(scene, &moved, hit);
    hit->point = pp_vec_add(hit->point, scene->centre);
    return meeting == PP_MEETS_PART;
}

/* ---- the environment ---- */

struct pp_rgb pp_light_scene_distant_radiance(const struct pp_light_scene *scene, int i,
                                              struct pp_vec3 u)
{
    const struct pp_distant *distant = &scene->distants[i];
    if (!(pp_vec_dot(u, distant->direction) >= distant->cos_half))
        return pp_rgb_grey(0.0);
    const struct pp_material *material = &scene->materials[distant->material];
    if (material->pattern < 0)
        return material->radiance;
    return pp_rgb_scale(
        material->radiance,
        pp_scene_description_pattern_value(&scene->patterns[material->pattern], u));
}

/* The extended distant source in direction u; if there are several, the one of smallest
 * solid angle. -1: none. */
static int distant_in(const struct pp_light_scene *scene, struct pp_vec3 u)
{
    int found = -1;
    for (int i = 0; i < scene->distant_count; i++) {
        const struct pp_distant *distant = &scene->distants[i];
        if (distant->emitter < 0
            && pp_vec_dot(u, distant->direction) >= distant->cos_half
            && (found < 0 || distant->solid < scene->distants[found].solid))
            found = i;
    }
    return found;
}

struct pp_rgb pp_light_scene_environment(const struct pp_light_scene *scene,
                                         const struct pp_environment *environment,
                                         struct pp_vec3 u, bool *is_sky)
{
    bool sky = false;
    double light = 0.0; /* pi L, as in environment.h */
    if (scene->world)
        light = pp_environment_light(environment, u, &sky);
    if (is_sky)
        *is_sky = sky;
    if (scene->world)
        return pp_rgb_grey(light / PP_PI);

    int distant = distant_in(scene, u);
    if (is_sky)
        *is_sky = distant >= 0 && u.z > 0.0;
    return distant < 0 ? pp_rgb_grey(0.0)
                       : pp_light_scene_distant_radiance(scene, distant, u);
}
