/* known_room.h - calculates the values of a room with known results, by hand methods
 * and by simulation. */
#ifndef PP_STUDIES_RESEARCH_VALIDATION_KNOWN_ROOM_H
#define PP_STUDIES_RESEARCH_VALIDATION_KNOWN_ROOM_H

#include <stdint.h>

#include "model/base/error.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/results/report.h"
#include "model/room/world.h"

/* A room with a window of 3 x 1.8 m, 3 m from the point. Its results have been
 * calculated in several ways. */
#define PP_KNOWN_HALL                                                                  \
    "<room version='1'><plan width='9' depth='8' height='4'/>"                         \
    "<window wall='south' left='3' sill='1.45' width='3' height='1.8'/>"               \
    "<point x='5.1' y='3'/>"

/* Settings for tracing a known room. */
struct pp_known_trace {
    uint64_t seed;
    int threads;  /* 0: one for each processor */
    long samples; /* paths for each point in each randomisation; 0: as many as needed
                   * for `error` */
    double error; /* target relative standard error of the daylight factor */
};

/* Reads a room from its text (UTF-8) and makes its light; the caller destroys
 * *world. */
enum pp_status pp_known_room_world(struct pp_world **world,
                                   struct pp_outside_light *light, const char *xml,
                                   struct pp_error *err);

/* A room with the results of methods at its first point and on average. */
struct pp_known_room {
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_report report;
};

/* Reads a room and evaluates `methods`, a list of names separated by commas. On success
 * the caller clears *room. */
enum pp_status pp_known_room_evaluate(struct pp_known_room *room, const char *xml,
                                      const char *methods, struct pp_error *err);
void pp_known_room_clear(struct pp_known_room *room);

/* A component by a method at the first point, and the average of the component; NAN if
 * missing. */
double pp_known_room_at_point(const struct pp_known_room *room,
                              enum pp_component component, const char *name);
double pp_known_room_average(const struct pp_known_room *room,
                             enum pp_component component, const char *name);

/* Simulates all components at `count` receivers, with diffuse surfaces; readings[i] is
 * for receiver i. */
enum pp_status pp_known_room_trace(struct pp_reading (*readings)[PP_COMPONENT_COUNT],
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receivers, int count,
                                   const struct pp_known_trace *how,
                                   struct pp_error *err);

#endif
