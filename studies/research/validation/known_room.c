/* known_room.c - reads rooms with known results, and calculates their values by methods
 * and by simulation. */
#include "studies/research/validation/known_room.h"

#include <math.h>
#include <string.h>

#include "methods/evaluate.h"
#include "model/room/building.h"
#include "model/room/room_light.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"

enum pp_status pp_known_room_world(struct pp_world **world,
                                   struct pp_outside_light *light, const char *xml,
                                   struct pp_error *err)
{
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    *world = NULL;
    pp_mistakes_init(&mistakes, "a room with a known answer");
    enum pp_status status =
        pp_building_parse(&building, xml, strlen(xml), &mistakes, err);
    if (status == PP_OK)
        status = pp_world_create(world, pp_building_room(building, 0), &mistakes, err);
    if (status == PP_OK)
        status = pp_room_light(light, pp_building_room(building, 0), err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, status, "a room with a known answer: %s", mistakes.list[0].text);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return status;
}

void pp_known_room_clear(struct pp_known_room *room)
{
    pp_report_clear(&room->report);
    pp_world_destroy(room->world);
}

enum pp_status pp_known_room_evaluate(struct pp_known_room *room, const char *xml,
                                      const char *methods, struct pp_error *err)
{
    *room = (struct pp_known_room){0};
    enum pp_status status = pp_known_room_world(&room->world, &room->light, xml, err);
    if (status != PP_OK)
        return status;
    room->report = (struct pp_report){.world = room->world,
                                      .light = room->light,
                                      .receivers = room->world->receivers,
                                      .receiver_count = 1};
    status = pp_methods_evaluate(&room->report, methods, err);
    if (status != PP_OK)
        pp_known_room_clear(room);
    return status;
}

double pp_known_room_at_point(const struct pp_known_room *room,
                              enum pp_component component, const char *name)
{
    const struct pp_column *column = pp_report_find(&room->report, component, name);
    return column && column->points ? column->points[0].value : NAN;
}

double pp_known_room_average(const struct pp_known_room *room,
                             enum pp_component component, const char *name)
{
    const struct pp_column *column = pp_report_find(&room->report, component, name);
    return column ? column->average.value : NAN;
}

enum pp_status pp_known_room_trace(struct pp_reading (*readings)[PP_COMPONENT_COUNT],
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receivers, int count,
                                   const struct pp_known_trace *how,
                                   struct pp_error *err)
{
    struct pp_tracer_options options = {.samples = how->samples,
                                        .error = how->error,
                                        .seed = how->seed,
                                        .threads = how->threads};
    struct pp_light_scene *scene = NULL;
    struct pp_environment *environment = NULL;
    struct pp_tracer *tracer = NULL;
    enum pp_status status = pp_light_scene_of_world_matt(&scene, world, err);
    if (status == PP_OK)
        status = pp_light_scene_under(&environment, scene, light, err);
    if (status == PP_OK)
        status = pp_tracer_create(&tracer, scene, environment, receivers, count,
                                  &options, err);
    while (status == PP_OK && !pp_tracer_done(tracer))
        status = pp_tracer_advance(tracer, 1.0, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        pp_tracer_read(tracer, i, readings[i]);
    pp_tracer_destroy(tracer);
    pp_environment_destroy(environment);
    pp_light_scene_destroy(scene);
    return status;
}
