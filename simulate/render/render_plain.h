/* render_plain.h - a pixel's light by plain path tracing. */
#ifndef PP_SIMULATE_RENDER_RENDER_PLAIN_H
#define PP_SIMULATE_RENDER_RENDER_PLAIN_H

#include "simulate/path_tracer/path_walk.h"

/* One sample of the radiance along the ray, in the coordinates of the scene. */
struct pp_rgb pp_render_plain_radiance(struct pp_path_walk *walk,
                                       struct pp_light_ray ray);

/* One sample of the irradiance of the surface that the ray meets. Light reflected
 * indoors is multiplied by `decorations`. False if the ray meets glass or nothing. */
bool pp_render_plain_irradiance(struct pp_path_walk *walk, struct pp_light_ray ray,
                                double decorations, struct pp_rgb *value);

#endif
