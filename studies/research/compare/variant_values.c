/* variant_values.c - changes a copy of the room, and simulates the copy. */
#include "studies/research/compare/variant_values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/position.h"
#include "model/room/room.h"
#include "model/room/room_light.h"
#include "simulate/scene/light_scene_of_world.h"
#include "simulate/fast/tracer.h"
#include "studies/research/compare/variant_glass.h"
#include "studies/research/compare/variant_sensors.h"

/* ---- the changed room ---- */

static enum pp_status change(struct pp_room *room, const struct pp_study_room *is,
                             const struct pp_room_variant *variant,
                             struct pp_error *err)
{
    for (int i = 0; i < pp_room_opening_count(room); i++) {
        pp_room_set_glass(room, i,
                          pp_variant_glass(pp_room_opening_at(room, i).glass, variant));
        if (variant->no_frame)
            pp_room_set_frame_factor(room, i, 1.0);
        if (variant->no_dirt)
            pp_room_set_maintenance(room, i, 1.0);
    }
    if (variant->nothing_outside)
        pp_room_clear_surroundings(room, is->world);
    if (variant->open_ground || !isnan(variant->ground))
        pp_room_set_ground(room,
                           isnan(variant->ground) ? is->light.ground_reflectance
                                                  : variant->ground,
                           variant->open_ground || is->world->ground_is_open);
    if (variant->sky[0] && strcmp(variant->sky, "gensky") != 0)
        return pp_room_set_sky(room, variant->sky, err);
    return PP_OK;
}

/* Everything needed for a simulation. */
struct varied_room {
    struct pp_world *world;
    struct pp_outside_light light;
    struct pp_light_scene *scene;
    struct pp_environment *environment;
    struct pp_receiver *receivers;
};

static void clear_varied_room(struct varied_room *varied)
{
    pp_environment_destroy(varied->environment);
    pp_light_scene_destroy(varied->scene);
    pp_world_destroy(varied->world);
    free(varied->receivers);
}

static enum pp_status resolve_varied_room(struct varied_room *varied,
                                          const struct pp_study_room *room,
                                          const struct pp_room_variant *variant,
                                          struct pp_error *err)
{
    struct pp_room *copy = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, room->file ? room->file : "");
    enum pp_status status = pp_room_copy(&copy, room->room, err);
    if (status == PP_OK)
        status = change(copy, room, variant, err);
    if (status == PP_OK)
        status = pp_world_create(&varied->world, copy, &mistakes, err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, PP_BAD_INPUT, "the room with the switches is not valid: %.300s",
                mistakes.list[0].text);
    if (status == PP_OK)
        status = pp_room_light(&varied->light, copy, err);
    if (status == PP_OK && strcmp(variant->sky, "gensky") == 0)
        varied->light.sky = pp_sky_faded(varied->light.ground_reflectance);
    pp_mistakes_clear(&mistakes);
    pp_room_destroy(copy);
    return status;
}

static enum pp_status place_points(struct varied_room *varied,
                                   const struct pp_study_room *room,
                                   const struct pp_room_variant *variant,
                                   struct pp_error *err)
{
    int count = room->receiver_count;
    varied->receivers = malloc(((size_t)count + 1) * sizeof *varied->receivers);
    if (!varied->receivers)
        return pp_fail_memory(err);
    memcpy(varied->receivers, room->receivers,
           (size_t)count * sizeof *varied->receivers);
    for (int i = 0; i < count && !isnan(variant->plane_m); i++) {
        struct pp_receiver *receiver = &varied->receivers[i];
        receiver->position.z = variant->plane_m;
        const char *fault = pp_position_receiver_fault(
            varied->world, receiver->position, receiver->normal);
        /* Points inside furniture are valid here: they receive no light, as in the
         * other program. */
        if (fault && !pp_position_in_fitting(varied->world, receiver->position))
            return pp_fail(err, PP_BAD_INPUT, "plane=%g: the point %g, %g %s",
                           variant->plane_m, receiver->position.x, receiver->position.y,
                           fault);
    }
    return PP_OK;
}

static enum pp_status make_varied_room(struct varied_room *varied,
                                       const struct pp_study_room *room,
                                       const struct pp_room_variant *variant,
                                       struct pp_error *err)
{
    *varied = (struct varied_room){0};
    enum pp_status status = resolve_varied_room(varied, room, variant, err);
    if (status == PP_OK)
        status = place_points(varied, room, variant, err);
    if (status == PP_OK)
        status = pp_light_scene_of_world_matt(&varied->scene, varied->world, err);
    if (status == PP_OK)
        status = pp_light_scene_under(&varied->environment, varied->scene,
                                      &varied->light, err);
    if (status != PP_OK)
        clear_varied_room(varied);
    return status;
}

/* ---- its values ---- */

static enum pp_status trace_varied_room(double *values, double *errors,
                                        const struct varied_room *varied, int count,
                                        const struct pp_variant_tracing *tracing,
                                        struct pp_error *err)
{
    const struct pp_tracer_options options = {
        .error = tracing->error, .seed = tracing->seed, .threads = tracing->threads};
    struct pp_tracer *tracer;
    enum pp_status status =
        pp_tracer_create(&tracer, varied->scene, varied->environment, varied->receivers,
                         count, &options, err);
    if (status != PP_OK)
        return status;
    while (status == PP_OK && !pp_tracer_done(tracer)) {
        status = pp_variant_sensors_go_on(tracing, pp_tracer_progress(tracer), err);
        if (status == PP_OK)
            status = pp_tracer_advance(tracer, PP_VARIANT_SLICE_S, err);
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
                                    const struct varied_room *varied, int count,
                                    const struct pp_room_variant *variant,
                                    const struct pp_variant_tracing *tracing,
                                    struct pp_error *err)
{
    struct pp_sensor_reading *readings = calloc((size_t)count + 1, sizeof *readings);
    if (!readings)
        return pp_fail_memory(err);
    enum pp_status status =
        pp_variant_sensors(readings, varied->scene, varied->environment,
                           varied->receivers, count, 1.0, variant, tracing, err);
    for (int i = 0; i < count && status == PP_OK; i++) {
        values[i] = readings[i].grey;
        errors[i] = readings[i].grey_error;
    }
    free(readings);
    return status;
}

enum pp_status pp_variant_values(double *values, double *errors,
                                 const struct pp_study_room *room,
                                 const struct pp_room_variant *variant,
                                 const struct pp_variant_tracing *tracing,
                                 struct pp_error *err)
{
    int count = room->receiver_count;
    struct varied_room varied;
    for (int i = 0; i < count; i++)
        values[i] = errors[i] = 0.0;
    if (variant->colour != PP_ROOM_VARIANT_COLOUR_IS)
        return pp_fail(err, PP_BAD_INPUT,
                       "colour= does not apply: a room file has no colours");
    if (variant->dark)
        return PP_OK;
    enum pp_status status = make_varied_room(&varied, room, variant, err);
    if (status != PP_OK)
        return status;
    status = variant->bounces < 0
                 ? trace_varied_room(values, errors, &varied, count, tracing, err)
                 : follow_so_far(values, errors, &varied, count, variant, tracing, err);
    for (int i = 0; i < count && status == PP_OK; i++) {
        values[i] *= variant->factor;
        errors[i] *= variant->factor;
    }
    clear_varied_room(&varied);
    return status;
}
