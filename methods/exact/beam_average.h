/* beam_average.h - the mean over the working plane of what comes through an opening, as
 * an integral over directions (view/beam.h). */
#ifndef PP_METHODS_EXACT_BEAM_AVERAGE_H
#define PP_METHODS_EXACT_BEAM_AVERAGE_H

#include "methods/exact/quadrature.h"
#include "methods/average/beams.h"

/* Luminances in one direction, through the glass, over Eh. */
struct pp_beam_light {
    pp_luminance_function *sky;      /* of the sky there, seen or hidden */
    pp_luminance_function *exitance; /* of an exitance of 1; NULL: of none */
    const void *context;
    double of_reflectance; /* luminance factor of an obstruction of reflectance 1 */
    bool with_outside;     /* else nothing outside hides the sky */
};

/* The error of the mean, relative to both components together. Over the rooms of
 * tests/methods/exact/test_beam_average.c the figures are within a tenth. */
#define PP_BEAM_AVERAGE_ERROR 1e-3

/* The means over the world's plane of the sky component and the externally reflected
 * component of one opening. The plane must not be empty. */
enum pp_status pp_beam_average(double mean[2], struct pp_beams *beams,
                               const struct pp_opening *opening,
                               const struct pp_beam_light *light, double relative_error,
                               struct pp_error *err);

#endif
