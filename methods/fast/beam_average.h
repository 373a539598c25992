/* beam_average.h - the mean light through an opening over the working plane, as an
 * integral over directions (beam.h). */
#ifndef PP_METHODS_FAST_BEAM_AVERAGE_H
#define PP_METHODS_FAST_BEAM_AVERAGE_H

#include "methods/average/plane_light.h"

/* The error of the mean, relative to the sum of both components. In the rooms of
 * tests/methods/fast/test_beam_average.c the actual errors are below a tenth of this
 * value. */
#define PP_BEAM_AVERAGE_ERROR 1e-3

/* The means over the world's plane of the sky component and the externally reflected
 * component of one opening. The plane must not be empty. */
enum pp_status pp_beam_average(double mean[2], struct pp_beams *beams,
                               const struct pp_opening *opening,
                               const struct pp_plane_light *light,
                               double relative_error, struct pp_error *err);

#endif
