/* light_parts.h - what is inside a light scene. Inside simulate/ only. */
#ifndef PP_SIMULATE_SCENE_LIGHT_PARTS_H
#define PP_SIMULATE_SCENE_LIGHT_PARTS_H

#include "simulate/sampling/gloss.h"
#include "simulate/scene/light_scene.h"
#include "simulate/scene/rays.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/ray_scene.h"

/* What has one plane or one curve. */
struct pp_light_part {
    struct pp_vec3 normal; /* of its front, unit; of plane ones */
    double offset_m;       /* normal . x of its points, from the centre */
    double area_m2;        /* of plane ones of a description */
    int material[2];       /* of front and back */
    int tag;
    int round;              /* which of the round shapes; -1: plane */
    int window;             /* whose pane; -1: none */
    int emitter[2];         /* what front and back are, if aimed at; -1: nothing */
    int mirror;             /* in whose plane it is, if it mirrors; -1: none */
    unsigned char space[2]; /* enum pp_space of rays that leave front and back */
    bool envelope;          /* of a room: its back is not seen from inside */
    bool back_emits;
};

enum pp_emitter_shape {
    PP_EMITTER_PLANE,  /* aimed at by its target */
    PP_EMITTER_SPHERE, /* its part is round: aimed at by the angle it fills */
    PP_EMITTER_ROUND,  /* aimed at by area */
    PP_EMITTER_DISTANT,
};

/* One side of something that is aimed at. */
struct pp_emitter {
    enum pp_emitter_shape shape;
    int part;     /* -1: distant */
    int distant;  /* which; -1: none */
    int material; /* of the side that emits */
    struct pp_rgb radiance;
    struct pp_target target;            /* of a plane one */
    int first_triangle, triangle_count; /* of the scene's emitter_triangles */
    struct pp_shape round;              /* of a round one */
    bool back;                          /* is it the back that emits? */
    struct pp_vec3 middle;
    double area_m2;
};

/* Infinitely far away: a cone of directions. */
struct pp_distant {
    struct pp_vec3 direction;
    double cos_half, solid; /* sr */
    int material, tag;
    int emitter; /* -1: extended */
};

/* A plane in which something mirrors, so that emitters are aimed at by it. */
struct pp_mirror {
    struct pp_vec3 normal; /* unit, of any side */
    double offset_m;
    double share; /* what it reflects at right angles, at most */
};

/* Reflections one after the other on the way from a point to an emitter. */
enum { PP_MIRROR_PATH_MOST = 2 };
struct pp_mirror_path {
    int mirrors[PP_MIRROR_PATH_MOST]; /* -1 behind the last */
    double share;                     /* of all of them */
};

struct pp_light_scene {
    struct pp_vec3 centre;        /* what is below is measured from there */
    const struct pp_world *world; /* NULL: of a description; not owned */
    struct pp_ray_scene *room;    /* of a world: its rays, windows, outside */
    bool matt;                    /* of a world: its finishes without their gloss */

    struct pp_material *materials;
    int material_count;
    struct pp_gloss *glosses;
    int gloss_count;
    int *gloss_of_material; /* -1: it has none, or is a mirror */
    struct pp_pattern *patterns;
    int pattern_count;
    struct pp_light_part *parts;
    int part_count;
    int *part_of_triangle; /* then that of each round shape */
    int triangle_count;
    struct pp_shape *rounds;
    int round_count;
    struct pp_rays *rays; /* of a world: the room's */

    struct pp_emitter *emitters;
    int emitter_count;
    struct pp_vec3 (*emitter_triangles)[3];
    int emitter_triangle_count, emitter_triangle_space;
    struct pp_distant *distants;
    int distant_count;
    struct pp_mirror *mirrors;
    int mirror_count;
    struct pp_mirror_path *mirror_paths;
    int mirror_path_count;
    double unsampled_share; /* the most that any other reflections leave */
    struct pp_rgb glow; /* the brightest of its extended emitters that has a place */

    struct pp_vec3 low, high; /* of everything */
    uint64_t hash;
};

/* What a ray comes to. */
enum pp_meeting {
    PP_MEETS_PART,
    PP_MEETS_ENVIRONMENT, /* sky, ground, skyline, distant sources */
    PP_MEETS_LEAK,        /* the wrong side of a room's envelope: to be given up */
};

/* The general question; ray and hit are measured from the centre. hit->distance_m is
 * how far away it is in any case, INFINITY for what has no distance. */
enum pp_meeting pp_light_scene_meet(const struct pp_light_scene *scene,
                                    const struct pp_light_ray *ray,
                                    struct pp_light_hit *hit);

/* The light of what is beyond, without concentrated sources; near: what `meet` gave as
 * distance (a skyline stands there if it is finite). *is_sky may be NULL. */
struct pp_rgb pp_light_scene_environment(const struct pp_light_scene *scene,
                                         const struct pp_light_ray *ray, double near_m,
                                         bool *is_sky);

/* The radiance of distant source i in direction u, 0 outside its cone. */
struct pp_rgb pp_light_scene_distant_radiance(const struct pp_light_scene *scene, int i,
                                              struct pp_vec3 u);

/* Once all materials are there: works out the glosses that they have. */
enum pp_status pp_light_scene_add_glosses(struct pp_light_scene *scene,
                                          struct pp_error *err);

/* Of a material; NULL: it has none, or is a mirror. */
const struct pp_gloss *pp_light_scene_gloss(const struct pp_light_scene *scene,
                                            int material);

/* Stirs all that the scene has into its hash (light_hash.c). */
void pp_light_hash_scene(struct pp_light_scene *scene, const float (*triangles)[3][3]);

/* Appends emitters of the sides of a part that emit concentrated light. The polygon's
 * corners and triangles are from the centre. */
enum pp_status pp_emitters_add_part(struct pp_light_scene *scene, int part,
                                    const struct pp_vec3 *corners, int count,
                                    const struct pp_vec3 (*triangles)[3],
                                    int triangle_count, struct pp_error *err);
enum pp_status pp_emitters_add_distant(struct pp_light_scene *scene,
                                       const struct pp_shape *shape,
                                       struct pp_error *err);

/* Once all are there: their targets get their triangles. */
void pp_emitters_link_triangles(struct pp_light_scene *scene);

/* ---- emitters, aimed at: emitters.c ---- */

/* An emitter as it is seen from one point of a surface. */
struct pp_emitter_sampler {
    const struct pp_emitter *emitter; /* not owned */
    struct pp_vec3 from;
    struct pp_polygon_sampler plane;
    struct pp_vec3 axis; /* sphere: to its middle; distant: its own */
    double fall;         /* 1 - cos of the half angle to aim into */
};

/* False where no light of it can reach that side of the surface. n is the normal of
 * the side that is to be lit. */
bool pp_emitters_sampler_init(struct pp_emitter_sampler *aim,
                              const struct pp_light_scene *scene,
                              const struct pp_emitter *emitter, struct pp_vec3 from,
                              struct pp_vec3 n);

/* A direction to the emitter; false where there it gives no light to the point. Of a
 * distant one distance_m is INFINITY. */
bool pp_emitters_sample(const struct pp_emitter_sampler *aim, double u, double v,
                        struct pp_direction_sample *aimed);

/* How much it may count, for choosing among several; not 0 where it counts. */
double pp_emitters_importance(const struct pp_emitter *emitter,
                              const struct pp_light_scene *scene, struct pp_vec3 from,
                              struct pp_vec3 n);

/* How large it looks from there: its size over its distance. */
double pp_emitters_angular_size(const struct pp_emitter *emitter,
                                const struct pp_light_scene *scene,
                                struct pp_vec3 from);

/* How many directions make each one's share look smaller than `size`: a power of two,
 * at most `most`. */
uint32_t pp_emitters_direction_count(double spread, double size, int most);

/* Once all parts are there: unsampled.c. */
void pp_unsampled_find_glow(struct pp_light_scene *scene);

/* ---- emitters in plane mirrors: mirrors.c ---- */

/* Once all parts and emitters are there. */
enum pp_status pp_mirrors_find(struct pp_light_scene *scene, struct pp_error *err);

/* The mirror_path with that mirror behind its last; -1: there is none. mirror_path -1 is the empty
 * one, here and below. */
int pp_mirrors_path_extend(const struct pp_light_scene *scene, int mirror_path,
                           int mirror);

/* Where the point, and what direction, is seen to be behind the mirror_path's last mirror. */
struct pp_vec3 pp_mirrors_path_point(const struct pp_light_scene *scene,
                                     int mirror_path, struct pp_vec3 p);
struct pp_vec3 pp_mirrors_path_direction(const struct pp_light_scene *scene,
                                         int mirror_path, struct pp_vec3 u);

/* The direction in which what leaves the last mirror along u has left the point. */
struct pp_vec3 pp_mirrors_path_unfold(const struct pp_light_scene *scene,
                                      int mirror_path, struct pp_vec3 u);

#endif
