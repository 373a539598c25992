/* emitters.h - concentrated emitters, which next-event estimation samples: the sides of
 * parts that emit, and directions to them.
 *
 * Plane emitters are sampled like openings (sample_polygon.h), spheres by the cone of
 * directions that they fill, distant emitters by their own cone, and cones and rings by
 * area.
 */
#ifndef PP_SIMULATE_SCENE_EMITTERS_H
#define PP_SIMULATE_SCENE_EMITTERS_H

#include "model/light/scene_description.h"
#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"

enum pp_emitter_shape {
    PP_EMITTER_PLANE,  /* sampled by its target */
    PP_EMITTER_SPHERE, /* by the cone of directions that it fills */
    PP_EMITTER_ROUND,  /* a cone or ring, by area */
    PP_EMITTER_DISTANT,
};

/* A side of a part that emits, or a distant source. */
struct pp_emitter {
    enum pp_emitter_shape shape;
    int part;     /* -1: distant */
    int distant;  /* index of the distant source; -1: not distant */
    int material; /* material of the side that emits */
    struct pp_rgb radiance;
    struct pp_target target;            /* target of a plane emitter */
    int first_triangle, triangle_count; /* range in the scene's emitter_triangles */
    struct pp_shape round;              /* shape of a round emitter */
    bool back;                          /* the back emits */
    struct pp_vec3 middle;
    double area_m2;
};

/* A source infinitely far away: a cone of directions. */
struct pp_distant {
    struct pp_vec3 direction;
    double cos_half, solid; /* cosine of the cone's half angle; its solid angle, sr */
    int material, tag;
    int emitter; /* -1: extended */
};

/* Appends emitters for the sides of a part that emit concentrated light. The polygon's
 * corners and triangles are measured from the scene's centre. */
enum pp_status pp_emitters_add_part(struct pp_light_scene *scene, int part,
                                    const struct pp_vec3 *corners, int count,
                                    const struct pp_vec3 (*triangles)[3],
                                    int triangle_count, struct pp_error *err);
enum pp_status pp_emitters_add_distant(struct pp_light_scene *scene,
                                       const struct pp_shape *shape,
                                       struct pp_error *err);

/* Links the triangles of targets, after all emitters are added. */
void pp_emitters_link_triangles(struct pp_light_scene *scene);

/* An emitter as seen from one point of a surface. */
struct pp_emitter_sampler {
    const struct pp_emitter *emitter; /* not owned */
    struct pp_vec3 from;
    struct pp_polygon_sampler plane;
    struct pp_vec3
        axis;    /* axis of the cone of directions: to a sphere's middle, or of a
                  * distant source */
    double fall; /* 1 - cos of the cone's half angle; accurate for small angles */
};

/* False if no light of the emitter can reach this side of the surface. n: normal of
 * this side. */
bool pp_emitters_sampler_init(struct pp_emitter_sampler *sampler,
                              const struct pp_light_scene *scene,
                              const struct pp_emitter *emitter, struct pp_vec3 from,
                              struct pp_vec3 n);

/* Samples a direction to the emitter; false if the emitter sends no light along it. The
 * distance of a distant source is INFINITY. */
bool pp_emitters_sample(const struct pp_emitter_sampler *sampler, double u, double v,
                        struct pp_direction_sample *sample);

/* The density with which pp_emitters_sample gives a direction that meets the emitter,
 * per steradian. */
double pp_emitters_pdf(const struct pp_emitter_sampler *sampler,
                       struct pp_vec3 direction);

/* Estimated light of an emitter at a point, as a weight for the choice among several
 * emitters; above 0 if the emitter contributes any light. */
double pp_emitters_importance(const struct pp_emitter *emitter,
                              const struct pp_light_scene *scene, struct pp_vec3 from,
                              struct pp_vec3 n);

/* The angular size of an emitter from a point: the square root of its area, divided by
 * its distance. */
double pp_emitters_angular_size(const struct pp_emitter *emitter,
                                const struct pp_light_scene *scene,
                                struct pp_vec3 from);

#endif
