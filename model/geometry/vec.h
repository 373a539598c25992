/* vec.h - points and directions in space, by value.
 *
 * Axes are right-handed: x along the plan's width, y along its depth, z up; metres.
 */
#ifndef PP_MODEL_GEOMETRY_VEC_H
#define PP_MODEL_GEOMETRY_VEC_H

#include <math.h>
#include <stdbool.h>

#define PP_PI 3.14159265358979323846
#define PP_RAD (PP_PI / 180.0) /* one degree in radians */

struct pp_vec3 {
    double x, y, z;
};

static inline struct pp_vec3 pp_vec(double x, double y, double z)
{
    return (struct pp_vec3){x, y, z};
}

static inline struct pp_vec3 pp_vec_add(struct pp_vec3 a, struct pp_vec3 b)
{
    return pp_vec(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline struct pp_vec3 pp_vec_sub(struct pp_vec3 a, struct pp_vec3 b)
{
    return pp_vec(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct pp_vec3 pp_vec_scale(struct pp_vec3 a, double s)
{
    return pp_vec(a.x * s, a.y * s, a.z * s);
}

/* a + s b. */
static inline struct pp_vec3 pp_vec_along(struct pp_vec3 a, double s, struct pp_vec3 b)
{
    return pp_vec(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

static inline double pp_vec_dot(struct pp_vec3 a, struct pp_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct pp_vec3 pp_vec_cross(struct pp_vec3 a, struct pp_vec3 b)
{
    return pp_vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double pp_vec_length(struct pp_vec3 a)
{
    return sqrt(pp_vec_dot(a, a));
}

static inline bool pp_vec_same(struct pp_vec3 a, struct pp_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Direction a, reflected in a plane with unit normal n. */
static inline struct pp_vec3 pp_vec_mirrored(struct pp_vec3 a, struct pp_vec3 n)
{
    return pp_vec_along(a, -2.0 * pp_vec_dot(n, a), n);
}

/* Unit vector in the direction of a, which must not be zero. */
static inline struct pp_vec3 pp_vec_unit(struct pp_vec3 a)
{
    return pp_vec_scale(a, 1.0 / pp_vec_length(a));
}

/* Unit vector with that altitude, and bearing clockwise from +y (north). */
static inline struct pp_vec3 pp_vec_at_bearing(double bearing_rad, double altitude_rad)
{
    double c = cos(altitude_rad);
    return pp_vec(c * sin(bearing_rad), c * cos(bearing_rad), sin(altitude_rad));
}

#endif
