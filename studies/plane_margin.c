/* plane_margin.c - see plane_margin.h. */
#include "studies/plane_margin.h"

#include <string.h>

#include "model/geometry/clipper.h"
#include "studies/engines/engine.h"

static const double MARGIN_M = 0.5;

enum pp_status pp_plane_margin_init(struct pp_plane_margin *margin,
                                    const struct pp_study_room *room,
                                    struct pp_error *err)
{
    *margin = (struct pp_plane_margin){.world = *room->world, .room = *room};
    margin->world.plane = (struct pp_region){0};
    margin->world.receivers = NULL;
    margin->world.receiver_count = 0;
    margin->room.world = &margin->world;
    margin->room.receivers = NULL;
    margin->room.receiver_count = 0;
    struct pp_clipper *clipper = NULL;
    enum pp_status status = pp_clipper_create(&clipper, err);
    if (status == PP_OK)
        status = pp_clipper_inset(clipper, &margin->world.plane, &room->world->plane,
                                  MARGIN_M, err);
    pp_clipper_destroy(clipper);
    margin->has_plane = pp_region_area(&margin->world.plane) > 0.0;
    return status;
}

void pp_plane_margin_clear(struct pp_plane_margin *margin)
{
    pp_region_clear(&margin->world.plane);
    *margin = (struct pp_plane_margin){.has_plane = false};
}

/* True for the daylight factor of a method that gives one value for the whole plane, so
 * that it is neither a pair nor simulated. */
static bool is_of_the_whole_plane(const struct pp_column *column)
{
    return column->component == PP_DF && !strchr(column->name, '+')
           && !pp_engine_of_column(column->name);
}

enum pp_status pp_plane_margin_take(struct pp_report *report,
                                    const struct pp_report *inside,
                                    struct pp_error *err)
{
    for (int i = 0; i < report->column_count; i++) {
        struct pp_column *column = &report->columns[i];
        const struct pp_column *of =
            inside ? pp_report_find(inside, column->component, column->name) : NULL;
        column->has_margin_average = true;
        if (is_of_the_whole_plane(column)) {
            column->margin_average =
                pp_reading_none("the value is for the whole plane only");
            continue;
        }
        if (!of) {
            column->margin_average = pp_reading_none(
                inside
                    ? "not computed"
                    : "no part of the working plane is 0.5 m or more from the walls");
            continue;
        }
        column->margin_average = of->average;
        column->margin_average.steps = NULL;
        if (of->average.why)
            column->margin_average.why = pp_report_say(report, "%s", of->average.why);
        if (of->average.why && !column->margin_average.why)
            return pp_fail_memory(err);
    }
    return PP_OK;
}
