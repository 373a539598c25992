/* light_scene_parts.h - the data of a light scene. Inside simulate/ only. */
#ifndef PP_SIMULATE_SCENE_LIGHT_SCENE_PARTS_H
#define PP_SIMULATE_SCENE_LIGHT_SCENE_PARTS_H

#include "model/light/scene_description.h"
#include "simulate/sampling/gloss.h"
#include "simulate/sampling/scatter.h"
#include "simulate/scene/coarse_openings.h"
#include "simulate/scene/convex_room.h"
#include "simulate/scene/emitters.h"
#include "simulate/scene/images/glass_images.h"
#include "simulate/scene/images/mirrors.h"
#include "simulate/scene/openings.h"
#include "simulate/scene/rays.h"
#include "simulate/scene/images/reflectors.h"
#include "simulate/scene/scene_ground.h"
#include "simulate/scene/scene_skylines.h"
#include "simulate/scene/images/window_images.h"

/* A part of the scene: one plane or one curved surface. */
struct pp_light_part {
    struct pp_vec3 normal; /* unit normal of the front of a plane part */
    struct pp_vec3 a, b;   /* axes of a plane part: a right-handed frame with the
                            * normal */
    double offset_m;       /* normal . x for all points x of the plane, from the
                            * centre */
    double area_m2;
    int material[2]; /* front and back */
    int tag;
    int round;        /* index of the part's round shape; -1: plane */
    int window;       /* index of its pane's opening; -1: none */
    int niche;        /* index of the rectangular opening if the part is a side of its
                       * niche; -1: none */
    int emitter[2];   /* front and back; -1: not a concentrated emitter */
    int mirror;       /* index of the mirror in its plane; -1: none */
    int reflector[2]; /* front and back; -1: none */
    unsigned char space[2]; /* enum pp_space of rays that leave front and back */
    bool envelope;          /* part of a room's envelope: its back is not seen from
                             * inside */
    bool back_emits;
    bool matt[2]; /* front and back are opaque and purely diffuse */
};

struct pp_light_scene {
    struct pp_vec3 centre; /* origin of the points below */

    /* World of the scene. */
    const struct pp_world *world; /* NULL: scene from a description; not owned */
    bool has_room;                /* false: every point is outside */
    double size_m;                /* greatest coordinate of the room */
    struct pp_pane *panes;
    int pane_count;
    bool has_niches; /* true if one of the openings has a reveal */
    struct pp_vec3 (*pane_triangles)[3];
    struct pp_coarse_openings coarse;
    struct pp_vec3 (*plane)[3]; /* the working plane's triangles */
    int plane_count;
    double plane_area_m2;
    struct pp_scene_skylines skylines;
    struct pp_scene_ground ground;
    double decorations;   /* allowance on internally reflected light, not applied to
                           * paths; 1 for a description */
    double most_exitance; /* the greatest emission (exitance) of any surface */
    bool reflects;        /* a surface visible in the room reflects */

    struct pp_material *materials;
    int material_count;
    struct pp_glass_curve *glass_curves; /* curves of the materials that are glass */
    struct pp_gloss *glosses;
    int gloss_count;
    int *gloss_of_material; /* index by material; -1: none, or a mirror */
    struct pp_pattern *patterns;
    int pattern_count;
    struct pp_measured_pane **measured; /* measured panes of a description; owned */
    int measured_count;
    struct pp_light_part *parts;
    int part_count;
    int *part_of_triangle; /* by triangle, then by round shape */
    int triangle_count;
    struct pp_shape *rounds;
    int round_count;
    struct pp_rays *rays;
    struct pp_convex_room *convex; /* for rays indoors; NULL: use the kernels */

    struct pp_emitter *emitters;
    int emitter_count;
    struct pp_vec3 (*emitter_triangles)[3];
    int emitter_triangle_count, emitter_triangle_capacity;
    struct pp_distant *distants;
    int distant_count;
    struct pp_mirror *mirrors;
    int mirror_count;
    struct pp_mirror_path *mirror_paths;
    int mirror_path_count;
    struct pp_reflector *reflectors;
    int reflector_count;
    struct pp_reflection *reflections; /* by reflector, then by emitter */
    int reflection_count;
    struct pp_window_image *window_images;
    int window_image_count;
    struct pp_glass_image *glass_images;
    int glass_image_count;
    double unsampled_share; /* the greatest reflectance, or product of successive ones,
                             * that no mirror path samples */
    struct pp_rgb glow;     /* radiance of the brightest extended emitter that is not
                             * distant */

    struct pp_bounds3 bounds; /* bounds of everything that is not distant, in the
                               * scene's coordinates */
    uint64_t hash;
};

/* A part with these materials (front and back), which is not round and has no window,
 * niche, emitter, mirror or reflector. */
static inline struct pp_light_part pp_light_scene_parts_of(int tag,
                                                           const int material[2])
{
    return (struct pp_light_part){.material = {material[0], material[1]},
                                  .tag = tag,
                                  .round = -1,
                                  .window = -1,
                                  .niche = -1,
                                  .emitter = {-1, -1},
                                  .mirror = -1,
                                  .reflector = {-1, -1}};
}

/* The point of a plane part's plane at these coordinates along its a and b. */
static inline struct pp_vec3 pp_light_scene_parts_point(
    const struct pp_light_part *part, double a, double b)
{
    struct pp_vec3 foot = pp_vec_scale(part->normal, part->offset_m);
    return pp_vec_along(pp_vec_along(foot, a, part->a), b, part->b);
}

/* Space of a ray that leaves a hit, on the side that was hit or through the part. */
static inline enum pp_space pp_light_scene_parts_space(
    const struct pp_light_scene *scene, const struct pp_light_hit *hit, bool through)
{
    return through ? (enum pp_space)scene->parts[hit->part].space[!hit->back]
                   : hit->space;
}

/* Diffuse reflectance at the hit: local, if the material has a pattern. Not for
 * materials with bumps. The hit's point is measured from the scene's centre. */
static inline struct pp_rgb pp_light_scene_parts_diffuse(
    const struct pp_light_scene *scene, const struct pp_light_hit *hit)
{
    const struct pp_material *material = &scene->materials[hit->material];
    return material->surface_pattern
               ? pp_material_diffuse_at(material, pp_vec_add(hit->point, scene->centre))
               : material->diffuse;
}

/* The lobes of the part that a ray along `to` has hit, for light scattered back along
 * the ray. */
void pp_light_scene_parts_lobes(const struct pp_light_scene *scene,
                                const struct pp_light_hit *hit, struct pp_vec3 to,
                                struct pp_lobes *lobes);

/* Continues the ray straight through the part that it has hit, or mirrors it.
 * Multiplies *light by the transmittance or reflectance. False if the result is 0. */
bool pp_light_scene_parts_pass(const struct pp_light_scene *scene,
                               const struct pp_light_hit *hit, struct pp_light_ray *ray,
                               struct pp_rgb *light);
bool pp_light_scene_parts_reflect(const struct pp_light_scene *scene,
                                  const struct pp_light_hit *hit,
                                  struct pp_light_ray *ray, struct pp_rgb *light);

#endif
