/* sight.h - sky visibility from a point, with rays tested against every polygon: slow
 * and simple, for tests of the methods and the simulation. It shares nothing with
 * methods/ or simulate/. */
#ifndef PP_TESTS_LIB_SIGHT_H
#define PP_TESTS_LIB_SIGHT_H

#include <math.h>

#include "model/room/world.h"

/* True if p, in the polygon's plane, is inside it, by the number of edges crossed, in
 * projection. */
static inline bool sight_within(const struct pp_polygon *polygon, struct pp_vec3 p)
{
    struct pp_vec3 n = polygon->normal;
    int drop = fabs(n.x) > fabs(n.y)   ? fabs(n.x) > fabs(n.z) ? 0 : 2
               : fabs(n.y) > fabs(n.z) ? 1
                                       : 2;
    bool inside = false;
    for (int i = 0, j = polygon->count - 1; i < polygon->count; j = i++) {
        struct pp_vec3 a = polygon->vertices[i], b = polygon->vertices[j];
        double ax = drop == 0 ? a.y : a.x, ay = drop == 2 ? a.y : a.z;
        double bx = drop == 0 ? b.y : b.x, by = drop == 2 ? b.y : b.z;
        double px = drop == 0 ? p.y : p.x, py = drop == 2 ? p.y : p.z;
        if ((ay > py) != (by > py) && px < ax + (py - ay) / (by - ay) * (bx - ax))
            inside = !inside;
    }
    return inside;
}

/* Distance along u (in lengths of u) at which the ray from eye meets the polygon; -1:
 * none. */
static inline double sight_meets(const struct pp_polygon *polygon, struct pp_vec3 eye,
                                 struct pp_vec3 u)
{
    double slope = pp_vec_dot(u, polygon->normal);
    if (fabs(slope) < 1e-12)
        return -1.0;
    double t =
        pp_vec_dot(pp_vec_sub(polygon->vertices[0], eye), polygon->normal) / slope;
    return t > 1e-7 && sight_within(polygon, pp_vec_along(eye, t, u)) ? t : -1.0;
}

/* True if a skyline of that face hides the sky from eye along u. */
static inline bool sight_skyline(const struct pp_world *world, int face,
                                 struct pp_vec3 eye, struct pp_vec3 u)
{
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *line = &world->skylines[i];
        if (line->face != face)
            continue;
        const struct pp_polygon *wall = &world->surfaces[face].outline;
        double out = -pp_vec_dot(u, wall->normal);
        double from = -pp_vec_dot(pp_vec_sub(eye, wall->vertices[0]), wall->normal);
        if (isinf(line->distance_m)) {
            if (u.z < out * tan(line->angle_rad))
                return true;
        } else {
            double t = (line->distance_m - from) / out;
            double head = line->middle_z_m + line->distance_m * tan(line->angle_rad);
            if (out > 0.0 && eye.z + t * u.z < head)
                return true;
        }
    }
    return false;
}

/* True if the ray reaches the sky. `own`: -1 for an eye in the room, whose ray may pass
 * through openings; otherwise the face at whose outside the eye is, which the ray may
 * cross. */
static inline bool sight_sees_sky(const struct pp_world *world, struct pp_vec3 eye,
                                  struct pp_vec3 u, int own)
{
    int through = own;
    if (u.z <= 0.0)
        return false;
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (i == own || (own >= 0 && surface->role == PP_REVEAL))
            continue;
        double t = sight_meets(&surface->outline, eye, u);
        if (t < 0.0)
            continue;
        bool open = false;
        for (int k = 0; k < world->opening_count && own < 0 && !open; k++)
            open = world->openings[k].face == i
                   && sight_within(&world->openings[k].inner, pp_vec_along(eye, t, u));
        if (!open)
            return false;
        through = through < 0 ? i : through;
    }
    return through >= 0 && !sight_skyline(world, through, eye, u);
}

/* Illuminance of a horizontal plane at eye from a uniform sky through unglazed
 * openings, over that of the open plane. Each opening's outer outline is divided into n
 * pieces across and 4 n up, since most obstructing edges are horizontal. at_all:
 * returns a positive value with the first piece that shows sky. */
static inline double sight_sky_factor(const struct pp_world *world, struct pp_vec3 eye,
                                      int n, bool at_all)
{
    double sum = 0.0;
    for (int k = 0; k < world->opening_count; k++) {
        const struct pp_opening *opening = &world->openings[k];
        const struct pp_polygon *outline = &opening->outer;
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i < outline->count; i++) {
            struct pp_vec3 v = pp_vec_sub(outline->vertices[i], outline->vertices[0]);
            double at[2] = {pp_vec_dot(v, opening->along), pp_vec_dot(v, opening->up)};
            for (int c = 0; c < 2; c++) {
                low[c] = fmin(low[c], at[c]);
                high[c] = fmax(high[c], at[c]);
            }
        }
        double step[2] = {(high[0] - low[0]) / n, (high[1] - low[1]) / (4 * n)};
        for (int i = 0; i < 4 * n * n && !(at_all && sum > 0.0); i++) {
            struct pp_vec3 p = pp_vec_along(
                outline->vertices[0], low[0] + (i % n + 0.5) * step[0], opening->along);
            p = pp_vec_along(p, low[1] + (i / n + 0.5) * step[1], opening->up);
            struct pp_vec3 way = pp_vec_sub(p, eye);
            double r = pp_vec_length(way),
                   cosine = -pp_vec_dot(way, outline->normal) / r;
            if (cosine <= 0.0 || way.z <= 0.0 || !sight_within(outline, p)
                || !sight_sees_sky(world, eye, pp_vec_scale(way, 1.0 / r), -1))
                continue;
            sum += way.z / r * cosine * step[0] * step[1] / (r * r);
        }
    }
    return sum / PP_PI;
}

/* Vertical sky component: illuminance of a plane outside with the horizontal unit
 * normal `normal` from the overcast sky, over that of the open horizontal plane, by n x
 * 2n pieces of the quarter sphere. `own`: the face in that plane. */
static inline double sight_vertical_sky(const struct pp_world *world,
                                        struct pp_vec3 eye, struct pp_vec3 normal,
                                        int own, int n)
{
    struct pp_vec3 across = {-normal.y, normal.x, 0.0};
    double sum = 0.0, step = PP_PI / 2.0 / n;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 2 * n; k++) {
            double altitude = (i + 0.5) * step;
            double azimuth = (k + 0.5) * step - PP_PI / 2.0;
            struct pp_vec3 level =
                pp_vec_along(pp_vec_scale(normal, cos(azimuth)), sin(azimuth), across);
            struct pp_vec3 u = pp_vec_scale(level, cos(altitude));
            u.z = sin(altitude);
            if (sight_sees_sky(world, eye, u, own))
                sum += (1.0 + 2.0 * sin(altitude)) / 3.0 * cos(altitude) * cos(azimuth)
                       * cos(altitude) * step * step;
        }
    return sum / (7.0 * PP_PI / 9.0);
}

#endif
