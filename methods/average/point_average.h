/* point_average.h - the mean over the working plane of the light through an opening, as an
 * integral over points: the plain way. */
#ifndef PP_METHODS_AVERAGE_POINT_AVERAGE_H
#define PP_METHODS_AVERAGE_POINT_AVERAGE_H

#include "methods/average/plane_light.h"

/* The error of the mean that the cubature over the plane aims at, relative to both
 * components together; at each point the view is integrated to PP_QUADRATURE_GLAZED. */
#define PP_POINT_AVERAGE_ERROR 1e-3

/* Average over points; parameters as for pp_plane_light_average. */
enum pp_status pp_point_average(double mean[2], const struct pp_world *world,
                                const struct pp_opening *opening,
                                const struct pp_plane_light *light,
                                struct pp_error *err);

#endif
