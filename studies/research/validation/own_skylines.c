/* own_skylines.c - combines the obstruction angles of openings that face the same
 * direction. */
#include "studies/research/validation/own_skylines.h"

#include <math.h>
#include <stdlib.h>

#include "methods/reflected/obstruction.h"
#include "model/light/graded_sky.h"
#include "model/room/room.h"

/* Reflectance of obstructions that the formulae contain. */
static const double formulas_reflectance = 0.2;

/* Tolerances for equal angles (rad), and for equal directions (1 less the cosine
 * between them). */
static const double same_angle_rad = 1e-6, same_way = 1e-9;

/* A skyline's angle is less than 90 degrees. */
static const double most_rad = 89.9 * PP_RAD;

/* The openings that face one direction. */
struct side {
    struct pp_vec3 outward; /* horizontal, unit */
    double area_m2, sum;    /* total area of the openings; sum of area times angle */
};

/* Outward horizontal direction of a face; false if the face is horizontal. */
static bool way_out(struct pp_vec3 *outward, const struct pp_polygon *outline)
{
    struct pp_vec3 n = outline->normal;
    double level = hypot(n.x, n.y);
    *outward = pp_vec(-n.x / level, -n.y / level, 0.0);
    return level > same_angle_rad;
}

/* Angle of the obstructions in front of an opening, without the part hidden by the
 * room's own walls. */
static enum pp_status angle_outside(double *angle_rad, const struct pp_world *world,
                                    const struct pp_world *bare,
                                    const struct pp_outside_light *light, int opening,
                                    struct pp_error *err)
{
    double own_rad;
    enum pp_status status =
        pp_obstruction_angle(angle_rad, world, light, &world->openings[opening], err);
    if (status == PP_OK)
        status =
            pp_obstruction_angle(&own_rad, bare, light, &bare->openings[opening], err);
    if (status != PP_OK || own_rad == 0.0)
        return status;
    if (*angle_rad - own_rad < same_angle_rad) {
        *angle_rad = 0.0;
        return PP_OK;
    }
    double b = light->sky.gradation;
    double hidden = pp_graded_sky_over_skyline(b, own_rad)
                    - pp_graded_sky_over_skyline(b, *angle_rad);
    *angle_rad = pp_graded_sky_skyline(b, pp_graded_sky_over_skyline(b, 0.0) - hidden);
    return PP_OK;
}

static struct side *side_facing(struct side *sides, int *count, struct pp_vec3 outward)
{
    for (int i = 0; i < *count; i++)
        if (pp_vec_dot(sides[i].outward, outward) > 1.0 - same_way)
            return &sides[i];
    sides[*count] = (struct side){.outward = outward};
    return &sides[(*count)++];
}

/* Groups all openings by direction. Sets *covered to false if a horizontal opening has
 * an obstruction. */
static enum pp_status gather_opening_sides(struct side *sides, int *count,
                                           bool *covered, const struct pp_world *world,
                                           const struct pp_world *bare,
                                           const struct pp_outside_light *light,
                                           struct pp_error *err)
{
    *count = 0;
    *covered = true;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        struct pp_vec3 outward;
        double angle_rad;
        enum pp_status status = angle_outside(&angle_rad, world, bare, light, i, err);
        if (status != PP_OK)
            return status;
        if (!way_out(&outward, outline)) {
            *covered &= angle_rad < same_angle_rad;
            continue;
        }
        struct side *side = side_facing(sides, count, outward);
        side->area_m2 += outline->area_m2;
        side->sum += outline->area_m2 * angle_rad;
    }
    return PP_OK;
}

/* Name of a wall that faces this direction; NULL: there is none. */
static const char *wall_towards(const struct pp_world *world, struct pp_vec3 outward)
{
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        struct pp_vec3 out;
        if (face->role == PP_WALL && face->name && way_out(&out, &face->outline)
            && pp_vec_dot(out, outward) > 1.0 - same_way)
            return face->name;
    }
    return NULL;
}

/* True if the room's own obstructions are the same as these skylines: all are skylines
 * without a distance, with these angles and with the formulae's reflectance. */
static bool are_the_rooms(const struct pp_own_skylines *skylines,
                          const struct pp_world *world)
{
    for (int i = world->face_count; i < world->surface_count; i++)
        if (!world->surfaces[i].inside)
            return false;
    int found = 0;
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *one = &world->skylines[i];
        struct pp_vec3 outward;
        way_out(&outward, &world->surfaces[one->face].outline);
        const char *wall = wall_towards(world, outward);
        bool same = false;
        for (int k = 0; k < skylines->count && wall; k++)
            same |=
                skylines->list[k].wall == wall && isinf(one->distance_m)
                && one->reflectance == formulas_reflectance
                && fabs(skylines->list[k].angle_rad - one->angle_rad) < same_angle_rad;
        if (!same && one->angle_rad > 0.0)
            return false;
        found += same;
    }
    return found == skylines->count;
}

enum pp_status pp_own_skylines_of(struct pp_own_skylines *skylines,
                                  const struct pp_world *world,
                                  const struct pp_world *bare,
                                  const struct pp_outside_light *light,
                                  struct pp_error *err)
{
    size_t most = (size_t)world->opening_count + 1;
    struct side *sides = malloc(most * sizeof *sides);
    *skylines = (struct pp_own_skylines){.list = calloc(most, sizeof *skylines->list)};
    enum pp_status status = sides && skylines->list ? PP_OK : pp_fail_memory(err);
    int count = 0;
    bool covered = true;
    if (status == PP_OK)
        status = gather_opening_sides(sides, &count, &covered, world, bare, light, err);
    for (int i = 0; status == PP_OK && i < count; i++) {
        double angle_rad = fmin(sides[i].sum / sides[i].area_m2, most_rad);
        const char *wall = wall_towards(world, sides[i].outward);
        if (angle_rad < same_angle_rad)
            continue;
        covered &= wall != NULL;
        skylines->list[skylines->count++] = (struct pp_own_skyline){wall, angle_rad};
    }
    free(sides);
    skylines->as_they_are = !covered || are_the_rooms(skylines, world);
    if (status != PP_OK)
        pp_own_skylines_clear(skylines);
    return status;
}

void pp_own_skylines_clear(struct pp_own_skylines *skylines)
{
    free(skylines->list);
    *skylines = (struct pp_own_skylines){0};
}

enum pp_status pp_own_skylines_put(const struct pp_own_skylines *skylines,
                                   struct pp_room *room, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (int i = 0; i < skylines->count && status == PP_OK; i++)
        status =
            pp_room_add_skyline(room, skylines->list[i].wall,
                                skylines->list[i].angle_rad, formulas_reflectance, err);
    return status;
}
