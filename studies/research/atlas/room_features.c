/* room_features.c - calculates the features from sums over the openings of a room, and
 * over their parts visible from a point. */
#include "studies/research/atlas/room_features.h"

#include <math.h>

#include "methods/exact/solid_angle.h"
#include "methods/reflected/interior.h"
#include "methods/reflected/obstruction.h"

const char *const pp_room_feature_names[PP_ROOM_FEATURES] = {
    [PP_ROOM_GLASS_FLOOR] = "glass-floor",
    [PP_ROOM_GLASS_INSIDE] = "glass-inside",
    [PP_ROOM_REFLECTANCE] = "reflectance",
    [PP_ROOM_FLOOR] = "floor",
    [PP_ROOM_CEILING] = "ceiling",
    [PP_ROOM_DEPTH_HEAD] = "depth-head",
    [PP_ROOM_DEPTH_WIDTH] = "depth-width",
    [PP_ROOM_BELOW] = "below",
    [PP_ROOM_UPRIGHT] = "upright",
    [PP_ROOM_WALLS] = "walls",
    [PP_ROOM_SPREAD] = "spread",
    [PP_ROOM_REVEAL] = "reveal",
    [PP_ROOM_PANE] = "pane",
    [PP_ROOM_OBSTRUCTION] = "obstruction",
    [PP_ROOM_THINGS] = "things",
    [PP_ROOM_GROUND] = "ground",
    [PP_ROOM_FACING] = "facing",
    [PP_ROOM_OPPOSITE] = "opposite",
    [PP_ROOM_ORDINARY] = "ordinary",
    [PP_ROOM_DEPTH] = "depth",
    [PP_ROOM_SIDE] = "side",
    [PP_ROOM_VIEW] = "view",
};

static const double upright_rad = 75.0 * PP_RAD;

/* Least height of an opening's head above the working plane, relative to the room's
 * height; smaller heights are raised to this value. */
static const double height_least = 0.02;

static double glass_m2(const struct pp_opening *opening)
{
    return opening->inner.area_m2 * opening->frame_factor;
}

static struct pp_bounds3 polygon_bounds(const struct pp_polygon *outline)
{
    struct pp_bounds3 bounds = pp_bounds3_empty();
    for (int i = 0; i < outline->count; i++)
        pp_bounds3_add(&bounds, outline->vertices[i]);
    return bounds;
}

/* ---- proportions ---- */

/* The opening with the largest area of glass; NULL: there is none. upright: only among
 * vertical openings. */
static const struct pp_opening *largest(const struct pp_world *world, bool upright)
{
    const struct pp_opening *found = NULL;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        if ((!upright || opening->slope_rad >= upright_rad)
            && (!found || glass_m2(opening) > glass_m2(found)))
            found = opening;
    }
    return found;
}

/* Extent of the room in a direction (unit). */
static double room_reach(const struct pp_world *world, struct pp_vec3 direction)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < world->face_count; i++)
        for (int k = 0; k < world->surfaces[i].outline.count; k++) {
            double at = pp_vec_dot(world->surfaces[i].outline.vertices[k], direction);
            low = fmin(low, at);
            high = fmax(high, at);
        }
    return high - low;
}

static void fill_proportions(double features[PP_ROOM_FEATURES],
                             const struct pp_world *world)
{
    const struct pp_opening *opening = largest(world, true);
    double plane = world->working_plane_m, least = height_least * world->height_m;
    if (!opening) {
        opening = largest(world, false);
        double side = sqrt(pp_interior_role(world, PP_FLOOR).area_m2);
        features[PP_ROOM_DEPTH_HEAD] = side / fmax(opening->middle_z_m - plane, least);
        features[PP_ROOM_DEPTH_WIDTH] = 1.0;
        return;
    }
    struct pp_vec3 in = opening->inner.normal;
    in = pp_vec_unit(pp_vec(in.x, in.y, 0.0));
    double head = polygon_bounds(&opening->inner).high.z - plane;
    double depth = room_reach(world, in);
    features[PP_ROOM_DEPTH_HEAD] = depth / fmax(head, least);
    features[PP_ROOM_DEPTH_WIDTH] = depth / room_reach(world, pp_vec(-in.y, in.x, 0.0));
}

/* ---- openings ---- */

/* Number of faces that have openings. */
static int count_faces(const struct pp_world *world)
{
    int count = 0;
    for (int i = 0; i < world->opening_count; i++) {
        bool first = true;
        for (int k = 0; k < i; k++)
            first &= world->openings[k].face != world->openings[i].face;
        count += first;
    }
    return count;
}

static void fill_openings(double features[PP_ROOM_FEATURES],
                          const struct pp_world *world)
{
    double all = 0.0, below = 0.0, upright = 0.0, reveal = 0.0, pane = 0.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_opening *opening = &world->openings[i];
        double glass = glass_m2(opening);
        all += glass;
        below += opening->frame_factor
                 * pp_interior_area_below(&opening->inner, world->working_plane_m);
        upright += opening->slope_rad >= upright_rad ? glass : 0.0;
        reveal += glass * opening->reveal_m / sqrt(opening->inner.area_m2);
        pane += glass * opening->glass.diffuse / opening->glass.normal;
    }
    struct pp_interior inside = pp_interior_all(world);
    features[PP_ROOM_GLASS_FLOOR] = all / pp_interior_role(world, PP_FLOOR).area_m2;
    features[PP_ROOM_GLASS_INSIDE] = all / inside.area_m2;
    features[PP_ROOM_REFLECTANCE] = inside.reflectance;
    features[PP_ROOM_BELOW] = below / all;
    features[PP_ROOM_UPRIGHT] = upright / all;
    features[PP_ROOM_WALLS] = count_faces(world);
    features[PP_ROOM_SPREAD] = glass_m2(largest(world, false)) / all;
    features[PP_ROOM_REVEAL] = reveal / all;
    features[PP_ROOM_PANE] = pane / all;
}

/* ---- outside ---- */

static bool has_things(const struct pp_world *world)
{
    for (int i = world->face_count; i < world->surface_count; i++)
        if (!world->surfaces[i].inside && world->surfaces[i].role != PP_SKYLINE)
            return true;
    return false;
}

static enum pp_status fill_outside(double features[PP_ROOM_FEATURES],
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   struct pp_error *err)
{
    double sum = 0.0, facing = 0.0, opposite = 0.0, all = 0.0;
    struct pp_outside_planes planes = {0};
    struct pp_outside_light known = *light;
    known.planes = &planes;
    enum pp_status status = PP_OK;
    for (int i = 0; i < world->opening_count && status == PP_OK; i++) {
        const struct pp_opening *opening = &world->openings[i];
        struct pp_vec3 in = opening->inner.normal, out = pp_vec_scale(in, -1.0);
        double angle_rad = 0.0;
        status = pp_obstruction_angle(&angle_rad, world, light, opening, err);
        if (status == PP_OK)
            status = pp_outside_light_add_plane(&planes, &light->sky, out, err);
        if (status == PP_OK)
            status = pp_outside_light_add_plane(&planes, &light->sky, in, err);
        sum += glass_m2(opening) * angle_rad / PP_RAD;
        facing += glass_m2(opening) * pp_outside_light_sky_on_plane(&known, out);
        opposite += glass_m2(opening) * pp_outside_light_sky_on_plane(&known, in);
        all += glass_m2(opening);
    }
    pp_outside_light_clear_planes(&planes);
    if (status != PP_OK)
        return status;
    features[PP_ROOM_OBSTRUCTION] = sum / all;
    features[PP_ROOM_THINGS] = has_things(world);
    features[PP_ROOM_GROUND] = light->ground_reflectance;
    features[PP_ROOM_FACING] = facing / all;
    features[PP_ROOM_OPPOSITE] = opposite / all;
    return PP_OK;
}

/* ---- ordinary rooms ---- */

/* Ranges of the features of ordinary rooms. */
static const struct {
    enum pp_room_feature feature;
    double from, to;
} ordinary_ranges[] = {
    {PP_ROOM_GLASS_FLOOR, 0.04, 0.6}, {PP_ROOM_REFLECTANCE, 0.4, 0.8},
    {PP_ROOM_FLOOR, 0.12, 0.48},      {PP_ROOM_CEILING, 0.58, 0.9},
    {PP_ROOM_DEPTH_HEAD, 0.5, 6.5},   {PP_ROOM_DEPTH_WIDTH, 0.25, 2.5},
    {PP_ROOM_BELOW, 0.0, 0.4},        {PP_ROOM_UPRIGHT, 0.9, 1.0},
    {PP_ROOM_OBSTRUCTION, 0.0, 50.0}, {PP_ROOM_GROUND, 0.07, 0.33},
};

static bool is_ordinary(const double features[PP_ROOM_FEATURES])
{
    bool ordinary = true;
    for (size_t i = 0; i < sizeof ordinary_ranges / sizeof ordinary_ranges[0]; i++) {
        double value = features[ordinary_ranges[i].feature];
        ordinary &= value >= ordinary_ranges[i].from && value <= ordinary_ranges[i].to;
    }
    return ordinary;
}

enum pp_status pp_room_features(double features[PP_ROOM_FEATURES],
                                const struct pp_world *world,
                                const struct pp_outside_light *light,
                                struct pp_error *err)
{
    for (int i = 0; i < PP_ROOM_FEATURES; i++)
        features[i] = NAN;
    if (world->opening_count == 0)
        return PP_OK;
    fill_proportions(features, world);
    fill_openings(features, world);
    features[PP_ROOM_FLOOR] = pp_interior_role(world, PP_FLOOR).reflectance;
    features[PP_ROOM_CEILING] = pp_interior_role(world, PP_CEILING).reflectance;
    enum pp_status status = fill_outside(features, world, light, err);
    features[PP_ROOM_ORDINARY] = is_ordinary(features);
    return status;
}

/* ---- a point ---- */

/* Horizontal distance from a point to a polygon's outline, both seen in plan. */
static double plan_distance(const struct pp_polygon *outline, struct pp_vec3 point)
{
    double least = INFINITY;
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 a = outline->vertices[i],
                       b = outline->vertices[(i + 1) % outline->count];
        struct pp_vec3 along = pp_vec(b.x - a.x, b.y - a.y, 0.0);
        struct pp_vec3 from = pp_vec(point.x - a.x, point.y - a.y, 0.0);
        double square = pp_vec_dot(along, along);
        double t = square > 0.0 ? pp_vec_dot(from, along) / square : 0.0;
        struct pp_vec3 foot = pp_vec_scale(along, fmin(fmax(t, 0.0), 1.0));
        least = fmin(least, pp_vec_length(pp_vec_sub(from, foot)));
    }
    return least;
}

/* True if the point is above or below a polygon that is not vertical. */
static bool lies_under(const struct pp_polygon *outline, struct pp_vec3 point)
{
    bool inside = false;
    for (int i = 0, k = outline->count - 1; i < outline->count; k = i++) {
        struct pp_vec3 a = outline->vertices[i], b = outline->vertices[k];
        if ((a.y > point.y) != (b.y > point.y)
            && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

static double depth_of(const struct pp_world *world, struct pp_vec3 point)
{
    double least = INFINITY;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        double height = polygon_bounds(outline).high.z - point.z;
        if (height <= 0.0)
            continue;
        height = fmax(height, height_least * world->height_m);
        double distance =
            lies_under(outline, point) ? 0.0 : plan_distance(outline, point);
        least = fmin(least, distance / height);
    }
    return least;
}

static double room_side_of_point(const struct pp_world *world, struct pp_vec3 point)
{
    double least = INFINITY;
    for (int i = 0; i < world->face_count; i++)
        if (world->surfaces[i].role == PP_WALL)
            least =
                fmin(least, pp_polygon_distance(&world->surfaces[i].outline, point));
    return least / world->height_m;
}

/* Greatest number of vertices of an outline that are used; the others are ignored. */
enum { VERTICES = 64 };

static double view_of(const struct pp_world *world, struct pp_vec3 point)
{
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    struct pp_moments sum = {0};
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        struct pp_vec3 seen[VERTICES];
        int count = outline->count < VERTICES ? outline->count : VERTICES;
        if (!(pp_polygon_height(outline, point) > 1e-9))
            continue;
        for (int k = 0; k < count; k++)
            seen[k] = pp_vec_sub(outline->vertices[k], point);
        pp_solid_angle_add_moments(&sum, seen, count, up, &up, 1);
    }
    return sum.cosine / PP_PI;
}

void pp_room_features_at(double features[PP_ROOM_FEATURES],
                         const struct pp_world *world, struct pp_vec3 point)
{
    features[PP_ROOM_DEPTH] = depth_of(world, point);
    features[PP_ROOM_SIDE] = room_side_of_point(world, point);
    features[PP_ROOM_VIEW] = view_of(world, point);
}
