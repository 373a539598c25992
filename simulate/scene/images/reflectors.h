/* reflectors.h - plane parts with a gloss, by which next-event estimation samples
 * emitters; for example, light that polished metal reflects to a ceiling.
 *
 * Unlike a mirror (mirrors.h) a rough gloss has no sharp image from which to sample.
 * But the light of an emitter leaves the plane in a lobe about one direction. A
 * direction of that lobe is drawn. A diffuse surface sends a ray in the opposite
 * direction and, if the ray meets the reflector, adds the emitter's light there. A ray
 * of the diffuse lobe may find the same light. Multiple importance sampling weights the
 * two estimates.
 */
#ifndef PP_SIMULATE_SCENE_IMAGES_REFLECTORS_H
#define PP_SIMULATE_SCENE_IMAGES_REFLECTORS_H

#include "model/geometry/frame.h"
#include "simulate/scene/light_scene.h"

/* A plane side with a gloss, of one or several parts. */
struct pp_reflector {
    struct pp_frame frame; /* x along the grain, z the side's normal */
    double offset_m;       /* z . x for all points x of the plane */
    int gloss;
    double share, area_m2; /* greatest reflectance of the gloss; area of all its
                            * parts */
};

/* A reflector with an emitter, and its probability of being chosen. */
struct pp_reflection {
    int reflector, emitter;
    double chance;
};

/* Finds the scene's reflectors, after all parts, glosses and emitters are added. */
enum pp_status pp_reflectors_find(struct pp_light_scene *scene, struct pp_error *err);

/* The reflection selected by u in [0, 1); -1: there is none. */
int pp_reflectors_choose(const struct pp_light_scene *scene, double u);

/* Samples a direction from a point to the reflector, opposite to a direction of the
 * emitter's reflected light, by two numbers in (0, 1). False if there is none. */
bool pp_reflectors_sample(const struct pp_light_scene *scene, int reflection,
                          struct pp_vec3 from, double u, double v, struct pp_vec3 *to);

/* The density of choosing the reflection and direction `to`, per steradian. */
double pp_reflectors_pdf(const struct pp_light_scene *scene, int reflection,
                         struct pp_vec3 from, struct pp_vec3 to);

/* Index of the reflection of this reflector and emitter; -1: it is not sampled. */
int pp_reflectors_reflection(const struct pp_light_scene *scene, int reflector,
                             int emitter);

#endif
