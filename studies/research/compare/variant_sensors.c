/* variant_sensors.c - see variant_sensors.h. */
#include "studies/research/compare/variant_sensors.h"

#include <stdlib.h>

enum pp_status pp_variant_sensors_go_on(const struct pp_variant_tracing *tracing,
                                        double done, struct pp_error *err)
{
    if (!tracing->look || tracing->look(tracing->data, done))
        return PP_OK;
    return pp_fail(err, PP_INTERRUPTED, "interrupted");
}

static enum pp_status follow_variant_sensors(struct pp_sensors *sensors,
                                             const struct pp_variant_tracing *tracing,
                                             struct pp_error *err)
{
    enum pp_status status = PP_OK;
    while (status == PP_OK && !pp_sensors_done(sensors)) {
        status = pp_variant_sensors_go_on(tracing, pp_sensors_progress(sensors), err);
        if (status == PP_OK)
            status = pp_sensors_advance(sensors, PP_VARIANT_SLICE_S, err);
    }
    return status;
}

enum pp_status pp_variant_sensors(
    struct pp_sensor_reading *readings, const struct pp_light_scene *scene,
    const struct pp_environment *environment, const struct pp_receiver *points,
    int count, double horizontal, const struct pp_room_variant *variant,
    const struct pp_variant_tracing *tracing, struct pp_error *err)
{
    const struct pp_sensors_options options = {.error = tracing->error,
                                               .seed = tracing->seed,
                                               .threads = tracing->threads,
                                               .horizontal = horizontal,
                                               .limited = variant->bounces >= 0,
                                               .ground_counts = variant->ground_counts,
                                               .bounces = variant->bounces};
    struct pp_sensors *sensors = NULL;
    struct pp_sensor *list = calloc((size_t)count + 1, sizeof *list);
    if (!list)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++)
        list[i] = (struct pp_sensor){points[i].position, points[i].normal, 0};
    enum pp_status status =
        pp_sensors_create(&sensors, scene, environment, list, count, &options, err);
    if (status == PP_OK)
        status = follow_variant_sensors(sensors, tracing, err);
    for (int i = 0; i < count && status == PP_OK; i++)
        readings[i] = pp_sensors_read(sensors, i);
    pp_sensors_destroy(sensors);
    free(list);
    return status;
}
