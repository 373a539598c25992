/* light_scene.h - any scene prepared for tracing: shapes, materials, sky and lamps.
 *
 * A scene is made from a room's world (light_scene_of_world.h) or from a description
 * (light_scene_of_description.h). The distant sources of a description are part of the
 * scene; a world's light from outside is not (environment.h). A finished scene is only
 * read, by any number of threads. Points and directions are in the coordinates of the
 * scene; the shift and rounding for the ray kernels are internal.
 *
 * Light of a world is over Eh: radiances per steradian, irradiances as daylight
 * factors. Light of a description has the description's unit.
 */
#ifndef PP_SIMULATE_SCENE_LIGHT_SCENE_H
#define PP_SIMULATE_SCENE_LIGHT_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "model/base/error.h"
#include "model/geometry/bounds.h"
#include "model/light/material.h"

struct pp_convex_nearest;
struct pp_environment;
struct pp_gloss;
struct pp_lanes_directions;
struct pp_light_scene;
struct pp_outside_light;
struct pp_triangles;

void pp_light_scene_destroy(struct pp_light_scene *scene); /* NULL is allowed */

/* Space in which a ray runs, if known. In a world, an indoor ray cannot see the back of
 * the room's envelope. A ray that does has leaked through a gap between the edges of
 * two surfaces, and counts as nothing. Rays of a description run anywhere. */
enum pp_space { PP_ANYWHERE, PP_INDOORS, PP_OUTDOORS };

/* Space of a point: PP_ANYWHERE in a description's scene. */
enum pp_space pp_light_scene_space(const struct pp_light_scene *scene,
                                   struct pp_vec3 point);

struct pp_light_ray {
    struct pp_vec3 from;
    struct pp_vec3 off; /* unit normal of the surface that the ray leaves, on the side
                         * to which the ray leaves. The ray does not meet that surface
                         * again at its start. Zero: the ray starts in the air */
    struct pp_vec3 to;  /* unit */
    enum pp_space space;
};

/* The first surface that a ray meets. A part is a polygon, a sphere or another shape
 * with one plane or one curved surface. */
struct pp_light_hit {
    int part; /* -1: the ground, or nothing */
    int tag;  /* tag of the shape */
    struct pp_vec3 point;
    struct pp_vec3 normal; /* unit, on the side that was hit */
    bool back;             /* true if the back was hit */
    double distance_m;
    int material;        /* material of that side */
    enum pp_space space; /* space of a ray that leaves that side */
};

/* False if the ray meets no part, or has leaked. */
bool pp_light_scene_first(const struct pp_light_scene *scene,
                          const struct pp_light_ray *ray, struct pp_light_hit *hit);

/* Materials, by the indices in hits. A world's materials are named after their surfaces
 * ("floor", "ceiling", a wall's name, "reveal", "surface", "block", "glazing"). Names
 * of materials of backs have the suffix " (outside)". */
int pp_light_scene_material_count(const struct pp_light_scene *scene);
const struct pp_material *pp_light_scene_material(const struct pp_light_scene *scene,
                                                  int material);

/* True if every surface except glass is diffuse. */
bool pp_light_scene_is_matt(const struct pp_light_scene *scene);

/* Bounding box of everything that is not infinitely far away; with `room`, in a world,
 * of the room alone. All zero if there is nothing. */
struct pp_bounds3 pp_light_scene_bounds(const struct pp_light_scene *scene, bool room);

/* Prepares the light from outside for the scene of a world. The scene must outlive
 * *environment. */
enum pp_status pp_light_scene_under(struct pp_environment **environment,
                                    const struct pp_light_scene *scene,
                                    const struct pp_outside_light *light,
                                    struct pp_error *err);

/* Hash of all shapes and materials of the scene, and of a description's lights. */
uint64_t pp_light_scene_hash(const struct pp_light_scene *scene);

/* ---- for the other files of simulate/: points are measured from the scene's centre
 * ---- */

/* The end of a ray. */
enum pp_meeting {
    PP_MEETS_PART,
    PP_MEETS_GROUND,      /* as a surface (scene_ground.h) */
    PP_MEETS_ENVIRONMENT, /* sky, open ground, skyline without a distance, distant
                           * sources */
    PP_MEETS_LEAK,        /* the wrong side of a room's envelope, or nothing although
                           * the ray runs indoors: the ray is abandoned */
};

/* The nearest planes of rays that run indoors from one point, if the room is empty and
 * convex (convex_room.h); false if they are unknown. */
bool pp_light_scene_nearest(const struct pp_light_scene *scene, struct pp_vec3 from,
                            const struct pp_lanes_directions *to, int count,
                            struct pp_convex_nearest *nearest);

/* First intersection of the ray. hit->distance_m is always set, to INFINITY for sky and
 * similar ends. hit->part is -1 if the ray meets no part. The other members are set for
 * a part or the ground; material for a part only. */
enum pp_meeting pp_light_scene_meet(const struct pp_light_scene *scene,
                                    const struct pp_light_ray *ray,
                                    struct pp_light_hit *hit);

/* First intersection by the ray kernels alone, without the shortcut for convex
 * rooms. */
enum pp_meeting pp_light_scene_trace(const struct pp_light_scene *scene,
                                     const struct pp_light_ray *ray,
                                     struct pp_light_hit *hit);

/* First intersection, like pp_light_scene_meet, if the ray's nearest plane is given;
 * NULL: unknown. */
enum pp_meeting pp_light_scene_meet_by(const struct pp_light_scene *scene,
                                       const struct pp_light_ray *ray,
                                       const struct pp_convex_nearest *nearest,
                                       struct pp_light_hit *hit);

/* First intersection of a ray that is known to meet no part. */
enum pp_meeting pp_light_scene_meet_outside(const struct pp_light_scene *scene,
                                            const struct pp_light_ray *ray,
                                            struct pp_light_hit *hit);

/* The light of the environment (of a world; NULL: of a description) from direction u
 * (unit), without concentrated sources. *is_sky may be NULL. */
struct pp_rgb pp_light_scene_environment(const struct pp_light_scene *scene,
                                         const struct pp_environment *environment,
                                         struct pp_vec3 u, bool *is_sky);

/* The radiance of distant source i in direction u, 0 outside its cone. */
struct pp_rgb pp_light_scene_distant_radiance(const struct pp_light_scene *scene, int i,
                                              struct pp_vec3 u);

/* Builds the structure for the ray kernels, after all parts are added, from the
 * triangles (by number of the part) and the scene's round shapes. Also sets the scene's
 * hash. */
enum pp_status pp_light_scene_add_rays(struct pp_light_scene *scene,
                                       const struct pp_triangles *triangles,
                                       struct pp_error *err);

/* Calculates the glosses and glass curves after all materials and parts are added, and
 * marks the diffuse parts. */
enum pp_status pp_light_scene_add_laws(struct pp_light_scene *scene,
                                       struct pp_error *err);

/* The gloss of a material; NULL: it has none, or is a mirror. */
const struct pp_gloss *pp_light_scene_gloss(const struct pp_light_scene *scene,
                                            int material);

#endif
