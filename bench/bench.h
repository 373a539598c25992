/* bench.h - helpers for the programs of bench/: exit on an error, processor time, and a
 * room from the text of a room file. */
#ifndef PP_BENCH_BENCH_H
#define PP_BENCH_BENCH_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "model/base/error.h"
#include "model/room/building.h"
#include "model/room/room_light.h"
#include "model/room/world.h"

static inline void must(enum pp_status status, const struct pp_error *err)
{
    if (status != PP_OK) {
        fprintf(stderr, "bench: %s\n", err->message);
        exit(3);
    }
}

/* Processor time of all threads, which excludes other work on the machine. */
static inline double processor_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Creates the world and the outside light from the text of a room file. The caller
 * destroys the world. */
static inline struct pp_world *world_of(struct pp_outside_light *light, const char *xml)
{
    struct pp_building *building = NULL;
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {.message = "the room has mistakes"};
    pp_mistakes_init(&mistakes, "bench");
    must(pp_building_parse(&building, xml, strlen(xml), &mistakes, &err), &err);
    must(pp_world_create(&world, pp_building_room(building, 0), &mistakes, &err), &err);
    must(pp_room_light(light, pp_building_room(building, 0), &err), &err);
    pp_mistakes_clear(&mistakes);
    pp_building_destroy(building);
    return world;
}

#endif
