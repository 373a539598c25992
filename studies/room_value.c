/* room_value.c - evaluates the method and reads the value: the lowest value at the
 * points, or the average. */
#include "studies/room_value.h"

#include <stdio.h>

#include "methods/evaluate.h"

/* Reading of a method at a point, or its average (point -1): the daylight factor, or
 * else the internally reflected component, or else the sum of sky and externally
 * reflected component. */
static struct pp_reading method_reading(const struct pp_report *report,
                                        const char *method, int point)
{
    static const enum pp_component order[] = {PP_DF, PP_IRC, PP_SC};
    const struct pp_column *column = NULL;
    for (int i = 0; i < 3 && !column; i++)
        column = pp_report_find(report, order[i], method);
    if (!column)
        return pp_reading_none("the method gives no value");
    if (point >= 0 && !column->points)
        return pp_reading_none("the method gives only the average of the room");
    struct pp_reading reading =
        point < 0 || !column->points ? column->average : column->points[point];
    const struct pp_column *external =
        column->component == PP_SC ? pp_report_find(report, PP_ERC, method) : NULL;
    if (external && !reading.why)
        reading.value +=
            (point < 0 ? external->average : external->points[point]).value;
    return reading;
}

enum pp_status pp_room_value(struct pp_room_value *value, const struct pp_world *world,
                             struct pp_reading *reading, struct pp_error *err)
{
    struct pp_report report = {.world = world,
                               .light = *value->light,
                               .receivers = value->points,
                               .receiver_count = value->point_count,
                               .finished = true,
                               .threads = value->threads};
    enum pp_status status = pp_methods_evaluate(&report, value->method, err);
    if (status == PP_OK) {
        *reading =
            method_reading(&report, value->method, value->point_count > 0 ? 0 : -1);
        for (int i = 1; i < value->point_count && !reading->why; i++) {
            struct pp_reading other = method_reading(&report, value->method, i);
            if (other.why || other.value < reading->value)
                *reading = other;
        }
    }
    if (status == PP_OK && reading->why) {
        snprintf(value->why, sizeof value->why, "%s", reading->why);
        reading->why = value->why;
    }
    pp_report_clear(&report);
    return status;
}
