/* plane_light.h - the mean over the working plane of the light through an opening.
 *
 * The plain implementation is an integral over points of the plane. The fast one
 * (beam_average.h) is an integral over directions. pp_beams_create selects one of them.
 */
#ifndef PP_METHODS_AVERAGE_PLANE_LIGHT_H
#define PP_METHODS_AVERAGE_PLANE_LIGHT_H

#include "methods/fast/beams.h"
#include "methods/exact/quadrature.h"
#include "model/light/outside_light.h"

/* Light through the glass as a function of direction: luminances divided by Eh. */
struct pp_plane_light {
    pp_luminance_function *sky;      /* luminance of the sky in that direction,
                                      * visible or hidden */
    pp_luminance_function *exitance; /* luminance of visible surfaces for an exitance
                                      * of pi; NULL: none is self-luminous */
    const void *context;
    double grain_rad;      /* resolution of sky(), see struct pp_integrand */
    double of_reflectance; /* luminance factor of an obstruction of reflectance 1 */
    bool with_outside;     /* false: obstructions outside are left out */
};

/* Means over the beams' working plane of the sky component and the externally reflected
 * component of one opening, for receivers that face up. The plane must not be empty. */
enum pp_status pp_plane_light_average(double mean[2], struct pp_beams *beams,
                                      const struct pp_opening *opening,
                                      const struct pp_plane_light *light,
                                      struct pp_error *err);

/* Means of the sky component and the externally reflected component through `glass`
 * (clear, or none). Both components are defined as in pp_direct_through. All users of
 * one `beams` must have the same light. */
enum pp_status pp_plane_light_direct(double mean[2], struct pp_beams *beams,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_glass *glass,
                                     struct pp_error *err);

#endif
