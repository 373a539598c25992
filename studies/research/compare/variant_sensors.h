/* variant_sensors.h - sensors in a scene, with reflections limited by a variant's
 * switches. */
#ifndef PP_STUDIES_RESEARCH_COMPARE_VARIANT_SENSORS_H
#define PP_STUDIES_RESEARCH_COMPARE_VARIANT_SENSORS_H

#include "model/room/world.h"
#include "simulate/transport/sensors.h"
#include "studies/research/compare/room_variant.h"

#define PP_VARIANT_SLICE_S 0.1 /* seconds between calls of look */

/* Creates and runs sensors. readings: `count`, one for each point. horizontal:
 * irradiance of the open ground. environment: of a world; NULL: of a description.
 * PP_INTERRUPTED if `look` returns false. */
enum pp_status pp_variant_sensors(
    struct pp_sensor_reading *readings, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *points,
    int count, double horizontal, const struct pp_room_variant *variant,
    const struct pp_variant_tracing *tracing, struct pp_error *err);

/* Calls `look`, with done from 0 to 1; PP_INTERRUPTED if it returns false. */
enum pp_status pp_variant_sensors_go_on(const struct pp_variant_tracing *tracing,
                                        double done, struct pp_error *err);

#endif
