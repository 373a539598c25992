/* sun_on_surface.h - sunlight on one side of a surface, by a ray to the sun's centre.
 *
 * The sun is a point. Its light passes through clear glass with the transmittance at
 * the angle of incidence; specular reflections are neglected.
 */
#ifndef PP_SIMULATE_YEAR_SUN_ON_SURFACE_H
#define PP_SIMULATE_YEAR_SUN_ON_SURFACE_H

#include "simulate/path_tracer/path_trace.h"

/* Illuminance divided by that of a plane normal to the sun: cosine times transmittance,
 * 0 in shade. sun: unit, towards the sun. *opening: index of the opening through which
 * the sunlight enters; -1: none. */
double pp_sun_on_surface(const struct pp_light_scene *scene,
                         const struct pp_lit_point *at, struct pp_vec3 sun,
                         int *opening);

/* BTDF of a scattering pane for light of the sun and this class of leaving light. sun:
 * unit, towards the sun. */
double pp_sun_on_surface_scattered(const struct pp_opening *opening, struct pp_vec3 sun,
                                   int leaving);

#endif
