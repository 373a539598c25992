/* daylight.c - how a program of your own uses the library: the daylight factors of a
 * room file by the default methods, one line a point and method.
 *
 *     cc daylight.c -o daylight $(pkg-config --cflags --libs pepperpot)
 *     ./daylight deep-office.xml
 */
#include <math.h>
#include <stdio.h>

#include "methods/evaluate.h"
#include "model/room/building.h"

static void print_report(const struct pp_report *report)
{
    for (int i = 0; i < report->receiver_count; i++)
        for (int k = 0; k < report->column_count; k++) {
            const struct pp_column *column = &report->columns[k];
            if (column->component != PP_DF || !column->points)
                continue;
            struct pp_vec3 p = report->receivers[i].position;
            const struct pp_reading *reading = &column->points[i];
            printf("%.2f %.2f %.2f  %-16s ", p.x, p.y, p.z, column->name);
            if (isnan(reading->value))
                printf("- (%s)\n", reading->why);
            else
                printf("%.2f %%\n", 100.0 * reading->value);
        }
}

static enum pp_status work_out(const struct pp_room *room, struct pp_mistakes *mistakes,
                               struct pp_error *err)
{
    struct pp_world *world = NULL;
    enum pp_status status = pp_world_create(&world, room, mistakes, err);
    if (status == PP_OK) {
        struct pp_report report = {.world = world,
                                   .receivers = world->receivers,
                                   .receiver_count = world->receiver_count,
                                   .finished = true};
        status = pp_methods_evaluate(&report, "default", err);
        if (status == PP_OK)
            print_report(&report);
        pp_report_clear(&report);
    }
    pp_world_destroy(world);
    return status;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: daylight FILE\n");
        return 2;
    }
    struct pp_building *building = NULL;
    struct pp_mistakes mistakes;
    struct pp_error err = {PP_OK, ""};
    pp_mistakes_init(&mistakes, argv[1]);

    enum pp_status status = pp_building_read(&building, argv[1], &mistakes, &err);
    for (int i = 0; status == PP_OK && i < pp_building_room_count(building); i++)
        status = work_out(pp_building_room(building, i), &mistakes, &err);

    for (int i = 0; i < mistakes.count; i++)
        fprintf(stderr, "%s:%d: %s\n", mistakes.file, mistakes.list[i].line,
                mistakes.list[i].text);
    if (status != PP_OK)
        fprintf(stderr, "daylight: %s\n", err.message);
    pp_building_destroy(building);
    pp_mistakes_clear(&mistakes);
    return status == PP_OK ? 0 : 1;
}
