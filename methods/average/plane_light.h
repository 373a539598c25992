/* plane_light.h - the mean over the working plane of the light through an opening.
 *
 * Plainly it is an integral over points of the plane. By beams it is an
 * integral over directions (beam_average.h), which is sooner. pp_beams_create says which.
 */
#ifndef PP_METHODS_AVERAGE_PLANE_LIGHT_H
#define PP_METHODS_AVERAGE_PLANE_LIGHT_H

#include "methods/fast/beams.h"
#include "methods/exact/quadrature.h"
#include "model/light/outside_light.h"

/* Light of one direction: luminances through the glass, over Eh. */
struct pp_plane_light {
    pp_luminance_function *sky;      /* of the sky there, seen or hidden */
    pp_luminance_function *exitance; /* of an exitance of 1; NULL: of none */
    const void *context;
    double grain_rad;      /* of sky(), as for struct pp_integrand */
    double of_reflectance; /* luminance factor of an obstruction of reflectance 1 */
    bool with_outside;     /* else nothing outside hides the sky */
};

/* The means over the beams' working plane, for receivers that face up, of sky component and
 * externally reflected component of one opening. The plane must not be empty. */
enum pp_status pp_plane_light_average(double mean[2], struct pp_beams *beams,
                                      const struct pp_opening *opening,
                                      const struct pp_plane_light *light,
                                      struct pp_error *err);

/* Mean of the light of sky, ground and obstructions through `glass` (clear, or none),
 * defined as for pp_direct_through at a point. All users of one `beams` must have the
 * same light. */
enum pp_status pp_plane_light_direct(double mean[2], struct pp_beams *beams,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_glass *glass,
                                     struct pp_error *err);

#endif
