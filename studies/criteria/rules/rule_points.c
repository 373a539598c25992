/* rule_points.c - see rule_points.h. */
#include "studies/criteria/rules/rule_points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/room/position.h"
#include "studies/bands/report_bands.h"
#include "studies/criteria/factors.h"

static const double from_side_m = 1.0;

/* Normal, into the room, of the only wall with windows; false if there is none. */
static bool window_normal(struct pp_vec3 *normal, const struct pp_world *world)
{
    if (world->opening_count == 0)
        return false;
    const struct pp_surface *wall = &world->surfaces[world->openings[0].face];
    *normal = wall->outline.normal;
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face != world->openings[0].face)
            return false;
    return fabs(normal->z) < 1e-6;
}

/* Extent of the working plane along a horizontal direction. */
static void plane_extent(double extent[2], const struct pp_region *plane,
                         struct pp_vec3 along)
{
    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (int r = 0; r < plane->count; r++)
        for (int i = 0; i < plane->rings[r].count; i++) {
            double at =
                along.x * plane->rings[r].xy[i][0] + along.y * plane->rings[r].xy[i][1];
            extent[0] = fmin(extent[0], at);
            extent[1] = fmax(extent[1], at);
        }
}

static int half_depth(struct pp_receiver points[2], const struct pp_world *world)
{
    struct pp_vec3 into, up = {0.0, 0.0, 1.0};
    double depth[2], side[2];
    if (!window_normal(&into, world) || world->plane.count == 0)
        return 0;
    struct pp_vec3 along = pp_vec_cross(up, into);
    plane_extent(depth, &world->plane, into);
    plane_extent(side, &world->plane, along);
    double area_m2 = (depth[1] - depth[0]) * (side[1] - side[0]);
    if (fabs(pp_region_area(&world->plane) - area_m2) > 1e-3 * area_m2
        || side[1] - side[0] <= 2.0 * from_side_m)
        return 0;
    double middle = 0.5 * (depth[0] + depth[1]);
    const double at[2] = {side[0] + from_side_m, side[1] - from_side_m};
    for (int i = 0; i < 2; i++) {
        struct pp_vec3 place = pp_vec_along(pp_vec_scale(into, middle), at[i], along);
        place.z = world->working_plane_m;
        points[i] = (struct pp_receiver){.position = place, .normal = up};
        if (pp_position_receiver_fault(world, place, up))
            return 0;
    }
    return 2;
}

/* The points of a word of the table; the caller frees *points. */
static enum pp_status make_points(struct pp_receiver **points, int *count,
                                  const struct pp_world *world, const char *word,
                                  struct pp_error *err)
{
    *count = 0;
    *points = calloc((size_t)world->receiver_count + 2, sizeof **points);
    if (!*points)
        return pp_fail_memory(err);
    if (strcmp(word, "half-depth") == 0) {
        *count = half_depth(*points, world);
        return PP_OK;
    }
    for (int i = 0; i < world->receiver_count; i++)
        if (world->receivers[i].line > 0)
            (*points)[(*count)++] = world->receivers[i];
    return PP_OK;
}

enum pp_status pp_rule_points_report(struct pp_report *report,
                                     struct pp_receiver **points,
                                     const struct pp_study_room *room, const char *word,
                                     struct pp_error *err)
{
    int count;
    enum pp_status status = make_points(points, &count, room->world, word, err);
    *report = (struct pp_report){.world = room->world,
                                 .light = room->light,
                                 .receivers = *points,
                                 .receiver_count = count,
                                 .finished = true};
    if (status == PP_OK && count > 0)
        status = pp_factors_by_hand(report, err);
    return status == PP_OK && count > 0 ? pp_report_bands_fill(report, err) : status;
}
