/* section_angle.c - intersects every polygon outside with the vertical section, and
 * finds the highest angle of the pieces. */
#include "studies/criteria/section_angle.h"

#include <math.h>

#include "methods/exact/exterior.h"
#include "model/geometry/tolerance.h"

/* The section: the eye is the middle of the opening's outside, `ahead` points
 * horizontally out of the wall, `across` is the section's normal. */
struct section_plane {
    struct pp_vec3 eye, ahead, across;
};

/* Intersection of the edge from p to q with the section: distance ahead of the eye and
 * height above it; false if there is none. Edges are half-open, so that a corner in the
 * section counts once. */
static bool section_crossing(const struct section_plane *section, struct pp_vec3 p,
                             struct pp_vec3 q, double at[2])
{
    struct pp_vec3 a = pp_vec_sub(p, section->eye), b = pp_vec_sub(q, section->eye);
    double from = pp_vec_dot(a, section->across), to = pp_vec_dot(b, section->across);
    if ((from >= 0.0) == (to >= 0.0))
        return false;
    struct pp_vec3 place = pp_vec_along(a, from / (from - to), pp_vec_sub(b, a));
    at[0] = pp_vec_dot(place, section->ahead);
    at[1] = place.z;
    return true;
}

/* Highest angle of the part of the piece from a to b that lies ahead of the eye. */
static double angle_of_piece(const double a[2], const double b[2])
{
    const double nearest = PP_SAME_M;
    double highest = 0.0;
    for (int end = 0; end < 2; end++) {
        const double *p = end ? b : a, *other = end ? a : b;
        double forward = p[0], up = p[1];
        if (forward < nearest) {
            if (other[0] <= nearest)
                continue;
            up += (other[1] - up) * (nearest - forward) / (other[0] - forward);
            forward = nearest;
        }
        highest = fmax(highest, atan2(up, forward));
    }
    return highest;
}

/* A point where an edge of a polygon meets the section. */
struct edge_crossing {
    double along; /* position on the line in which the polygon cuts the section */
    int edge;     /* decides the order of crossings at one position */
    double at[2]; /* distance ahead of the eye, height above the eye */
};

static bool is_before(const struct edge_crossing *a, const struct edge_crossing *b)
{
    return a->along < b->along || (a->along == b->along && a->edge < b->edge);
}

/* The first crossing after `last` along the line; false: there is none. */
static bool next_crossing(struct edge_crossing *next, const struct edge_crossing *last,
                          const struct section_plane *section,
                          const struct pp_polygon *polygon)
{
    const double line[2] = {polygon->normal.z,
                            -pp_vec_dot(polygon->normal, section->ahead)};
    *next = (struct edge_crossing){.along = INFINITY, .edge = polygon->count};
    for (int i = 0; i < polygon->count; i++) {
        struct edge_crossing place = {.edge = i};
        if (!section_crossing(section, polygon->vertices[i],
                              polygon->vertices[(i + 1) % polygon->count], place.at))
            continue;
        place.along = place.at[0] * line[0] + place.at[1] * line[1];
        if (is_before(last, &place) && is_before(&place, next))
            *next = place;
    }
    return isfinite(next->along);
}

/* Highest angle of the polygon's pieces; their ends are consecutive pairs of crossings
 * along the line. */
static double angle_of_polygon(const struct section_plane *section,
                               const struct pp_polygon *polygon)
{
    double highest = 0.0;
    struct edge_crossing from, to = {.along = -INFINITY};
    while (next_crossing(&from, &to, section, polygon)
           && next_crossing(&to, &from, section, polygon))
        highest = fmax(highest, angle_of_piece(from.at, to.at));
    return highest;
}

double pp_section_angle(const struct pp_world *world, const struct pp_opening *opening,
                        bool with_shades)
{
    struct pp_vec3 out = pp_vec_scale(opening->inner.normal, -1.0);
    struct pp_vec3 ahead = pp_vec_unit(pp_vec(out.x, out.y, 0.0));
    struct section_plane section = {pp_exterior_opening_centroid(opening), ahead,
                                    pp_vec(-ahead.y, ahead.x, 0.0)};
    double highest = 0.0;
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        if (skyline->face != opening->face)
            continue;
        highest = fmax(highest, pp_world_skyline_angle(skyline, section.eye.z, 0.0));
    }
    for (int i = 0; i < world->surface_count; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        bool free_inside = surface->role == PP_COVER
                           || (surface->role == PP_FREE_SURFACE && surface->inside);
        bool own_facade =
            surface->role == PP_FACADE && surface->owner == opening->facade;
        bool own_skyline = surface->role == PP_SKYLINE
                           && world->skylines[surface->owner].face == opening->face;
        if (i != opening->face && surface->role != PP_REVEAL && !free_inside
            && !own_facade && !own_skyline && (with_shades || !surface->is_shade))
            highest = fmax(highest, angle_of_polygon(&section, &surface->outline));
    }
    return highest;
}
