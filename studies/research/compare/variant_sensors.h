/* variant_sensors.h - simulates irradiance at points of a scene, with a variant's limit
 * on reflections. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_SENSORS_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_SENSORS_H

#include "model/room/world.h"
#include "simulate/transport/sensors.h"
#include "studies/research/compare/room_variant.h"

#define PP_VARIANT_SLICE_S 0.1 /* seconds of simulation between calls of `look` */

/* Simulates the irradiance at `count` points with the variant's limit on reflections.
 * readings[i]: result at points[i]. environment: surroundings of the room's world; NULL
 * if the scene was made from a scene description. horizontal: irradiance of open
 * horizontal ground. PP_INTERRUPTED if `look` returns false. */
enum pp_status pp_variant_sensors(
    struct pp_sensor_reading *readings, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *points,
    int count, double horizontal, const struct pp_room_variant *variant,
    const struct pp_variant_tracing *tracing, struct pp_error *err);

/* Calls `look` with the fraction of work done, 0 to 1. PP_INTERRUPTED if `look` returns
 * false. */
enum pp_status pp_variant_sensors_go_on(const struct pp_variant_tracing *tracing,
                                        double done, struct pp_error *err);

#endif
