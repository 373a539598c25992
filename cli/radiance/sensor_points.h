/* sensor_points.h - sensor points as Radiance's programs read them: lines of
 * "x y z dx dy dz". */
#ifndef PP_CLI_RADIANCE_SENSOR_POINTS_H
#define PP_CLI_RADIANCE_SENSOR_POINTS_H

#include "simulate/transport/sensors.h"

/* Reads the file ("-": standard input); *list is the caller's to free. Empty lines and
 * those that begin with "#" are passed over; directions are made unit. A line of
 * anything else is PP_BAD_INPUT, with its number; so is a file without points. */
enum pp_status pp_sensor_points_read(struct pp_sensor **list, int *count,
                                     const char *path, struct pp_error *err);

#endif
