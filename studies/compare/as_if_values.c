/* as_if_values.c - changes a copy of the room, and traces it. */
#include "studies/compare/as_if_values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/position.h"
#include "model/room/room.h"
#include "model/room/room_light.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/tracer/tracer.h"
#include "studies/compare/as_if_glass.h"
#include "studies/compare/as_if_sensors.h"

/* ---- the room that it is as if it were ---- */

static enum pp_status change(struct pp_room *room, const struct pp_study_room *is,
                             const struct pp_as_if *as_if, struct pp_error *err)
{
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        pp_room_set_glass(room, i,
                          pp_as_if_glass(pp_room_opening_at(room, i).glass, as_if));
        if (as_if->no_frame)
            pp_room_set_frame_factor(room, i, 1.0);
        if (as_if->no_dirt)
            pp_room_set_maintenance(room, i, 1.0);
    }
    if (as_if->nothing_outside)
        pp_room_clear_surroundings(room, is->world);
    if (as_if->open_ground || !isnan(as_if->ground))
        pp_room_set_ground(
            room, isnan(as_if->ground) ? is->light.ground_reflectance : as_if->ground,
            as_if->open_ground || is->world->ground_is_open);
    if (as_if->sky[0] && strcmp(as_if->sky, "gensky") != 0)
        return pp_room_set_sky(room, as_if->sky, err);
    return PP_OK;
}

/* All that a tracing stands on. */
struct variant {
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_receiver *receivers;
};

static void clear(struct variant *variant)
{
    pp_environment_destroy(variant->environment);
    pp_light_scene_destroy(variant->scene);
    pp_world_destroy(variant->world);
    free(variant->receivers);
}

static enum pp_status resolve(struct variant *variant, const struct pp_study_room *room,
                              const struct pp_as_if *as_if, struct pp_error *err)
{
    struct pp_room *copy = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, room->file ? room->file : "");
    enum pp_status status = pp_room_copy(&copy, room->room, err);
    if (status == PP_OK)
        status = change(copy, room, as_if, err);
    if (status == PP_OK)
        status = pp_world_create(&variant->world, copy, &mistakes, err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, PP_BAD_INPUT, "as if: %.300s", mistakes.list[0].text);
    if (status == PP_OK)
        status = pp_room_light(&variant->light, copy, err);
    if (status == PP_OK && strcmp(as_if->sky, "gensky") == 0)
        variant->light.sky = pp_sky_faded(variant->light.ground_reflectance);
    pp_mistakes_clear(&mistakes);
    pp_room_destroy(copy);
    return status;
}

static enum pp_status place_points(struct variant *variant,
                                   const struct pp_study_room *room,
                                   const struct pp_as_if *as_if, struct pp_error *err)
{
    int count = room->receiver_count;
    variant->receivers = malloc(((size_t)count + 1) * sizeof *variant->receivers);
    if (!variant->receivers)
        return pp_fail_memory(err);
    memcpy(variant->receivers, room->receivers,
           (size_t)count * sizeof *variant->receivers);
    for (int i = 0; i < count && !isnan(as_if->plane_m); i++) {
        struct pp_receiver *receiver = &variant->receivers[i];
        receiver->position.z = as_if->plane_m;
        const char *fault = pp_position_receiver_fault(
            variant->world, receiver->position, receiver->normal);
        /* Under a desk, too: no light comes there, as none does by the other program. */
        if (fault && !pp_position_in_fitting(variant->world, receiver->position))
            return pp_fail(err, PP_BAD_INPUT, "plane=%g: the point %g, %g %s",
                           as_if->plane_m, receiver->position.x, receiver->position.y,
                           fault);
    }
    return PP_OK;
}

static enum pp_status make(struct variant *variant, const struct pp_study_room *room,
                           const struct pp_as_if *as_if, struct pp_error *err)
{
    *variant = (struct variant){0};
    enum pp_status status = resolve(variant, room, as_if, err);
    if (status == PP_OK)
        status = place_points(variant, room, as_if, err);
    if (status == PP_OK)
        status = pp_light_scene_of_world_matt(&variant->scene, variant->world, err);
    if (status == PP_OK)
        status = pp_light_scene_under(&variant->environment, variant->scene,
                                      &variant->light, err);
    if (status != PP_OK)
        clear(variant);
    return status;
}

/* ---- its values ---- */

static enum pp_status trace(double *values, double *errors,
                            const struct variant *variant, int count,
                            const struct pp_as_if_tracing *tracing,
                            struct pp_error *err)
{
    const struct pp_tracer_options options = {
        .error = tracing->error, .seed = tracing->seed, .threads = tracing->threads};
    struct pp_tracer *tracer;
    enum pp_status status =
        pp_tracer_create(&tracer, variant->scene, variant->environment,
                         variant->receivers, count, &options, err);
    if (status != PP_OK)
        return status;
    while (status == PP_OK && !pp_tracer_done(tracer)) {
        status = pp_as_if_goes_on(tracing, pp_tracer_progress(tracer), err);
        if (status == PP_OK)
            status = pp_tracer_advance(tracer, PP_AS_IF_SLICE_S, err);
    }
    for (int i = 0; i < count && status == PP_OK; i++) {
        struct pp_reading readings[PP_COMPONENT_COUNT];
        pp_tracer_read(tracer, i, readings);
        values[i] = readings[PP_DF].value;
        errors[i] = readings[PP_DF].std_error;
    }
    pp_tracer_destroy(tracer);
    return status;
}

static enum pp_status follow_so_far(double *values, double *errors,
                                    const struct variant *variant, int count,
                                    const struct pp_as_if *as_if,
                                    const struct pp_as_if_tracing *tracing,
                                    struct pp_error *err)
{
    struct pp_sensor_reading *readings = calloc((size_t)count + 1, sizeof *readings);
    if (!readings)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_as_if_sensors(readings, variant->scene, variant->environment,
                         variant->receivers, count, 1.0, as_if, tracing, err);
    for (int i = 0; i < count && status == PP_OK; i++) {
        values[i] = readings[i].grey;
        errors[i] = readings[i].grey_error;
    }
    free(readings);
    return status;
}

enum pp_status pp_as_if_values(double *values, double *errors,
                               const struct pp_study_room *room,
                               const struct pp_as_if *as_if,
                               const struct pp_as_if_tracing *tracing,
                               struct pp_error *err)
{
    int count = room->receiver_count;
    struct variant variant;
    for (int i = 0; i < count; i++)
        values[i] = errors[i] = 0.0;
    if (as_if->colour != PP_AS_IF_COLOUR_IS)
        return pp_fail(err, PP_BAD_INPUT, "colour=: a room file has no colours");
    if (as_if->dark)
        return PP_OK;
    enum pp_status status = make(&variant, room, as_if, err);
    if (status != PP_OK)
        return status;
    status = as_if->bounces < 0
                 ? trace(values, errors, &variant, count, tracing, err)
                 : follow_so_far(values, errors, &variant, count, as_if, tracing, err);
    for (int i = 0; i < count && status == PP_OK; i++) {
        values[i] *= as_if->factor;
        errors[i] *= as_if->factor;
    }
    clear(&variant);
    return status;
}
