/* window_images.h - images of openings in the polished planes of a room, sampled by
 * next-event estimation.
 *
 * Seen from a point, an opening stands behind a plane mirror as it stands before the
 * point's own image: directions to it are sampled from there (sample_polygon.h), and
 * unfolded. A gloss blurs the image: it is sampled as if the opening were larger, by as
 * much as the lobe is wide at its distance. A ray that comes to the reflector by such a
 * direction goes on as the gloss is shaped, and has the opening's light if it meets it.
 * The rays of the diffuse lobe find the same light: multiple importance sampling
 * divides it between the two.
 */
#ifndef PP_SIMULATE_SCENE_IMAGES_WINDOW_IMAGES_H
#define PP_SIMULATE_SCENE_IMAGES_WINDOW_IMAGES_H

#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"

/* An opening in a reflector (reflectors.h). */
struct pp_window_image {
    int reflector, window;
    double share; /* the reflector's greatest reflectance */
};

/* Finds the scene's images, after its reflectors and panes are added. */
enum pp_status pp_window_images_find(struct pp_light_scene *scene,
                                     struct pp_error *err);

/* A diffuse side of a surface that looks for images: points as the scene's own. */
struct pp_image_viewer {
    struct pp_vec3 point, normal;
    struct pp_brightness brightness; /* as guessed, outside */
};

/* Chooses an image by u in [0, 1), in proportion to its possible light at the viewer,
 * with its probability; -1: none can contribute. */
int pp_window_images_choose(const struct pp_light_scene *scene,
                            const struct pp_image_viewer *viewer, double u,
                            double *probability);

/* Samples a direction from the viewer to a visible image by two numbers in (0, 1), and
 * its density per steradian; false if it misses the reflector's plane. */
bool pp_window_images_sample(const struct pp_light_scene *scene, int image,
                             const struct pp_image_viewer *viewer, double u, double v,
                             struct pp_vec3 *to, double *pdf);

/* The density of choosing the image of that window in that reflector and the direction,
 * per steradian; 0 where it is none. */
double pp_window_images_pdf(const struct pp_light_scene *scene, int reflector,
                            int window, const struct pp_image_viewer *viewer,
                            struct pp_vec3 to);

#endif
