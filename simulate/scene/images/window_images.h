/* window_images.h - images of openings in the polished planes of a room, sampled by
 * next-event estimation.
 *
 * The image of an opening in a plane mirror is seen from a point in the same way as the
 * opening is seen from the point's mirror image: directions are sampled from there
 * (sample_polygon.h), and mirrored back. A gloss blurs the image: it is sampled as if
 * the opening were larger, by as much as the lobe is wide at its distance. A ray that
 * reaches the reflector in such a direction continues in a direction of the gloss lobe,
 * and has the opening's light if it meets it. The rays of the diffuse lobe find the
 * same light: multiple importance sampling divides it between the two.
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

/* One side of a diffuse surface for which images are sampled, in the scene's
 * coordinates. */
struct pp_image_viewer {
    struct pp_vec3 point, normal;
    struct pp_brightness brightness; /* estimated brightness outside */
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

/* The density of choosing the image of that window in that reflector, and the
 * direction, per steradian; 0 if there is no such image. */
double pp_window_images_pdf(const struct pp_light_scene *scene, int reflector,
                            int window, const struct pp_image_viewer *viewer,
                            struct pp_vec3 to);

#endif
