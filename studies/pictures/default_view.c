/* default_view.c - chooses the best viewpoint from a grid of trial points, and the
 * planes of plan and section. */
#include "studies/pictures/default_view.h"

#include <math.h>

#include "model/room/position.h"

enum {
    PLACES = 24, /* number of viewpoints tried along each side of the room */
    WAYS = 8,    /* number of directions in which the distance of a viewpoint from walls
                  * is checked */
    RAYS = 24,   /* number of rays across the picture */
};

/* Preferred distance of the viewpoint from walls (m), if the room is large enough. */
static const double clear_m = 0.4;

/* An opening whose slope is at most this is treated as a rooflight. */
static const double upright_rad = 45.0 * PP_RAD;

/* A view is horizontal if the window is at most level_rad above the eye. Otherwise it
 * is raised by the excess, but by at most raised_most_rad. */
static const double level_rad = 20.0 * PP_RAD, raised_most_rad = 15.0 * PP_RAD;

static const struct pp_vec3 upwards = {0.0, 0.0, 1.0};

/* Index of the opening with the largest area; -1: none. Openings steeper than
 * upright_rad take precedence over all others. */
static int largest_window(const struct pp_world *world)
{
    int largest = -1;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *a = &world->openings[i];
        const struct pp_opening *b = &world->openings[largest < 0 ? i : largest];
        bool upright = a->slope_rad > upright_rad, before = b->slope_rad > upright_rad;
        if (largest < 0 || (upright && !before)
            || (upright == before && a->inner.area_m2 > b->inner.area_m2))
            largest = i;
    }
    return largest;
}

static struct pp_vec3 polygon_middle(const struct pp_polygon *polygon)
{
    struct pp_vec3 sum = {0.0, 0.0, 0.0};
    for (int i = 0; i < polygon->count; i++)
        sum = pp_vec_along(sum, 1.0 / polygon->count, polygon->vertices[i]);
    return sum;
}

/* Distance to the nearest surface in the direction `to`; INFINITY: there is none. */
static double free_way(const struct pp_light_scene *scene, struct pp_vec3 from,
                       struct pp_vec3 to)
{
    struct pp_light_ray ray = {.from = from, .to = to, .space = PP_INDOORS};
    struct pp_light_hit hit;
    return pp_light_scene_first(scene, &ray, &hit) ? hit.distance_m : INFINITY;
}

/* Distance to the nearest surface at the height of `place`, limited to `most`. */
static double clearance(const struct pp_light_scene *scene, struct pp_vec3 place,
                        double most)
{
    for (int i = 0; i < WAYS; i++) {
        double angle = 2.0 * PP_PI * (i + 0.5) / WAYS;
        most = fmin(most, free_way(scene, place, pp_vec(cos(angle), sin(angle), 0.0)));
    }
    return most;
}

/* Penalty for a viewpoint from which the target is not visible. */
static double hidden(const struct pp_light_scene *scene, struct pp_vec3 place,
                     struct pp_vec3 target)
{
    struct pp_vec3 way = pp_vec_sub(target, place);
    double distance_m = pp_vec_length(way);
    if (!(distance_m > 0.0))
        return 1e3;
    double free_m = free_way(scene, place, pp_vec_scale(way, 1.0 / distance_m));
    return free_m < 0.98 * distance_m - 0.02 ? 1e3 : 0.0;
}

/* Harmonic mean of the free distances across the picture, in the horizontal plane
 * through `place`. The harmonic mean gives most weight to near walls, which obstruct
 * the view. */
static double prospect(const struct pp_light_scene *scene, struct pp_vec3 place,
                       struct pp_vec3 target)
{
    double middle = atan2(target.y - place.y, target.x - place.x), sum = 0.0;
    for (int i = 0; i < RAYS; i++) {
        double angle = middle + PP_PERSPECTIVE_DEG * PP_RAD * ((i + 0.5) / RAYS - 0.5);
        double free_m = free_way(scene, place, pp_vec(cos(angle), sin(angle), 0.0));
        sum += 1.0 / fmax(free_m, 1e-3);
    }
    return RAYS / sum;
}

/* Finds the best of PLACES x PLACES viewpoints at that height. A good viewpoint has a
 * distant view, sees the target near the middle of the picture, and is clear of all
 * surfaces. Viewpoints farther in the direction `back` are slightly preferred; if back
 * is zero, none is. If no viewpoint is indoors, returns the middle of the room's
 * bounding box. */
static struct pp_vec3 stand_back(const struct pp_light_scene *scene,
                                 struct pp_vec3 target, struct pp_vec3 back,
                                 double height_m)
{
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    struct pp_vec3 low = room.low, high = room.high;
    struct pp_vec3 best = pp_bounds3_middle(&room);
    double best_score = -INFINITY;
    for (int j = 0; j < PLACES; j++)
        for (int i = 0; i < PLACES; i++) {
            struct pp_vec3 place = {low.x + (high.x - low.x) * (i + 0.5) / PLACES,
                                    low.y + (high.y - low.y) * (j + 0.5) / PLACES,
                                    height_m};
            if (pp_light_scene_space(scene, place) != PP_INDOORS)
                continue;
            struct pp_vec3 way = pp_vec_sub(place, target);
            way.z = 0.0;
            double behind =
                pp_vec_length(back) > 0.0 ? pp_vec_dot(way, back) : pp_vec_length(way);
            double aside = sqrt(fmax(pp_vec_dot(way, way) - behind * behind, 0.0));
            double clear = clearance(scene, place, clear_m);
            double score = prospect(scene, place, target) - 0.5 * aside + 0.1 * behind
                           - 20.0 * (clear_m - clear) - hidden(scene, place, target);
            if (score > best_score) {
                best_score = score;
                best = place;
            }
        }
    return best;
}

static void look_at_window(struct pp_view_place *place,
                           const struct pp_light_scene *scene,
                           const struct pp_world *world, int window)
{
    const struct pp_opening *opening = &world->openings[window];
    double eye_m = fmin(PP_EYE_HEIGHT_M, 0.6 * world->height_m);
    struct pp_vec3 target = polygon_middle(&opening->inner);
    struct pp_vec3 back = {opening->inner.normal.x, opening->inner.normal.y, 0.0};
    if (opening->slope_rad > upright_rad && pp_vec_length(back) > 0.0)
        back = pp_vec_unit(back);
    else
        back = pp_vec(0.0, 0.0, 0.0);
    place->eye = stand_back(scene, target, back, eye_m);
    place->toward = pp_vec_sub(target, place->eye);
    double level = hypot(place->toward.x, place->toward.y);
    double altitude = atan2(place->toward.z, level);
    if (level < 1e-3)
        place->toward = pp_vec(0.0, 1.0, 0.3);
    else
        place->toward.z =
            level * tan(fmin(fmax(altitude - level_rad, 0.0), raised_most_rad));
}

/* Sets the view of a room without openings: along its longer side. */
static void look_along(struct pp_view_place *place, const struct pp_light_scene *scene,
                       const struct pp_world *world)
{
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    struct pp_vec3 low = room.low, high = room.high;
    bool deep = high.y - low.y >= high.x - low.x;
    struct pp_vec3 end = pp_bounds3_middle(&room);
    struct pp_vec3 back = deep ? pp_vec(0.0, 1.0, 0.0) : pp_vec(1.0, 0.0, 0.0);
    end.x = deep ? end.x : low.x;
    end.y = deep ? low.y : end.y;
    double eye_m = fmin(PP_EYE_HEIGHT_M, 0.6 * world->height_m);
    place->eye = stand_back(scene, end, back, eye_m);
    place->toward = pp_vec_scale(back, -1.0);
}

/* Point of the working plane that is nearest to the middle of the room and clear of all
 * surfaces. */
static struct pp_vec3 middle_of_plane(const struct pp_light_scene *scene,
                                      const struct pp_world *world)
{
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    struct pp_vec3 low = room.low, high = room.high;
    struct pp_vec3 middle = pp_bounds3_middle(&room);
    middle.z = world->working_plane_m;
    struct pp_vec3 best = middle;
    double best_score = -INFINITY;
    for (int j = 0; j <= PLACES; j++)
        for (int i = 0; i <= PLACES; i++) {
            struct pp_vec3 place = {low.x + (high.x - low.x) * i / PLACES,
                                    low.y + (high.y - low.y) * j / PLACES, middle.z};
            if (pp_position_receiver_fault(world, place, upwards))
                continue;
            double clear = clearance(scene, place, clear_m);
            double score = 20.0 * clear - pp_vec_length(pp_vec_sub(place, middle));
            if (score > best_score) {
                best_score = score;
                best = place;
            }
        }
    return best;
}

static void cut_plan(struct pp_view_place *place, const struct pp_light_scene *scene,
                     const struct pp_world *world)
{
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    struct pp_vec3 low = room.low, high = room.high;
    place->eye = pp_bounds3_middle(&room);
    place->eye.z = fmin(PP_PLAN_CUT_M, 0.5 * world->height_m);
    place->toward = pp_vec(0.0, 0.0, -1.0);
    place->up = pp_vec(0.0, 1.0, 0.0);
    place->across_m = high.x - low.x;
    place->down_m = high.y - low.y;
}

static void cut_section(struct pp_view_place *place, const struct pp_light_scene *scene,
                        const struct pp_world *world, int window)
{
    struct pp_bounds3 room = pp_light_scene_bounds(scene, true);
    struct pp_vec3 low = room.low, high = room.high;
    struct pp_vec3 size = pp_vec_sub(high, low);
    place->eye = pp_bounds3_middle(&room);
    place->down_m = size.z;
    /* `right` is the direction to the right on the drawing. This direction is from the
     * window into the room, so the window is on the left. */
    struct pp_vec3 right =
        size.y >= size.x ? pp_vec(0.0, 1.0, 0.0) : pp_vec(1.0, 0.0, 0.0);
    if (window >= 0) {
        const struct pp_opening *opening = &world->openings[window];
        struct pp_vec3 middle = polygon_middle(&opening->inner);
        struct pp_vec3 in = opening->inner.normal;
        in.z = 0.0;
        if (opening->slope_rad > upright_rad && pp_vec_length(in) > 0.0)
            right = pp_vec_unit(in);
        /* Moves the cut plane to the middle of the window. */
        double along = pp_vec_dot(pp_vec_sub(place->eye, middle), right);
        struct pp_vec3 at = pp_vec_along(middle, along, right);
        place->eye = pp_vec(at.x, at.y, place->eye.z);
    }
    place->toward = pp_vec_cross(upwards, right);
    place->across_m = fabs(right.x) * size.x + fabs(right.y) * size.y;
}

void pp_default_view(struct pp_view_place *place, const struct pp_light_scene *scene,
                     const struct pp_world *world, enum pp_room_view view)
{
    *place = (struct pp_view_place){.up = upwards};
    int window = largest_window(world);
    switch (view) {
    case PP_ROOM_VIEW_PERSPECTIVE:
        if (window >= 0)
            look_at_window(place, scene, world, window);
        else
            look_along(place, scene, world);
        return;
    case PP_ROOM_VIEW_FISHEYE:
        place->eye = middle_of_plane(scene, world);
        place->toward = upwards;
        place->up = pp_vec(0.0, 1.0, 0.0);
        return;
    case PP_ROOM_VIEW_PLAN:
        cut_plan(place, scene, world);
        return;
    case PP_ROOM_VIEW_SECTION:
        cut_section(place, scene, world, window);
        return;
    }
}
