/* light_images.h - next-event estimation of openings by reflection in polished planes
 * and in other openings' glass. It samples a direction from a diffuse surface to an
 * opening's image in a reflector (window_images.h) or in glass (glass_images.h), and
 * from there a direction to the opening. Inside simulate/ only.
 *
 * At the reflector, a direction of the lobe is sampled or, if the opening's solid angle
 * is smaller than the lobe's, a direction to the opening. light_path.c then adds the
 * light outside:
 *
 *     if (pp_light_images_view(state, &shading, &view)
 *         && pp_light_images_sample(state, &view, &sample))
 *         ... sample.weight times the light that comes along sample.ray ...
 */
#ifndef PP_SIMULATE_TRANSPORT_LIGHT_IMAGES_H
#define PP_SIMULATE_TRANSPORT_LIGHT_IMAGES_H

#include "simulate/scene/images/glass_images.h"
#include "simulate/transport/sample_openings.h"

/* A point of a reflector at which an image is sampled. */
struct pp_image_view {
    struct pp_shading_point
        there; /* shading point at this place; its lobes are below */
    struct pp_lobes lobes;
    int window;
    struct pp_rgb weight; /* weight, at the diffuse surface, of the radiance that comes
                           * from this point */
};

/* Makes the view. False if no image is sampled, or if none is visible at the shading
 * point. */
bool pp_light_images_view(struct pp_radiance_state *state,
                          const struct pp_shading_point *shading,
                          struct pp_image_view *view);

/* Samples the view towards the opening; false if no light arrives along it. */
bool pp_light_images_sample(struct pp_radiance_state *state,
                            const struct pp_image_view *view,
                            struct pp_opening_sample *sample);

/* Probability of sampling an image in glass, whose light is weak and varies little.
 * Chosen by trial. */
#define PP_GLASS_CHANCE 0.25

/* Samples the image of an opening in the glass of another opening (glass_images.h): a
 * path to the glass, and from there to the opening. *there: the point in the glass.
 * False if no light arrives along this path. */
bool pp_light_images_in_glass(struct pp_radiance_state *state,
                              const struct pp_shading_point *shading,
                              struct pp_glass_view *view,
                              struct pp_shading_point *there,
                              struct pp_opening_sample *sample);

#endif
