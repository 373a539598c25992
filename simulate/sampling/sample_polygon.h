/* sample_polygon.h - directions towards an opening, by importance sampling.
 *
 * A rectangle is sampled uniformly in solid angle by the area-preserving map of Ureña,
 * Fajardo and King [URENA13], a triangle by Arvo's map [ARVO95b]. An opening of small
 * angular size is sampled by area. A bilinear density over the unit square [PJH23] then
 * makes the samples follow, from corner to corner, the cosine at the receiving surface
 * and the brightness behind the opening. The estimate of that brightness affects the
 * variance alone, since the density of each direction is known exactly and is above 0
 * for every direction to the opening.
 */
#ifndef PP_SIMULATE_SAMPLING_SAMPLE_POLYGON_H
#define PP_SIMULATE_SAMPLING_SAMPLE_POLYGON_H

#include <stdbool.h>

#include "model/geometry/vec.h"

/* A plane shape to which directions are sampled. It emits on the side of `normal`. */
struct pp_target {
    struct pp_vec3 normal; /* unit, into the room */
    struct pp_vec3 middle;
    double area_m2;

    bool rectangle;
    struct pp_vec3 corner, along, up; /* rectangle; along and up of unit length */
    double width_m, height_m;

    struct pp_vec3 (*triangles)[3]; /* directions are sampled to them if the shape is no
                                     * rectangle; not owned */
    int triangle_count;
};

/* Height of a point in front of the target's plane (m). */
static inline double pp_target_height(const struct pp_target *target,
                                      struct pp_vec3 point)
{
    return pp_vec_dot(target->normal, pp_vec_sub(point, target->middle));
}

/* The place x along and y up from the corner of a rectangle. */
static inline struct pp_vec3 pp_target_point(const struct pp_target *target, double x,
                                             double y)
{
    return pp_vec_along(pp_vec_along(target->corner, x, target->along), y, target->up);
}

/* True if a point of its plane is in the rectangle. */
static inline bool pp_target_rectangle_has(const struct pp_target *target,
                                           struct pp_vec3 point)
{
    struct pp_vec3 in = pp_vec_sub(point, target->corner);
    double x = pp_vec_dot(in, target->along), y = pp_vec_dot(in, target->up);
    return x > 0.0 && x < target->width_m && y > 0.0 && y < target->height_m;
}

/* Finds the point where a ray meets the front of a rectangle; false if it does not. */
static inline bool pp_target_meets_rectangle(const struct pp_target *target,
                                             struct pp_vec3 from, struct pp_vec3 to,
                                             struct pp_vec3 *point)
{
    double toward = -pp_vec_dot(target->normal, to);
    double over = pp_vec_dot(target->normal, pp_vec_sub(from, target->corner));
    if (!(toward > 0.0) || !(over > 0.0))
        return false;
    *point = pp_vec_along(from, over / toward, to);
    return pp_target_rectangle_has(target, *point);
}

struct pp_sky_bright;

/* Estimated luminance outside the openings, relative to the luminance of the
 * horizon. */
struct pp_brightness {
    double ground;    /* below the horizon */
    double gradation; /* above the horizon: 1 + gradation sin(altitude) */
    const struct pp_sky_bright
        *bright; /* bright parts of a photographed sky (sample_bright.h); NULL: none;
                  * not owned */
    const struct pp_target
        *beyond; /* rectangular openings of a coarse model outside, through which the
                  * sky is seen (sample_part.h); not owned */
    int beyond_count;
};

/* The part of a rectangle through which openings beyond it are seen: a rectangle, from
 * the corner (m). share: of the directions; 0: none. */
struct pp_seen_part {
    double x0, x1, y0, y1, share;
};

/* A target as seen from one point of a surface. */
struct pp_polygon_sampler {
    const struct pp_target *target; /* not owned */
    struct pp_vec3 from, facing;    /* the point, and the normal of its surface */
    bool by_area;
    double distance_m;          /* to the target's plane, greater than 0 */
    double x0, x1, y0, y1;      /* sides of the rectangle, from the foot of the point */
    double b0, b1, k, solid;    /* parameters of the map of [URENA13]; solid angle in
                                 * sr */
    double corner_weight[2][2]; /* [v][u], their mean is 1 */
    const struct pp_sky_bright *bright;
    double bright_share; /* share of directions to the bright parts of the sky; 0:
                          * none */
    struct pp_seen_part part;
};

/* True if the front of the target is at least partly visible from this side of a
 * surface (at `from`, normal n). Obstructions are ignored. */
bool pp_sample_polygon_in_sight(const struct pp_target *target, struct pp_vec3 from,
                                struct pp_vec3 n);

/* Estimated light of the target at `from`, as a weight for the choice among several
 * targets; never 0 for a visible target. */
double pp_sample_polygon_importance(const struct pp_target *target, struct pp_vec3 from,
                                    struct pp_vec3 n,
                                    const struct pp_brightness *brightness);

/* The target must be in sight. n is the normal of the receiving surface. */
void pp_sample_polygon_init(struct pp_polygon_sampler *sampler,
                            const struct pp_target *target, struct pp_vec3 from,
                            struct pp_vec3 n, const struct pp_brightness *brightness);

/* A point of the target for two numbers in (0, 1), its direction and distance from
 * sampler->from, and 1/density in steradians. A direction to a bright part of the sky
 * that misses the target has per_density 0 and the direction 0. */
struct pp_direction_sample {
    struct pp_vec3 point, direction;
    double distance_m, per_density;
};
struct pp_direction_sample pp_sample_polygon_draw(
    const struct pp_polygon_sampler *sampler, double u, double v);

/* The density with which pp_sample_polygon_draw gives a direction, per steradian. The
 * direction must meet the target; 0 if it does not lead towards the target's front. */
double pp_sample_polygon_pdf(const struct pp_polygon_sampler *sampler,
                             struct pp_vec3 direction);

#endif
