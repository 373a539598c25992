/* window_images.h - images of openings in the polished planes of a room, sampled by
 * next-event estimation.
 *
 * From a point, the image of an opening in a plane mirror looks like the opening seen
 * from the point's mirror image. Directions are sampled from the mirror image of the
 * point (sample_polygon.h), and mirrored back. A gloss blurs the image. It is therefore
 * sampled as if the opening were larger by the width of the lobe at the opening's
 * distance. A ray that reaches the reflector in such a direction continues in a
 * direction of the gloss lobe, and adds the opening's light if it meets the opening.
 * Rays of the diffuse lobe find the same light. Multiple importance sampling weights
 * the two estimates.
 */
#ifndef PP_SIMULATE_SCENE_IMAGES_WINDOW_IMAGES_H
#define PP_SIMULATE_SCENE_IMAGES_WINDOW_IMAGES_H

#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"

/* An opening and the reflector (reflectors.h) in which it is mirrored. */
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
    const struct pp_brightness
        *brightness; /* estimated brightness outside; not owned */
};

/* Chooses an image by u in [0, 1), in proportion to its possible light at the viewer.
 * Also sets the probability of the choice. -1: no image can contribute. */
int pp_window_images_choose(const struct pp_light_scene *scene,
                            const struct pp_image_viewer *viewer, double u,
                            double *probability);

/* Samples a direction from the viewer to a visible image by two numbers in (0, 1), and
 * sets its density per steradian. False if no direction is found, or if it misses the
 * reflector's plane. */
bool pp_window_images_sample(const struct pp_light_scene *scene, int image,
                             const struct pp_image_viewer *viewer, double u, double v,
                             struct pp_vec3 *to, double *pdf);

/* The density of choosing the image of this window in this reflector, and of the
 * direction, per steradian; 0 if there is no such image. The probability of the choice
 * is taken as the image's fraction of all importances. */
double pp_window_images_pdf(const struct pp_light_scene *scene, int reflector,
                            int window, const struct pp_image_viewer *viewer,
                            struct pp_vec3 to);

#endif
