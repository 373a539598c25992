/* glass_images.h - images of openings in the glass of other openings, sampled by
 * next-event estimation at the points of a room (fast/path.h).
 *
 * Clear glass reflects. From a point, the image of one opening in the glass of another
 * looks like the opening seen from the point's mirror image. Directions are sampled
 * from the mirror image of the point (sample_polygon.h) to the part of the opening that
 * is visible through the outline of the glass, and mirrored back. Glass reflects a
 * tenth of the light, and the image shows bright sky. Only a few in a thousand rays of
 * a diffuse lobe would find the image, each with many times the mean light.
 */
#ifndef PP_SIMULATE_SCENE_IMAGES_GLASS_IMAGES_H
#define PP_SIMULATE_SCENE_IMAGES_GLASS_IMAGES_H

#include "simulate/sampling/sample_polygon.h"
#include "simulate/scene/light_scene.h"

/* Greatest number of pairs that are sampled: the pairs that exchange most light. Images
 * of other pairs are found by rays. */
enum { PP_GLASS_IMAGES_MOST = 32 };

/* Indices of two panes: the opening `window` is mirrored in the glass of the opening
 * `glass`. */
struct pp_glass_image {
    int glass, window;
};

/* Finds the scene's images, after its panes and their parts are added. These are pairs
 * of openings, each in front of the other, of which one has clear glass. */
enum pp_status pp_glass_images_find(struct pp_light_scene *scene, struct pp_error *err);

/* True if the pair is one of the scene's images. */
bool pp_glass_images_has(const struct pp_light_scene *scene, int glass, int window);

/* One image, seen from the view's point. */
struct pp_glass_sight {
    int image;               /* index of the image plus 1; 0: none */
    struct pp_target target; /* the part of the opening that is seen */
    struct pp_polygon_sampler sampler;
};

enum { PP_GLASS_SIGHTS = 4 };

/* Images seen from the last point that was processed; initially all zero. */
struct pp_glass_view {
    struct pp_vec3 point, normal;
    double share[PP_GLASS_IMAGES_MOST]; /* possible contribution of each image; 0: not
                                         * visible */
    struct pp_glass_sight kept[PP_GLASS_SIGHTS]; /* by index of the image, modulo
                                                  * PP_GLASS_SIGHTS */
};

/* Samples a direction from the point to an image, by three numbers in (0, 1). Also sets
 * the density per steradian, which includes the probability of the choice. Returns the
 * image's number; -1: none is visible, or the direction misses the image. */
int pp_glass_images_sample(const struct pp_light_scene *scene,
                           struct pp_glass_view *view, struct pp_vec3 point,
                           struct pp_vec3 normal,
                           const struct pp_brightness *brightness, const double u[3],
                           struct pp_vec3 *to, double *pdf);

#endif
